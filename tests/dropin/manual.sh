#!/bin/sh
# The program in a header's comment, in a folder of its own: sh tests/dropin/manual.sh HEADER OUT [COMPILER FLAGS...]. It
# stands between the lines "   Example:" and "   End of example.", indented by six spaces. -fsyntax-only does not run it.
set -eu
header=$1
out=$2
shift 2
[ $# -gt 0 ] || set -- ${CC:-cc} -std=c99
sed -n '/^   Example:/,/^   End of example\./p' "$header" | sed '1d;$d' | sed 's/^      //' >"$out.c"
if ! grep -q main "$out.c"; then
    echo "$header has no example in its comment"
    exit 1
fi
"$@" -O0 -I. -Wall -Wextra -pedantic -Wconversion -Wshadow -Werror "$out.c" -o "$out" -lm
case " $* " in *" -fsyntax-only "*) exit ;; esac
folder=$(mktemp -d)
program=$(pwd)/$out
(cd "$folder" && "$program")
rm -rf "$folder"
