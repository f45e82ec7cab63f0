#!/bin/sh
# Makes examples/data/truth_*.bin: random walks through a bust of skin and a knot of marble. Needs Embree (make deps); five
# minutes on one core.
set -eu
embree=embree4
printf 'int main(void) { return 0; }\n' >build/probe.c
cc build/probe.c -o build/probe -lembree4 2>/dev/null || embree=embree3
cc -std=c99 -O2 -D_POSIX_C_SOURCE=200809L -I. -Itests -Iexamples/tools -Iexamples/demo -Iexamples/engine tests/render/truth_data.c -o build/truth_data -l$embree -lm -lpthread
build/truth_data
