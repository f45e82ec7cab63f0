#!/bin/sh
# What a header costs a program: a table of lines and of bytes of code and constants in its object, whole and as small as it
# gets, in build/bench/sizes.md (for README, between <!-- bench:sizes --> and <!-- end -->).
set -eu
CC=${CC:-cc}
mkdir -p build/bench
kilobytes() { # HEADER FLAGS...
    printf '#define %s_IMPLEMENTATION\n#include "%s"\n' "$(echo "${1%.h}" | tr a-z A-Z)" "$1" >build/bench/size.c
    shift
    $CC -std=c99 -I. "$@" -c build/bench/size.c -o build/bench/size.o
    size build/bench/size.o | awk 'NR == 2 {printf "%.0f", ($1 + $2 + $3) / 1000}'
}
{
    echo "Kilobytes of code and constants in the object (no writable globals), $($CC --version | head -1), $(uname -m); \`make sizes\`."
    echo
    echo "| header | lines | \`-O2\` | \`-O2\`, no SIMD | \`-Os\`, no SIMD, no stdio |"
    echo "|---|---:|---:|---:|---:|"
    for h in ms_*.h; do
        no_stdio="-D$(echo "${h%.h}" | tr a-z A-Z)_NO_STDIO"
        echo "| \`$h\` | $(wc -l <"$h" | tr -d ' ') | $(kilobytes "$h" -O2) | $(kilobytes "$h" -O2 -DMS_NO_SIMD) | $(kilobytes "$h" -Os -DMS_NO_SIMD "$no_stdio") |"
    done
    echo "| \`ms_sss.h\`, \`MS_SSS_NO_DESIGN\` | | $(kilobytes ms_sss.h -O2 -DMS_SSS_NO_DESIGN) | $(kilobytes ms_sss.h -O2 -DMS_SSS_NO_DESIGN -DMS_NO_SIMD) | $(kilobytes ms_sss.h -Os -DMS_SSS_NO_DESIGN -DMS_NO_SIMD -DMS_SSS_NO_STDIO) |"
} >build/bench/sizes.md
cat build/bench/sizes.md
