#!/bin/sh
# README's Meson snippet in a project of C alone and in one of C++ alone: sh tests/dropin/meson.sh OUT
set -u
out=$1
if ! command -v meson >/dev/null 2>&1 || ! command -v ninja >/dev/null 2>&1; then
    echo "no meson on this machine"
    exit 77
fi
passed=0
failed=0
for language in c cpp; do
    project=$out/$language
    rm -rf "$project"
    mkdir -p "$project/third_party/ms"
    cp ms_*.h "$project/third_party/ms/"
    { echo "project('user', '$language')"
      sed -n '/^```meson/,/^```$/p' README.md | sed '1d;$d'
      echo "executable('user', 'user.$language', dependencies: ms)"; } >"$project/meson.build"
    printf '#define MS_PME_IMPLEMENTATION\n#include "ms_pme.h"\nint main(void) { return ms_pme_defaults().tolerance != 0; }\n' >"$project/user.$language"
    if meson setup "$project/build" "$project" >"$out/log" 2>&1 && ninja -C "$project/build" >>"$out/log" 2>&1 && "$project/build/user"; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "FAIL a project of $language"
        tail -5 "$out/log"
    fi
done
echo "$passed passed, $failed failed"
[ $failed = 0 ]
