#!/bin/sh
# make demo: runs the examples and leaves their pictures and tables in build/demo/.
set -eu
out=build/demo
mkdir -p $out
echo "profiles of skin1 -> $out/skin1.csv"
build/profile skin1 --csv $out/skin1.csv >/dev/null
echo "seven taps for skin1 -> $out/skin1_kernel.txt"
build/sss_kernel skin1 --model preintegrated --taps 7 >$out/skin1_kernel.txt
build/demo_sss $out
echo "300 recommendations -> $out/recommended.csv, latent plane -> $out/latent.png"
build/recommend examples/data/scores.csv --count 300 --out $out/recommended.csv 2>$out/recommend.txt
build/latent examples/data/scores.csv $out/latent.png
if [ -f examples/data/renderer_128.safetensors ]; then
    echo "neural previews | path-traced truth | 8 x difference -> $out/preview.png"
    build/preview examples/data/renderer_128.safetensors examples/data/materials.csv $out/preview.png examples/data/materials.ppm
fi
if [ -f examples/data/inversion_1.safetensors ]; then
    echo "eight edits: source | edited target | match | 4 x difference -> $out/match.png"
    build/demo_match $out/match.png
    echo "gallery, taste, recommendations, variants, an edited picture -> $out/workflow.png, materials -> $out/workflow.mtlx"
    build/workflow $out
fi
ls -l $out | awk 'NR > 1 {print "  " $NF, $5, "bytes"}'
