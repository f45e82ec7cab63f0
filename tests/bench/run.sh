#!/bin/sh
# make bench: runs tests/bench/bench_*.c one after another (FILTER: part of a name), each writes its CSV, SVG and table
# to build/bench/, then puts the tables into README.md and tests/bench/RESULTS.md.
set -u
mkdir -p build/bench
for f in tests/bench/bench_*.c; do
    n=$(basename "$f" .c)
    case $n in *"${FILTER:-}"*) ;; *) continue ;; esac
    echo "== $n"
    begin=$(date +%s)
    libraries=""
    for library in $(sed -n 's/.*peer libraries: *\(-l.*[a-zA-Z0-9]\).*/\1/p' "$f" | head -1); do
        echo 'int main(void) { return 0; }' >build/bench/probe.c
        ${CC:-cc} build/bench/probe.c -o build/bench/probe "$library" >/dev/null 2>&1 &&
            libraries="$libraries $library -DHAVE_$(echo "$library" | sed 's/^-l//' | tr 'a-z-' 'A-Z_')"
    done
    # a peer in C++: its source and libraries, when it compiles
    sed -n 's/.*peer source: *\([^ ]*\) \(-l.*[a-zA-Z0-9]\).*/\1 \2/p' "$f" | head -1 >build/bench/peer
    read -r source with <build/bench/peer && name=$(basename "$source" .cpp) &&
        ${CXX:-c++} -std=c++11 -O3 -march=native -ffast-math -I/usr/include/opencv4 -c "tests/bench/$source" -o "build/bench/$name.o" >/dev/null 2>&1 &&
        libraries="$libraries build/bench/$name.o $with -lstdc++ -DHAVE_$(echo "$name" | tr a-z A-Z)"
    ${CC:-cc} -std=c99 ${CFLAGS:--O2} -D_POSIX_C_SOURCE=200809L -I. -Itests -Iexamples/tools -Iexamples/demo -Iexamples/engine -Itests/bench "$f" -o "build/bench/$n" $libraries -lm -lpthread &&
        "build/bench/$n" || echo "$n failed"
    echo "== $n: $(($(date +%s) - begin)) s"
done
sh tests/bench/readme.sh
