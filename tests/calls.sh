#!/bin/sh
# Every public call of a header while the header's own tests run: sh tests/calls.sh OUT HEADER MODES [-O2|-O0],
# MODES being one or several of stack, traps and flush with commas between.
#   stack   at most 32 KB of stack at -O2 and 64 KB at -O0; also lists the functions that no test calls. (A task that the
#           caller's threads run takes no more than the call that hands it out, which runs them itself without threads.)
#   traps   unmasked floating-point exceptions never trap; lists function and line of those that do
#   flush   the tests pass where the host flushes subnormals to zero
# CASES: part of the cases' names. The calls are caught in the assembler text: the function is renamed, and its name becomes a
# jump to tests/calls.c. The header is compiled once, and again only in tests that call its private functions.
set -u
out=$1
header=$2
modes=$(echo "$3" | tr , ' ')
case $modes in *stack*flush*) modes="stack,flush $(echo "$modes" | sed 's/stack//; s/flush//')" ;; esac # of one run
level=${4:--O2}
mkdir -p "$out"
case $level in -O0) limit=65536 ;; *) limit=32768 ;; esac
if [ "$(uname -sm)" != "Linux x86_64" ] || ! gcc --version >/dev/null 2>&1; then
    echo "calls are caught with GCC on x86-64 Linux alone"
    exit 77
fi
name=${header%.h}
flags="-std=c99 -D_POSIX_C_SOURCE=200809L -I. -Itests -Iexamples/tools -Iexamples/demo -Iexamples/engine -Itests/bench"
printf '#define %s_IMPLEMENTATION\n#include "%s"\n' "$(echo "$name" | tr a-z A-Z)" "$header" >"$out/names.c"
gcc $flags -O0 -c "$out/names.c" -o "$out/names.o" || exit 1
nm "$out/names.o" | awk -v p="^${name}_" '$2 == "T" && $3 ~ p {print $3}' >"$out/names"
awk '{
    print "s/^" $1 ":$/real_" $1 ":/"
    print "s/^\t\\.globl\t" $1 "$/\t.globl\treal_" $1 "/"
    print "s/^\t\\.type\t" $1 ", @function$/\t.type\treal_" $1 ", @function/"
    print "s/^\t\\.size\t" $1 ", \\.-" $1 "$/\t.size\treal_" $1 ", .-real_" $1 "/"
}' "$out/names" >"$out/rename.sed"
awk 'BEGIN {print "\t.text"}
{ print "\t.globl " $1 "\n" $1 ":\n\tlea 1f(%rip), %r10\n\tmov real_" $1 "@GOTPCREL(%rip), %r11\n\tjmp calls_enter\n1:\t.string \"" $1 "\"" }
END {print "\t.section .note.GNU-stack,\"\",@progbits"}' "$out/names" >"$out/enter.s"
gcc -O1 -fno-stack-protector -c tests/calls.c -o "$out/calls.o" && gcc -c "$out/enter.s" -o "$out/enter.o" || exit 1
rm -f "$out/report"
failed=0
# assembler FILE OUT FLAGS. -fPIC: a public function may be replaced when the program is linked, so that no call of it is inlined
assembler() {
    gcc $flags $level $3 -g1 -w -fPIC -fsemantic-interposition -S "$1" -o "$2.raw" && sed -f "$out/rename.sed" "$2.raw" >"$2"
}
upper=$(echo "$name" | tr a-z A-Z)
assembler "$out/names.c" "$out/names.s" "" && gcc -c "$out/names.s" -o "$out/names.o" || exit 1
for t in tests/test_*.c; do
    grep -q "include \"$header\"" "$t" || continue
    n=$(basename "$t" .c)
    case $n in *_big_endian | test_memory) continue ;; esac
    if grep -q -E "(${name}|$upper|\bms)__|include \"(io|[a-z]*_inside)\.h\"" "$t"; then assembler "$t" "$out/$n.s" "" || exit 1; part=
    else assembler "$t" "$out/$n.s" "-D${upper}_IMPLEMENTED" || exit 1; part=$out/names.o
    fi
    gcc -no-pie "$out/$n.s" $part "$out/enter.o" "$out/calls.o" -o "$out/$n" -lm -lpthread -Wl,--unresolved-symbols=ignore-all || exit 1
    its=$modes # what a renderer by ms_nn.h takes of the stack is not that of ms_pme_match
    [ "$n" != test_pme_match ] || its=$(echo "$modes" | sed 's/stack,*//')
    for mode in $its; do
        if ! CALLS=$mode CALLS_REPORT="$out/report.$n" "$out/$n" ${CASES:-} >"$out/$n.log" 2>&1; then
            failed=$((failed + 1))
            echo "FAIL $n with $mode:"
            grep -v '^ok' "$out/$n.log" | tail -12
        fi
        grep '^TRAP' "$out/report.$n" | while read -r trap function address; do
            echo "FAIL $function traps: $(addr2line -i -e "$out/$n" "$address" | grep -m 1 "$header" | sed 's/.*\///; s/ (.*//')"
        done | sort -u >"$out/trapped"
        cat "$out/trapped"
        failed=$((failed + $(wc -l <"$out/trapped")))
        grep -v '^TRAP' "$out/report.$n" >>"$out/report"
        rm -f "$out/report.$n"
    done
done
[ -n "${CASES:-}" ] || awk 'NR == FNR {seen[$1] = 1; next} !($1 in seen) {print "  no test calls " $1}' "$out/report" "$out/names"
sort -k1,1 -k2,2nr "$out/report" | awk '!seen[$1]++' | sort -k2,2nr >"$out/sorted"
awk -v limit=$limit -v level=$level -v header="$header" -v failed=$failed '
    NR <= 3 {top = top sprintf("%s%s %d", NR > 1 ? ", " : "", $1, $2)}
    $2 > limit {printf "FAIL %s: %d bytes of stack at %s, at most %d\n", $1, $2, level, limit; bad++; next}
    {good++}
    END {if (top !~ / 0$/) printf "%s %s: deepest %s bytes\n", header, level, top
         printf "%d passed, %d failed\n", good, bad + failed; exit bad + failed > 0 || good == 0}' "$out/sorted"
