#!/bin/sh
# What a header adds to a program: no public symbol and no macro without the ms_ prefix, no writable global, no printing,
# exit or locale. Reads with nm the object that the examples link, if there is one. (Files and memory: dropin.sh.)
# sh tests/dropin/symbols.sh HEADER OUT
set -eu
name=${1%.h}
upper=$(echo "$name" | tr a-z A-Z)
CC=${CC:-cc}
checks=0
bad=0
none() { # WHAT, LIST: the list must be empty
    checks=$((checks + 1))
    [ -z "$2" ] || { echo "$name.h has $1: $(echo $2)"; bad=$((bad + 1)); }
}
undefined() { nm "$object" | awk '$1 == "U" {print $2}' | grep -E "^_?($1)\$" || true; }
macros() { $CC -std=c99 -dM -E -I. "$1" | awk '{print $2}' | sed 's/(.*//' | sort -u; }

printf '#define %s_IMPLEMENTATION\n#include "%s"\n' "$upper" "$1" >"$2.c"
object=build/$name.o
if [ ! -f "$object" ] || [ "$object" -ot "$1" ]; then
    object=$2.o
    $CC -std=c99 -O1 -I. -c "$2.c" -o "$object"
fi
none "symbols without the prefix" "$(nm "$object" | awk 'NF == 3 && $2 ~ /[A-Z]/ && $2 != "U" && $3 !~ /^_?ms_/ {print $3}')"
none "writable globals" "$(nm -f sysv "$object" | awk -F'|' '$3 ~ /[bBdDC]/ && $7 !~ /rel\.ro/ {print $1}')" # .data.rel.ro: constant tables of pointers
none "calls that print, end the program or heed the locale" \
    "$(undefined 'f?printf|puts|fputs|putchar|stdout|stderr|exit|_exit|abort|raise|s?rand|strtod|atof|scanf|setlocale|getenv|errno|__errno_location')"
none "library calls that may allocate" "$(undefined 'calloc|realloc|aligned_alloc|posix_memalign|strdup|qsort|getline')"

# Macros: what is defined after the header and was not by the standard headers that it includes.
grep -h -E '^ *# *include *<' "$1" | sort -u | sed '/<io\.h>\|immintrin\|intrin.h\|cpuid\|arm_neon\|windows\|sys\//d' >"$2.base.c"
macros "$2.base.c" >"$2.before"
printf '#include "%s"\n' "$1" >"$2.declare.c"
macros "$2.declare.c" >"$2.after"
none "macros without the prefix" "$(comm -13 "$2.before" "$2.after" | grep -v -E '^MS_' || true)"
none "private macros left defined" "$(macros "$2.c" | grep -E "^${upper}__" || true)"
echo "$((checks - bad)) passed, $bad failed"
[ $bad = 0 ]
