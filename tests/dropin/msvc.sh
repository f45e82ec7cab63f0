#!/bin/sh
# All headers for Windows by Clang, as clang-cl takes them (Microsoft's macros, intrinsics by level, no GNU macros), over stubs of
# the C headers in msvc/; C and C++, alone and after windows.h's macros. sh tests/dropin/msvc.sh OUT HEADER...
set -u
out=$1
shift
mkdir -p "$out"
if ! command -v clang >/dev/null 2>&1; then
    echo "no clang on this machine"
    exit 77
fi
passed=0
failed=0
flags="-target x86_64-pc-windows-msvc -nostdlibinc -fms-extensions -fms-compatibility-version=19.30 -isystem tests/dropin/msvc -I. -Wall -Wextra -Werror -O0"
for h; do
    upper=$(echo "${h%.h}" | tr a-z A-Z)
    printf '#include "%s"\n' "$h" >"$out/plain.c"
    printf '#include <windows.h>\n#include "%s"\n' "$h" >"$out/windows.c"
    for file in plain windows; do
        for language in "-x c -std=c99" "-x c++ -std=c++14"; do
            case "$file $language" in "plain -x c "*) only=-c ;; *) only=-fsyntax-only ;; esac # which intrinsics a level has is seen once
            if clang $language $flags "-D${upper}_IMPLEMENTATION" $only "$out/$file.c" -o "$out/$file.o" >"$out/log" 2>&1; then
                passed=$((passed + 1))
            else
                failed=$((failed + 1))
                echo "FAIL $h, $file, $language"
                grep -m 5 error "$out/log"
            fi
        done
    done
done
echo "$passed passed, $failed failed"
[ $failed = 0 ]
