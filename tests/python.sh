#!/bin/sh
# Runs a Python test with the first interpreter that has PyTorch; exit 77 where there is none.
for python in python3 /usr/bin/python3 /usr/local/bin/python3; do
    if $python -c 'import torch' >/dev/null 2>&1; then exec $python "$@"; fi
done
echo "no Python with PyTorch on this machine"
exit 77
