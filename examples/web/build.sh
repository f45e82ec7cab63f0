#!/bin/sh
# A page of one file: sh examples/web/build.sh studio OUT.html; kernels; three, which also writes sss_three.js beside it; babylon, and sss_babylon.js.
# WebAssembly by clang with wasi-libc; the networks of the studio packed (pack.c) from examples/data; three.js (MIT license) into three.html by esbuild,
# both from npm (make deps). `sh examples/web/build.sh hash studio` is what a page of these sources carries.
set -eu
cd "$(dirname "$0")/../.."
web=examples/web

sources() { # what page $1 is made of
    case $1 in
    studio) echo ms_gpr.h ms_nn.h ms_pme.h examples/tools/studio.h examples/tools/space.h examples/tools/plane.h examples/tools/neural.h examples/tools/matcher.h examples/tools/maps.h $(ls examples/tools/warnings.h 2>/dev/null) examples/tools/materialx.h \
        examples/tools/files.h examples/tools/image.h $web/studio.c $web/wasi.js $web/studio.worker.js $web/studio.js $web/page.css $web/studio.css \
        $web/studio.part.html $web/pack.c $web/build.sh examples/data/renderer_128.safetensors examples/data/inversion_6.safetensors ;;
    kernels) echo ms_mcml.h ms_sss.h examples/engine/shader/ms_sss.glsl examples/engine/shader/ms_sss_pyramid.glsl examples/tools/wgsl.h examples/demo/scene.h examples/tools/image.h examples/tools/files.h examples/tools/layered.h examples/tools/skin.h $web/kernels.c $web/wasi.js $web/kernels.worker.js \
        $web/kernels.js $web/page.css $web/kernels.css $web/kernels.part.html $web/kernels_poster.jpg $web/build.sh ;;
    three) echo ms_sss.h examples/engine/shader/ms_sss.glsl $web/three.c $web/sss_core.part.js $web/sss_three.part.js $web/three.page.js $web/three.unpack.js $web/three.part.html $web/build.sh ;;
    babylon) echo ms_sss.h examples/engine/shader/ms_sss.glsl $web/three.c $web/sss_core.part.js $web/sss_babylon.part.js $web/babylon.page.js $web/babylon.part.html $web/build.sh \
        examples/data/truth_bust.bin examples/data/truth_knot.bin examples/data/truth_skin1.csv examples/data/truth_marble.csv ;;
    *) echo "no page of that name: $1" >&2; exit 2 ;;
    esac
}
# Comments of C do not make a page older.
hash() {
    for f in $(sources "$1"); do
        case $f in
        *.h | *.c) awk '{
            line = $0; kept = ""
            while (line != "") {
                if (inside) { at = index(line, "*/"); if (!at) break; line = substr(line, at + 2); inside = 0 }
                else { at = index(line, "/*"); if (!at) { kept = kept line; break }
                    kept = kept substr(line, 1, at - 1); line = substr(line, at + 2); inside = 1 }
            }
            sub(/[ \t]+$/, "", kept); if (kept != "") print kept }' "$f" | cksum ;;
        *) cksum <"$f" ;;
        esac
    done | cksum | awk '{print $1}'
}
[ "$1" != hash ] || { hash "$2"; exit; }

page=$1
out=$2
if ! printf '#include <stdlib.h>\nint main(void) { return 0; }\n' | ${WASM_CC:-clang} --target=wasm32-wasi -x c - -o /dev/null 2>/dev/null; then
    echo "no WebAssembly here: wants clang, lld, wasi-libc and libclang-rt-dev-wasm32 (WASM_CC=... for another clang)" >&2
    exit 1
fi
made=build/web
mkdir -p "$made" "$(dirname "$out")"
case $page in
babylon) program=three; level=-Os ;;
three) program=three; level=-Os ;; # a kernel or two, once
*) program=$page; level="-O3 -msimd128" ;;
esac
echo "compiling $program.wasm"
# shellcheck disable=SC2086
${WASM_CC:-clang} --target=wasm32-wasi -mexec-model=reactor $level -I. $web/"$program".c -o "$made/$program.wasm" \
    -D_WASI_EMULATED_PROCESS_CLOCKS -lwasi-emulated-process-clocks -Wl,-z,stack-size=524288 -Wl,--strip-all
if [ "$page" = three ]; then # a module, and a page that holds it and three.js, because browsers do not import from files
    module=$(dirname "$out")/sss_three.js
    packages=${MS_PACKAGES:-${HOME:-.}/.cache/ms/npm}/node_modules
    if [ ! -x "$packages/.bin/esbuild" ] || ! grep -q '"version": "0.187.0"' "$packages/three/package.json" 2>/dev/null; then
        echo "no three.js 0.187.0 or no esbuild in $packages: make deps installs them" >&2
        exit 1
    fi
    {
        echo "// sources $(hash three)"
        cat $web/sss_three.part.js $web/sss_core.part.js
        echo 'const SHADER = `'
        cat examples/engine/shader/ms_sss.glsl # without a backquote or a backslash
        echo '`;'
        echo "const BINARY = '$(gzip -9nc "$made/three.wasm" | base64 | tr -d '\n')';"
    } >"$made/sss_three.js"
    cat "$made/sss_three.js" $web/three.page.js >"$made/three.entry.js"
    "$packages/.bin/esbuild" "$made/three.entry.js" --bundle --minify --format=esm --charset=utf8 --log-level=warning --legal-comments=none \
        --alias:three="$packages/three/build/three.module.js" --outfile="$made/three.bundle.js"
    {
        echo '<!DOCTYPE html>'
        echo "<!-- sources $(hash three). This page holds three.js 0.187.0 (threejs.org), whose license is:"
        echo
        cat "$packages/three/LICENSE"
        echo '-->'
        cat $web/three.part.html
        echo "<script type=\"application/base64\" id=\"packed\">$(gzip -9nc "$made/three.bundle.js" | base64 | tr -d '\n')</script>"
        echo '<script type="module">'
        cat $web/three.unpack.js
        echo '</script>'
    } >"$made/three.html"
    mv "$made/sss_three.js" "$module"
    mv "$made/three.html" "$out"
    echo "$out: $(wc -c <"$out" | tr -d ' ') bytes"
    exit
fi
if [ "$page" = babylon ]; then # a script, which pages take from files as well, and the page with the light and the truth of two objects
    module=$(dirname "$out")/sss_babylon.js
    {
        echo "// sources $(hash babylon)"
        echo '(() => {'
        echo 'const SHADER = `'
        cat examples/engine/shader/ms_sss.glsl
        echo '`;'
        cat $web/sss_core.part.js $web/sss_babylon.part.js
        echo "const BINARY = '$(gzip -9nc "$made/three.wasm" | base64 | tr -d '\n')';"
        echo '})();'
    } >"$made/sss_babylon.js"
    {
        echo '<!DOCTYPE html>'
        echo "<!-- sources $(hash babylon) -->"
        echo '<meta charset="utf-8">'
        echo '<meta name="viewport" content="width=device-width, initial-scale=1">'
        cat $web/babylon.part.html
        echo '<script src="https://cdn.jsdelivr.net/npm/babylonjs@9.35.0/babylon.js"></script>'
        echo '<script src="sss_babylon.js"></script>'
        for object in bust:skin1 knot:marble; do
            echo "<script type=\"application/base64\" id=\"${object%:*}\">$(gzip -9nc examples/data/truth_"${object%:*}".bin | base64 | tr -d '\n')</script>"
            echo "<script type=\"text/csv\" id=\"${object%:*}-profile\">"
            cat examples/data/truth_"${object#*:}".csv
            echo '</script>'
        done
        echo '<script type="module">'
        cat $web/babylon.page.js
        echo '</script>'
    } >"$made/babylon.html"
    mv "$made/sss_babylon.js" "$module"
    mv "$made/babylon.html" "$out"
    echo "$out: $(wc -c <"$out" | tr -d ' ') bytes"
    exit
fi
base64_of() { gzip -9nc "$1" | base64 | tr -d '\n'; }
binary() { # id, file
    printf '<script type="application/base64" %s>' "$1"
    base64_of "$2"
    echo '</script>'
}
{
    cat <<HTML
<!DOCTYPE html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="sources" content="$(hash "$page")">
HTML
    sed -n '1{/^<title>/p;}' $web/"$page".part.html
    echo "<style>"
    cat $web/page.css $web/"$page".css
    [ "$page" != kernels ] || echo "#poster{background:center/cover url(data:image/jpeg;base64,$(base64 <$web/kernels_poster.jpg | tr -d '\n'))}"
    echo "</style>"
    sed '1{/^<title>/d;}' $web/"$page".part.html
    binary 'id="binary"' "$made/$page.wasm"
    echo '<script type="text/plain" id="wasi">'
    cat $web/wasi.js
    echo '</script>'
    if [ "$page" = studio ]; then
        echo "packing networks" >&2
        ${CC:-cc} -std=c99 -I. $web/pack.c -o "$made/pack" -lm
        for network in renderer_128 inversion_6; do
            "$made/pack" examples/data/$network.safetensors "$made/$network.safetensors"
            binary "data-network=\"${network%_*}\"" "$made/$network.safetensors"
        done
    fi
    if [ "$page" = kernels ]; then
        for part in ms_sss ms_sss_pyramid; do
            echo "<script type=\"text/plain\" id=\"$part\">"
            cat examples/engine/shader/$part.glsl
            echo '</script>'
        done
    fi
    echo '<script type="text/plain" id="worker">'
    cat $web/"$page".worker.js
    echo '</script>'
    echo '<script>'
    cat $web/"$page".js
    echo '</script>'
    echo '</html>'
} >"$made/$page.html"
mv "$made/$page.html" "$out"
echo "$out: $(wc -c <"$out" | tr -d ' ') bytes"
