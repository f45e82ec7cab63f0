#!/bin/sh
# README's tables between <!-- rows --> and <!-- end --> hold rows of tests/bench/RESULTS.md: a row's first cell stands there as a first cell,
# and each of its other cells in that row. Links and pictures of README lead somewhere. At most 250 lines.
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
    if (!head++) next
    name = trim($2)
    if (!(name in rows)) { print "FAIL no row \"" name "\" in RESULTS.md"; next }
    n = split(rows[name], candidate, "\n")
    good = 0
    for (k = 2; k <= n && !good; ++k) {
        good = 1
        for (i = 3; i < NF; ++i) { cell = trim($i); if (cell != "" && index(candidate[k], "|" cell "|") == 0) good = 0 }
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
if [ "$lines" -le 250 ]; then passed=$((passed + 1)); else failed=$((failed + 1)); echo "FAIL README has $lines lines"; fi
echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
