#!/bin/sh
# What of each header its own tests reach, in lines and branches (gcov): sh tests/coverage.sh [HEADER...]. Lines that no test
# reaches stand in build/coverage/HEADER.missed. SIMD text counts as one of several levels: each has its own lines.
set -u
CC=gcc
if ! command -v gcov >/dev/null 2>&1 || ! command -v gcc >/dev/null 2>&1; then
    echo "no gcc with gcov on this machine"
    exit 0
fi
root=$(pwd)
[ $# -gt 0 ] || set -- ms_*.h
for h; do
    out=build/coverage/${h%.h}
    rm -rf "$out"
    mkdir -p "$out"
    for t in tests/test_*.c; do
        grep -q "include \"$h\"" "$t" || continue
        n=$(basename "$t" .c)
        case $n in *_big_endian | test_memory) continue ;; esac
        $CC -std=c99 -O0 --coverage -fprofile-update=atomic -w -D_POSIX_C_SOURCE=200809L -I"$root" -I"$root/tests" -I"$root/examples/tools" -I"$root/examples/demo" -I"$root/examples/engine" -I"$root/tests/bench" -c "$t" -o "$out/$n.o" &&
            $CC --coverage "$out/$n.o" -o "$out/$n" -lm -lpthread || exit 1
        "$out/$n" >"$out/$n.log" 2>&1 || echo "FAIL $n: $(tail -1 "$out/$n.log")"
        (cd "$out" && gcov -b -c "$n.o" >"$n.gcov.log" 2>&1 && for g in "$h".gcov *"#$h".gcov; do [ ! -f "$g" ] || mv "$g" "$n.lines"; done)
    done
    # A line counts as reached if any program reaches it.
    cat "$out"/*.lines | awk -v header="$h" -v missed="build/coverage/$h.missed" '
        /^branch/ {if (on) {key = at "," ++k; total_b[key] = 1; if ($0 ~ /taken [1-9]/) hit_b[key] = 1}; next}
        /^(call|function|unconditional)/ {next}
        {split($0, f, ":"); count = f[1]; gsub(/[ *]/, "", count); at = f[2] + 0; k = 0; on = at > 0 && count != "-"
         if (!on) next
         total[at] = 1; text[at] = $0; sub(/^[^:]*:[^:]*:/, "", text[at])
         if (count !~ /^[#=]/) hit[at] = 1}
        END {for (i in total) {n++; if (i in hit) h++; else print i ": " text[i] | "sort -n >" missed}
             for (i in total_b) {nb++; if (i in hit_b) hb++}
             if (n) printf "%-10s %5.1f%% of %d lines, %5.1f%% of %d branches\n", header, 100 * h / n, n, 100 * hb / nb, nb}'
done
