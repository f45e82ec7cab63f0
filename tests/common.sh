#!/bin/sh
# The blocks that headers share, two in all of them, the others where they are needed: `sh tests/common.sh check` compares
# them byte for byte with ms_mcml.h's, `sh tests/common.sh copy` copies ms_mcml.h's into the rest.
set -eu
block() { awk -v mark="$1" '$0 ~ "^/\\* " mark " begin" {on = 1} on {print} $0 ~ "^/\\* " mark " end" {on = 0}' "$2"; }
scratch=build/common
mkdir -p $scratch
bad=0
count=0
for h in ms_*.h; do
    [ "$h" != ms_mcml.h ] || continue
    for mark in ms-common ms-common-private ms-common-simd ms-common-files; do
        block $mark ms_mcml.h >$scratch/original
        block $mark "$h" >$scratch/copy
        case $mark in *-simd | *-files) [ -s $scratch/copy ] || continue ;; esac
        if ! [ -s $scratch/original ] || ! [ -s $scratch/copy ]; then
            echo "$h or ms_mcml.h has no block '$mark'"
            bad=$((bad + 1))
        elif ! cmp -s $scratch/original $scratch/copy; then
            if [ "$1" = copy ]; then
                awk -v mark="$mark" -v original=$scratch/original '
                    $0 ~ "^/\\* " mark " begin" {while ((getline line < original) > 0) print line; skip = 1}
                    !skip {print}
                    $0 ~ "^/\\* " mark " end" {skip = 0}' "$h" >$scratch/new
                cat $scratch/new >"$h"
                echo "$h: '$mark' copied from ms_mcml.h"
            else
                echo "$h: the block '$mark' differs from ms_mcml.h's (make common copies it)"
                diff $scratch/original $scratch/copy | head -5 || true
                bad=$((bad + 1))
            fi
        else
            count=$((count + 1))
        fi
    done
done
[ "$1" = copy ] || echo "$count passed, $bad failed"
[ $bad = 0 ]
