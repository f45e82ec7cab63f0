#!/bin/sh
# The pages of examples/web: not older than their sources, of one file, within their size; then used with a mouse in headless Chromium
# (web.py). sh tests/web.sh OUT
set -u
out=$1
mkdir -p "$out"
passed=0
failed=0
check() { # NAME, value, expected
    if [ "$2" = "$3" ]; then passed=$((passed + 1)); else failed=$((failed + 1)); echo "FAIL $1: '$2', expected '$3'"; fi
}
for page in studio:5000000 kernels:2000000; do
    name=${page%:*}
    file=examples/web/$name.html
    check "$name: of these sources (make $name renews it)" "$(sed -n 's/.*<meta name="sources" content="\([0-9]*\)">.*/\1/p' $file)" "$(sh examples/web/build.sh hash $name)"
    check "$name: below ${page#*:} bytes" "$([ "$(wc -c <$file)" -lt "${page#*:}" ] && echo yes)" yes
    # what would be fetched: an address in an attribute, a style, an import or a call
    check "$name: asks for nothing else" "$(grep -c -E '(src|href)="|url\((http|/)|@import|import +.* from|fetch\(|XMLHttpRequest|WebSocket' $file)" 0
done
# The folder can be served as it is: what the index names lies beside it, and nothing is named by a path from elsewhere.
index=examples/web/index.html
names=$(grep -oE '(src|href)="[^"]*"' $index | sed 's/.*="//; s/"$//' | sort -u)
check "index: pages and their pictures" "$(echo "$names" | tr '\n' ' ')" "babylon.html babylon.jpg kernels.html kernels.jpg studio.html studio.jpg three.html three.jpg "
for name in $names; do check "index: $name is there" "$([ -s "examples/web/$name" ] && echo yes)" yes; done
browser=""
for name in chromium chromium-browser google-chrome google-chrome-stable; do [ -n "$browser" ] || browser=$(command -v $name || true); done
if [ -z "$browser" ] || ! command -v python3 >/dev/null; then
    echo "$passed passed, $failed failed, 1 skipped"
    echo "no Chromium or no python3 on this machine: the pages were not tried"
else
    python3 tests/web.py "$out" >"$out/web.txt" 2>&1
    rc=$?
    cat "$out/web.txt"
    last=$(grep -E '^[0-9]+ passed, [0-9]+ failed' "$out/web.txt" | tail -1)
    passed=$((passed + $(echo "${last:-0}" | awk '{print $1 + 0}')))
    failed=$((failed + $(echo "$last" | awk '{print $3 + 0}')))
    [ -n "$last" ] && { [ $rc = 0 ] || [ "$failed" != 0 ]; } || failed=$((failed + 1))
    echo "$passed passed, $failed failed"
fi
[ $failed = 0 ]
