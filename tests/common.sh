#!/bin/sh
# The blocks that headers share: ms-common and ms-common-private stand in all of them, the others where they are needed.
# `sh tests/common.sh check` compares each byte for byte with its original, in the first header of the list that has it;
# `sh tests/common.sh copy` copies that one into the rest.
set -eu
headers="ms_gpr.h ms_nn.h ms_mcml.h ms_pme.h ms_sss.h"
block() { awk -v mark="$1" '$0 ~ "^/\\* " mark " begin" {on = 1} on {print} $0 ~ "^/\\* " mark " end" {on = 0}' "$2"; }
scratch=build/common
mkdir -p $scratch
bad=0
count=0
for mark in ms-common ms-common-private ms-common-half ms-common-simd ms-common-files; do
    original=""
    for h in $headers; do
        block $mark "$h" >$scratch/copy
        if ! [ -s $scratch/copy ]; then
            case $mark in ms-common | ms-common-private) echo "$h has no block '$mark'" && bad=$((bad + 1)) ;; esac
        elif [ -z "$original" ]; then
            original=$h
            cp $scratch/copy $scratch/original
        elif cmp -s $scratch/original $scratch/copy; then
            count=$((count + 1))
        elif [ "$1" = copy ]; then
            awk -v mark="$mark" -v original=$scratch/original '
                $0 ~ "^/\\* " mark " begin" {while ((getline line < original) > 0) print line; skip = 1}
                !skip {print}
                $0 ~ "^/\\* " mark " end" {skip = 0}' "$h" >$scratch/new
            cat $scratch/new >"$h"
            echo "$h: '$mark' copied from $original"
        else
            echo "$h: the block '$mark' differs from that of $original (make common copies it)"
            diff $scratch/original $scratch/copy | head -5 || true
            bad=$((bad + 1))
        fi
    done
done
[ "$1" = copy ] || echo "$count passed, $bad failed"
[ $bad = 0 ]
