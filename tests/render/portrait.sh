#!/bin/sh
# make portrait: README's pictures of a head of skin. examples/data/portrait.png: without scattering and by ms_sss.h, and parts of it beside a
# path-traced picture (WALKS, 128, a pixel and channel); ten minutes on one core. examples/data/portrait.gif: a lamp goes round it (FRAMES, 48);
# three minutes. Into OUT; ONLY=loop or heads makes one of them. Needs Embree (make deps), Chromium for the words, ImageMagick for the loop.
set -eu
folder=build/portrait
walks=${WALKS:-128}
frames=${FRAMES:-48}
out=${OUT:-examples/data}
only=${ONLY:-both}
mkdir -p "$folder/loop"
for embree in embree4 embree3 none; do
    echo "#include <$embree/rtcore.h>" >"$folder/embree.c"
    ! ${CC:-cc} -c "$folder/embree.c" -o "$folder/embree.o" 2>/dev/null || break
done
${CC:-cc} -std=c99 -O3 -D_POSIX_C_SOURCE=200809L -I. -Itests -Iexamples/tools -Iexamples/demo -Iexamples/engine tests/render/portrait.c -o "$folder/portrait" "-l$embree" -lm

if [ "$only" != heads ]; then
    command -v convert >/dev/null 2>&1 || { echo "make portrait: no ImageMagick, which writes the loop"; exit 1; }
    "$folder/portrait" loop "$folder/loop" 400 450 "$frames"
    # one palette for all frames, of every sixth, so that what does not change costs nothing; 4 s in hundredths
    convert "$folder"/loop/frame_*.png -filter Triangle -resize 600x "$folder/loop/small_%02d.png"
    convert $(ls "$folder"/loop/small_*.png | awk 'NR % 6 == 1') -append -colors 160 -unique-colors "$folder/loop/palette.png"
    convert -delay $((400 / frames)) "$folder"/loop/small_*.png -dither None -remap "$folder/loop/palette.png" -layers OptimizeTransparency -loop 0 \
        "$out/portrait.gif"
    rm -f "$folder"/loop/small_*.png
    echo "$out/portrait.gif"
    [ "$only" != loop ] || exit 0
fi

browser=""
for name in chromium chromium-browser google-chrome google-chrome-stable; do [ -n "$browser" ] || browser=$(command -v $name || true); done
[ -n "$browser" ] || { echo "make portrait: no Chromium, which draws the words"; exit 1; }
width=1600 height=900
# parts of 176 x 220 pixels: their left and upper edges
parts="nose:560:430:176:220 ear:962:372:176:220 lips:548:610:176:220"
"$folder/portrait" heads "$folder" $width $height "$walks" $parts
. "$folder/costs" # walk_times: what a pixel of the walk costs over one of the taps
{
    echo '<!doctype html><meta charset="utf-8"><style>body{margin:0;width:1600px;background:#101214;color:#e8e6e3;font:22px "DejaVu Sans",Arial,sans-serif}
.heads,.parts{display:flex;justify-content:space-between}.head{position:relative;width:799px;height:900px;background-position:-400px 0}
.head span{position:absolute;left:20px;top:16px;font-size:28px}.group{display:flex;gap:2px}.part{width:176px}.part div{height:220px}
.part p,.made{margin:7px 0 8px;text-align:center;font-size:18px}.parts{margin-top:2px}.made{color:#aeb4ba;margin:0}</style><div class="heads">'
    echo '<div class="head" style="background-image:url(without.png)"><span>without</span></div>'
    echo '<div class="head" style="background-image:url(taps.png)"><span>ms_sss.h, 7 taps</span></div></div><div class="parts">'
    for part in $parts; do
        name=${part%%:*} left=$(echo "$part" | cut -d: -f2) top=$(echo "$part" | cut -d: -f3)
        echo '<div class="group">'
        for kind in without taps; do
            echo "<div class=part><div style=\"background:url($kind.png) -${left}px -${top}px\"></div><p>$([ $kind = taps ] && echo 7 taps || echo without)</p></div>"
        done
        echo "<div class=part><div style=\"background:url($name.png)\"></div><p>path-traced</p></div></div>"
    done
    echo "</div><p class=made>7 taps: ms_sss_filter, and ms_sss_transmission for the lamp behind the ear. Path-traced: $walks random walks a pixel and channel, $walk_times × the time.</p>"
} >"$folder/portrait.html"
"$browser" --headless --no-sandbox --disable-gpu --hide-scrollbars --window-size=1600,1196 --screenshot="$folder/portrait.png" "file://$PWD/$folder/portrait.html" >"$folder/browser.log" 2>&1
cp "$folder/portrait.png" "$out/portrait.png"
echo "$out/portrait.png"
