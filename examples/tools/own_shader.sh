#!/bin/sh
# Another shader from its pictures to recommendations, previews and matching (examples/tools/own_shader.md): sh examples/tools/own_shader.sh [OUT]
# COUNT (3000) pictures of SIZE (64) pixels, STEPS (3000) for the inversion networks, TRAIN: more options for build/train.
set -eu
out=${1:-build/own}
count=${COUNT:-3000}
size=${SIZE:-64}
mkdir -p "$out"

echo "$count pictures of random materials, and 50 that nobody trains on"
build/own_shader "$out/pictures" "$count" "$size" 1
build/own_shader "$out/unseen" 50 "$size" 4321

echo "a renderer of their parameters"
build/train "$out/pictures" "$out/pictures.csv" "$out/renderer.safetensors" --check "$out/unseen" ${TRAIN:-} | tee "$out/train.txt" | grep -v '^epoch'
build/train --inversion "$out/renderer.safetensors" "$out/inversion_" --count 4 --steps "${STEPS:-3000}" | tail -5

echo "recommendations to a taste for red metal without lacquer, learned from 120 scored pictures"
awk -F, 'NR == 1 { print $0 ",score"; next } NR <= 121 {
    taste = 10 * $9 * (0.5 + $1 - 0.5 * $2 - 0.5 * $3) * (1 - 0.7 * $10); printf "%s,%.3f\n", $0, taste < 0 ? 0 : taste }' "$out/pictures.csv" >"$out/scores.csv"
build/recommend "$out/scores.csv" --count 24 --out "$out/recommended.csv" 2>"$out/recommend.txt"
build/preview "$out/renderer.safetensors" "$out/recommended.csv" "$out/recommended.png"

echo "materials from pictures alone"
for i in 00003 00017 00031; do
    build/match "$out/renderer.safetensors" "$out/unseen/$i.png" --inversion "$out" --out-params "$out/match_$i.csv" --out-png "$out/match_$i.png"
done
echo "$out: renderer.safetensors, inversion_*.safetensors, recommended.png, match_*.csv and .png"
