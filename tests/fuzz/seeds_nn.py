#!/usr/bin/env python3
"""The seeds net_layers_*.safetensors of fuzz_safetensors: small networks of every kind of layer and activation, all weights 0.25.
python3 tests/fuzz/seeds_nn.py tests/fuzz/corpus_safetensors"""
import json, struct, sys

SEEDS = {
    "conv1d": ("[4,6]", [{"type": "conv1d", "name": "a", "kernel": 3, "filters": 4, "stride": 2, "zeros": 2, "activation": "silu"}], {"a": [4, 4, 3]}),
    "conv2d": ("[2,3,3]", [{"type": "conv2d", "name": "a", "filters": 2, "kernel": [3, 2], "stride": [2, 1], "zeros": [1, 0], "activation": "gelu"}, {"type": "upsample2d", "factor": [2, 3]}], {"a": [2, 2, 3, 2]}),
    "pools": ("[2,6,6]", [{"type": "avgpool2d", "size": 3, "stride": 1}, {"type": "maxpool2d"}, {"type": "globalpool"}], {}),
    "chain": ("[2,3]", [{"type": "flatten", "order": "channels_last"}, {"type": "dense", "name": "a", "activation": "softplus"},
                        {"type": "dense", "name": "b", "activation": "tanh"}], {"a": [4, 6], "b": [2, 4]}),
    "skips": ("[4]", [{"type": "dense", "name": "a", "activation": "leaky_relu", "alpha": 0.2}, {"type": "dense", "name": "b", "activation": "sigmoid"},
                      {"type": "add", "from": "a", "activation": "relu"}], {"a": [4, 4], "b": [4, 4]}),
    "planes": ("[3]", [{"type": "shared_channels", "inputs": [[0, 2], [1, 2]]}, {"type": "dense", "name": "a", "activation": "elu"},
                       {"type": "dense", "name": "b"}], {"a": [5, 2], "b": [4, 5]}),
}

for name, (shape, layers, weights) in SEEDS.items():
    header = {"__metadata__": {"ms_nn_version": "1", "ms_nn_input": shape, "ms_nn_layers": json.dumps(layers, separators=(",", ":"))}}
    data = b""
    for layer, sizes in weights.items():
        for part, dims in (("weight", sizes), ("bias", [sizes[0]])):
            count = 1
            for d in dims:
                count *= d
            header[layer + "." + part] = {"dtype": "F32", "shape": dims, "data_offsets": [len(data), len(data) + 4 * count]}
            data += struct.pack("<f", 0.25) * count
    text = json.dumps(header, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 8)
    with open("%s/net_layers_%s.safetensors" % (sys.argv[1], name), "wb") as f:
        f.write(struct.pack("<Q", len(text)) + text + data)
