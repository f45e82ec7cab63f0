#!/bin/sh
# The page that examples/demo/demo.sh leaves, of the files that it writes: all of them are there, each table, and no more than is true; laid
# out by headless Chromium at the width of a phone and of a desktop. sh tests/page.sh OUT
set -u
out=$1/demo
mkdir -p "$out"
passed=0
failed=0
check() { # NAME, value, expected
    if [ "$2" = "$3" ]; then passed=$((passed + 1)); else failed=$((failed + 1)); echo "FAIL $1: '$2', expected '$3'"; fi
}
sh examples/demo/demo.sh "$out" >"$out.log" 2>&1 || { failed=$((failed + 1)); echo "FAIL the demo"; tail -3 "$out.log"; }
page=$out/index.html
for f in "$out"/*; do
    name=${f##*/}
    [ "$name" = index.html ] || check "$name is linked" "$(grep -c -F "href=\"$name\"" "$page" | awk '{print ($1 > 0)}')" 1
done
check "the portrait, then the live pages, then the sections" \
    "$(grep -o 'src="portrait.png"\|href="kernels.html"\|href="studio.html"\|<section id="[a-z_]*"' "$page" | head -4 | tr '\n' ' ')" \
    'src="portrait.png" href="kernels.html" href="studio.html" <section id="ms_sss" '
check "progress" "$(grep -c '^[1-5] of 5: ' "$out.log")" 5
check "sections" "$(grep -c '<section' "$page") $(grep -c '</section' "$page")" "6 6"
check "materials" "$(grep -c '<tr><td>[a-z0-9]*</td><td>0\.[0-9]*</td><td>0\.[0-9]*</td><td>0\.[0-9]*</td></tr>' "$page")" "$(build/profile --list | wc -l | tr -d ' ')"
check "edits and their matches" "$(grep -c '<td>inversion_[0-9]</td>' "$page")" "$(grep -c RMSE "$out/match_rmse.txt")"
check "the networks' figures" "$(grep -c "mean $(sed -n 's/.*mean \([0-9.]*\) dB.*/\1/p' "$out/preview_psnr.txt") dB" "$page")" 1
check "stages and their times" "$(grep -c '<td>GPLVM</td>' "$page")" 1
check "what made the filtered pictures, and its cost" "$(grep -o 'ms_sss_filter, 7 taps[^<]* ns a pixel' "$page" | wc -l | tr -d ' ')" "$(grep -c ' ns a pixel' "$out/sss.txt")"
check "errors of the filters" "$(grep -c "$(sed -n 's/.*7 taps: \([0-9.]*%\).*/\1/p' "$out/sss.txt" | head -1)" "$page" | awk '{print ($1 > 0)}')" 1
check "a program a header" "$(grep -c '#define MS_[A-Z]*_IMPLEMENTATION' "$page")" 5
browser=""
for name in chromium chromium-browser google-chrome; do [ -n "$browser" ] || browser=$(command -v $name || true); done
if [ -z "$browser" ]; then
    echo "$passed passed, $failed failed, 1 skipped"
    echo "no Chromium on this machine: the layout was not tried"
else
    pictures=$(grep -o '<img ' "$page" | wc -l | tr -d ' ')
    for width in 400 1280; do
        # a frame of that width, since a window may not get as narrow as a phone; text of 12 units in the plots is at least 8.5 pixels high
        cat >"$out/frame.html" <<HTML
<iframe id="page" src="index.html" style="width:${width}px;height:900px;border:0"></iframe><p id="found">nothing</p>
<script>onload = () => { const d = document.getElementById("page").contentDocument, plots = [...d.querySelectorAll(".plots img")];
document.getElementById("found").textContent = "over " + Math.max(0, d.documentElement.scrollWidth - $width) + " missing " +
[...d.images].filter(i => !i.complete || i.naturalWidth === 0).length + " of " + d.images.length + " plots " + plots.length + " small " +
plots.filter(i => 12 * i.clientWidth / i.naturalWidth < 8.5).length; };</script>
HTML
        found=$("$browser" --headless --no-sandbox --disable-gpu --no-first-run --disable-background-networking --disable-component-update \
            --disable-sync --allow-file-access-from-files --user-data-dir="$1/profile" --window-size=1800,1000 --virtual-time-budget=10000 \
            --dump-dom "file://$(cd "$out" && pwd)/frame.html" 2>/dev/null | sed -n 's/.*id="found">\([^<]*\)<.*/\1/p')
        check "page of $width pixels" "$found" "over 0 missing 0 of $pictures plots 3 small 0"
    done
    rm -rf "$1/profile"
    echo "$passed passed, $failed failed"
fi
[ $failed = 0 ]
