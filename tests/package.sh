#!/bin/sh
# Builds a test that needs packages: sh tests/package.sh tests/pkg_X.c OUT OBJECTS FLAGS, OBJECTS being a folder with the headers
# (ms.a) and oiio.o compiled already, FLAGS what leaves them to the linker. The test's comment may hold a line
# "libraries: -lEGL ..." with more of them; where those can't be linked the test is skipped (exit 77).
set -u
CC=${CC:-cc}
CXX=${CXX:-c++}
flags="-D_POSIX_C_SOURCE=200809L -I. -Itests -Iexamples/tools -Iexamples/demo -Iexamples/engine -Itests/bench -O2"
embree=-lembree3
echo '#include <embree4/rtcore.h>
int main(void) { return 0; }' >"$2.probe.c"
! $CC "$2.probe.c" -o "$2.probe" -lembree4 >/dev/null 2>&1 || embree=-lembree4
more=$(sed -n 's/.*libraries: *\(-l.*[a-zA-Z0-9]\).*/\1/p' "$1" | head -1)
if [ -n "$more" ]; then
    echo 'int main(void) { return 0; }' >"$2.probe.c"
    if ! $CC "$2.probe.c" -o "$2.probe" $more >/dev/null 2>&1; then
        echo "no $more on this machine"
        exit 77
    fi
fi
$CC -std=c99 $flags $4 -c "$1" -o "$2.o" &&
    $CXX "$2.o" "$3/oiio.o" "$3/ms.a" -o "$2" -lOpenImageIO -lOpenImageIO_Util $embree $more -lm -lpthread
