#!/bin/sh
# make demo: runs the examples and leaves their pictures and tables in build/demo/, or in the folder that is named, no two under one name.
set -eu
out=${1:-build/demo}
mkdir -p "$out"
steps=5
[ -f examples/data/renderer_128.safetensors ] || steps=2
step=0
next() {
    step=$((step + 1))
    echo "$step of $steps: $1"
}
echo "about half a minute of one core; pictures and tables go to $out"
next "subsurface scattering: a head, a knot, six skins, kernel models"
build/profile skin1 --csv $out/skin1.csv >/dev/null
build/sss_kernel skin1 --model preintegrated --taps 7 >$out/skin1_kernel.txt
build/demo_sss $out --width 1088 | sed 's/^/    /' # as wide as the page shows them
next "a taste from 150 scores: 300 new materials, and the plane of the best"
build/recommend examples/data/scores.csv --count 300 --out $out/glass.csv 2>$out/recommend.txt
build/latent examples/data/scores.csv $out/latent.png examples/data/renderer_64.safetensors >/dev/null
if [ $steps = 5 ]; then
    next "pictures of 64 materials by a network"
    build/preview examples/data/renderer_128.safetensors examples/data/materials.csv $out/preview.png examples/data/materials.png >$out/preview_psnr.txt
    next "eight edited pictures, and the materials that match them"
    build/demo_match $out/match.png >$out/match_rmse.txt
    next "a gallery, a taste learned from it, recommendations, a match"
    build/workflow $out >$out/workflow.txt
fi
cp examples/data/portrait.png examples/data/hero.png examples/data/materialx.png examples/web/studio.html examples/web/kernels.html $out
sh examples/demo/exhibition.sh $out >$out/index.html
echo "open $out/index.html"
