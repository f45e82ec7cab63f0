#!/bin/sh
# Macros: a header defines and undefines names that begin with MS_ or ms_ alone, and is not disturbed by those that
# windows.h and others define. sh tests/dropin/macros.sh OUT HEADER...
set -u
CC=${CC:-cc}
CXX=${CXX:-c++}
out=$1
shift
mkdir -p "$out"
passed=0
failed=0
none() { # WHAT, FILE: it must be empty
    if [ -s "$2" ]; then
        failed=$((failed + 1))
        echo "FAIL $1: $(tr '\n' ' ' <"$2" | cut -c1-300)"
    else passed=$((passed + 1)); fi
}
upper() { echo "${1%.h}" | tr a-z A-Z; }
macros() { $CC -std=c99 -I. -dM -E "$1" | sed 's/^#define //' | sort; }

for h; do
    # the text, whatever the platform
    grep -n -o -E '^ *# *(define|undef) +[A-Za-z_0-9]+' "$h" | grep -v -E '(define|undef) +(MS_|ms_)' >"$out/text"
    none "$h defines or undefines names of others" "$out/text"
    # what the preprocessor knows before and after, values included; what the system's headers bring stands on both sides
    grep -h -E '^ *# *include *<' "$h" | sort -u | grep -v -E '<(io|intrin|immintrin|[a-z0-9]*intrin|cpuid|arm_neon)\.h' >"$out/base.h"
    [ "$(uname -m)" != x86_64 ] || grep -q simd "$h" && printf '#include <immintrin.h>\n#include <cpuid.h>\n' >>"$out/base.h"
    awk 'BEGIN {for (i = 0; i < 26; i++) {c = sprintf("%c", 65 + i); print "#define " c " own_" c; print "#define " c "_" c " own"}
                n = split("V_LOAD V_ADD V_SET V_BITS B_DOT W_HALF MIN MAX CLAMP PI ABS SQUARE SWAP COUNT LANES LEVEL", name, " ")
                for (i = 1; i <= n; i++) print "#define " name[i] " own"}' >"$out/own.h"
    cat "$out/base.h" "$out/own.h" >"$out/before.c"
    { cat "$out/before.c"; echo "#define $(upper "$h")_IMPLEMENTATION"; echo "#include \"$h\""; } >"$out/after.c"
    macros "$out/before.c" | grep -v -E '^(MS_|ms_)' >"$out/before"
    macros "$out/after.c" | grep -v -E '^(MS_|ms_)' >"$out/after"
    comm -3 "$out/before" "$out/after" | tr -s '\t' ' ' >"$out/changed"
    none "macros that $h adds (second column: takes away or changes)" "$out/changed"
done

# One file with everything behind the macros of windows.h and of a user who likes short names.
{ cat tests/dropin/foreign.h; for h; do echo "#define $(upper "$h")_IMPLEMENTATION"; echo "#include \"$h\""; done; } >"$out/unity.c"
$CC -std=c99 -I. -Wall -Wextra -Werror -fsyntax-only "$out/unity.c" 2>&1 | grep -m 5 error >"$out/log"
none "a unity build in C" "$out/log"
if command -v "$CXX" >/dev/null 2>&1; then
    $CXX -x c++ -std=c++11 -I. -Wall -Wextra -Werror -fsyntax-only "$out/unity.c" 2>&1 | grep -m 5 error >"$out/log"
    none "a unity build in C++" "$out/log"
fi
echo "$passed passed, $failed failed"
[ $failed = 0 ]
