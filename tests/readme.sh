#!/bin/sh
# README's tables between <!-- rows --> and <!-- end --> hold rows of tests/bench/RESULTS.md: a row's first cell stands there as a first cell,
# and each of its other cells in that row, but for those of a column "call", whose functions a header declares. Links and pictures lead
# somewhere. Programs below <!-- program --> compile as C and as C++ without a warning, and run; what stands below <!-- shader --> compiles
# before the shader file. At most 200 lines of 110 columns.
set -u
passed=0
failed=0
out=$(awk -F'|' '
function trim(s) { gsub(/^[ *]+|[ *]+$/, "", s); return s }
FNR == NR {
    if ($0 ~ /^\|/ && $0 !~ /^\|[-:| ]+\|$/) { row = "|"; for (i = 2; i < NF; ++i) row = row trim($i) "|"; name = trim($2); rows[name] = rows[name] "\n" row }
    next
}
/^<!-- rows -->$/ { on = 1; head = 0; next }
/^<!-- end -->$/ { on = 0 }
on && /^\|/ && $0 !~ /^\|[-:| ]+\|$/ {
    if (!head++) { call = 0; for (i = 2; i < NF; ++i) if (trim($i) == "call") call = i; next }
    name = trim($2)
    if (!(name in rows)) { print "FAIL no row \"" name "\" in RESULTS.md"; next }
    n = split(rows[name], candidate, "\n")
    good = 0
    for (k = 2; k <= n && !good; ++k) {
        good = 1
        for (i = 3; i < NF; ++i) { cell = trim($i); if (i != call && cell != "" && index(candidate[k], "|" cell "|") == 0) good = 0 }
    }
    print good ? "ok" : "FAIL README says other than RESULTS.md: " $0
}' tests/bench/RESULTS.md README.md)
passed=$(echo "$out" | grep -c '^ok')
failed=$(echo "$out" | grep -c '^FAIL')
echo "$out" | grep '^FAIL'
for target in $(grep -o '](\([^)#]*\))' README.md | sed 's/^](//; s/)$//' | grep -v '^http' | sort -u); do
    if [ -e "$target" ]; then passed=$((passed + 1)); else failed=$((failed + 1)); echo "FAIL README links to $target, which is not there"; fi
done
lines=$(wc -l <README.md)
check() { # NAME, then a command that must succeed
    name=$1
    shift
    if "$@"; then passed=$((passed + 1)); else failed=$((failed + 1)); echo "FAIL $name"; fi
}
check "README has $lines lines" [ "$lines" -le 200 ]
check "README has a line of more than 110 columns" [ "$(awk '{gsub(/[\200-\277]/, "")} length > 110' README.md | wc -l)" = 0 ]
for build in cmake meson; do check "README has no lines for $build" grep -q "^\`\`\`$build\$" README.md; done # tests/dropin/builds.sh runs them
for name in $(grep -o '`ms_[a-z]*_[a-z_]*`' README.md | tr -d '`' | sort -u); do
    check "no header declares or lists $name" grep -qE "^MS_API .*[ *]$name\(|^ +[0-9]+  $name " ms_*.h
done
work=${TMPDIR:-/tmp}/ms_readme.$$
mkdir -p "$work"
awk -v out="$work" '/^<!-- program -->$/ {n = n + 1; next} /^```c$/ && n > done {on = 1; next} /^```$/ && on {on = 0; done = n} on {print > (out "/" n ".c")}' README.md
for program in "$work"/*.c; do
    check "the program of README as C" ${CC:-cc} -std=c99 -Wall -Wextra -pedantic -Werror -I. "$program" -o "$work/program" -lm
    check "what it prints is constants" [ "$("$work/program" | awk 'NF == 4 && $1 + 0 == $1' | wc -l)" = 13 ]
    if command -v ${CXX:-c++} >/dev/null; then check "as C++" ${CXX:-c++} -x c++ -std=c++11 -Wall -Wextra -Werror -fsyntax-only -I. "$program"; fi
done
if command -v glslangValidator >/dev/null; then
    for step in 0 1; do
        awk -v step=$step '/^<!-- shader -->$/ {on = 1} /^```$/ {on = 0} on && !/^(<!--|```)/ {if (/MS_SSS_STEP/) $3 = step; print}' README.md |
            cat - examples/engine/shader/ms_sss.glsl >"$work/pass.frag"
        check "pass $step of README" sh -c "glslangValidator '$work/pass.frag' >/dev/null"
    done
fi
rm -rf "$work"
echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
