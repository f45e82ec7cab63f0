#!/usr/bin/env python3
"""The seeds net_layers_*.safetensors of fuzz_safetensors: small networks of every kind of layer and activation, all weights 0.25.
python3 tests/fuzz/seeds_nn.py tests/fuzz/corpus_safetensors"""
import json, struct, sys

SEEDS = {
    "groups": ("[4,6]", [{"type": "conv1d", "name": "a", "kernel": 3, "filters": 4, "groups": 2, "dilation": 2, "zeros": 2, "activation": "silu"}], {"a": [4, 2, 3]}),
    "transposed1d": ("[2,5]", [{"type": "conv1d_transpose", "name": "a", "filters": 3, "kernel": 4, "stride": 2, "extra": 1, "activation": "gelu"}], {"a": [2, 3, 4]}),
    "transposed2d": ("[2,3,3]", [{"type": "conv2d_transpose", "name": "a", "filters": 2, "kernel": [3, 2], "stride": [2, 1], "groups": 2}], {"a": [2, 1, 3, 2]}),
    "pools": ("[2,6,6]", [{"type": "avgpool2d", "size": 3, "stride": 1}, {"type": "maxpool2d"}, {"type": "globalpool"}], {}),
    "linear": ("[2,3,4]", [{"type": "upsample2d", "mode": "linear", "factor": [2, 3], "align_corners": True}, {"type": "avgpool2d"}], {}),
    "concat": ("[3]", [{"type": "dense", "name": "a", "activation": "softplus"}, {"type": "concat", "from": "input", "order": "before"},
                       {"type": "dense", "name": "b", "activation": "tanh"}], {"a": [4, 3], "b": [2, 7]}),
    "skips": ("[4]", [{"type": "dense", "name": "a", "activation": "leaky_relu", "alpha": 0.2}, {"type": "dense", "name": "b", "activation": "sigmoid"},
                      {"type": "add", "from": "a", "activation": "relu"}], {"a": [4, 4], "b": [4, 4]}),
    "planes": ("[3]", [{"type": "shared_channels", "inputs": [[0, 2], [1, 2]]}, {"type": "dense", "name": "a", "activation": "elu"},
                       {"type": "dense", "name": "b"}], {"a": [5, 2], "b": [4, 5]}),
}

for name, (shape, layers, weights) in SEEDS.items():
    header = {"__metadata__": {"ms_nn_version": "1", "ms_nn_input": shape, "ms_nn_layers": json.dumps(layers, separators=(",", ":"))}}
    data = b""
    for layer, sizes in weights.items():
        turned = next(l for l in layers if l.get("name") == layer)
        outputs = turned["filters"] if "transpose" in turned["type"] else sizes[0]
        for part, dims in (("weight", sizes), ("bias", [outputs])):
            count = 1
            for d in dims:
                count *= d
            header[layer + "." + part] = {"dtype": "F32", "shape": dims, "data_offsets": [len(data), len(data) + 4 * count]}
            data += struct.pack("<f", 0.25) * count
    text = json.dumps(header, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 8)
    with open("%s/net_layers_%s.safetensors" % (sys.argv[1], name), "wb") as f:
        f.write(struct.pack("<Q", len(text)) + text + data)
