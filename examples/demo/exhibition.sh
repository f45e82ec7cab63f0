#!/bin/sh
# What `make demo` made, on one page: sh examples/demo/exhibition.sh build/demo > build/demo/index.html
# The portrait and the live pages; then a section a header: its pictures with what made them and at what cost, its table, its program;
# last, every file. No script, no network.
set -eu
out=$1

figure() { # PICTURE, what it shows, then the panels' widths and names: 25:before 25:after ...
    [ -f "$out/$1" ] || return 0
    picture=$1
    caption=$2
    shift 2
    echo "<figure>"
    if [ $# -gt 0 ]; then
        echo "<div class=\"labels\">"
        for panel; do echo "<span style=\"width:${panel%%:*}%\">${panel#*:}</span>"; done
        echo "</div>"
    fi
    echo "<a href=\"$picture\"><img src=\"$picture\" alt=\"$caption\"></a><figcaption>$caption</figcaption></figure>"
}
table() { # Markdown table rows on standard input
    echo "<div class=\"wide\"><table>"
    awk -F'|' 'NF > 2 && $0 !~ /^\|[-:| ]+\|$/ {
        cell = n++ ? "td" : "th"
        printf "<tr>"
        for (i = 2; i < NF; ++i) { gsub(/^ +| +$|\*\*/, "", $i); printf "<%s>%s</%s>", cell, $i, cell }
        print "</tr>" }'
    echo "</table></div>"
}
section() { # header, its name, its sentence
    echo "<section id=\"${1%.h}\"><h2>$2 <code>$1</code></h2><p>$3</p>"
}
made() { # the words of sss.txt for a picture
    sed -n "s/^$1: //p" "$out/sss.txt" 2>/dev/null
}
code() { # the command; then the program of the header, which a reader may open
    name=${2:-}
    echo "<p class=\"command\"><code>$1</code></p><details><summary>A whole program, examples/$name.c</summary><pre><code>"
    sed 's/&/\&amp;/g; s/</\&lt;/g; s/>/\&gt;/g' "examples/$name.c"
    echo "</code></pre></details></section>"
}

cat <<'HTML'
<!DOCTYPE html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>ms: material systems in five C headers</title>
<style>
:root{color-scheme:light dark;--ink:#20242a;--soft:#5c6570;--line:#d9dde2;--paper:#fbfaf8;--card:#fff;--accent:#a8402a}
@media (prefers-color-scheme:dark){:root{--ink:#e7e5e1;--soft:#a2a7ae;--line:#34383e;--paper:#15171a;--card:#1d2024;--accent:#f08a6c}}
*{box-sizing:border-box}
body{margin:0;background:var(--paper);color:var(--ink);font:17px/1.55 system-ui,sans-serif}
main{max-width:1460px;margin:0 auto;padding:clamp(1rem,3.5vw,3rem)}
h1{font-size:clamp(1.7rem,5vw,3rem);line-height:1.1;margin:0 0 .4em}
h2{font-size:clamp(1.25rem,3vw,1.7rem);margin:0 0 .3em;color:var(--accent)}
h2 code{font-size:.7em;color:var(--soft);font-weight:400;margin-left:.4em}
p{max-width:70ch;margin:.4em 0 1em}
nav{display:flex;flex-wrap:wrap;gap:.4em 1.4em;margin:1em 0 2.5em}
a{color:var(--accent)}
section{background:var(--card);border:1px solid var(--line);border-radius:14px;padding:clamp(1rem,3vw,2rem);margin:0 0 2rem}
figure{margin:1rem 0}
img{display:block;width:100%;height:auto;border-radius:6px}
.labels{display:flex;font-size:clamp(.6rem,1.6vw,.9rem);color:var(--soft);margin:0 0 .3em}
.labels span{text-align:center;padding:0 .2em;overflow-wrap:anywhere}
figcaption{font-size:.9rem;color:var(--soft);margin-top:.4em}
.plots{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,300px),1fr));gap:0 1rem}
.plots img{background:#fff}
.live{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,320px),1fr));gap:1rem;margin:1rem 0 2rem}
.live a{display:block;background:var(--card);border:1px solid var(--line);border-radius:14px;padding:1rem;text-decoration:none;color:var(--ink)}
.live b{color:var(--accent)}
summary{cursor:pointer;color:var(--soft);font-size:.9rem;margin:0 0 .5em}
.wide{overflow-x:auto}
table{border-collapse:collapse;font-variant-numeric:tabular-nums;font-size:.95rem;margin:.5rem 0 1rem}
td,th{padding:.25em .9em;border-bottom:1px solid var(--line);text-align:right;white-space:nowrap}
td:first-child,th:first-child{text-align:left;padding-left:0}
pre{overflow-x:auto;background:var(--paper);border:1px solid var(--line);border-radius:8px;padding:.2em 1em;font-size:.85rem;margin:0}
code{font-family:ui-monospace,monospace}
.command{margin:1em 0 .5em;color:var(--soft);font-size:.9rem;overflow-wrap:anywhere}
.command::before{content:"$ ";color:var(--accent)}
</style>
<main>
<h1>Material systems in five C headers</h1>
<p>Programs of this repository made the pictures and tables below on this machine, when <code>make demo</code> ran. Copies of
<code>examples/data</code>, which take longer, say so. Times are those of this machine, one core.</p>
HTML
figure portrait.png "A head of skin without scattering, and by ms_sss.h with 7 taps a pass; below, parts of both beside path tracing (a copy of examples/data/portrait.png: make portrait)"
cat <<'HTML'
<div class="live"><a href="kernels.html"><b>Live: the kernel designer</b><br>Light under the surface of a head and a knot. Change the material, copy the kernel and the shader.</a>
<a href="studio.html"><b>Live: the studio</b><br>Score materials. It learns what you like, recommends more, and matches what you paint.</a></div>
<nav><a href="#ms_sss">subsurface scattering</a><a href="#ms_mcml">diffusion profiles</a><a href="#ms_gpr">a learned taste</a><a href="#ms_nn">neural previews</a><a href="#ms_pme">from a picture to its material</a><a href="#files">all files</a></nav>
HTML

section ms_sss.h "Subsurface scattering" "A filter over the light of a picture, in an engine's frame or on a render, measured against path-traced truth."
if [ -f "$out/sss.txt" ]; then
    while IFS= read -r line; do
        case $line in
        skin1.png:*) caption="Skin (skin1 of the thesis), filtered in the surface's light before its color: build/demo_sss" ;;
        marble.png:*) caption="Marble, the same way" ;;
        *.png:*) caption="The same light without scattering, by two methods, and path-traced by random walks (examples/data/truth_${line%%.png*}.bin). Errors: root mean square of the difference from the walks over the object, in % of the walks' own; ns: a pixel of the object" ;;
        *) continue ;;
        esac
        old=$IFS; IFS='|'; set -- ${line#*:}; IFS=$old
        width=$(awk -v n=$# 'BEGIN {print 100 / n}')
        picture=${line%%:*}
        labels=""
        for label; do labels="$labels
$width:$(echo "$label" | sed 's/^ *//; s/ *$//')"; done
        old=$IFS; IFS='
'; set -f; figure "$picture" "$caption" $labels; set +f; IFS=$old
    done <"$out/sss.txt"
fi
figure skins.png "Six skins from what skin is made of: build/profile --skin melanin=0.02,eumelanin=0.7,blood=0.04; $(made skins)" "16.6:melanin 0.4%" 16.6:2% 16.6:5% 16.6:10% 16.6:20% 16.6:40%
echo '<p><a href="models.html">Kernel models and their errors</a>: 17 ways to make a separable kernel, on a dot, a disk and a step</p>'
code "build/sss_filter irradiance.pfm depth.pfm out.png --material skin1 --fov 24" ms_sss

section ms_mcml.h "Diffusion profiles" "How light spreads in skin, milk and marble, from optical coefficients, without noise: what leaves at a distance from where a thin beam enters."
echo '<div class="plots">'
for channel in red green blue; do figure profiles_$channel.svg "$channel; $(made profiles)"; done
echo '</div>'
{ echo "| material | reflectance red | green | blue |"
  echo "|---|---|---|---|"
  for material in $(build/profile --list | awk '{print $1}'); do
      build/profile "$material" | awk -F, -v name="$material" '/^# total_reflectance/ {printf "| %s | %.4f | %.4f | %.4f |\n", name, $2, $3, $4; exit}'
  done; } | table
code "build/profile skin1" ms_mcml

section ms_gpr.h "A learned taste" "Score a gallery, get hundreds of materials to your taste, and a plane to walk in."
figure hero.png "Materials recommended to five tastes, on 209 objects, path-traced (a copy of examples/data/hero.png: make hero)"
sum=$(sed -n 's/^| \*\*sum\*\* |[^*]*\*\*\([0-9]*\)\*\*.*/\1/p' "$out/times.md" 2>/dev/null || true)
figure workflow.png "build/workflow, ${sum:-1000} ms in all: a gallery that a program scores, what is recommended from it, the plane of the best (white: embedded, red: chosen, black: variants), an edited picture's match, a walk through the plane. Pictures by the networks preview_64 and renderer_128"
figure latent.png "Another taste, of 150 scores: the plane of its best materials by ms_gpr_latent_fit. build/latent examples/data/scores.csv latent.png examples/data/renderer_64.safetensors"
figure materialx.png "Eight materials by the path tracer, and by the shader that MaterialX's own library makes of the file that build/materialx writes (a copy of examples/data/materialx.png)"
[ ! -f "$out/recommend.txt" ] || echo "<p>build/recommend on examples/data/scores.csv: $(tr '\n' ' ' <"$out/recommend.txt")</p>"
[ ! -f "$out/workflow.txt" ] || echo "<p>build/workflow: $(awk 'NF == 0 {exit} {print}' "$out/workflow.txt" | tr '\n' ' ')</p>"
[ ! -f "$out/times.md" ] || awk 'NF == 0 {exit} {print}' "$out/times.md" | table
code "build/recommend examples/data/scores.csv --count 300" ms_gpr

section ms_nn.h "Neural previews" "Pictures of materials by networks of a few megabytes."
figure preview.png "64 materials that the network never saw: renderer_128, 3.9 MB, $(sed -n 's/^64 materials.*, \([0-9.]* ms\) each/\1/p' "$out/preview_psnr.txt" 2>/dev/null) a picture" 33.3:network 33.3:path-traced 33.3:"difference × 8"
[ ! -f "$out/preview_psnr.txt" ] || echo "<p>Peak signal-to-noise ratio over the 64 pictures, against path-traced ones with their noise: $(sed -n 's/.*noise: //p' "$out/preview_psnr.txt").</p>"
code "build/preview examples/data/renderer_128.safetensors examples/data/materials.csv sheet.png examples/data/materials.png" ms_nn

section ms_pme.h "From a picture to its material" "The material whose picture is nearest to an edited one."
figure match.png "Eight edited pictures, and the materials that come nearest to them: ms_pme_match with renderer_128 and nine inversion networks, times in the table. * Edited in part, of the object or of what is around it: no material explains that, and the nearest is shown"
[ ! -f "$out/match_rmse.txt" ] || { echo '| edit | RMSE of the match, levels of 255 | of the best inversion network | which | time, ms |'; echo '|---|---|---|---|---|'
    sed -n 's/^\(.*[^ ]\)  *RMSE *\([0-9.]*\) of 255 from *\([0-9.]*\) by \([a-z_0-9]*\), \([0-9.]*\) ms$/| \1 | \2 | \3 | \4 | \5 |/p' "$out/match_rmse.txt"; } | table
code "build/match examples/data/renderer_128.safetensors edited.png --inversion examples/data --out-png match.png" ms_pme
echo '<section id="files"><h2>All files</h2><p>'
for f in "$out"/*; do
    f=${f##*/}
    case $f in index.html) ;; *) echo "<a href=\"$f\">$f</a>" ;; esac
done
echo '</p></section>'
echo "</main></html>"
