#!/bin/sh
# Runs a Python test with the first interpreter that has PyTorch, else with one that has numpy; exit 77 where there is none.
for module in torch numpy; do
    for python in python3 /usr/bin/python3 /usr/local/bin/python3; do
        if $python -c "import $module" >/dev/null 2>&1; then exec $python "$@"; fi
    done
done
echo "no Python with PyTorch or numpy on this machine"
exit 77
