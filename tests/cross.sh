#!/bin/sh
# The headers on other machines and C libraries, where the compiler and the emulator are installed; installs nothing.
#   sh tests/cross.sh                the names of the machines
#   sh tests/cross.sh MACHINE OUT    builds and runs there; exit 77 with the reason where that is not possible
# Everywhere: all headers in one program (tests/dropin/use.h), every file format (tests/fuzz with its corpus, the tests of
# the readers and writers: byte order, 32-bit sizes). Where programs run at full speed: every test.
set -u
if [ $# -eq 0 ]; then
    echo "x86_32 arm64 armv7 s390x ppc64 windows wasm musl tcc"
    exit 0
fi
out=$2
mkdir -p "$out"
flags="-std=c99 -O1 -D_POSIX_C_SOURCE=200809L -D_FILE_OFFSET_BITS=64"
libraries="-lm -lpthread"
emulator=""
suffix=""
everything=no
case $1 in
x86_32) compiler="gcc -m32 -msse2 -mfpmath=sse" everything=yes ;; # x87 registers would round twice
arm64) compiler="aarch64-linux-gnu-gcc -static" emulator=qemu-aarch64 ;;
armv7) compiler="arm-linux-gnueabihf-gcc -static" emulator=qemu-arm ;;
s390x) compiler="s390x-linux-gnu-gcc -static" emulator=qemu-s390x ;;
ppc64) compiler="powerpc64-linux-gnu-gcc -static" emulator=qemu-ppc64 ;;
windows)
    compiler="x86_64-w64-mingw32-gcc -static -D__USE_MINGW_ANSI_STDIO=1" emulator=wine suffix=.exe
    WINEPREFIX=$(pwd)/$out/wine WINEDEBUG=-all DISPLAY=
    export WINEPREFIX WINEDEBUG DISPLAY ;;
wasm) compiler="emcc -sNODERAWFS=1 -sWASM_ASYNC_COMPILATION=0 -sALLOW_MEMORY_GROWTH=1 -sEXIT_RUNTIME=1" emulator=node suffix=.js libraries=-lm ;;
musl) compiler="musl-gcc -static" everything=yes ;;
tcc) compiler="tcc -DMS_NO_SIMD" ;;
*) echo "unknown machine '$1'" >&2; exit 2 ;;
esac

echo 'int main(void) { return 0; }' >"$out/probe.c"
for tool in ${compiler%% *} $emulator; do
    command -v "$tool" >/dev/null 2>&1 || { echo "no $tool on this machine"; exit 77; }
done
$compiler "$out/probe.c" -o "$out/probe$suffix" $libraries >"$out/log" 2>&1 || { echo "${compiler%% *} cannot build a program here: $(tail -1 "$out/log")"; exit 77; }
$emulator "$out/probe$suffix" >"$out/log" 2>&1 || { echo "${emulator:-this machine} cannot run it: $(tail -1 "$out/log")"; exit 77; }

passed=0
failed=0
build() { # NAME SOURCE...
    program=$out/$1$suffix
    shift
    $compiler $flags -I. -Itests -Iexamples/tools -Iexamples/demo -Iexamples/engine -Itests/bench "$@" -o "$program" $libraries >"$out/log" 2>&1 && return 0
    echo "FAIL to build $*"
    head -20 "$out/log"
    failed=$((failed + 1))
    return 1
}
runs() { # NAME ARGUMENTS...: the program that was built last; cases that it counts are counted
    name=$1
    shift
    $emulator "$program" "$@" >"$out/log" 2>&1
    rc=$?
    cases=$(tr -d '\r' <"$out/log" | sed -n 's/^\([0-9]*\) passed, 0 failed.*/\1/p' | tail -1)
    if [ $rc -eq 0 ] && [ "${cases:-1}" != 0 ]; then passed=$((passed + ${cases:-1})); else
        echo "FAIL $name $* (exit $rc)"
        grep -v '^ok' "$out/log" | tail -20
        failed=$((failed + 1))
    fi
}

{ for h in ms_*.h; do echo "#define $(echo "${h%.h}" | tr a-z A-Z)_IMPLEMENTATION"; done
  for h in ms_*.h; do echo "#include \"$h\""; done
  echo '#include "tests/dropin/use.h"'; } >"$out/use.c"
build use "$out/use.c" && runs use

for f in tests/fuzz/fuzz_*.c; do
    n=$(basename "$f" .c)
    build "$n" "$f" tests/fuzz/replay.c && runs "$n" "tests/fuzz/corpus_${n#fuzz_}"
done

if [ $everything = yes ]; then
    for t in tests/test_*.c; do
        n=$(basename "$t" .c)
        build "$n" "$t" && runs "$n"
    done
else # the cases that read or write files, or pack bytes
    build test_image tests/test_image.c && runs test_image
    build test_nn_format tests/test_nn_format.c && runs test_nn_format
    build test_nn tests/test_nn.c && runs test_nn "reference networks"
    build test_gpr tests/test_gpr.c && runs test_gpr files
    build test_sss_kernel tests/test_sss_kernel.c && runs test_sss_kernel "csv files"
    build test_mcml tests/test_mcml.c && runs test_mcml damaged_tallies
fi
echo "$passed passed, $failed failed"
[ $failed = 0 ]
