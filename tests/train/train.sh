#!/bin/sh
# make train: the networks and pictures of examples/data from nothing, in about three hours on two cores: training pictures,
# held-out ones in two takes, renderers, inversion networks, the validation sheet. Pictures that are there are kept, so it
# can be interrupted, or the data set be made by several machines with `make dataset` and FIRST, COUNT.
# DATASET (build/dataset), COUNT (4160), JOBS (2), PYTHON (python3: needs NumPy and PyTorch), OUT (build/train).
# The files in examples/data were trained on materials 0 to 2623 and 4096 to 5631.
set -eu
python=${PYTHON:-python3}
data=${DATASET:-build/dataset}
out=${OUT:-build/train}
count=${COUNT:-4160}
export CC="${CC:-cc}" SIZE=128 JOBS="${JOBS:-2}"

DATASET=$data FIRST=0 COUNT=$count SAMPLES=16 sh tests/render/dataset.sh
for take in 0 1; do # 256 held-out materials, for measuring
    DATASET=${data}_heldout_$take FIRST=1073741824 COUNT=256 SAMPLES=64 TAKE=$take sh tests/render/dataset.sh
done
# the first 64 of them with less noise, to ship
DATASET=${data}_heldout_2 FIRST=1073741824 COUNT=64 SAMPLES=192 TAKE=2 sh tests/render/dataset.sh

# 256 x 256: pictures with noise, which a layer on the trunk of 128 x 128 averages out
SIZE=256 DATASET=${data}_256 FIRST=0 COUNT=1024 SAMPLES=4 sh tests/render/dataset.sh
for take in 0 1; do
    SIZE=256 DATASET=${data}_256_heldout_$take FIRST=1073741824 COUNT=64 SAMPLES=32 TAKE=$take sh tests/render/dataset.sh
done

held="--held-out ${data}_heldout_0 ${data}_heldout_1"
mkdir -p "$out"
train() { "$python" tests/train/"$@" --data "$data" 2>&1 | tee -a "$out/train.log"; }
train renderer.py --size 64 --rank 96 --pixels F16 $held --out "$out/renderer_64.safetensors"
train renderer.py --size 128 --rank 96 --pixels F16 $held --out "$out/renderer_128.safetensors"
build/train "${data}_256" - "$out/renderer_256.safetensors" --trunk "$out/renderer_128.safetensors" --rank 32 \
    --check "${data}_256_heldout_0" --check "${data}_256_heldout_1" | tee -a "$out/train.log"
train inversion.py --renderer "$out/renderer_64.safetensors" --out "$out" --kind dense --from-number 1 --count 5 --first 64 --minutes 9
train inversion.py --renderer "$out/renderer_64.safetensors" --out "$out" --kind convolution --from-number 6 --count 4 --first 12 --minutes 10
"$python" tests/train/validation.py "$out" "${data}_heldout_0" "${data}_heldout_1" "${data}_heldout_2"
echo "networks and pictures are in $out; examples/data has the ones that ship"
