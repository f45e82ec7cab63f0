#!/bin/sh
# Every way in which a program may take some of the headers (one, or all together), each built, linked and run with
# use.h: one file and several, C and C++, static and shared libraries, -ffast-math, without stdio and malloc, renamed. One alone is
# built as one file in every language, and with -ffast-math; the ways that join objects and copies are those of all together.
# sh tests/dropin/dropin.sh OUT HEADER...
set -u
CC=${CC:-cc}
CXX=${CXX:-c++}
out=$1
shift
mkdir -p "$out/third party"
passed=0
failed=0
skipped=0
log() {
    failed=$((failed + 1))
    echo "FAIL $1"
    head -20 "$out/log"
}
works() { # NAME COMMAND...: the command succeeds
    name=$1
    shift
    if "$@" >"$out/log" 2>&1; then passed=$((passed + 1)); else log "$name: $*"; fi
}
runs() { # NAME COMPILER ARGUMENTS...: the program builds without a warning, and finds its numbers right
    name=$1
    shift
    if "$@" -o "$out/x" $libraries >"$out/log" 2>&1 && "$out/x" >"$out/log" 2>&1; then passed=$((passed + 1)); else log "$name: $*"; fi
}
upper() { echo "${1%.h}" | tr a-z A-Z; }
make_all() { for h; do echo "#define $(upper "$h")_IMPLEMENTATION"; done; }
include_all() { for h; do echo "#include \"$h\""; done; }
use='#include "tests/dropin/use.h"'
warn="-I. -Wall -Wextra -pedantic -Werror"
libraries=-lm
# The ways that differ in what is declared and linked, not in what is compiled, leave the text for SIMD out: a third of the time.
plain="-O0 -DMS_NO_SIMD"

# One file. The last two: declarations first and twice; the headers in the opposite order.
{ make_all "$@"; include_all "$@"; echo "$use"; } >"$out/one.c"
if [ $# = 1 ]; then
    runs "one file, C99" $CC -std=c99 $warn -O0 "$out/one.c"
else
    works "one file, C99" $CC -std=c99 $warn -fsyntax-only "$out/one.c"
    { include_all "$@" "$@"; make_all "$@"; include_all "$@" "$@"; echo "$use"; } >"$out/twice.c"
    runs "declared first, made once, included again" $CC -std=c99 $warn $plain "$out/twice.c"
    reversed=$(printf '%s\n' "$@" | sed '1!G;h;$!d')
    { make_all $reversed; include_all $reversed; echo "$use"; } >"$out/reversed.c"
    works "the opposite order" $CC -std=c99 $warn -fsyntax-only "$out/reversed.c"
fi
if command -v "$CXX" >/dev/null 2>&1; then
    # built and run as C++ by the other compiler in make test (clang_ of tests/run.sh), by this one in make test-long
    works "one file, c++11" $CXX -x c++ -std=c++11 $warn -fsyntax-only "$out/one.c"
    works "one file, c++20" $CXX -x c++ -std=c++20 $warn -fsyntax-only "$out/one.c" # c++17: make check-style
    [ $# -gt 1 ] || for h; do works "the example of $h, C++11" sh tests/dropin/manual.sh "$h" "$out/manual" $CXX -x c++ -std=c++11 -fsyntax-only; done
else
    skipped=$((skipped + 2 + $#))
fi

# -ffast-math promises fewer digits, no NaN handling and no equal bits, but no other results.
[ $# -gt 1 ] || runs "-ffast-math" $CC -std=c99 $warn -O1 -ffast-math "$out/one.c"
if [ $# = 1 ]; then
    echo "$passed passed, $failed failed, $skipped skipped"
    [ $failed = 0 ]
    exit
fi

# One object a header, hidden but for the public functions: linked as they are, as a static and as a shared library.
objects=""
for h; do
    printf '#define %s_IMPLEMENTATION\n#include "%s"\n' "$(upper "$h")" "$h" >"$out/${h%.h}.c"
    works "object of $h" $CC -std=c99 $warn $plain -fPIC -fvisibility=hidden '-DMS_DEF=__attribute__((visibility("default")))' -c "$out/${h%.h}.c" -o "$out/${h%.h}.o"
    objects="$objects $out/${h%.h}.o"
done
{ include_all "$@"; echo "$use"; } >"$out/user.c"
runs "objects, C user" $CC -std=c99 $warn "$out/user.c" $objects
command -v "$CXX" >/dev/null 2>&1 && runs "objects, C++ user" $CXX -x c++ -std=c++11 $warn "$out/user.c" -x none $objects
rm -f "$out/libms.a" "$out/libms.so"
works "static library" ar rc "$out/libms.a" $objects
runs "static library, linked" $CC -std=c99 $warn "$out/user.c" "$out/libms.a"
works "shared library" $CC -shared $objects -o "$out/libms.so" -lm
runs "shared library, linked" $CC -std=c99 $warn "$out/user.c" "$out/libms.so" "-Wl,-rpath,$(pwd)/$out"
declared=$(for h; do $CC -std=c99 -I. -E "$h"; done 2>/dev/null | grep -o -E '\bms_[a-z0-9]+_[a-z0-9_]+ *\(' | tr -d ' (' | grep -v '__' | sort -u)
exported=$(nm -D "$out/libms.so" | awk '$2 ~ /[A-Z]/ && $2 != "U" {print $3}' | grep -v -E '^_(init|fini|edata|end|_bss_start)$|^__bss_start$' | sort)
echo "$exported" | grep -v '^ms_' >"$out/log"
works "the shared library exports ms_ alone" test ! -s "$out/log"
for f in $exported; do echo "$declared" | grep -q -x "$f" || echo "$f is exported, but not declared"; done >"$out/log"
works "and what is declared alone" test ! -s "$out/log"

# Private copies: two files of one program each have their own.
{ echo '#define MS_DEF static'; make_all "$@"; include_all "$@"; } >"$out/copy.c"
{ cat "$out/copy.c"; echo "$use"; } >"$out/static.c"
runs "two static copies" $CC -std=c99 $warn $plain "$out/static.c" "$out/copy.c"

# Memory from use.h's arena only: neither the C library's allocator nor stdio in the object.
{ printf '#include <stdlib.h>\n#define malloc(size) NULL\n#define free(pointer) ((void)(pointer))\n'
  for h; do echo "#define $(upper "$h")_NO_STDIO"; done
  make_all "$@"; include_all "$@"; } >"$out/bare.c"
works "no stdio, no malloc" $CC -std=c99 $warn $plain -c "$out/bare.c" -o "$out/bare.o"
nm "$out/bare.o" | awk '$1 == "U" {print $2}' | grep -E '^_?(malloc|calloc|realloc|free|qsort|f(open|close|read|write|seek|tell|stat)|remove|v?s?n?printf|open|close|read|write|m(un)?map)$' >"$out/log"
works "the object calls neither" test ! -s "$out/log"
runs "no stdio, no malloc, linked" $CC -std=c99 $warn "$out/user.c" "$out/bare.o"

# In a folder, under another name: ms_x.h includes itself again, as MS_X_FILENAME says.
{ for h; do cp "$h" "$out/third party/renamed_$h"; echo "#define $(upper "$h")_FILENAME \"renamed_$h\""; done
  make_all "$@"
  for h; do echo "#include \"third party/renamed_$h\""; done; } >"$out/renamed.c"
works "renamed, in a folder" $CC -std=c99 -Wall -Wextra -pedantic -Werror -fsyntax-only "$out/renamed.c"

echo "$passed passed, $failed failed, $skipped skipped"
[ $failed = 0 ]
