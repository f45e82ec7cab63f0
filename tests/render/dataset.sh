#!/bin/sh
# make dataset: pictures of the materials FIRST to FIRST + COUNT - 1 (0, 4096), SIZE (128) pixels, SAMPLES (32) paths a
# pixel, by JOBS (2) processes, into DATASET (build/dataset); TAKE (0) numbers pictures with independent noise. What is
# there already is kept. At 128 pixels and 32 samples a picture takes a second or two on one core, and 100 KB.
set -eu
folder=${DATASET:-build/dataset}
first=${FIRST:-0}
count=${COUNT:-4096}
mkdir -p build "$folder"
for embree in embree4 embree3 none; do
    echo "#include <$embree/rtcore.h>" >build/embree.c
    ! ${CC:-cc} -c build/embree.c -o build/embree.o 2>/dev/null || break
done
${CC:-cc} -std=c99 -O3 -D_POSIX_C_SOURCE=200809L -I. -Itests -Iexamples/tools -Iexamples/demo -Iexamples/engine tests/render/dataset.c -o build/dataset_tool "-l$embree" -lm
# one process a job, each on every JOBS-th block of 256 pictures
seq "$first" 256 $((first + count - 1)) | while read -r at; do
    left=$((first + count - at))
    echo "$at $((left < 256 ? left : 256))"
done | xargs -n 2 -P "${JOBS:-2}" sh -c 'build/dataset_tool "$1" "$5" "$6" "$2" "$3" "$4"' dataset "$folder" "${SIZE:-128}" "${SAMPLES:-32}" "${TAKE:-0}"
