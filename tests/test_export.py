#!/usr/bin/env python3
"""examples/tools/export_torch.py against build/nn_run: outputs and input gradients of PyTorch networks, and of a Keras network
whose layers are stood in for by objects with get_config() and get_weights(). Skipped (exit 77) without PyTorch."""
import copy, os, subprocess, sys, types
sys.path.insert(0, "examples/tools")
try:
    import numpy as np, torch
    from torch import nn
except ImportError as e:
    print("skip:", e)
    sys.exit(77)
import export_torch as ms

os.makedirs("build", exist_ok=True)
FILE, X, G = "build/test_export.safetensors", "build/test_export_x.csv", "build/test_export_g.csv"
failed = 0


def run(*args):
    out = subprocess.run(("build/nn_run", FILE) + args, capture_output=True, text=True, check=True).stdout
    return np.array([[float(v) for v in line.split(",")] for line in out.split()])


def check(name, net, shape, forward, tolerance):
    """forward: what the network must compute, as a torch function of a batch in ms_nn's order."""
    global failed
    x = torch.rand(3, *shape, dtype=torch.float64, generator=torch.Generator().manual_seed(1)).float().requires_grad_(True)
    y = forward(x.double())
    g = torch.randn(y.shape, dtype=torch.float64, generator=torch.Generator().manual_seed(2)).float()
    (gx,) = torch.autograd.grad((y * g.double()).sum(), x)
    np.savetxt(X, x.detach().reshape(3, -1).numpy(), "%.9g", ",")
    np.savetxt(G, g.reshape(3, -1).numpy(), "%.9g", ",")
    for what, ours, theirs in (("outputs", run(X), y), ("gradients", run(X, "--vjp", G), gx)):
        theirs = theirs.detach().reshape(3, -1).numpy()
        error = abs(ours - theirs).max() / abs(theirs).max() if ours.shape == theirs.shape else np.inf
        good = error <= tolerance
        failed += not good
        print("%s %s: %s, largest error %.1e of %.0e" % ("ok  " if good else "FAIL", name, what, error, tolerance))


torch.manual_seed(3)
renderer = nn.Sequential(nn.Conv1d(1, 8, 3, padding=1), nn.ELU(), nn.Upsample(scale_factor=2), nn.Conv1d(8, 6, 4, padding="same"), nn.ELU(0.5),
                         nn.Upsample(scale_factor=2), nn.Flatten(), nn.Dropout(0.5), nn.Linear(6 * 76, 30), nn.Tanh(), nn.Linear(30, 48, bias=False))
inversion = nn.Sequential(nn.Conv2d(3, 8, (5, 3), padding=(2, 1)), nn.ReLU(), nn.MaxPool2d(2), nn.Conv2d(8, 5, 3, stride=2), nn.LeakyReLU(0.2),
                          nn.MaxPool2d(3, stride=1), nn.Softplus(), nn.Upsample(scale_factor=(2, 3)), nn.Flatten(), nn.Linear(5 * 4 * 12, 19), nn.Sigmoid())


def rounded(net, kind):
    """The network in double with the weights that a file of that kind holds."""
    net = copy.deepcopy(net).double()
    for m in net.modules():
        if not hasattr(m, "weight"):
            continue
        w = m.weight.data
        if kind == "float16":
            m.weight.data = w.half().double()
        if kind == "int8":  # one scale an output, largest weight at 127
            scale = w.flatten(1).abs().amax(1).reshape((-1,) + (1,) * (w.dim() - 1)) / 127
            m.weight.data = torch.round(w / scale) * scale.float().double()
    return net


for name, net, shape in (("renderer", renderer, (1, 19)), ("inversion", inversion, (3, 21, 26))):
    net.eval()
    for kind in ("float32", "float16", "int8"):
        ms.save_torch(FILE, net, shape, kind)
        check(name + " " + kind, net, shape, rounded(net, kind), 1e-5)  # rounding of the run


def keras_layer(kind, weights=(), **config):
    layer = type(kind, (), {})()
    layer.name, layer.get_config, layer.get_weights = config.pop("name", kind), lambda: config, lambda: list(weights)
    return layer


r = np.random.default_rng(4)
conv, conv_b, dense, dense_b = r.normal(size=(3, 3, 2, 4)) / 4, r.normal(size=4), r.normal(size=(4 * 5 * 6, 7)) / 10, r.normal(size=7)
keras = types.SimpleNamespace(input_shape=(None, 10, 12, 2), layers=[
    keras_layer("InputLayer"),
    keras_layer("Conv2D", (conv, conv_b), name="c", filters=4, kernel_size=(3, 3), strides=(1, 1), padding="same", activation="relu", use_bias=True),
    keras_layer("MaxPooling2D", pool_size=(2, 2), strides=(2, 2), padding="valid"), keras_layer("Flatten"), keras_layer("Dropout", rate=0.1),
    keras_layer("Dense", (dense, dense_b), name="d", units=7, activation="tanh", use_bias=True)])
ms.save_keras(FILE, keras)
t = lambda a: torch.tensor(np.asarray(a, np.float32)).double()


def keras_forward(x):  # Keras's own definitions: channels last throughout
    y = nn.functional.conv2d(x, t(conv).permute(3, 2, 0, 1), t(conv_b), padding=1).relu()
    y = nn.functional.max_pool2d(y, 2).permute(0, 2, 3, 1).reshape(len(x), -1)
    return torch.tanh(y @ t(dense) + t(dense_b))


check("keras", keras, (2, 10, 12), keras_forward, 1e-5)

conv, dense = r.normal(size=(4, 2, 3)) / 3, r.normal(size=(18 * 3, 5)) / 7
keras = types.SimpleNamespace(input_shape=(None, 9, 2), layers=[
    keras_layer("Conv1D", (conv,), name="c", filters=3, kernel_size=(4,), strides=(1,), padding="same", activation="leaky_relu", use_bias=False),
    keras_layer("UpSampling1D", size=2), keras_layer("ELU", alpha=0.5), keras_layer("Flatten"),
    keras_layer("Dense", (dense,), name="d", units=5, activation="linear", use_bias=False), keras_layer("LeakyReLU", negative_slope=0.3)])
ms.save_keras(FILE, keras)


def keras_forward_1d(x):  # an even kernel: one zero in front, two behind; the string means a slope of 0.2
    y = nn.functional.leaky_relu(nn.functional.conv1d(nn.functional.pad(x, (1, 2)), t(conv).permute(2, 1, 0)), 0.2)
    y = nn.functional.elu(y.repeat_interleave(2, dim=2), 0.5).permute(0, 2, 1).reshape(len(x), -1)
    return nn.functional.leaky_relu(y @ t(dense), 0.3)


check("keras 1d", keras, (2, 9), keras_forward_1d, 1e-5)
for f in (FILE, X, G):
    os.remove(f)
sys.exit(failed != 0)
