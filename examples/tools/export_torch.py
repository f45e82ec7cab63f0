#!/usr/bin/env python3
"""Saves a PyTorch or Keras Sequential for ms_nn.h: safetensors with the layer list in its metadata. Needs numpy.

    import export_torch as ms
    ms.save_torch("net.safetensors", net, (3, 410, 410))  # the shape of an input; PyTorch flattens channels first
    ms.save_keras("net.safetensors", net)  # channels last: inputs and kernels are turned, the flatten order is recorded

Sequentials within one another are joined; a BatchNorm behind a linear or convolution layer goes into its weights (as in eval()), one that
stands alone becomes a convolution of each channel with one tap. A module with an attribute ms_nn, a layer in the words of the head of ms_nn.h,
is saved as that: {"type": "concat", "from": "l3"} is torch.cat([x, output of module 3], 1). What ms_nn.h cannot run raises Unsupported
with the module's name and type, before anything is written."""
import json, os, struct
import numpy as np

ACTIVATIONS = {"ReLU": "relu", "LeakyReLU": "leaky_relu", "ELU": "elu", "Tanh": "tanh", "Sigmoid": "sigmoid", "Softplus": "softplus",
               "SiLU": "silu", "GELU": "gelu"}


class Unsupported(ValueError):
    """A module that ms_nn.h cannot run."""


def unless(module, good, what):
    """Raises Unsupported: module (a name and a type) and what of it is not known, unless good."""
    if not good: raise Unsupported("module '%s' of type %s cannot be saved: %s" % (*module, what))


def write(path, input_shape, layers, tensors, metadata={}):
    """The file: the layer list, then the tensors (numpy arrays by name), the largest first. Written beside, then renamed."""
    header = {"__metadata__": {"format": "pt", "ms_nn_version": "1", "ms_nn_input": json.dumps(list(input_shape)), "ms_nn_layers": json.dumps(layers), **metadata}}
    names, end = sorted(tensors, key=lambda name: -tensors[name].nbytes), 0
    for name in names:
        t = tensors[name]
        dtype = {"float64": "F64", "float32": "F32", "float16": "F16", "int8": "I8"}[str(t.dtype)]
        header[name] = {"dtype": dtype, "shape": list(t.shape), "data_offsets": [end, end := end + t.nbytes]}
    text = json.dumps(header).encode()
    text += b" " * (-(8 + len(text)) % 64)
    with open(path + ".new", "wb") as f:
        f.write(struct.pack("<Q", len(text)) + text + b"".join(np.ascontiguousarray(tensors[name]).tobytes() for name in names))
    os.replace(path + ".new", path)


def store(layer, tensors, dtype, weight, bias=None):
    """Weights as float32, float16, or int8 with one scale an output."""
    if dtype == "int8":
        scale = np.maximum(np.abs(weight).reshape(len(weight), -1).max(1), 1e-30).astype(np.float32) / 127
        weight = np.rint(weight / scale.reshape((-1,) + (1,) * (weight.ndim - 1)))
        tensors[layer["name"] + ".weight_scale"] = scale
    tensors[layer["name"] + ".weight"] = weight.astype(dtype)
    if bias is not None: tensors[layer["name"] + ".bias"] = np.asarray(bias, np.float32)
    layer["bias"] = bias is not None


def modules(net, prefix=""):
    """Names and modules of a Sequential and of those within it, in order."""
    for name, m in net.named_children():
        if type(m).__name__ == "Sequential": yield from modules(m, prefix + name + ".")
        else: yield prefix + name, m


def array(x): return None if x is None else np.asarray(x.detach().numpy(), np.float64)


def save_torch(path, net, input_shape, dtype="float32"):
    layers, tensors, weights = [], {}, {}
    for name, m in modules(net):
        kind, layer, numbers = type(m).__name__, {"name": "l" + name}, lambda x: [int(v) for v in x] if np.ndim(x) else int(x)
        me = name, kind
        if hasattr(m, "ms_nn"):
            layer.update(m.ms_nn)
            unless(me, layer.get("from", "input") in ["input"] + [l["name"] for l in layers], "no module before it is named %s" % layer.get("from"))
        elif kind in ("Conv1d", "Conv2d", "ConvTranspose1d", "ConvTranspose2d"):
            turned = "Transpose" in kind
            unless(me, m.padding_mode == "zeros", "padding_mode is %s" % m.padding_mode)
            layer.update(type="conv" + kind[-2:] + "_transpose" * turned, kernel=numbers(m.kernel_size), stride=numbers(m.stride), dilation=numbers(m.dilation), groups=int(m.groups))
            if turned: layer.update(filters=int(m.out_channels), extra=numbers(m.output_padding))
            if isinstance(m.padding, str): layer["padding"] = m.padding
            else: layer["zeros"] = numbers(m.padding)
        elif kind in ("MaxPool1d", "MaxPool2d"):
            unless(me, not np.any(m.padding) and np.all(np.equal(m.dilation, 1)) and not m.ceil_mode, "it pads, dilates or rounds up")
            layer.update(type=kind.lower(), size=numbers(m.kernel_size), stride=numbers(m.stride))
        elif kind in ("AvgPool1d", "AvgPool2d"):
            unless(me, not np.any(m.padding) and not m.ceil_mode and not getattr(m, "divisor_override", None), "it pads, rounds up or divides by another number")
            layer.update(type=kind.lower(), size=numbers(m.kernel_size), stride=numbers(m.stride))
        elif kind in ("AdaptiveAvgPool1d", "AdaptiveAvgPool2d"):
            unless(me, set(np.atleast_1d(m.output_size)) == {1}, "output_size is %s; only 1 is known" % (m.output_size,))
            layer["type"] = "globalpool"
        elif kind == "Upsample":
            unless(me, m.mode in ("nearest", "linear", "bilinear") and m.scale_factor and np.all(np.mod(m.scale_factor, 1) == 0),
                   "mode is %s; nearest, linear and bilinear with a whole scale_factor are known" % m.mode)
            layer.update(type="upsample%dd" % (len(input_shape) - 1), factor=numbers(m.scale_factor))
            if m.mode != "nearest": layer.update(mode="linear", align_corners=bool(m.align_corners))
        elif kind in ACTIVATIONS:
            unless(me, getattr(m, "beta", 1) == 1, "beta is not 1")
            unless(me, getattr(m, "approximate", "none") == "none", "approximate is %s" % getattr(m, "approximate", ""))
            layer.update(type="activation", activation=ACTIVATIONS[kind], alpha=getattr(m, "negative_slope", getattr(m, "alpha", 1.0)))
        elif kind in ("BatchNorm1d", "BatchNorm2d"):
            unless(me, m.running_var is not None, "it has no running statistics")
            gain = 1 / np.sqrt(array(m.running_var) + m.eps) * (1 if m.weight is None else array(m.weight))
            shift = (0 if m.bias is None else array(m.bias)) - gain * array(m.running_mean)
            last = layers[-1] if layers else {}
            if last.get("name") in weights:
                weight, bias = weights[last["name"]]
                if "transpose" in last["type"]: # [inputs][outputs of a group]...
                    turn = np.repeat(gain.reshape(last["groups"], -1), len(weight) // last["groups"], 0).reshape(weight.shape[:2] + (1,) * (weight.ndim - 2))
                else: turn = gain.reshape((-1,) + (1,) * (weight.ndim - 1))
                weights[last["name"]] = weight * turn, shift + (0 if bias is None else gain * bias)
                continue
            rank = kind[-2:] if len(input_shape) > 1 else ""
            unless(me, rank, "it does not follow a linear or convolution layer")
            layer.update(type="conv" + rank, groups=len(gain))
            weights[layer["name"]] = gain.reshape((-1, 1) + (1,) * int(rank[0])), shift + 0 * gain
            layers.append(layer)
            continue
        else:
            plain = {"Linear": "dense", "Flatten": "flatten", "Dropout": "dropout"}
            unless(me, kind in plain, "ms_nn.h has no such layer")
            unless(me, kind != "Flatten" or (getattr(m, "start_dim", 1), getattr(m, "end_dim", -1)) == (1, -1), "it flattens a part only")
            layer["type"] = plain[kind]
        if hasattr(m, "weight"): weights[layer["name"]] = array(m.weight), array(m.bias)
        layers.append(layer)
    for layer in layers:
        if layer["name"] in weights: store(layer, tensors, dtype, *weights[layer["name"]])
    write(path, input_shape, layers, tensors)


def save_keras(path, net, dtype="float32"):
    layers, tensors, shape = [], {}, tuple(net.input_shape[1:])
    for m in net.layers:
        kind, c, layer = type(m).__name__, m.get_config(), {"name": m.name}
        me = m.name, kind
        if kind == "InputLayer": continue
        if kind in ("Conv1D", "Conv2D"):
            unless(me, c["padding"] == "valid" or c["padding"] == "same" and set(c["strides"]) == {1}, "padding is %s with strides %s" % (c["padding"], c["strides"]))
            unless(me, set(np.atleast_1d(c.get("dilation_rate", 1))) == {1} and c.get("groups", 1) == 1, "it has dilation or groups")
            layer.update(type=kind.lower(), kernel=list(c["kernel_size"]), stride=list(c["strides"]), padding=c["padding"])
        elif kind in ("MaxPooling1D", "MaxPooling2D") and c["padding"] == "valid":
            layer.update(type="maxpool" + kind[-2:].lower(), size=np.atleast_1d(c["pool_size"]).tolist(), stride=np.atleast_1d(c["strides"]).tolist())
        elif kind in ("UpSampling1D", "UpSampling2D") and c.get("interpolation", "nearest") == "nearest":
            layer.update(type="upsample" + kind[-2:].lower(), factor=np.atleast_1d(c["size"]).tolist())
        elif kind in ACTIVATIONS and not (c.get("max_value") or c.get("threshold") or kind == "ReLU" and c.get("negative_slope")):
            layer.update(type="activation", activation=ACTIVATIONS[kind], alpha=float(c.get("negative_slope", c.get("alpha", 1.0))))
        else:
            plain = {"Dense": "dense", "Activation": "activation", "Flatten": "flatten", "Dropout": "dropout"}
            unless(me, kind in plain, "ms_nn.h has no such layer, or not with these settings: %s" % c)
            layer["type"] = plain[kind]
        if kind == "Flatten": layer["order"] = "channels_last"
        known = {"linear", "leaky_relu", *ACTIVATIONS.values()}
        unless(me, c.get("activation", "linear") in known, "activation is %s" % c.get("activation"))
        if "activation" in c: layer.update(activation=c["activation"], alpha=0.2 if c["activation"] == "leaky_relu" else 1.0)
        if m.get_weights():  # the kernel's last dimensions, inputs and outputs, come first in PyTorch's layout, exchanged
            weight = np.moveaxis(np.asarray(m.get_weights()[0]), (-1, -2), (0, 1))
            store(layer, tensors, dtype, weight, *m.get_weights()[1:])
        layers.append(layer)
    write(path, shape[-1:] + shape[:-1], layers, tensors)
