#!/bin/sh
# What a header adds to a program: no public symbol and no macro without the ms_ prefix, no writable global, no malloc
# but through the allocator, no stdio when told so. sh tests/compile/symbols.sh HEADER OUT
set -eu
name=${1%.h}
upper=$(echo "$name" | tr a-z A-Z)
CC=${CC:-cc}
bad=0
fail() { echo "$1: $2"; bad=$((bad + 1)); }
printf '#define %s_IMPLEMENTATION\n#include "%s"\n' "$upper" "$1" >"$2.c"
$CC -std=c99 -O2 -I. -c "$2.c" -o "$2.o"
globals=$(nm "$2.o" | awk 'NF == 3 && $2 ~ /[A-Z]/ && $2 != "U" && $3 !~ /^_?ms_/ {print $3}')
[ -z "$globals" ] || fail "$1" "symbols without the prefix: $globals"
writable=$(nm -f sysv "$2.o" | awk -F'|' '$3 ~ /[bBdDC]/ && $7 !~ /rel\.ro/ {print $1}') # .data.rel.ro: constant tables of pointers
[ -z "$writable" ] || fail "$1" "writable globals: $writable"
printf '#define %s_NO_STDIO\n#define %s_IMPLEMENTATION\n#include "%s"\n' "$upper" "$upper" "$1" >"$2.nostdio.c"
$CC -std=c99 -O2 -I. -c "$2.nostdio.c" -o "$2.nostdio.o"
stdio=$(nm "$2.nostdio.o" | awk '$1 == "U" {print $2}' | grep -E '^_?(f?printf|puts|fopen|fclose|fread|fwrite|fputs|fgets|sn?printf|vsn?printf|stdout|stderr|exit|abort|rand|srand|strtod|atof|setlocale)$' || true)
[ -z "$stdio" ] || fail "$1" "with NO_STDIO still calls: $stdio"
any=$(nm "$2.o" | awk '$1 == "U" {print $2}' | grep -E '^_?(printf|puts|stdout|stderr|exit|abort|rand|srand|strtod|atof|setlocale)$' || true)
[ -z "$any" ] || fail "$1" "calls: $any"
# Macros: what is defined after the header and was not defined by the standard headers it includes.
grep -h -E '^ *# *include *<' "$1" | sort -u >"$2.base.c"
sed -i.bak -e '/immintrin\|intrin.h\|cpuid\|arm_neon\|windows\|sys\//d' "$2.base.c"
$CC -std=c99 -dM -E -I. "$2.base.c" 2>/dev/null | awk '{print $2}' | sed 's/(.*//' | sort -u >"$2.before" || true
printf '#include "%s"\n' "$1" >"$2.declare.c"
$CC -std=c99 -dM -E -I. "$2.declare.c" | awk '{print $2}' | sed 's/(.*//' | sort -u >"$2.after"
macros=$(comm -13 "$2.before" "$2.after" | grep -v -E '^MS_' || true)
[ -z "$macros" ] || fail "$1" "macros without the prefix: $(echo $macros)"
$CC -std=c99 -O2 -dM -E -I. "$2.c" | awk '{print $2}' | sed 's/(.*//' | sort -u | grep -E "^${upper}__" >"$2.private" || true
[ ! -s "$2.private" ] || fail "$1" "private macros left defined: $(head -5 "$2.private" | tr '\n' ' ')"
size "$2.o" | tail -1 | awk -v h="$1" '{print h ": " $1 " bytes of code and constants at -O2"}'
echo "$((6 - bad)) passed, $bad failed"
[ $bad = 0 ]
