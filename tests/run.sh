#!/bin/sh
# Runs a group of tests, two programs at a time (test: three), and ends with "N passed, N failed, N skipped".
#   sh tests/run.sh check      what needs a C compiler only: a minute and a half
#   sh tests/run.sh test       check, the headers without SIMD and as C++ by another compiler, every way to use them, packages: eight minutes
#   sh tests/run.sh long       what test leaves out: the long versions at -O3, fused products and sums, GCC's C++, stack of every call
#   sh tests/run.sh style      warnings as errors: GCC and Clang, C99 and C++11, -O0 and -O3, 32-bit where there is one
#   sh tests/run.sh sanitize   address and undefined-behavior sanitizers
#   sh tests/run.sh thread     thread sanitizer;   valgrind, fuzz, soak: as they say
#   sh tests/run.sh calls      every public call: stack, traps, flushed subnormals, at -O2 and -O0
#   sh tests/run.sh attack     random valid calls with a fresh seed under sanitizers (tests/attack; ATTACK_SECONDS of processor time, 600)
#   sh tests/run.sh cross      other machines and C libraries, those whose compiler (and emulator) is installed
# Called by make from the repository's root. CC, CXX, CFLAGS, JOBS (2), FILTER (parts of jobs' names), SHUFFLE (a number: the jobs in a
# random order of that number, two or more at a time: nothing may depend on it), FUZZ_SECONDS (20), SINCE (a commit:
# style, sanitize and long only for the files that differ from it, headers without their rarer options).
# Each job writes build/run/GROUP/NAME.log; the log of a failed one is shown. Seconds are of processor time; build/run/GROUP/seconds
# lists them for every job, the dearest first, with those of the clock behind them.
set -u

# --- one job (called through xargs): run it, count what it says, keep its log -------------------------------------
if [ "${1:-}" = --one ]; then
    [ $# -gt 1 ] || exit 0 # no job at all
    job=$2
    log=${job%.job}.log
    start=$(date +%s)
    sh "$job" >"$log" 2>&1
    rc=$?
    clock=$(($(date +%s) - start))
    times >"$log.times" # its second line: of the children, user and system
    processor=$(awk 'NR == 2 {for (i = 1; i <= 2; i++) {split($i, t, "[ms]"); s += 60 * t[1] + t[2]}; printf "%.1f", s}' "$log.times")
    rm -f "$log.times"
    line=$(grep -E '^[0-9]+ passed, [0-9]+ failed' "$log" | tail -1)
    if [ $rc -eq 77 ]; then counts="0 0 1" # a job that can't run here exits with 77 after a line that says why
    elif [ -n "$line" ]; then
        counts=$(echo "$line" | awk '{print $1, $3, $5 + 0}')
        [ $rc -eq 0 ] || [ "$(echo "$counts" | cut -d' ' -f2)" != 0 ] || counts="$(echo "$counts" | awk '{print $1, $2 + 1, $3}')"
    elif [ $rc -eq 0 ]; then counts="1 0 0" # says nothing: a compilation
    else counts="0 1 0"
    fi
    [ "$counts" != "0 0 0" ] || { counts="0 1 0"; echo "no case ran" >>"$log"; }
    echo "$counts" >"${job%.job}.counts"
    name=$(basename "$job" .job | cut -d- -f2-)
    echo "$processor $clock $name" >"${job%.job}.seconds"
    set -- $counts
    if [ "$2" != 0 ]; then
        echo "FAIL $name (exit $rc)"
        grep -v -E '^ok  ' "$log" | tail -40 | sed 's/^/    /'
    elif [ "$3" != 0 ] && [ "$1" = 0 ]; then echo "skip $name: $(tail -1 "$log")"
    else echo "ok   $name: $1 passed$([ "$3" = 0 ] || echo ", $3 skipped")$([ "${processor%.*}" -lt 5 ] || echo " ($processor s of processor time)")"
    fi
    exit 0
fi

group=${1:?usage: sh tests/run.sh check|test|long|style|sanitize|thread|valgrind|fuzz|soak|calls|attack|cross}
CC=${CC:-cc}
CXX=${CXX:-c++}
CFLAGS=${CFLAGS:--O2}
JOBS=${JOBS:-2}
out=build/run/$group
rm -rf "$out"
mkdir -p "$out"
number=1000

warn="-Wall -Wextra -pedantic -Wconversion -Wsign-conversion -Wshadow -Wdouble-promotion -Wvla -Wcast-align -Wundef"
warn_c="$warn -Wstrict-prototypes -Wmissing-prototypes"
posix="-D_POSIX_C_SOURCE=200809L"
paths="-I. -Itests -Iexamples/tools -Iexamples/demo -Iexamples/engine -Itests/bench"
headers=$(ls ms_*.h)

# job NAME COMMAND: a line of shell; false where FILTER leaves it out
job() {
    [ -z "${FILTER:-}" ] || {
        found=""
        for part in $FILTER; do case $1 in *"$part"*) found=1 ;; esac; done
        [ -n "$found" ] || return 1
    }
    number=$((number + 1))
    printf '%s\n' "$2" >"$out/$number-$1.job"
}

# since FILE...: has one of them changed since that commit? Always where none is given
changes=""
[ -z "${SINCE:-}" ] || changes=$(git diff --name-only "$SINCE" -- | tr '\n' ' ')
since() {
    [ -n "${SINCE:-}" ] || return 0
    for file; do case " $changes" in *" $file "*) return 0 ;; esac; done
    return 1
}
# used FILE: it and all that it includes of this repository; reached FILE: the headers among them
used() {
    list=$out/used/$(echo "$1" | tr / _)
    [ -f "$list" ] || { mkdir -p "$out/used" && $CC -std=c99 $posix $paths -MM -MG "$1" 2>/dev/null | tr -s ' \\' '\n\n' | sed 's/^\.\///' | grep '\.[ch]$' | sort -u >"$list"; }
    cat "$list"
}
reached() { used "$1" | grep -x 'ms_[a-z]*\.h'; }

have() { command -v "$1" >/dev/null 2>&1; }

# compiles FLAGS: can this compiler build and link an empty program with them?
compiles() {
    echo 'int main(void) { return 0; }' >"$out/probe.c"
    "$@" "$out/probe.c" -o "$out/probe" >/dev/null 2>&1
}

# Long to run for what they add: check and test leave them out.
long="test_nn_big_endian test_memory"
# What make test leaves to test-long: without SIMD, what reaches no text for it (kernels of ms_sss.h, all of ms_pme.h); in other builds, the
# trainer, which is compiled once for all and takes forward and backward passes that test_nn compares there.
not_scalar="test_sss_kernel test_pme test_pme_match test_pool test_train"
not_clang="test_train"

# objects PREFIX COMPILER LANGUAGE-FLAGS HEADER...: these compiled once for all that is linked with OUT/PREFIXms.a; a warning fails
# the job, not the programs. Check and test take the objects of the examples for the archive without a prefix, but for headers whose inner
# calls a test wants (tests/X_inside.h): these are compiled with that file.
inside=""
objects() {
    mkdir -p "$out/objects"
    case "$group:$1" in check: | test: | long:) examples=1 ;; *) examples="" ;; esac
    [ -n "$examples" ] || [ -f "$out/objects/$1ms.a" ] || ar rcs "$out/objects/$1ms.a" # it may stay empty
    case $3 in -x*) language="$warn" ;; *) language="-x c $warn_c" ;; esac
    prefix=$1 build="$2 $posix -I. $3"
    shift 3
    for n; do
        n=${n%.h}
        upper=$(echo $n | tr a-z A-Z)
        more=""
        case " $inside " in *" ${n#ms_}_inside.h "*) more="$paths -DTEST_INSIDE= -include ${n#ms_}_inside.h" ;; esac
        [ -z "$examples" ] || [ -n "$more" ] || continue
        echo "$build $language -D${upper}_IMPLEMENTATION -D${upper}_WITH_SCALAR -include $n.h $more -c -o $out/objects/$prefix$n.o /dev/null 2>&1 |
            awk '{print; bad += /warning:|error:/} END {exit bad > 0}'" >"$out/objects/1-$prefix$n.job"
    done
}

# linked TEST: the flags that leave the headers to the linker, but for those of which (or of whose common block) the test calls private functions or
# whose C library it replaces.
linked() {
    for h in $headers; do
        upper=$(echo "${h%.h}" | tr a-z A-Z)
        grep -q -E "(${h%.h}|$upper|\bms)__|include \"io\.h\"" "$1" || printf ' -D%s_IMPLEMENTED' "$upper"
    done
}
# needed FILE: the headers that it leaves to the linker
needed() { for h in $(reached "$1"); do case $(linked "$1") in *"-D$(echo "${h%.h}" | tr a-z A-Z)_IMPLEMENTED"*) echo "$h" ;; esac; done; }
all_linked() { [ "$(echo "$1" | wc -w)" = "$(echo $headers | wc -w)" ]; }

# test_jobs PREFIX COMPILER LANGUAGE-FLAGS RUNNER ARGUMENTS: every tests/test_*.c, built and run. A program that has no header inside is
# compiled once and linked with the objects of every build.
test_jobs() {
    some=""
    for t in tests/test_*.c; do
        n=$(basename "$t" .c)
        case "$group:$1: $long " in check:*" $n "* | test:*" $n "* | long:[!f]*" $n "* | long:fma_:*" $n "*) continue ;; esac
        case "$group:$1: $not_scalar " in test:scalar_:*" $n "*) continue ;; esac
        case "$group:$1: $not_clang " in test:c*_:*" $n "*) continue ;; esac
        case $group in sanitize | long) since $(used "$t") || continue ;; esac
        # what uses no header is the same in every build
        case $1 in "" | full_) ;; *) [ -n "$(reached "$t")" ] || continue ;; esac
        with=$(linked "$t")
        if all_linked "$with"; then level=-O1; else level=""; fi
        ! grep -q 'include "io.h"' "$t" || level=-O0 # it waits for the disk
        case "$group:$level" in
        check:-O1 | test:-O1 | long:-O1)
            job "$1$n" "$2 $out/objects/program_$n.o $out/objects/$1ms.a -o $out/$1$n -lm -lpthread && $4 $out/$1$n $5" || continue
            mkdir -p "$out/objects"
            echo "$CC $posix $paths -std=c99 -O1$with -c $t -o $out/objects/program_$n.o" >"$out/objects/1-program_$n.job" ;;
        *)
            job "$1$n" "$2 $posix $paths $3 $level$with $t $([ "${3#-x}" = "$3" ] || echo -x none) $out/objects/$1ms.a -o $out/$1$n -lm -lpthread && $4 $out/$1$n $5" || continue ;;
        esac
        some="$some $(needed "$t")"
        inside="$inside $(used "$t" | sed -n 's/.*\/\([a-z]*_inside\.h\)$/\1/p')"
    done
    [ -z "$some" ] || objects "$1" "$2" "$3" $some
}

# --- groups --------------------------------------------------------------------------------------------------------

# replay_jobs FLAGS: every fuzz target over its corpus, linked with the archive that has no prefix
replay_jobs() {
    some=""
    # sizes of 32 bits, as in WebAssembly: products of a file's sizes wrap there
    if compiles $CC -m32; then
        narrow="$CC $posix $paths -std=c99 -m32 -msse2 -mfpmath=sse -O1 $1"
        job replay_32bit "$narrow tests/fuzz/fuzz_safetensors.c tests/fuzz/replay.c -o $out/fuzz_32bit -lm && $out/fuzz_32bit tests/fuzz/corpus_safetensors 2000"
        job x87 "for f in mcml profile train; do $CC $posix $paths -std=c99 -m32 -fsyntax-only -Werror examples/tools/\$f.c || exit 1; done"
        job train_32bit "$narrow examples/tools/train.c -o $out/train_32bit -lm -lpthread && $out/train_32bit --inversion examples/data/preview_64.safetensors $out/train_32bit_ --count 1 --first 8 --width 8 --steps 2"
        job test_nn_32bit "$narrow -O0 tests/test_nn.c -o $out/test_nn_32bit -lm -lpthread && $out/test_nn_32bit $([ $group != check ] || echo --build) sizes"
    else
        job replay_32bit "echo '$CC cannot build for 32 bits here'; exit 77"
    fi
    for f in tests/fuzz/fuzz_*.c; do
        n=$(basename "$f" .c)
        since $(used "$f") || continue
        job "replay_$n" "$CC $posix $paths -std=c99 $1$(linked "$f") $f tests/fuzz/replay.c $out/objects/ms.a -o $out/$n -lm && $out/$n tests/fuzz/corpus_${n#fuzz_} 2000" &&
            some="$some $(needed "$f")"
    done
    [ -z "$some" ] || objects "" "$CC" "-std=c99 $1" $some
}

check_jobs() {
    [ ! -f tests/examples.sh ] || job examples "sh tests/examples.sh $out/examples"
    if [ "$group" = check ]; then only=--build; else only=""; fi # methods are judged in make test
    test_jobs "" "$CC" "-std=c99 $CFLAGS" "" "$only"
    job common "sh tests/common.sh check"
    job readme "sh tests/readme.sh"
    job texts "sh tests/texts.sh"
    job macros "sh tests/dropin/macros.sh $out/macros $(echo $headers)"
    for h in $headers; do
        n=${h%.h}
        job "manual_$n" "sh tests/dropin/manual.sh $h $out/manual_$n"
    done
    replay_jobs "$CFLAGS"
}

if [ -f /usr/include/embree4/rtcore.h ] || [ -f /usr/local/include/embree4/rtcore.h ]; then embree=-lembree4; else embree=-lembree3; fi

# warnings_jobs: what make sanitize and check-style would say of the tests (C, C++), and of the headers with their inner calls, without code
warnings_jobs() {
    flags="-std=c99 -O1 -fsyntax-only -Werror"
    ! compiles $CC -fsanitize=address,undefined || flags="$flags -fsanitize=address,undefined"
    {
        for t in tests/test_*.c tests/attack/*.c; do echo "$CC $posix $paths -Itests/attack $warn_c $flags$(linked "$t") $t || bad=1"; done
        for t in tests/test_*.c; do ! have clang++ || echo "clang++ -x c++ -std=c++11 $posix $paths $warn -Werror -fsyntax-only$(linked "$t") $t || bad=1"; done
        for h in $headers; do
            n=${h%.h}
            upper=$(echo $n | tr a-z A-Z)
            [ ! -f "tests/${n#ms_}_inside.h" ] ||
                echo "$CC $posix $paths $warn_c $flags -D${upper}_IMPLEMENTATION -x c /dev/null -include $h -DTEST_INSIDE= -include ${n#ms_}_inside.h || bad=1"
        done
        echo '[ -z "${bad:-}" ]'
    } >"$out/warnings.sh"
    job warnings "sh $out/warnings.sh"
}

test_group() {
    # first those that wait for a browser
    job web "sh tests/web.sh $out/web"
    job three "command -v python3 >/dev/null || { echo no python3 here; exit 77; }; python3 tests/three.py $out/three"
    job babylon "command -v python3 >/dev/null || { echo no python3 here; exit 77; }; python3 tests/babylon.py $out/babylon"
    job materialx "command -v python3 >/dev/null || { echo no python3 here; exit 77; }; python3 tests/materialx_open.py $out/materialx"
    job blender "sh tests/blender.sh $out/blender"
    job page "sh tests/page.sh $out/page"
    packages=""
    for t in tests/pkg_*.c; do
        n=$(basename "$t" .c)
        job "$n" "sh tests/package.sh $t $out/$n $out/objects '$(linked "$t")' && $out/$n" && packages=1
    done
    if [ -n "$packages" ]; then
        objects "" "$CC" "-std=c99 $CFLAGS"
        echo "$CXX -std=c++17 -Itests -O1 -c tests/oiio.cpp -o $out/objects/oiio.o" >"$out/objects/1-oiio.job"
    fi
    # long ones, so that none of them is the last
    job dropin_together "sh tests/dropin/dropin.sh $out/dropin_together $(echo $headers)"
    job alone "sh tests/alone.sh $out/alone"
    for t in tests/test_*.py; do
        [ -f "$t" ] || continue
        n=$(basename "$t" .py)
        job "$n" "sh tests/python.sh $t"
    done
    job null "command -v python3 >/dev/null || { echo no python3 here; exit 77; }; python3 tests/null.py $out/null"
    for h in $headers; do
        n=${h%.h}
        job "dropin_$n" "sh tests/dropin/dropin.sh $out/dropin_$n $h"
        job "symbols_$n" "sh tests/dropin/symbols.sh $h $out/symbols_$n"
    done
    attack_jobs 60
    warnings_jobs
    job dropin_msvc "sh tests/dropin/msvc.sh $out/dropin_msvc $(echo $headers)"
    job dropin_builds "sh tests/dropin/builds.sh $out/dropin_builds"
    test_jobs "scalar_" "$CC" "-std=c99 $CFLAGS -DMS_NO_SIMD" "" "--build --no-simd"
    # The other language by the other compiler.
    if have clang++; then test_jobs "clang_" clang++ "-x c++ -std=c++11 $CFLAGS" "" "--build"
    else test_jobs "cxx_" "$CXX" "-x c++ -std=c++11 $CFLAGS -O1" "" "--build"
    fi
    check_jobs
}

long_group() {
    test_jobs "full_" "$CC" "-std=c99 -O3" "" "--full"
    for h in $headers; do
        since "$h" tests/calls.sh tests/calls.c || continue
        job "calls_${h%.h}" "sh tests/calls.sh $out/calls_${h%.h} $h stack,flush"
    done
    # as many programs are built: products and sums in one instruction wherever the compiler likes
    ! grep -q -w fma /proc/cpuinfo 2>/dev/null || test_jobs "fma_" "$CC" "-std=gnu11 $CFLAGS -march=haswell -ffp-contract=fast" "" "--fused"
    test_jobs "scalar_" "$CC" "-std=c99 $CFLAGS -DMS_NO_SIMD" "" "--no-simd"
    test_jobs "cxx_" "$CXX" "-x c++ -std=c++11 $CFLAGS -O1" "" ""
    packages=""
    for t in tests/pkg_*.c; do
        n=$(basename "$t" .c)
        grep -q test_full "$t" && since $(used "$t") || continue
        job "full_$n" "sh tests/package.sh $t $out/$n $out/objects '$(linked "$t")' && $out/$n --full" && packages=1
    done
    if [ -n "$packages" ]; then
        objects "" "$CC" "-std=c99 $CFLAGS"
        echo "$CXX -std=c++17 -Itests -O1 -c tests/oiio.cpp -o $out/objects/oiio.o" >"$out/objects/1-oiio.job"
    fi
}

style_jobs() {
        # Layout, by the version whose results are in the repository.
    if ! clang-format --version 2>/dev/null | grep -q 'version 14\.'; then
        job style_format "echo 'no clang-format 14 on this machine'; exit 77"
    else
        job style_format "git ls-files '*.c' '*.h' | xargs clang-format --dry-run -Werror"
    fi
    for compiler in gcc clang; do
        have $compiler || { job "style_$compiler" "echo 'no $compiler on this machine'; exit 77"; continue; }
        cxx=$(echo $compiler | sed 's/gcc/g++/; s/clang/clang++/')
        # Clang warns before it optimizes, GCC in part while it does so.
        if [ $compiler = clang ]; then only=-fsyntax-only levels=-O2; else only=-c levels="-O0 -O2 -O3"; fi
        for f in tests/test_*.c tests/attack/*.c tests/bench/bench_*.c tests/fuzz/*.c examples/*.c examples/*/*.c; do
            ! grep -q '"egl.h"' "$f" || continue # its headers are not everywhere
            [ -f "$f" ] && since $(used "$f" | grep -v '^ms_') || continue
            n=$(echo "${f%.c}" | sed 's/^examples\/ms_/small_ms_/; s/.*\(tests\|examples\)\///; s/\//_/g')
            attributes="" # those of WebAssembly are unknown here
            case $f in examples/web/*) attributes="-Wno-attributes $([ $compiler = gcc ] || echo -Wno-unknown-attributes)" ;; esac
            case $f in tests/attack/*) # programs of C alone
                job "${compiler}_$n" "$compiler -std=c99 $posix $paths -Werror $warn_c$(linked "$f") -O1 $only $f -o $out/${compiler}_$n.o"
                continue ;;
            esac
            job "${compiler}_$n" "$compiler -std=c99 $posix $paths -Werror $warn_c $attributes$(linked "$f") -O3 $only $f -o $out/${compiler}_$n.o &&
$cxx -x c++ -std=c++11 $posix $paths -Werror $warn $attributes$(linked "$f") -O1 $only $f -o $out/${compiler}_$n.o"
        done
        for h in $headers; do
            since "$h" || continue
            n=${h%.h}
            upper=$(echo "$n" | tr a-z A-Z)
            c="$out/${compiler}_$n.c"
            printf '#define %s_IMPLEMENTATION\n#include "%s"\n' "$upper" "$h" >"$c"
            if [ -n "${SINCE:-}" ]; then # `make test` compiles it at -O2 and -O3, as C and as C++
                job "${compiler}_$n" "$compiler -std=c99 -I. -Werror $warn_c -DMS_NO_SIMD -O2 $only $c -o $c.o &&
$compiler -std=c99 -I. -Werror $warn_c -D${upper}_NO_STDIO -DMS_DEF=static -O0 $only $c -o $c.o &&
$cxx -x c++ -std=c++20 -I. -Werror $warn -O1 $only $c -o $c.o"
                continue
            fi
            for flags in "" "-DMS_NO_SIMD" "-D${upper}_NO_STDIO" "-DMS_DEF=static"; do
                job "${compiler}_${n}$(echo "$flags" | tr -d ' ')" "for o in $levels; do $compiler -std=c99 -I. -Werror $warn_c $flags \$o $only $c -o $c.o || exit 1; done
for s in c++11 c++17 c++20; do $cxx -x c++ -std=\$s -I. -Werror $warn $flags -O2 $only $c -o $c.o || exit 1; done"
            done
            if compiles $compiler -m32; then
                job "${compiler}_${n}_32bit" "$compiler -m32 -std=c99 -I. -Werror $warn_c -O2 -c $c -o $c.32.o"
            else
                job "${compiler}_${n}_32bit" "echo '$compiler cannot build for 32 bits here'; exit 77"
            fi
        done
    done
}

sanitize_jobs() {
    flags="-g -O1 -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer"
    if ! compiles $CC $flags; then
        job sanitize "echo '$CC has no address and undefined-behavior sanitizers'; exit 77"
        return
    fi
    test_jobs "" "$CC" "-std=c99 $flags" "ASAN_OPTIONS=detect_leaks=1" ""
    replay_jobs "$flags"
}

# attack_jobs SECONDS: those of all programs together, which take tests/attack/cases first. The headers are compiled once with
# sanitizers, at -O1.
attack_jobs() {
    flags="-g1 -O1 -fsanitize=address,undefined,float-cast-overflow -fno-sanitize-recover=all -fno-omit-frame-pointer"
    if ! compiles $CC $flags; then
        job attack "echo '$CC has no address and undefined-behavior sanitizers'; exit 77"
        return
    fi
    some=""
    programs=$(ls tests/attack/attack_*.c)
    seconds=$(($1 / $(echo $programs | wc -w)))
    for f in $programs; do
        n=$(basename "$f" .c)
        job "$n" "$CC $posix $paths -Itests/attack -std=c99 $flags$(linked "$f") $f $out/objects/attack_ms.a -o $out/$n -lm && $out/$n --seconds $seconds --cases tests/attack/cases" &&
            some="$some ms_${n#attack_}.h"
    done
    [ -z "$some" ] || objects "attack_" "$CC" "-std=c99 $flags" $some
}

fuzz_jobs() {
    if ! have clang || ! compiles clang -fsanitize=fuzzer-no-link; then
        job fuzz "echo 'no clang with libFuzzer on this machine'; exit 77"
        return
    fi
    for f in tests/fuzz/fuzz_*.c; do
        n=$(basename "$f" .c)
        job "$n" "mkdir -p build/fuzz/$n && clang $posix $paths -std=c99 -g -O1 -fsanitize=fuzzer,address,undefined -fno-sanitize-recover=all $f -o $out/$n -lm &&
$out/$n -max_total_time=${FUZZ_SECONDS:-20} -timeout=10 -error_exitcode=1 -rss_limit_mb=2048 -artifact_prefix=build/fuzz/$n- -print_final_stats=1 build/fuzz/$n tests/fuzz/corpus_${n#fuzz_}"
    done
}

case $group in
check) check_jobs ;;
test) test_group ;;
long) long_group ;;
style) style_jobs ;;
sanitize) sanitize_jobs ;;
thread) test_jobs "" "$CC" "-std=c99 -g -O1 -fsanitize=thread" "" "" ;;
valgrind)
    if have valgrind; then
        test_jobs "" "$CC" "-std=c99 -g -O1" "valgrind -q --error-exitcode=9 --leak-check=full" ""
    else
        job valgrind "echo 'no valgrind on this machine'; exit 77"
    fi ;;
fuzz) fuzz_jobs ;;
attack) attack_jobs "${ATTACK_SECONDS:-600}" ;;
soak) job soak "$CC $posix $paths -std=c99 -O2 tests/test_memory.c -o $out/soak -lm -lpthread && $out/soak --full soak" ;;
calls)
    for h in $headers; do
        job "calls_${h%.h}" "sh tests/calls.sh $out/calls_${h%.h} $h stack,traps,flush"
        job "calls_${h%.h}_O0" "sh tests/calls.sh $out/calls_${h%.h}_O0 $h stack -O0"
    done ;;
cross) for machine in $(sh tests/cross.sh); do job "$machine" "sh tests/cross.sh $machine $out/$machine"; done ;;
*) echo "unknown group '$group'" >&2; exit 2 ;;
esac

in_order() {
    if [ -z "${SHUFFLE:-}" ]; then cat
    else awk -v seed="$SHUFFLE" 'BEGIN {srand(seed)} {print rand() "\t" $0}' | sort | cut -f 2
    fi
}
# Those that wait for a browser most of the time run one after another beside the rest, from the start: they need no object of below.
browser='-(web|three|babylon|materialx|page)\.job$'
ls "$out"/*.job 2>/dev/null | grep -E -e "$browser" | in_order | xargs -n 1 sh tests/run.sh --one &
# The objects first, then what is linked with them.
case $group in
check | test | long) [ ! -d "$out/objects" ] || ar rcs "$out/objects/ms.a" build/ms_*.o ;;
esac
for job in "$out"/objects/*.job; do [ ! -f "$job" ] || echo "$job"; done | xargs -n 1 -P "$JOBS" sh tests/run.sh --one
for o in "$out"/objects/*ms_*.o; do [ ! -f "$o" ] || ar rcs "${o%ms_*.o}ms.a" "$o"; done
# In make test one more runs than there are processors: disks are waited for, too.
[ "$group" != test ] || [ "$JOBS" = 1 ] || JOBS=$((JOBS + 1))
ls "$out"/*.job 2>/dev/null | grep -v -E -e "$browser" | in_order | xargs -n 1 -P "$JOBS" sh tests/run.sh --one
wait
cat "$out"/*.seconds "$out"/objects/*.seconds 2>/dev/null | sort -rn >"$out/seconds"
[ "$(wc -l <"$out/seconds")" -lt 11 ] || { echo "the ten dearest, in seconds of processor time:"; head -10 "$out/seconds" | awk '{print "  " $1 "  " $3}'; }
awk '{s += $1} END {printf "%.0f s of processor time\n", s}' "$out/seconds"
cat "$out"/*.counts "$out"/objects/*.counts 2>/dev/null | awk -v group="$group" -v since="${SINCE:+1}" '{p += $1; f += $2; s += $3}
    END {printf "%s: %d passed, %d failed, %d skipped\n", group, p, f, s; exit f > 0 || (p == 0 && !since)}'
