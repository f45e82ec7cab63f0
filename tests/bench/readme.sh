#!/bin/sh
# Puts build/bench/NAME.md between the marks <!-- bench:NAME --> and <!-- end --> of README.md.
set -eu
awk '
    /^<!-- bench:[a-z0-9_]+ -->$/ {
        name = $2; sub(/^bench:/, "", name); file = "build/bench/" name ".md"
        print
        if ((getline line < file) > 0) {
            print line
            while ((getline line < file) > 0) print line
            close(file)
            skip = 1
        }
        next
    }
    /^<!-- end -->$/ {skip = 0}
    !skip {print}' README.md >build/bench/README.md
cmp -s build/bench/README.md README.md || cat build/bench/README.md >README.md
