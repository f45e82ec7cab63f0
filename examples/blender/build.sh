#!/bin/sh
# make blender: the add-on with its library, build/material_taste.zip (CC: also x86_64-w64-mingw32-gcc).
# make blender-dataset: pictures by Cycles in build/blender, half an hour of a core; what is there is kept.
#   COUNT (4000), SAMPLES (32), JOBS (2), HELD_OUT (2, the seed of the 100 materials to measure with).
# make blender-train: the network from them, or from the first of them, build/blender/renderer.safetensors.
set -eu
here=examples/blender
data=build/blender
jobs=${JOBS:-2}
mkdir -p "$data"

pictures() { # FOLDER, COUNT, SAMPLES, SEED, NOISE, GLASS
    job=0
    while [ $job -lt "$jobs" ]; do
        PART=$job PARTS=$jobs blender -b --factory-startup -t 1 --python $here/dataset.py -- "$@" | grep -E ' of |Error|error' &
        job=$((job + 1))
    done
    wait
}

case $1 in
addon)
    cp -r $here/material_taste build/
    case ${CC:-cc} in
    *mingw*) $CC -O2 -shared -static -I. -Iexamples/tools $here/flat.c -o build/material_taste/ms_flat.dll ;;
    *) ${CC:-cc} -std=c99 -O2 -shared -fPIC -fvisibility=hidden -I. -Iexamples/tools $here/flat.c \
        -o build/material_taste/libms_flat.so -lm ;;
    esac
    rm -rf build/material_taste/__pycache__ build/material_taste.zip
    (cd build && python3 -m zipfile -c material_taste.zip material_taste)
    echo "build/material_taste.zip: install it in Blender's preferences"
    ;;
dataset)
    pictures $data/train "${COUNT:-4000}" "${SAMPLES:-32}" 1 1 0.35
    for noise in 1 2; do # two renderings of the same materials: their noise cancels
        pictures $data/held_out_$noise 100 $((2 * ${SAMPLES:-32})) "${HELD_OUT:-2}" $noise 0
    done
    ;;
train)
    count=$(find $data/train -name '*.pfm' | wc -l)
    last=$(printf '%05d.pfm' $((count - 1)))
    if [ "$(find $data/train -name '*.pfm' -exec basename {} \; | sort | tail -1)" != "$last" ]; then
        echo "$data/train has gaps: finish make blender-dataset first"
        exit 1
    fi
    head -n $((count + 1)) $data/train.csv >$data/train_used.csv
    build/train $data/train $data/train_used.csv $data/renderer.safetensors --rank 64 --width 256 --epochs "${EPOCHS:-200}" \
        --check $data/held_out_1 --check $data/held_out_2
    python3 $here/label.py $data/renderer.safetensors blender "$(cat $data/train.version)"
    ;;
esac
