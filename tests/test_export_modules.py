#!/usr/bin/env python3
"""examples/export_torch.py without PyTorch: modules are stood in for by objects with its attributes. What cannot be saved is named and
leaves no file; Sequentials within one another and BatchNorm against numpy. Skipped (exit 77) without numpy."""
import os, subprocess, sys
sys.path.insert(0, "examples")
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


for net, words in ((sequential(module("ReLU"), sequential(module("GRU"))), ("'1.0'", "GRU")), (sequential(conv(groups=2)), ("'0'", "Conv2d", "groups is 2")),
                   (sequential(conv(dilation=(2, 2))), ("'0'", "dilation")), (sequential(conv(padding=(1, 1))), ("'0'", "padding is (1, 1)")),
                   (sequential(conv(padding_mode="reflect")), ("reflect",)), (sequential(module("Upsample", mode="bilinear", scale_factor=2)), ("'0'", "Upsample", "bilinear")),
                   (sequential(module("ReLU"), module("BatchNorm2d")), ("'1'", "BatchNorm2d", "follow")), (sequential(module("Flatten", start_dim=2, end_dim=-1)), ("'0'", "Flatten")),
                   (keras("LSTM", "memory", units=3), ("'memory'", "LSTM")), (keras("Dense", "last", activation="gelu"), ("'last'", "gelu")),
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
for f in (FILE, X): os.remove(f)
sys.exit(failed != 0)
