"""Writes the trained networks as safetensors for ms_nn.h, and reads the renderer back for what trains through it."""
import json, os, struct, sys
import numpy as np
import torch

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "examples"))
import export_torch as ms
import data


def rows_i8(w):
    """-> integers [rows][n], one scale a row."""
    scale = np.maximum(np.abs(w).max(1), 1e-30) / 127
    return np.rint(w / scale[:, None]).astype(np.int8), scale.astype(np.float32)


def dense(layers, tensors, name, weight, bias, activation, kind):
    weight = weight.detach().numpy()
    layers.append({"type": "dense", "name": name, "units": len(weight), "activation": activation})
    tensors[name + ".bias"] = bias.detach().numpy().astype(np.float32)
    if kind == "I8":
        tensors[name + ".weight"], tensors[name + ".weight_scale"] = rows_i8(weight)
    else:
        tensors[name + ".weight"] = weight.astype({"F16": np.float16, "F32": np.float32}[kind])


def renderer(path, trunk, scale, basis, mean, variance, kind):
    """kind: of the pixels' weights, I8 or F16. Features are divided by a power of their standard deviation, the basis is
    multiplied: with I8 the power decides how the rounding errors of a row are shared among its weights."""
    best = None
    for power in (0, 0.25, 0.5, 0.75):
        s = variance.clamp_min(1e-12) ** (0.5 * power)
        w = (basis * s).numpy()
        q, step = rows_i8(w)
        error = float((((q * step[:, None] - w) ** 2).sum(0) * (variance / s ** 2).numpy()).sum())
        if best is None or error < best[0]:
            best = (error, s)
    s = best[1]
    layers, tensors = [{"type": "shared_channels", "inputs": data.CHANNELS}], {}
    for i, layer in enumerate(trunk.hidden):
        dense(layers, tensors, "hidden%d" % (i + 1), layer.weight, layer.bias, "elu", "F16")
    dense(layers, tensors, "features", trunk.out.weight * (scale / s)[:, None], trunk.out.bias * scale / s, "linear", "F16")
    dense(layers, tensors, "pixels", basis * s, mean, "linear", kind)
    ms.write(path, [19], layers, tensors, {"ms_parameters": ",".join(data.NAMES)})
    print("%s: %d bytes" % (path, os.path.getsize(path)), flush=True)


def read(path):
    with open(path, "rb") as f:
        header = json.loads(f.read(struct.unpack("<Q", f.read(8))[0]))
        bytes_ = f.read()
    kinds = {"F32": np.float32, "F16": np.float16, "I8": np.int8}
    return {n: np.frombuffer(bytes_[t["data_offsets"][0]:t["data_offsets"][1]], kinds[t["dtype"]]).reshape(t["shape"]).astype(np.float32)
            for n, t in header.items() if n != "__metadata__"}


class load_renderer(torch.nn.Module):
    """The saved renderer with its rounded weights: features(x [n][11]) and pictures of them."""

    def __init__(self, path):
        super().__init__()
        t = {n: torch.from_numpy(v.copy()) for n, v in read(path).items()}
        self.hidden = []
        while "hidden%d.weight" % (len(self.hidden) + 1) in t:
            name = "hidden%d" % (len(self.hidden) + 1)
            self.hidden.append((t[name + ".weight"], t[name + ".bias"]))
        self.out = t["features.weight"], t["features.bias"]
        self.basis, self.mean = t["pixels.weight"], t["pixels.bias"]
        if "pixels.weight_scale" in t:
            self.basis = self.basis * t["pixels.weight_scale"][:, None]

    def features(self, x):
        for w, b in self.hidden:
            x = torch.nn.functional.elu(x @ w.T + b)
        return x @ self.out[0].T + self.out[1]

    def forward(self, x):
        return self.features(x) @ self.basis.T + self.mean
