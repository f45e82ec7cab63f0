#!/bin/sh
# The exhibition (examples/demo/exhibition.sh) from pictures that the repository holds, laid out by headless Chromium at the width of a
# phone and of a desktop: nothing wider than the window, no picture missing, every section there. sh tests/page.sh OUT
set -u
out=$1
mkdir -p "$out/demo"
passed=0
failed=0
check() { # NAME, value, expected
    if [ "$2" = "$3" ]; then passed=$((passed + 1)); else failed=$((failed + 1)); echo "FAIL $1: '$2', expected '$3'"; fi
}
for name in skin1 marble bust knot workflow latent preview materialx; do cp examples/data/demo.png "$out/demo/$name.png"; done
cp examples/data/match.png "$out/demo/match.png"
for channel in red green blue; do cp examples/data/profile.svg "$out/demo/profiles_$channel.svg"; done
echo 'bust.png: before 19.9% | after 10.3% | truth | difference x 4' >"$out/demo/sss.txt"
printf '| stage | size | time, ms |\n|---|---|---:|\n| fit | 250 | 9 |\n' >"$out/demo/times.md"
touch "$out/demo/studio.html" "$out/demo/designer.html"
sh examples/demo/exhibition.sh "$out/demo" >"$out/demo/index.html" || failed=$((failed + 1))
check "the live pages" "$(grep -c 'href="studio.html".*href="designer.html"' "$out/demo/index.html")" 1
check "sections" "$(grep -c '<section' "$out/demo/index.html")" 5
check "closed sections" "$(grep -c '</section' "$out/demo/index.html")" 5
check "the materials' table" "$(grep -c '<td>skin1</td>' "$out/demo/index.html")" 1
check "panels are named" "$(grep -c '>after 10.3%<' "$out/demo/index.html")" 1
browser=""
for name in chromium chromium-browser google-chrome; do [ -n "$browser" ] || browser=$(command -v $name || true); done
if [ -z "$browser" ]; then
    echo "$passed passed, $failed failed, 1 skipped"
    echo "no Chromium on this machine: the layout was not tried"
else
    for width in 390 1600; do
        # a frame of that width, since a window may not get as narrow as a phone
        cat >"$out/demo/frame.html" <<HTML
<iframe id="page" src="index.html" style="width:${width}px;height:900px;border:0"></iframe><p id="found">nothing</p>
<script>onload = () => { const d = document.getElementById("page").contentDocument;
document.getElementById("found").textContent = "over " + Math.max(0, d.documentElement.scrollWidth - $width) + " missing " +
[...d.images].filter(i => !i.complete || i.naturalWidth === 0).length + " of " + d.images.length; };</script>
HTML
        found=$("$browser" --headless --no-sandbox --disable-gpu --no-first-run --disable-background-networking --disable-component-update \
            --disable-sync --allow-file-access-from-files --user-data-dir="$out/profile" --window-size=1800,1000 --virtual-time-budget=10000 \
            --dump-dom "file://$(cd "$out/demo" && pwd)/frame.html" 2>/dev/null | sed -n 's/.*id="found">\([^<]*\)<.*/\1/p')
        check "page of $width pixels" "$found" "over 0 missing 0 of 10"
    done
    rm -rf "$out/profile"
    echo "$passed passed, $failed failed"
fi
[ $failed = 0 ]
