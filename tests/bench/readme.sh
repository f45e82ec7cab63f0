#!/bin/sh
# Puts build/bench/NAME.md between the marks <!-- bench:NAME --> and <!-- end --> of README.md and tests/bench/RESULTS.md.
set -eu
for page in README.md tests/bench/RESULTS.md; do
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
    !skip {print}' "$page" >build/bench/page.md
    cmp -s build/bench/page.md "$page" || cat build/bench/page.md >"$page"
done
