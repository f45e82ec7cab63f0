#!/usr/bin/env python3
"""examples/tools/export_torch.py without PyTorch: modules are stood in for by objects with its attributes. What cannot be saved is named and
leaves no file; Sequentials within one another and BatchNorm against numpy. Skipped (exit 77) without numpy."""
import math, os, subprocess, sys
sys.path.insert(0, "examples/tools")
try:
    import numpy as np
except ImportError as e:
    print("skip:", e)
    sys.exit(77)
import export_torch as ms

os.makedirs("build", exist_ok=True)
FILE, X = "build/test_export_modules.safetensors", "build/test_export_modules.csv"
failed = 0


class Tensor:
    def __init__(self, a): self.a = np.asarray(a)
    def detach(self): return self
    def numpy(self): return self.a


def module(kind, **attributes): return type(kind, (), attributes)()
def sequential(*list_of): return type("Sequential", (), {"named_children": lambda self: ((str(i), m) for i, m in enumerate(list_of))})()


def conv(**other):
    settings = dict(groups=1, dilation=(1, 1), padding_mode="zeros", padding=(0, 0), kernel_size=(2, 2), stride=(1, 1), weight=Tensor(np.ones((3, 2, 2, 2))), bias=None)
    return module("Conv2d", **{**settings, **other})


def keras(kind, name, **config):
    m = type(kind, (), {})()
    m.name, m.get_config, m.get_weights = name, lambda: config, lambda: []
    return type("Model", (), {"input_shape": (None, 8, 8, 2), "layers": [m]})()


for net, words in ((sequential(module("ReLU"), sequential(module("GRU"))), ("'1.0'", "GRU")), (sequential(module("AdaptiveAvgPool2d", output_size=(2, 2))), ("'0'", "AdaptiveAvgPool2d", "output_size")),
                   (sequential(module("GELU", approximate="tanh")), ("'0'", "GELU", "tanh")), (sequential(module("Join", ms_nn={"type": "concat", "from": "l7"})), ("'0'", "Join", "l7")),
                   (sequential(conv(padding_mode="reflect")), ("reflect",)), (sequential(module("Upsample", mode="bicubic", scale_factor=2)), ("'0'", "Upsample", "bicubic")),
                   (sequential(module("Upsample", mode="nearest", scale_factor=1.5)), ("'0'", "Upsample", "whole")),
                   (sequential(module("ReLU"), module("BatchNorm2d", running_var=None)), ("'1'", "BatchNorm2d", "running")), (sequential(module("Flatten", start_dim=2, end_dim=-1)), ("'0'", "Flatten")),
                   (keras("LSTM", "memory", units=3), ("'memory'", "LSTM")), (keras("Dense", "last", activation="selu"), ("'last'", "selu")),
                   (keras("Conv2D", "c", padding="same", strides=(2, 2), kernel_size=(3, 3)), ("'c'", "strides"))):
    if os.path.exists(FILE): os.remove(FILE)
    try:
        ms.save_keras(FILE, net) if hasattr(net, "layers") else ms.save_torch(FILE, net, (2, 8, 8))
        message = "was saved"
    except ms.Unsupported as e:
        message = str(e)
    good = all(w in message for w in words) and not os.path.exists(FILE)
    failed += not good
    print("%s %s" % ("ok  " if good else "FAIL", message))

r = np.random.default_rng(1)
w, b, gain, shift, mean, variance, w2 = (r.normal(size=s) for s in ((7, 5), 7, 7, 7, 7, 7, (3, 7)))
norm = module("BatchNorm1d", weight=Tensor(gain), bias=Tensor(shift), running_mean=Tensor(mean), running_var=Tensor(variance ** 2), eps=1e-5)
net = sequential(sequential(module("Linear", weight=Tensor(w), bias=Tensor(b)), norm), module("ReLU"), sequential(module("Dropout"), sequential(module("Linear", weight=Tensor(w2), bias=None))))
ms.save_torch(FILE, net, (5,))
x = r.normal(size=(4, 5))
np.savetxt(X, x, "%.9g", ",")
ours = np.loadtxt(subprocess.run(("build/nn_run", FILE, X), capture_output=True, text=True, check=True).stdout.split(), delimiter=",")
theirs = np.maximum((x @ w.T + b - mean) / np.sqrt(variance ** 2 + 1e-5) * gain + shift, 0) @ w2.T
error = abs(ours - theirs).max() / abs(theirs).max()
failed += not error < 1e-5  # rounding of the run
print("%s BatchNorm and nested Sequentials: largest error %.1e" % ("ok  " if error < 1e-5 else "FAIL", error))


def convolve(x, w, b, stride=1, zeros=0, dilation=1, groups=1):
    """[channels][height][width], one sample, by definition."""
    x = np.pad(x, ((0, 0), (zeros, zeros), (zeros, zeros)))
    own, k = len(w) // groups, (w.shape[2] - 1) * dilation + 1
    y = np.zeros((len(w), (x.shape[1] - k) // stride + 1, (x.shape[2] - k) // stride + 1))
    for o, i, j in np.ndindex(y.shape):
        part = x[o // own * w.shape[1]:(o // own + 1) * w.shape[1], i * stride:i * stride + k:dilation, j * stride:j * stride + k:dilation]
        y[o, i, j] = (part * w[o]).sum() + b[o]
    return y


def turned(x, w, b, stride, zeros, extra, groups):
    """ConvTranspose2d by definition: every input spreads its kernel."""
    own, per, k = w.shape[1], len(w) // groups, w.shape[2]
    n = [(s - 1) * stride + k + extra for s in x.shape[1:]]
    y = np.zeros((own * groups, n[0], n[1]))
    for c, i, j in np.ndindex(x.shape): y[c // per * own:(c // per + 1) * own, i * stride:i * stride + k, j * stride:j * stride + k] += x[c, i, j] * w[c]
    return y[:, zeros:n[0] - zeros, zeros:n[1] - zeros] + b[:, None, None]


def normal(kind, n):
    m = module(kind, weight=Tensor(r.normal(size=n)), bias=Tensor(r.normal(size=n)), running_mean=Tensor(r.normal(size=n)), running_var=Tensor(r.uniform(0.5, 2, n)), eps=1e-5)
    return m, lambda x: (x - m.running_mean.a[:, None, None]) / np.sqrt(m.running_var.a + 1e-5)[:, None, None] * m.weight.a[:, None, None] + m.bias.a[:, None, None]


def bilinear(n):  # the matrix of twice as many, centers of pixels in line
    at = np.clip((np.arange(2 * n) + 0.5) / 2 - 0.5, 0, n - 1)
    return np.maximum(0, 1 - abs(at[:, None] - np.arange(n)))


w1, b1, w2, b2, w3, b3 = (r.normal(size=s) for s in ((6, 2, 3, 3), 6, (6, 2, 3, 3), 4, (3, 8, 1, 1), 3))
(n0, f0), (n1, f1), (n2, f2) = normal("BatchNorm2d", 4), normal("BatchNorm2d", 6), normal("BatchNorm2d", 4)
plain = dict(padding_mode="zeros")
net = sequential(n0, sequential(module("Conv2d", groups=2, dilation=(2, 2), padding=(2, 2), kernel_size=(3, 3), stride=(1, 1), weight=Tensor(w1), bias=Tensor(b1), **plain), n1), module("SiLU"),
                 module("ConvTranspose2d", groups=2, dilation=(1, 1), padding=(1, 1), output_padding=(1, 1), kernel_size=(3, 3), stride=(2, 2), out_channels=4, weight=Tensor(w2), bias=Tensor(b2), **plain), n2,
                 module("GELU", approximate="none"), module("AvgPool2d", padding=0, ceil_mode=False, kernel_size=4, stride=4),
                 module("Upsample", mode="bilinear", scale_factor=2, align_corners=False), module("Join", ms_nn={"type": "concat", "from": "input"}),
                 module("Conv2d", groups=1, dilation=(1, 1), padding=(0, 0), kernel_size=(1, 1), stride=(1, 1), weight=Tensor(w3), bias=Tensor(b3), **plain), module("AdaptiveAvgPool2d", output_size=1))
ms.save_torch(FILE, net, (4, 6, 8))
x = r.normal(size=(4, 6, 8))
np.savetxt(X, x.reshape(1, -1), "%.9g", ",")
ours = np.array(subprocess.run(("build/nn_run", FILE, X), capture_output=True, text=True, check=True).stdout.split(","), float)
h = f1(convolve(f0(x), w1, b1, 1, 2, 2, 2))
h = f2(turned(h / (1 + np.exp(-h)), w2, b2, 2, 1, 1, 2))
h = h * 0.5 * (1 + np.vectorize(math.erf)(h / math.sqrt(2)))
h = bilinear(3) @ h.reshape(4, 3, 4, 4, 4).mean((2, 4)) @ bilinear(4).T
theirs = convolve(np.concatenate((h, x)), w3, b3).mean((1, 2))
error = abs(ours - theirs).max() / abs(theirs).max()
failed += not error < 1e-5  # rounding of the run
print("%s groups, dilation, transposed, norms alone and behind them, SiLU, GELU, means, bilinear, concat: largest error %.1e" % ("ok  " if error < 1e-5 else "FAIL", error))
for f in (FILE, X): os.remove(f)
sys.exit(failed != 0)
