#!/bin/sh
# make hero: README's top picture into OUT (build/hero/hero.png), WIDTH x HEIGHT (1600 x 900) pixels, PASSES (24) times
# SAMPLES (4) paths a pixel, by JOBS (2) processes. Finished passes in build/hero are kept: after an interruption, or with
# more PASSES, only what lacks is rendered (remove the folder after a change of the scene). A pass of this size takes
# half a minute or more on one core.
# The materials: MATERIALS, a CSV of 19 columns or more, the first row in the middle; or else what build/recommend
# proposes to users of five tastes who scored 400 random materials each.
set -eu
folder=build/hero
width=${WIDTH:-1600}
height=${HEIGHT:-900}
passes=${PASSES:-24}
samples=${SAMPLES:-4}
materials=${MATERIALS:-$folder/materials.csv}
mkdir -p "$folder"
for embree in embree4 embree3 none; do
    echo "#include <$embree/rtcore.h>" >"$folder/embree.c"
    ! ${CC:-cc} -c "$folder/embree.c" -o "$folder/embree.o" 2>/dev/null || break
done
${CC:-cc} -std=c99 -O3 -D_POSIX_C_SOURCE=200809L -I. -Itests -Iexamples/tools -Iexamples/demo -Iexamples/engine tests/render/hero.c -o "$folder/hero" "-l$embree" -lm
if [ ! -s "$materials" ]; then
    for taste in crystal:20 glass:52 metal:52 lacquer:52 wax:52; do
        name=${taste%:*}
        "$folder/hero" scores "$name" 400 >"$folder/scores_$name.csv"
        build/recommend "$folder/scores_$name.csv" --count "${taste#*:}" --tau 0.88 --out "$folder/$name.csv"
    done
    sed 1d "$folder/crystal.csv" | sort -t , -k 20,20nr | head -1 >"$folder/all.csv" # predicted to be liked most
    for name in glass metal lacquer wax; do sed 1d "$folder/$name.csv" >>"$folder/all.csv"; done
    mv "$folder/all.csv" "$materials"
fi
name=$folder/${width}x${height}_${samples}
seq 0 $((passes - 1)) | xargs -n 1 -P "${JOBS:-2}" sh -c '
    [ -s "$1_$6.pfm" ] || { "$0" pass "$2" "$1_$6_part.pfm" "$3" "$4" "$5" "$6" && mv "$1_$6_part.pfm" "$1_$6.pfm"; }
' "$folder/hero" "$name" "$materials" "$width" "$height" "$samples"
pictures=
for k in $(seq 0 $((passes - 1))); do pictures="$pictures ${name}_$k.pfm"; done
"$folder/hero" develop "${OUT:-$folder/hero.png}" $pictures
