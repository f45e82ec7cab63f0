#!/bin/sh
# README's lines for CMake and for Meson, each in a project of C alone and in one of C++ alone: sh tests/dropin/builds.sh OUT
set -u
out=$1
passed=0
failed=0
for system in cmake meson; do
    command -v $system >/dev/null 2>&1 || continue
    [ $system = cmake ] || command -v ninja >/dev/null 2>&1 || continue
    for language in c cpp; do
        project=$out/$system/$language
        rm -rf "$project"
        mkdir -p "$project/third_party/ms"
        cp ms_*.h "$project/third_party/ms/"
        printf '#define MS_PME_IMPLEMENTATION\n#include "ms_pme.h"\nint main(void) { return ms_pme_defaults().tolerance != 0; }\n' >"$project/user.$language"
        if [ $system = cmake ]; then
            file=CMakeLists.txt
            head="cmake_minimum_required(VERSION 3.13)
project(user $(echo $language | sed 's/c/C/; s/pp/XX/'))"
            tail="add_executable(user user.$language)
target_link_libraries(user ms)"
        else
            file=meson.build
            head="project('user', '$language')"
            tail="executable('user', 'user.$language', dependencies: ms)"
        fi
        { echo "$head"; sed -n '/^```'$system'/,/^```$/p' README.md | sed '1d;$d'; echo "$tail"; } >"$project/$file"
        if { case $system in
             cmake) cmake -S "$project" -B "$project/build" && cmake --build "$project/build" ;;
             meson) meson setup "$project/build" "$project" && ninja -C "$project/build" ;;
             esac; } >"$project/log" 2>&1 && "$project/build/user"; then
            passed=$((passed + 1))
        else
            failed=$((failed + 1))
            echo "FAIL $system in a project of $language"
            tail -5 "$project/log"
        fi
    done
done
[ $((passed + failed)) -gt 0 ] || { echo "no CMake and no Meson on this machine"; exit 77; }
echo "$passed passed, $failed failed"
[ $failed = 0 ]
