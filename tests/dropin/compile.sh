#!/bin/sh
# Every way in which a program may take the headers: alone, twice, declarations first, all in one file in both orders,
# in several files linked together, C beside C++, static copies, a renamed copy in a folder. sh tests/compile/compile.sh OUT
set -u
CC=${CC:-cc}
CXX=${CXX:-c++}
out=$1
mkdir -p "$out/third party"
passed=0
failed=0
try() { # NAME COMMAND...
    name=$1
    shift
    if "$@" >"$out/log" 2>&1; then passed=$((passed + 1)); else
        failed=$((failed + 1))
        echo "FAIL $name: $*"
        head -20 "$out/log"
    fi
}
warn="-Wall -Wextra -pedantic -Werror"
headers=$(ls ms_*.h)
up() { echo "${1%.h}" | tr a-z A-Z; }
include_all() { for h in $1; do echo "#include \"$h\""; done; }
reversed=$(echo "$headers" | sed '1!G;h;$!d')
cxx=no
! command -v "$CXX" >/dev/null 2>&1 || cxx=yes
echo 'int main(void) { return 0; }' >"$out/main.c"

for h in $headers; do
    H=$(up "$h")
    n=${h%.h}
    printf '#include "%s"\n#include "%s"\nint main(void) { return (int)ms_status_string(MS_OK)[0] == 0; }\n' "$h" "$h" >"$out/$n.declare.c"
    printf '#include "%s"\n#define %s_IMPLEMENTATION\n#include "%s"\n#include "%s"\nint main(void) { return 0; }\n' "$h" "$H" "$h" "$h" >"$out/$n.both.c"
    printf '#define %s_IMPLEMENTATION\n#include "%s"\n' "$H" "$h" >"$out/$n.c"
    try "$n declarations as C" $CC -std=c99 $warn -I. "$out/$n.declare.c" -o "$out/x" -lm
    try "$n twice, then made, as C" $CC -std=c99 $warn -O1 -I. "$out/$n.both.c" -o "$out/x" -lm
    try "$n static, unused" $CC -std=c99 $warn -O1 -DMS_DEF=static -I. "$out/$n.both.c" -o "$out/x" -lm
    try "$n as C, object" $CC -std=c99 $warn -O1 -I. -c "$out/$n.c" -o "$out/$n.o"
    try "$n with -ffast-math" $CC -std=c99 -Wall -Wextra -O2 -ffast-math -I. -c "$out/$n.c" -o "$out/x.o"
    cp "$h" "$out/third party/renamed_$h"
    printf '#define %s_FILENAME "renamed_%s"\n#define %s_IMPLEMENTATION\n#include "third party/renamed_%s"\n' "$H" "$h" "$H" "$h" >"$out/$n.renamed.c"
    try "$n renamed, in a folder" $CC -std=c99 $warn -O1 -c "$out/$n.renamed.c" -o "$out/x.o"
    [ $cxx = no ] || try "$n as C++" $CXX -x c++ -std=c++11 $warn -O1 -I. "$out/$n.both.c" -o "$out/x" -lm
done

for order in "$headers" "$reversed"; do
    { for h in $order; do echo "#define $(up "$h")_IMPLEMENTATION"; done
      include_all "$order"
      echo 'int main(void) { return 0; }'; } >"$out/all.c"
    try "all in one file as C" $CC -std=c99 $warn -O1 -I. "$out/all.c" -o "$out/x" -lm
    [ $cxx = no ] || try "all in one file as C++" $CXX -x c++ -std=c++11 $warn -O1 -I. "$out/all.c" -o "$out/x" -lm
    { include_all "$order"
      for h in $order; do printf '#define %s_IMPLEMENTATION\n#include "%s"\n' "$(up "$h")" "$h"; done
      echo 'int main(void) { return 0; }'; } >"$out/all.c"
    try "all declared, then all made" $CC -std=c99 $warn -O1 -I. "$out/all.c" -o "$out/x" -lm
done
{ include_all "$headers"; echo 'int main(void) { return 0; }'; } >"$out/user.c"
try "one object a header, linked" $CC -std=c99 $warn -I. "$out/user.c" $(for h in $headers; do echo "$out/${h%.h}.o"; done) -o "$out/x" -lm
if [ $cxx = yes ]; then
    { include_all "$headers"; echo 'int main() { return 0; }'; } >"$out/user.cpp"
    try "C objects, C++ user" $CXX -std=c++11 $warn -I. "$out/user.cpp" $(for h in $headers; do echo "$out/${h%.h}.o"; done) -o "$out/x" -lm
fi
{ for h in $headers; do echo "#define $(up "$h")_IMPLEMENTATION"; done; echo '#define MS_DEF static'; include_all "$headers"; } >"$out/static1.c"
{ cat "$out/static1.c"; echo 'int main(void) { return 0; }'; } >"$out/static2.c"
try "two static copies linked" $CC -std=c99 $warn -O1 -I. "$out/static1.c" "$out/static2.c" -o "$out/x" -lm
{ for h in $headers; do echo "#define $(up "$h")_IMPLEMENTATION"; done; echo '#define MS_DEF __attribute__((visibility("default")))'; include_all "$headers"; } >"$out/shared.c"
try "shared library, hidden by default" $CC -std=c99 $warn -O1 -fPIC -shared -fvisibility=hidden -I. "$out/shared.c" -o "$out/libms.so" -lm
echo "$passed passed, $failed failed"
[ $failed = 0 ]
