#!/bin/sh
# make portrait: README's first picture into OUT (examples/data/portrait.png): a head of skin without scattering and by ms_sss.h, and parts of
# it beside a path-traced picture (WALKS, 128, a pixel and channel). Needs Embree (make deps), and Chromium for the words. Ten minutes on one core.
set -eu
folder=build/portrait
walks=${WALKS:-128}
out=${OUT:-examples/data/portrait.png}
mkdir -p "$folder"
for embree in embree4 embree3 none; do
    echo "#include <$embree/rtcore.h>" >"$folder/embree.c"
    ! ${CC:-cc} -c "$folder/embree.c" -o "$folder/embree.o" 2>/dev/null || break
done
${CC:-cc} -std=c99 -O3 -D_POSIX_C_SOURCE=200809L -I. -Itests -Iexamples/tools -Iexamples/demo -Iexamples/engine tests/render/portrait.c -o "$folder/portrait" "-l$embree" -lm
browser=""
for name in chromium chromium-browser google-chrome google-chrome-stable; do [ -n "$browser" ] || browser=$(command -v $name || true); done
[ -n "$browser" ] || { echo "make portrait: no Chromium, which draws the words"; exit 1; }
width=1600 height=900
"$folder/portrait" without "$folder/without.png" $width $height
"$folder/portrait" taps "$folder/taps.png" $width $height
# parts of 176 x 220 pixels: their left and upper edges
parts="nose:560:430 ear:962:372 lips:548:610"
for part in $parts; do
    name=${part%%:*} left=$(echo "$part" | cut -d: -f2) top=$(echo "$part" | cut -d: -f3)
    [ -s "$folder/walk_${name}_$walks.png" ] ||
        "$folder/portrait" walk "$folder/walk_${name}_$walks.png" $width $height "$left" "$top" $((left + 176)) $((top + 220)) "$walks"
done
{
    echo '<!doctype html><meta charset="utf-8"><style>body{margin:0;width:1600px;background:#101214;color:#e8e6e3;font:22px "DejaVu Sans",Arial,sans-serif}
.heads,.parts{display:flex;justify-content:space-between}.head{position:relative;width:799px;height:900px;background-position:-400px 0}
.head span{position:absolute;left:20px;top:16px;font-size:28px}.group{display:flex;gap:2px}.part{width:176px}.part div{height:220px}
.part p{margin:7px 0 10px;text-align:center;font-size:18px}.parts{margin-top:2px}</style><div class="heads">'
    echo '<div class="head" style="background-image:url(without.png)"><span>without</span></div>'
    echo '<div class="head" style="background-image:url(taps.png)"><span>ms_sss.h, 7 taps</span></div></div><div class="parts">'
    for part in $parts; do
        name=${part%%:*} left=$(echo "$part" | cut -d: -f2) top=$(echo "$part" | cut -d: -f3)
        echo '<div class="group">'
        for kind in without taps; do
            echo "<div class=part><div style=\"background:url($kind.png) -${left}px -${top}px\"></div><p>$([ $kind = taps ] && echo 7 taps || echo without)</p></div>"
        done
        echo "<div class=part><div style=\"background:url(walk_${name}_$walks.png)\"></div><p>path-traced</p></div></div>"
    done
    echo '</div>'
} >"$folder/portrait.html"
"$browser" --headless --no-sandbox --disable-gpu --hide-scrollbars --window-size=1600,1160 --screenshot="$folder/portrait.png" "file://$PWD/$folder/portrait.html" >"$folder/browser.log" 2>&1
cp "$folder/portrait.png" "$out"
echo "$out"
