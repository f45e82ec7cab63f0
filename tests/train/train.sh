#!/bin/sh
# make train: the networks and pictures of examples/data from nothing: pictures (two hours of a core), then renderers and inversion networks
# (three quarters of an hour of a core). A C compiler and Embree, nothing else. Pictures and networks that are there are kept, so it can be
# interrupted, or the data set be made by several machines with `make dataset` and FIRST, COUNT.
# DATASET (build/dataset), COUNT (4160), JOBS (2), OUT (build/train).
set -eu
data=${DATASET:-build/dataset}
out=${OUT:-build/train}
count=${COUNT:-4160}
export CC="${CC:-cc}" SIZE=256 JOBS="${JOBS:-2}"

DATASET=$data FIRST=0 COUNT=$count SAMPLES=4 sh tests/render/dataset.sh
held=""
for take in 0 1; do # held-out materials, for measuring
    DATASET=${data}_heldout_$take FIRST=1073741824 COUNT=64 SAMPLES=16 TAKE=$take sh tests/render/dataset.sh
    held="$held --check ${data}_heldout_$take"
done
# with less noise, to ship
DATASET=${data}_heldout_2 FIRST=1073741824 COUNT=64 SAMPLES=64 TAKE=2 sh tests/render/dataset.sh
mkdir -p "$out"
$CC -std=c99 -O2 -I. -Iexamples/tools -Iexamples/demo -Iexamples/engine tests/render/sheet.c -o build/sheet -lm
build/sheet "$out" "${data}_heldout_0" "${data}_heldout_1" "${data}_heldout_2"

cat >"$out/names.csv" <<'END'
diffuse red,diffuse green,diffuse blue,glossy red,glossy green,glossy blue,glossy roughness,glossy share,glass red,glass green,glass blue,glass roughness,index of refraction,translucent red,translucent green,translucent blue,translucent share,transmissive share,absorption
END
train() { [ -f "$3" ] || build/train "$@" 2>&1 | tee -a "$out/train.log"; }
train "$data" "$out/names.csv" "$out/renderer_64.safetensors" --size 64 $held
train "$data" "$out/names.csv" "$out/preview_64.safetensors" --size 64 --width 256 --rank 80 $held
train "$data" "$out/names.csv" "$out/renderer_128.safetensors" --size 128 $held
train "$data" "$out/names.csv" "$out/renderer_256.safetensors" --trunk "$out/renderer_128.safetensors" --rank 32 $held
[ -f "$out/inversion_5.safetensors" ] || build/train --inversion "$out/renderer_64.safetensors" "$out/inversion_" --count 5 2>&1 | tee -a "$out/train.log"
echo "networks and pictures are in $out; examples/data has the ones that ship"
