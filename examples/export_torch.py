#!/usr/bin/env python3
"""Saves a PyTorch or Keras Sequential for ms_nn.h: safetensors with the layer list in its metadata. Needs numpy.

    import export_torch as ms
    ms.save_torch("net.safetensors", net, (3, 410, 410))  # the shape of an input; PyTorch flattens channels first
    ms.save_keras("net.safetensors", net)  # channels last: inputs and kernels are turned, the flatten order is recorded"""
import json, struct
import numpy as np

ACTIVATIONS = {"ReLU": "relu", "LeakyReLU": "leaky_relu", "ELU": "elu", "Tanh": "tanh", "Sigmoid": "sigmoid", "Softplus": "softplus"}


def write(path, input_shape, layers, tensors):
    """The file: the layer list, then the tensors (numpy arrays by name), the largest first."""
    header = {"__metadata__": {"format": "pt", "ms_nn_version": "1", "ms_nn_input": json.dumps(list(input_shape)), "ms_nn_layers": json.dumps(layers)}}
    names, end = sorted(tensors, key=lambda name: -tensors[name].nbytes), 0
    for name in names:
        t = tensors[name]
        dtype = {"float64": "F64", "float32": "F32", "float16": "F16", "int8": "I8"}[str(t.dtype)]
        header[name] = {"dtype": dtype, "shape": list(t.shape), "data_offsets": [end, end := end + t.nbytes]}
    text = json.dumps(header).encode()
    text += b" " * (-(8 + len(text)) % 64)
    with open(path, "wb") as f:
        f.write(struct.pack("<Q", len(text)) + text + b"".join(np.ascontiguousarray(tensors[name]).tobytes() for name in names))


def store(layer, tensors, dtype, weight, bias=None):
    """Weights as float32, float16, or int8 with one scale an output."""
    if dtype == "int8":
        scale = np.maximum(np.abs(weight).reshape(len(weight), -1).max(1), 1e-30).astype(np.float32) / 127
        weight = np.rint(weight / scale.reshape((-1,) + (1,) * (weight.ndim - 1)))
        tensors[layer["name"] + ".weight_scale"] = scale
    tensors[layer["name"] + ".weight"] = weight.astype(dtype)
    if bias is not None: tensors[layer["name"] + ".bias"] = np.asarray(bias, np.float32)
    layer["bias"] = bias is not None


def save_torch(path, net, input_shape, dtype="float32"):
    layers, tensors = [], {}
    for name, m in net.named_children():
        kind, layer, numbers = type(m).__name__, {"name": "l" + name}, lambda x: [int(v) for v in x] if np.ndim(x) else int(x)
        if kind in ("Conv1d", "Conv2d"):
            same = m.padding == "same" or all(2 * p == k - 1 for p, k in zip(m.padding, m.kernel_size))
            assert m.groups == 1 and set(m.dilation) == {1} and m.padding_mode == "zeros" and (same or set(m.padding) <= {0, *"valid"}), m
            layer.update(type=kind.lower(), kernel=numbers(m.kernel_size), stride=numbers(m.stride), padding="same" if same else "valid")
        elif kind in ("MaxPool1d", "MaxPool2d"):
            assert not np.any(m.padding) and np.all(np.equal(m.dilation, 1)) and not m.ceil_mode, m
            layer.update(type=kind.lower(), size=numbers(m.kernel_size), stride=numbers(m.stride))
        elif kind == "Upsample" and m.mode == "nearest":
            layer.update(type="upsample%dd" % (len(input_shape) - 1), factor=numbers(m.scale_factor))
        elif kind in ACTIVATIONS and getattr(m, "beta", 1) == 1:
            layer.update(type="activation", activation=ACTIVATIONS[kind], alpha=getattr(m, "negative_slope", getattr(m, "alpha", 1.0)))
        else:
            layer["type"] = {"Linear": "dense", "Flatten": "flatten", "Dropout": "dropout"}[kind]  # KeyError: ms_nn.h lacks it
        if hasattr(m, "weight"): store(layer, tensors, dtype, m.weight.detach().numpy(), None if m.bias is None else m.bias.detach().numpy())
        layers.append(layer)
    write(path, input_shape, layers, tensors)


def save_keras(path, net, dtype="float32"):
    layers, tensors, shape = [], {}, tuple(net.input_shape[1:])
    for m in net.layers:
        kind, c, layer = type(m).__name__, m.get_config(), {"name": m.name}
        if kind == "InputLayer": continue
        if kind in ("Conv1D", "Conv2D"):
            assert c["padding"] == "valid" or set(c["strides"]) == {1}, "Keras pads otherwise with strides"
            layer.update(type=kind.lower(), kernel=list(c["kernel_size"]), stride=list(c["strides"]), padding=c["padding"])
        elif kind in ("MaxPooling1D", "MaxPooling2D") and c["padding"] == "valid":
            layer.update(type="maxpool" + kind[-2:].lower(), size=np.atleast_1d(c["pool_size"]).tolist(), stride=np.atleast_1d(c["strides"]).tolist())
        elif kind in ("UpSampling1D", "UpSampling2D") and c.get("interpolation", "nearest") == "nearest":
            layer.update(type="upsample" + kind[-2:].lower(), factor=np.atleast_1d(c["size"]).tolist())
        elif kind in ACTIVATIONS and not (c.get("max_value") or c.get("threshold") or kind == "ReLU" and c.get("negative_slope")):
            layer.update(type="activation", activation=ACTIVATIONS[kind], alpha=float(c.get("negative_slope", c.get("alpha", 1.0))))
        else:
            layer["type"] = {"Dense": "dense", "Activation": "activation", "Flatten": "flatten", "Dropout": "dropout"}[kind]  # KeyError: ms_nn.h lacks it
        if kind == "Flatten": layer["order"] = "channels_last"
        if "activation" in c: layer.update(activation=c["activation"], alpha=0.2 if c["activation"] == "leaky_relu" else 1.0)
        if m.get_weights():  # the kernel's last dimensions, inputs and outputs, come first in PyTorch's layout, exchanged
            weight = np.moveaxis(np.asarray(m.get_weights()[0]), (-1, -2), (0, 1))
            store(layer, tensors, dtype, weight, *m.get_weights()[1:])
        layers.append(layer)
    write(path, shape[-1:] + shape[:-1], layers, tensors)
