#!/usr/bin/env python3
"""Saves a PyTorch or Keras network for ms_nn.h: a safetensors file with the layer list in its metadata.

    import export_torch as ms
    ms.save_torch("net.safetensors", torch_sequential, input_shape=(3, 410, 410))      # channels, height, width
    ms.save_keras("net.safetensors", keras_sequential)                                 # channels last, as Keras has it

Run as a program it writes two small examples into the folder given (PyTorch needed)."""
import json, struct, sys
import numpy as np

ACTIVATIONS = {"ReLU": "relu", "LeakyReLU": "leaky_relu", "ELU": "elu", "Tanh": "tanh", "Sigmoid": "sigmoid", "Softplus": "softplus"}


def write(path, input_shape, layers, tensors):
    """The file itself, largest tensor first: no package needed but numpy."""
    meta = {"format": "pt", "ms_nn_version": "1", "ms_nn_input": json.dumps(list(input_shape)), "ms_nn_layers": json.dumps(layers)}
    names, header, offset = sorted(tensors, key=lambda n: -tensors[n].nbytes), {"__metadata__": meta}, 0
    for n in names:
        t = tensors[n]
        kind = {"float64": "F64", "float32": "F32", "float16": "F16", "int8": "I8"}[str(t.dtype)]
        header[n] = {"dtype": kind, "shape": list(t.shape), "data_offsets": [offset, offset + t.nbytes]}
        offset += t.nbytes
    text = json.dumps(header).encode()
    text += b" " * (-(8 + len(text)) % 64)
    with open(path, "wb") as f:
        f.write(struct.pack("<Q", len(text)) + text)
        for n in names:
            f.write(np.ascontiguousarray(tensors[n]).tobytes())


def store(tensors, layer, weight, bias, dtype):
    """dtype float32, float16, or int8 with one scale an output row (not worth it for small layers)."""
    layer["bias"] = bias is not None
    if bias is not None:
        tensors[layer["name"] + ".bias"] = np.asarray(bias, np.float32)
    if dtype == "int8":
        flat = weight.reshape(len(weight), -1)
        scale = np.maximum(np.abs(flat).max(1), 1e-30) / 127
        tensors[layer["name"] + ".weight_scale"] = scale.astype(np.float32)
        weight = np.rint(flat / scale[:, None]).reshape(weight.shape)
    tensors[layer["name"] + ".weight"] = np.asarray(weight, dtype)


def save_torch(path, net, input_shape, dtype="float32"):
    """A torch.nn.Sequential. PyTorch flattens channels first."""
    layers, tensors = [], {}
    for name, m in net.named_children():
        kind, layer = type(m).__name__, {"name": "l" + name}
        one = lambda v: list(v) if isinstance(v, tuple) else v
        if kind in ("Linear", "Conv1d", "Conv2d"):
            if kind == "Linear":
                layer.update(type="dense", units=m.out_features)
            else:
                assert m.groups == 1 and set(one(m.dilation)) == {1} and m.padding_mode == "zeros", m
                zero, half = all(p == 0 for p in m.padding), all(2 * p == k - 1 for p, k in zip(m.padding, m.kernel_size))
                assert zero or half, "padding must be 0 or (k - 1) / 2 with odd k"
                layer.update(type=kind.lower(), filters=m.out_channels, kernel=one(m.kernel_size), stride=one(m.stride),
                             padding="valid" if zero else "same")
            store(tensors, layer, m.weight.detach().numpy(), None if m.bias is None else m.bias.detach().numpy(), dtype)
        elif kind in ACTIVATIONS:
            layer.update(type="activation", activation=ACTIVATIONS[kind])
            if kind in ("LeakyReLU", "ELU"):
                layer["alpha"] = m.negative_slope if kind == "LeakyReLU" else m.alpha
        elif kind in ("MaxPool1d", "MaxPool2d"):
            assert m.padding in (0, (0, 0)) and m.dilation in (1, (1, 1)) and not m.ceil_mode, m
            layer.update(type=kind.lower(), size=one(m.kernel_size), stride=one(m.stride))
        elif kind == "Upsample":
            assert m.mode == "nearest", m
            layer.update(type="upsample%dd" % (len(input_shape) - 1), factor=[int(f) for f in np.atleast_1d(m.scale_factor)])
        elif kind == "Flatten":
            layer.update(type="flatten", order="channels_first")
        elif kind in ("Dropout", "Dropout1d", "Dropout2d"):
            layer.update(type="dropout", rate=m.p)
        else:
            raise ValueError("no layer of ms_nn.h for " + kind)
        layers.append(layer)
    write(path, input_shape, layers, tensors)


def save_keras(path, net, dtype="float32"):
    """A keras.Sequential. Keras has channels last: kernels are turned, inputs given channels first, and the flatten order
    is recorded. get_config() says all that is needed, so that no version of Keras is imported here."""
    layers, tensors = [], {}
    shape = tuple(net.input_shape[1:])
    for m in net.layers:
        kind, c, layer = type(m).__name__, m.get_config(), {"name": m.name}
        if kind in ("Dense", "Conv1D", "Conv2D"):
            weight = np.asarray(m.get_weights()[0])
            weight = np.moveaxis(weight, -1, 0) if kind == "Dense" else np.moveaxis(weight, (-1, -2), (0, 1))
            if kind == "Dense":
                layer.update(type="dense", units=c["units"])
            else:
                assert c["padding"] == "valid" or set(c["strides"]) == {1} and all(k % 2 for k in c["kernel_size"]), "Keras pads otherwise"
                layer.update(type=kind.lower(), filters=c["filters"], kernel=list(c["kernel_size"]), stride=list(c["strides"]), padding=c["padding"])
            layer["activation"] = c["activation"]
            store(tensors, layer, weight, m.get_weights()[1] if c["use_bias"] else None, dtype)
        elif kind == "Activation":
            layer.update(type="activation", activation=c["activation"])
        elif kind in ("MaxPooling1D", "MaxPooling2D"):
            assert c["padding"] == "valid", m
            layer.update(type="maxpool" + kind[-2:].lower(), size=list(np.atleast_1d(c["pool_size"]).tolist()), stride=np.atleast_1d(c["strides"]).tolist())
        elif kind in ("UpSampling1D", "UpSampling2D"):
            layer.update(type="upsample" + kind[-2:].lower(), factor=np.atleast_1d(c["size"]).tolist())
        elif kind == "Flatten":
            layer.update(type="flatten", order="channels_last")
        elif kind == "Dropout":
            layer.update(type="dropout", rate=c["rate"])
        elif kind != "InputLayer":
            raise ValueError("no layer of ms_nn.h for " + kind)
        if kind != "InputLayer":
            layers.append(layer)
    write(path, (shape[-1],) + shape[:-1], layers, tensors)


if __name__ == "__main__":
    from torch import nn
    folder = sys.argv[1] if len(sys.argv) > 1 else "."
    save_torch(folder + "/inversion.safetensors", nn.Sequential(
        nn.Conv2d(3, 8, 3, padding=1), nn.ReLU(), nn.MaxPool2d(2), nn.Flatten(), nn.Linear(8 * 16 * 16, 19)), (3, 32, 32))
    save_torch(folder + "/renderer.safetensors", nn.Sequential(
        nn.Conv1d(1, 8, 3, padding=1), nn.ELU(), nn.Upsample(scale_factor=2), nn.Flatten(), nn.Linear(8 * 38, 3 * 32 * 32)), (1, 19), "float16")
