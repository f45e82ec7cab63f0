#!/usr/bin/env python3
"""examples/tools/export_torch.py on PyTorch's modules, functions and small networks: each is saved right, which build/nn_run proves on inputs
that the exporter did not see, or refused with its name and the reason; none is saved wrong. Skipped (exit 77) without PyTorch."""
import os, shutil, subprocess, sys, tempfile, types, warnings
sys.path.insert(0, "examples/tools")
try:
    import numpy as np, torch
    from torch import nn
    import torch.nn.functional as F
except ImportError as e:
    print("skip:", e)
    sys.exit(77)
import export_torch as ms

warnings.filterwarnings("ignore")  # of PyTorch, about padding

FOLDER = tempfile.mkdtemp()
FILE, X = os.path.join(FOLDER, "net.safetensors"), os.path.join(FOLDER, "x.csv")
counts = {True: 0, False: 0}
torch.manual_seed(3)


def result(good, *text):
    counts[bool(good)] += 1
    print("ok  " if good else "FAIL", *text)


def run(x):
    np.savetxt(X, x.reshape(len(x), -1), "%.9g", ",")
    out = subprocess.run(("build/nn_run", FILE, X), capture_output=True, text=True, check=True).stdout
    return np.array([line.split(",") for line in out.split()], np.float64)


def export(net, shape, *args, **kwargs):
    """The message of the refusal, or None."""
    try:
        ms.save_torch(FILE, net, shape, *args, **kwargs)
        return None
    except ms.Unsupported as e:
        return str(e)


def disturb(net):
    """Statistics and weights as after training; in eval()."""
    for m in net.modules():
        if getattr(m, "running_var", None) is not None:
            m.running_mean.normal_()
            m.running_var.uniform_(0.5, 2)
            if m.weight is not None:
                nn.init.normal_(m.weight)
                nn.init.normal_(m.bias)
    return net.eval()


def check(name, net, shape, words=None, dtype="float32", tolerance=1e-5):
    """words: in the refusal; None: the network is saved. tolerance: the rounding of float32, or of the narrow type."""
    disturb(net)
    if os.path.exists(FILE): os.remove(FILE)
    message = export(net, shape, dtype)
    left = os.listdir(FOLDER)
    if words is not None:
        return result(message and all(w in message for w in words) and not {f for f in left if f.startswith("net")}, name, "-", message or "was saved")
    if message: return result(False, name, "-", message)
    x = torch.randn(3, *shape, generator=torch.Generator().manual_seed(5))
    with torch.no_grad(): theirs = net.double()(x.double()).reshape(3, -1).numpy()
    ours = run(x.numpy())
    error = abs(ours - theirs).max() / abs(theirs).max() if ours.shape == theirs.shape else np.inf
    result(error <= tolerance, "%s - saved, largest error %.1e" % (name, error))


class Net(nn.Module):
    """forward(self, x) is a function; the modules stand under their names."""
    def __init__(self, function, **modules):
        super().__init__()
        self.function = function
        for name, m in modules.items(): setattr(self, name, m)

    def forward(self, x): return self.function(self, x)


class Twice(nn.Module):
    """Has control flow that depends on its input."""
    def forward(self, x): return x * 2 if x.sum() > 0 else x


class Scaled(nn.Linear):
    def forward(self, x): return 3 * super().forward(x)


class Named(nn.Linear):
    """Overrides nothing that counts."""


class Wrong(nn.Conv2d):
    def _conv_forward(self, x, *rest): return 2 * super()._conv_forward(x, *rest)


class Two(nn.Module):
    def forward(self, x, y): return x + y


def in_place(s, x):  # torch.fx takes += for an addition that leaves y what it was
    y = z = torch.tanh(x)
    z += torch.relu(z)
    return z + y


def hooked(m):
    m.register_forward_hook(lambda module, inputs, output: 2 * output)
    return m


def replaced(m):
    m.forward = lambda x: x
    return m


def big(m, value):
    m.weight.data[0] = value
    return m


def global_hook(name):
    handle = nn.modules.module.register_module_forward_hook(lambda module, inputs, output: None)
    check(name, nn.Sequential(nn.Linear(4, 3)), (4,), ("hooks",))
    handle.remove()


ZERO = torch.zeros(2, dtype=torch.double)
P, Q, V = (2, 8, 6), (2, 12), (5,)  # inputs: a picture, a row, a vector
c2, c1, shared = nn.Conv2d(2, 4, 3, padding=1), nn.Conv1d(2, 4, 3, padding=1), nn.Linear(5, 5)
same = nn.Conv2d(2, 2, 3, padding=1)

MODULES = [ # module, shape, words of the refusal
    (nn.Linear(5, 4), V, None), (nn.Linear(5, 4, bias=False), V, None), (nn.Linear(12, 4), Q, ("'0'", "Linear", "flatten")), (Named(5, 4), V, None),
    (Scaled(5, 4), V, ("Scaled", "linear")), (nn.Bilinear(5, 5, 3), V, ("Bilinear",)), (nn.Identity(), V, ("no layers",)),
    (nn.Conv1d(2, 4, 3, stride=2, padding=1), Q, None), (nn.Conv1d(2, 4, 3, groups=2), Q, ("Conv1d", "groups")), (nn.Conv1d(2, 3, 4, padding="same"), Q, None),
    (nn.Conv2d(2, 4, (3, 2), stride=(2, 1), padding=(1, 0)), P, None),
    (nn.Conv2d(2, 4, 3, padding="same"), P, None), (nn.Conv2d(2, 4, 3, dilation=2), P, ("Conv2d", "dilates")),
    (nn.Conv2d(2, 4, 3, padding=1, padding_mode="reflect"), P, ("'0'", "Conv2d", "reflect")), (nn.Conv3d(2, 4, 3), (2, 4, 4, 4), ("Conv3d",)),
    (Wrong(2, 4, 3), P, ("differ",)), (nn.ConvTranspose1d(2, 4, 3, stride=2), Q, ("ConvTranspose1d",)),
    (nn.ConvTranspose2d(2, 4, 3), P, ("ConvTranspose2d",)),
    (nn.ConvTranspose3d(2, 4, 3), (2, 4, 4, 4), ("ConvTranspose3d",)), (nn.MaxPool1d(3, 2), Q, None), (nn.MaxPool2d((2, 3), stride=(2, 1)), P, None),
    (nn.MaxPool2d(3, padding=1), P, ("MaxPool2d", "pads")), (nn.MaxPool2d(3, ceil_mode=True), P, ("rounds up",)),
    (nn.MaxPool2d(2, dilation=2), P, ("dilates",)), (nn.MaxPool2d(2, return_indices=True), P, ("MaxPool2d",)), (nn.AvgPool1d(3), Q, None),
    (nn.AvgPool2d(2, stride=1), P, None), (nn.AvgPool2d(3, padding=1), P, ("AvgPool2d", "pads")),
    (nn.AvgPool2d(2, divisor_override=3), P, ("another number",)), (nn.LPPool2d(2, 2), P, ("LPPool2d",)),
    (nn.FractionalMaxPool2d(2, output_size=2), P, ("FractionalMaxPool2d",)), (nn.AdaptiveAvgPool1d(1), Q, None),
    (nn.AdaptiveAvgPool2d((4, 2)), P, None), (nn.AdaptiveAvgPool2d((3, 2)), P, ("AdaptiveAvgPool2d", "divide")),
    (nn.AdaptiveMaxPool2d((2, 3)), P, None), (nn.AdaptiveMaxPool1d(5), Q, ("AdaptiveMaxPool1d",)), (nn.Upsample(scale_factor=2), Q, None),
    (nn.Upsample(size=(16, 18)), P, None), (nn.Upsample(scale_factor=(2, 3), mode="bilinear"), P, ("Upsample", "bilinear")),
    (nn.Upsample(scale_factor=2, mode="linear", align_corners=True), Q, ("Upsample", "linear")),
    (nn.Upsample(scale_factor=2, mode="bicubic"), P, ("Upsample", "bicubic")), (nn.Upsample(scale_factor=1.5), P, ("Upsample", "whole")),
    (nn.UpsamplingNearest2d(scale_factor=2), P, None), (nn.UpsamplingBilinear2d(scale_factor=3), P, ("UpsamplingBilinear2d", "bilinear")), (nn.BatchNorm1d(5), V, None),
    (nn.BatchNorm1d(2), Q, None), (nn.BatchNorm2d(2, affine=False), P, None),
    (nn.BatchNorm2d(2, track_running_stats=False), P, ("BatchNorm2d", "running")), (nn.BatchNorm3d(2), (2, 4, 4, 4), ("BatchNorm3d",)),
    (nn.InstanceNorm2d(2), P, ("InstanceNorm2d",)), (nn.GroupNorm(1, 2), P, ("GroupNorm",)), (nn.LayerNorm(5), V, ("LayerNorm",)),
    (nn.LocalResponseNorm(2), P, ("LocalResponseNorm",)), (nn.Flatten(), P, None), (nn.Flatten(2), P, ("Flatten", "flattening")),
    (nn.Flatten(2), Q, ("no layers",)), (nn.Unflatten(1, (1, 5)), V, ("Unflatten",)), (nn.ReLU(), V, None), (nn.ReLU(inplace=True), V, None),
    (nn.ReLU6(), V, ("ReLU6",)), (nn.LeakyReLU(0.3), V, None), (nn.PReLU(init=0.4), V, None), (nn.PReLU(5), V, ("PReLU",)),
    (nn.RReLU(), V, ("RReLU",)), (nn.ELU(0.7), V, None), (nn.CELU(), V, ("CELU",)), (nn.SELU(), V, ("SELU",)), (nn.GELU(), V, None),
    (nn.GELU("tanh"), V, ("GELU", "tanh")), (nn.SiLU(), V, None), (nn.Mish(), V, ("Mish",)), (nn.Softplus(), V, None),
    (nn.Softplus(2), V, ("Softplus", "beta")), (nn.Softplus(1, 3), V, ("Softplus", "threshold")), (nn.Tanh(), V, None), (nn.Sigmoid(), V, None),
    (nn.Softmax(1), V, ("Softmax",)), (nn.LogSoftmax(1), V, ("LogSoftmax",)), (nn.Hardtanh(), V, ("Hardtanh",)), (nn.Hardswish(), V, ("Hardswish",)),
    (nn.Softsign(), V, ("Softsign",)), (nn.Threshold(0, 1), V, ("Threshold",)), (nn.GLU(), (6,), ("GLU",)),
    (nn.PixelShuffle(2), (4, 3, 3), ("PixelShuffle",)), (nn.ZeroPad2d(1), P, ("ZeroPad2d",)), (nn.ReflectionPad2d(1), P, ("ReflectionPad2d",)),
    (nn.ChannelShuffle(2), (4, 3, 3), ("ChannelShuffle",)), (nn.LSTM(12, 3, batch_first=True), Q, ("LSTM",)),
    (nn.GRU(12, 3, batch_first=True), Q, ("GRU",)), (nn.TransformerEncoderLayer(12, 2, batch_first=True), Q, ("Transformer",)),
    (nn.Unfold(2), P, ("Unfold",)), (nn.CosineSimilarity(), V, ("CosineSimilarity",)),
]
for m, shape, words in MODULES:
    kind = type(m).__name__
    if kind in ("Bilinear", "CosineSimilarity"): check("forward with " + kind, Net(lambda s, x: s.m(x, x), m=m), shape, words)
    else: check(repr(m).split("\n")[0], m, shape, words)

FUNCTIONS = [ # forward(x), shape, words of the refusal
    ("F.relu", lambda s, x: F.relu(x), V, None), ("torch.relu", lambda s, x: torch.relu(x), V, None), ("x.relu()", lambda s, x: x.relu(), V, None),
    ("x.relu_()", lambda s, x: x.relu_(), V, None), ("F.leaky_relu", lambda s, x: F.leaky_relu(x, 0.2), V, None),
    ("F.elu", lambda s, x: F.elu(x, alpha=0.3), V, None), ("torch.tanh", lambda s, x: torch.tanh(x), V, None),
    ("x.sigmoid()", lambda s, x: x.sigmoid(), V, None), ("F.softplus", lambda s, x: F.softplus(x), V, None),
    ("F.softplus(beta=2)", lambda s, x: F.softplus(x, beta=2), V, ("beta",)), ("F.silu", lambda s, x: F.silu(x), V, None),
    ("F.gelu", lambda s, x: F.gelu(x), V, None), ("F.gelu(tanh)", lambda s, x: F.gelu(x, approximate="tanh"), V, ("tanh",)),
    ("F.max_pool2d", lambda s, x: F.max_pool2d(x, 2, 1), P, None),
    ("F.max_pool2d(ceil)", lambda s, x: F.max_pool2d(x, 3, ceil_mode=True), P, ("rounds up",)),
    ("F.max_pool2d(padding)", lambda s, x: F.max_pool2d(x, 3, 2, 1), P, ("pads",)), ("F.avg_pool2d", lambda s, x: F.avg_pool2d(x, (2, 3)), P, None),
    ("F.avg_pool1d", lambda s, x: F.avg_pool1d(x, 4), Q, None), ("F.adaptive_avg_pool2d", lambda s, x: F.adaptive_avg_pool2d(x, 1), P, None),
    ("F.interpolate", lambda s, x: F.interpolate(x, scale_factor=2), P, None),
    ("F.interpolate(linear)", lambda s, x: F.interpolate(x, size=24, mode="linear", align_corners=False), Q, ("linear",)),
    ("F.interpolate(1.5)", lambda s, x: F.interpolate(x, scale_factor=1.5), P, ("whole",)),
    ("F.interpolate(antialias)", lambda s, x: F.interpolate(x, scale_factor=2, mode="bilinear", antialias=True), P, ("arguments",)),
    ("torch.flatten", lambda s, x: torch.flatten(x, 1), P, None), ("x.view", lambda s, x: x.view(x.size(0), -1), P, None),
    ("x.reshape", lambda s, x: x.reshape(x.shape[0], -1), Q, None),
    ("x.view of another shape", lambda s, x: x.view(-1, 4, 24).flatten(1), P, ("view",)),
    ("x.transpose", lambda s, x: x.transpose(2, 3), P, ("transpose",)),
    ("x.permute, flattened", lambda s, x: x.permute(0, 2, 3, 1).flatten(1), P, ("permute",)), ("x.mean", lambda s, x: x.mean((2, 3)), P, None),
    ("torch.mean(keepdim)", lambda s, x: torch.mean(x, [-1, -2], keepdim=True), P, None), ("x.mean of rows", lambda s, x: x.mean(3), P, ("mean",)),
    ("x.mean()", lambda s, x: x.mean(), P, ("mean",)), ("F.dropout in eval", lambda s, x: F.dropout(F.relu(x), 0.5, s.training), V, None),
    ("F.dropout always", lambda s, x: F.dropout(x), V, ("drops in eval",)), ("F.softmax", lambda s, x: F.softmax(x, 1), V, ("softmax",)),
    ("F.linear", lambda s, x: F.linear(x, torch.ones(2, 5, dtype=torch.double)), V, ("linear",)),
    ("F.batch_norm", lambda s, x: F.batch_norm(x, ZERO, ZERO + 1), P, ("batch_norm",)), ("F.pad", lambda s, x: F.pad(x, (1, 1)), Q, ("pad",)),
    ("x + x", lambda s, x: x + x, V, None), ("x + 1", lambda s, x: x + 1, V, ("no tensor",)), ("2 * x", lambda s, x: 2 * x, V, ("mul",)),
    ("x - x.relu()", lambda s, x: x - x.relu(), V, ("sub",)), ("x * x", lambda s, x: x * x, V, ("mul",)),
    ("torch.add(alpha)", lambda s, x: torch.add(x, x, alpha=2), V, ("add",)),
    ("torch.matmul", lambda s, x: torch.matmul(x, torch.ones(5, 5)), V, ("double precision",)),
    ("x.clamp", lambda s, x: x.clamp(0, 1), V, ("clamp",)), ("x[:, 1:]", lambda s, x: x[:, 1:], V, ("getitem",)),
    ("torch.exp", lambda s, x: torch.exp(x), V, ("exp",)), ("x.detach().numpy()", lambda s, x: torch.from_numpy(x.detach().numpy()), V, ("trace",)),
    ("torch.cat([x, x])", lambda s, x: torch.cat([x, x], 1), P, ("cat",)),
]
for name, function, shape, words in FUNCTIONS: check(name, Net(function), shape, words)

NETWORKS = [
    ("an empty Sequential", nn.Sequential(), V, ("no layers",)),
    ("nested Sequentials", nn.Sequential(nn.Sequential(nn.Linear(5, 6), nn.BatchNorm1d(6)), nn.ReLU(), nn.Sequential(nn.Dropout(), nn.Sequential(nn.Linear(6, 3)))), V, None),
    ("a function between modules", Net(lambda s, x: s.b(F.relu(s.a(x))), a=nn.Linear(5, 30), b=nn.Linear(30, 4)), V, None),
    ("order of use, not of definition", Net(lambda s, x: s.a(torch.tanh(s.b(x))), a=nn.Linear(7, 4), b=nn.Linear(5, 7)), V, None),
    ("a module that is not used", Net(lambda s, x: s.a(x), a=nn.Linear(5, 4), unused=nn.GRU(3, 3)), V, None),
    ("an unused result", Net(lambda s, x: (s.b(x), s.a(x))[1], a=nn.Linear(5, 4), b=nn.Linear(5, 4)), V, None),
    ("a layer used twice", Net(lambda s, x: s.m(torch.relu(s.m(x))), m=shared), V, None),
    ("a layer used twice in a Sequential", nn.Sequential(shared, nn.ReLU(), shared), V, None),
    ("BatchNorm behind a convolution used twice", Net(lambda s, x: s.b(s.m(s.m(x))), m=same, b=nn.BatchNorm2d(2)), P, None),
    ("Identity, Dropout2d, BatchNorm in front", nn.Sequential(nn.BatchNorm2d(2), nn.Identity(), nn.Dropout2d(), nn.Conv2d(2, 3, 3), nn.Identity(), nn.Dropout2d(), nn.AlphaDropout(), nn.BatchNorm2d(3)), P, None),
    ("BatchNorm behind Identity", nn.Sequential(nn.Identity(), nn.BatchNorm2d(2), nn.Conv2d(2, 3, 3), nn.Identity(), nn.BatchNorm2d(3)), P, None),
    ("F.relu by keyword", Net(lambda s, x: F.relu(input=x)), V, None),
    ("BatchNorm behind an activation", nn.Sequential(nn.Conv2d(2, 3, 3), nn.ReLU(), nn.BatchNorm2d(3), nn.Flatten(), nn.Linear(3 * 6 * 4, 5), nn.Sigmoid(), nn.BatchNorm1d(5)), P, None),
    ("BatchNorm behind a convolution without bias", nn.Sequential(nn.Conv2d(2, 4, 3, stride=2, bias=False), nn.BatchNorm2d(4), nn.GELU()), P, None),
    ("BatchNorm whose input is read again", Net(lambda s, x: (lambda y: s.b(y) + y)(s.a(x)), a=c2, b=nn.BatchNorm2d(4)), P, None),
    ("residual blocks", Net(lambda s, x: (lambda y: torch.relu(s.c(torch.relu(s.b(s.a(y)))) + y))(F.relu(s.f(x))), f=c2, a=nn.Conv2d(4, 4, 3, padding=1), b=nn.BatchNorm2d(4), c=nn.Conv2d(4, 4, 1)), P, None),
    ("a skip around pooling and upsampling", Net(lambda s, x: (lambda y: s.c(F.interpolate(s.b(F.max_pool2d(y, 2)), scale_factor=2) + y))(F.elu(s.a(x))), a=c2, b=nn.Conv2d(4, 4, 3, padding=1), c=nn.Conv2d(4, 2, 1)), P, None),
    ("a projected shortcut", Net(lambda s, x: s.a(x) + s.b(x), a=c2, b=nn.Conv2d(2, 4, 1)), P, ("'b'", "Conv2d", "only additions")),
    ("an input that is read late", Net(lambda s, x: s.a(x) * 0 + s.b(x), a=shared, b=nn.Linear(5, 5)), V, ("'the network'",)),
    ("activations in place, read again", Net(lambda s, x: (lambda y: s.r(y) + y)(s.a(x)), a=shared, r=nn.ReLU(inplace=True)), V, ("'r'", "in place")),
    ("x.relu_(), read again", Net(lambda s, x: (lambda y: y.relu_() + y)(s.a(x)), a=shared), V, ("in place",)),
    ("F.relu in place, read again", Net(lambda s, x: (lambda y: F.relu(y, inplace=True) + y)(s.a(x)), a=shared), V, ("in place",)),
    ("+= with a second name", Net(in_place), V, ("differ",)),
    ("two inputs", Two(), V, ("Two",)),
    ("two outputs", Net(lambda s, x: (s.a(x), x), a=shared), V, ("not one tensor",)),
    ("an output that is not the last", Net(lambda s, x: (lambda y: s.b(y) if s.training else y)(s.a(x)), a=shared, b=shared), V, None),
    ("control flow by input", nn.Sequential(nn.Linear(5, 5), Twice()), V, ("'1'", "Twice", "trace")),
    ("hooks", nn.Sequential(nn.Sequential(nn.ReLU(), hooked(nn.Linear(5, 4)))), V, ("'0.1'", "Linear", "hooks")),
    ("weight_norm", nn.Sequential(nn.utils.weight_norm(nn.Linear(5, 4))), V, ("'0'", "hooks")),
    ("parametrized weights", nn.Sequential(nn.utils.parametrizations.spectral_norm(nn.Linear(5, 4))), V, None),
    ("a replaced forward()", nn.Sequential(replaced(nn.Linear(5, 4))), V, ("'0'", "replaced")),
    ("a parameter that is added", Net(lambda s, x: x + s.p, p=nn.Parameter(torch.ones(5))), V, ("no such layer",)),
    ("weights that are not finite", nn.Sequential(big(nn.Linear(5, 4), float("nan"))), V, ("not finite",)),
]
for name, net, shape, words in NETWORKS: check(name, net, shape, words)
global_hook("hooks on all modules")

renderer = nn.Sequential(nn.Conv1d(1, 8, 3, padding=1), nn.ELU(), nn.Upsample(scale_factor=2), nn.Conv1d(8, 6, 4, padding="same"), nn.ELU(0.5),
                         nn.Upsample(scale_factor=2), nn.Flatten(), nn.Dropout(0.5), nn.Linear(6 * 76, 30), nn.Tanh(), nn.Linear(30, 48, bias=False))
inversion = nn.Sequential(nn.Conv2d(3, 8, (5, 3), padding=(2, 1)), nn.ReLU(), nn.MaxPool2d(2), nn.Conv2d(8, 5, 3, stride=2), nn.LeakyReLU(0.2), nn.Conv2d(5, 5, 3, padding=1),
                          nn.MaxPool2d(3, stride=1), nn.Softplus(), nn.Upsample(scale_factor=(2, 3)), nn.Flatten(), nn.Linear(5 * 4 * 12, 19), nn.Sigmoid())
for name, net, shape in (("renderer", renderer, (1, 19)), ("inversion", inversion, (3, 21, 26))):
    # half a unit in the last of 11 bits of each weight, or of 7; a few layers
    for dtype, tolerance in (("float32", 1e-5), ("float16", 2e-3), ("int8", 0.05)): check(name + " in " + dtype, net, shape, None, dtype, tolerance)

check("70000 in float32", nn.Sequential(big(nn.Linear(5, 4), 70000.0)), V)
check("70000 in float16", nn.Sequential(nn.ReLU(), big(nn.Linear(5, 4), 70000.0)), V, ("'1'", "Linear", "70000", "float16"), "float16")
check("BatchNorm in float16", nn.Sequential(nn.Linear(5, 4), nn.BatchNorm1d(4, eps=0, affine=False)), V, None, "float16", 2e-3)
check("weights below float16's smallest", nn.Sequential(nn.Linear(5, 40), nn.Linear(40, 3, bias=False)).apply(lambda m: nn.init.constant_(m.weight, 1e-8) if hasattr(m, "weight") else None), V,
      ("float16", "differ"), "float16")

# The check catches what translation gets wrong: without the ReLU; with another slope; with weights transposed.
right = ms.torch_layer
def without(m, kind, *rest): return ([], None) if kind == "ReLU" else right(m, kind, *rest)
def slope(m, kind, *rest): return ([{"type": "activation", "activation": "leaky_relu", "alpha": 0.001}], None) if kind == "ReLU" else right(m, kind, *rest)
def turned(m, kind, *rest): return ([{"type": "dense"}], (ms.array(m.weight).T, ms.array(m.bias))) if kind == "Linear" else right(m, kind, *rest)
for wrong in (without, slope, turned):
    ms.torch_layer = wrong
    check("the check catches a wrong translation (%s)" % wrong.__name__, nn.Sequential(nn.Linear(5, 5), nn.ReLU()), V, ("differ",))
ms.torch_layer = right
torch.save(shared, os.path.join(FOLDER, "old"))
with open(FILE, "w") as f: f.write("old")
result(export(nn.Sequential(nn.GRU(5, 3)), V) and open(FILE).read() == "old", "a refusal leaves the old file")
training = nn.Sequential(nn.Linear(5, 4), nn.Dropout(), nn.BatchNorm1d(4)).train()
result(export(training, V) is None and training.training and training[2].training, "a network in training stays in training")
# Keras, whose layers are stood in for by objects with get_config() and get_weights(); predict() by Keras's own definitions, channels last.
t = lambda a: torch.tensor(np.asarray(a, np.float32)).double()


def keras_layer(kind, weights=(), **config):
    layer = type(kind, (), {})()
    layer.name, layer.get_config, layer.get_weights = config.pop("name", kind), lambda: config, lambda: list(weights)
    return layer


def check_keras(name, shape, forward, words, *layers):
    net = types.SimpleNamespace(input_shape=(None, *shape), layers=layers, predict=lambda x: forward(torch.from_numpy(x).double()).numpy())
    if os.path.exists(FILE): os.remove(FILE)
    try: message, error = None, ms.save_keras(FILE, net)
    except ms.Unsupported as e: message = str(e)
    if words is not None: return result(message and all(w in message for w in words) and not os.path.exists(FILE), name, "-", message or "was saved")
    if message: return result(False, name, "-", message)
    x = np.random.default_rng(6).normal(size=(3, *shape)).astype(np.float32)
    theirs = net.predict(x).reshape(3, -1)
    e = abs(run(np.moveaxis(x, -1, 1)) - theirs).max() / abs(theirs).max()
    result(e <= 1e-5 and error <= 1e-5, "%s - saved, largest error %.1e" % (name, e))


r = np.random.default_rng(4)
conv, conv_b, dense, dense_b = r.normal(size=(3, 3, 2, 4)) / 4, r.normal(size=4), r.normal(size=(4 * 5 * 6, 7)) / 10, r.normal(size=7)
conv1, dense1 = r.normal(size=(4, 2, 3)) / 3, r.normal(size=(18 * 3, 5)) / 7
c = keras_layer("Conv2D", (conv, conv_b), name="c", filters=4, kernel_size=(3, 3), strides=(1, 1), padding="same", activation="relu")
rest = (keras_layer("MaxPooling2D", pool_size=(2, 2), strides=(2, 2), padding="valid"), keras_layer("Flatten"), keras_layer("Dropout", rate=0.1),
        keras_layer("Dense", (dense, dense_b), name="d", units=7, activation="tanh"))


def forward_2d(x):
    y = F.conv2d(x.permute(0, 3, 1, 2), t(conv).permute(3, 2, 0, 1), t(conv_b), padding=1).relu()
    y = F.max_pool2d(y, 2).permute(0, 2, 3, 1).reshape(len(x), -1)
    return torch.tanh(y @ t(dense) + t(dense_b))


def forward_1d(x):  # an even kernel: one zero in front, two behind; the activation's name means a slope of 0.2
    y = F.leaky_relu(F.conv1d(F.pad(x.permute(0, 2, 1), (1, 2)), t(conv1).permute(2, 1, 0)), 0.2)
    y = F.elu(y.repeat_interleave(2, dim=2), 0.5).permute(0, 2, 1).reshape(len(x), -1)
    return F.leaky_relu(y @ t(dense1), 0.3)


check_keras("Keras, pictures", (10, 12, 2), forward_2d, None, keras_layer("InputLayer"), c, *rest)
check_keras("Keras, rows", (9, 2), forward_1d, None, keras_layer("Conv1D", (conv1,), name="c", filters=3, kernel_size=(4,), strides=(1,), padding="same", activation="leaky_relu"),
            keras_layer("UpSampling1D", size=2), keras_layer("ELU", alpha=0.5), keras_layer("Flatten"), keras_layer("Dense", (dense1,), name="d", units=5, activation="linear"),
            keras_layer("LeakyReLU", negative_slope=0.3))
check_keras("Keras, another network than its layers say", (10, 12, 2), lambda x: forward_2d(x).abs(), ("differ",), c, *rest)
check_keras("Keras, LSTM", (8, 2), None, ("'memory'", "LSTM"), keras_layer("LSTM", name="memory", units=3))
check_keras("Keras, selu", (8,), None, ("'last'", "selu"), keras_layer("Dense", name="last", activation="selu"))
check_keras("Keras, strides and padding", (8, 8, 2), None, ("'c'", "strides"), keras_layer("Conv2D", name="c", padding="same", strides=(2, 2), kernel_size=(3, 3)))
shutil.rmtree(FOLDER)
print("%d passed, %d failed, 0 skipped" % (counts[True], counts[False]))
sys.exit(counts[False] != 0)
