#!/bin/sh
# The program in a header's comment, as C99 and as C++11: sh tests/compile/manual.sh HEADER OUT. It stands between
# the lines "   Example:" and "   End of example.", indented by six spaces.
set -eu
sed -n '/^   Example:/,/^   End of example\./p' "$1" | sed '1d;$d' | sed 's/^      //' >"$2.c"
if ! grep -q main "$2.c"; then
    echo "$1 has no example in its comment"
    exit 1
fi
warn="-Wall -Wextra -pedantic -Wconversion -Wshadow -Werror"
${CC:-cc} -std=c99 -O2 -I. $warn "$2.c" -o "$2" -lm
folder=$(mktemp -d)
program=$(pwd)/$2
(cd "$folder" && "$program")
${CXX:-c++} -x c++ -std=c++11 -O2 -I. $warn "$2.c" -o "$2" -lm
(cd "$folder" && "$program")
rm -rf "$folder"
