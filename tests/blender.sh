#!/bin/sh
# The add-on of examples/blender in a headless Blender, and its layer for Windows where MinGW is there. sh tests/blender.sh OUT
set -eu
out=$1
command -v blender >/dev/null || { echo "no Blender on this machine: make deps BLENDER=1"; exit 77; }
mkdir -p "$out"
flat() { "$@" -shared -I. -Iexamples/tools examples/blender/flat.c -lm; }
flat ${CC:-cc} -std=c99 -O1 -fPIC -fvisibility=hidden -o "$out/libms_flat.so"
MS_FLAT="$out/libms_flat.so" blender -b --factory-startup -t 1 --python tests/blender.py -- "$out" >"$out/blender.txt" 2>&1 || rc=$?
grep -E -v '^(Fra:|Saved:| Time:|$)' "$out/blender.txt" | tail -40
if command -v x86_64-w64-mingw32-gcc >/dev/null; then
    flat x86_64-w64-mingw32-gcc -O0 -static -o "$out/ms_flat.dll"
else
    echo "no MinGW on this machine: the layer was not built for Windows"
fi
exit ${rc:-0}
