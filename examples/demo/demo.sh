#!/bin/sh
# make demo: runs the examples and leaves their pictures and tables in build/demo/, or in the folder that is named, no two under one name.
set -eu
out=${1:-build/demo}
mkdir -p "$out"
build/profile skin1 --csv $out/skin1.csv >/dev/null
build/sss_kernel skin1 --model preintegrated --taps 7 >$out/skin1_kernel.txt
echo "light under the skin, marble, kernel models: before and after"
build/demo_sss $out --width 1088 >/dev/null # as wide as the page shows them
build/recommend examples/data/scores.csv --count 300 --out $out/glass.csv 2>$out/recommend.txt
build/latent examples/data/scores.csv $out/latent.png examples/data/renderer_64.safetensors >/dev/null
if [ -f examples/data/renderer_128.safetensors ]; then
    echo "neural previews of 64 materials"
    build/preview examples/data/renderer_128.safetensors examples/data/materials.csv $out/preview.png examples/data/materials.png >$out/preview_psnr.txt
fi
if [ -f examples/data/inversion_1.safetensors ]; then
    echo "eight edited pictures, and the materials that match them"
    build/demo_match $out/match.png >$out/match_rmse.txt
    echo "a gallery, a taste learned from it, recommendations"
    build/workflow $out >$out/workflow.txt
fi
cp examples/data/materialx.png $out/materialx.png
cp examples/data/hero.png $out/hero.png
cp examples/web/studio.html $out/studio.html
cp examples/web/kernels.html $out/designer.html
sh examples/demo/exhibition.sh $out >$out/index.html
echo "open $out/index.html"
