#!/bin/sh
# Every example alone, with the line that its comment gives: sh tests/alone.sh OUT. CC takes the place of cc, OUT that of
# build, and -O0 without SIMD text, which takes a third of the time, that of -O2.
set -u
out=$1
mkdir -p "$out"
passed=0
failed=0
for f in examples/*/*.c; do
    case $f in examples/web/*) continue ;; esac # by examples/web/build.sh
    ! grep -q '"egl.h"' "$f" || continue      # its headers are not everywhere
    line=$(sed -n '1,/\*\//s/.*\(cc -O2 .*-I\. .*examples\/.*-lm\).*/\1/p' "$f" | head -1)
    n=$(basename "$f" .c)
    case $line in
    *" $f -o build/$n "* | *"-shared "*" $f -o lib"*)
        if (eval "$(echo "$line" | sed "s|^cc -O2|${CC:-cc} -O0 -DMS_NO_SIMD|; s|-o build/|-o $out/|; s|-o lib|-o $out/lib|")") >"$out/log" 2>&1; then
            passed=$((passed + 1))
            continue
        fi ;;
    *) echo "no line that compiles it" >"$out/log" ;;
    esac
    failed=$((failed + 1))
    echo "FAIL $f: $line"
    head -5 "$out/log"
done
echo "$passed passed, $failed failed"
[ $failed = 0 ] && [ $passed -gt 0 ]
