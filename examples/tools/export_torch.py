#!/usr/bin/env python3
"""Saves a PyTorch or Keras network for ms_nn.h: safetensors with the layer list in its metadata. Needs numpy.

    import export_torch as ms
    error = ms.save_torch("net.safetensors", net, (3, 410, 410))  # the shape of one input, channels first
    error = ms.save_keras("net.safetensors", net)  # channels last: inputs and kernels are transposed, the flatten order is recorded

PyTorch: torch.fx traces the network as it is in eval(). Any Module is saved whose forward() is a chain of layers that ms_nn.h has, as modules
or as functions (F.relu, x.tanh(), torch.flatten), with additions and torch.cat of earlier outputs. A layer that is used twice is stored
twice. BatchNorm is folded into the linear or convolution layer before it, or becomes a layer of its own.
Keras: Sequential.

Every file is checked before it is kept: build/nn_run runs it (a C compiler builds that from examples/tools/nn_run.c where it is missing), and
its outputs for random inputs must equal the network's own within tolerance times the largest output: 1e-4 by default, 0.01 for float16, 0.1
for int8. The result is that error of the saved file. Everything else raises Unsupported with the name and type of the module, and leaves no
file: what ms_nn.h cannot run, hooks, control flow that depends on the input, weights that are not finite or too large for float16."""
import copy, json, os, shutil, struct, subprocess, tempfile
import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
ACTIVATIONS = {"ReLU": "relu", "LeakyReLU": "leaky_relu", "ELU": "elu", "Tanh": "tanh", "Sigmoid": "sigmoid", "Softplus": "softplus",
               "SiLU": "silu", "GELU": "gelu"}
TOLERANCE = {"float32": 1e-4, "float16": 1e-2, "int8": 1e-1}


class Unsupported(ValueError):
    """A network that cannot be saved."""


def require(good, module, reason):
    """Raises Unsupported with the module's name and type, unless good."""
    if not good: raise Unsupported("module '%s' of type %s cannot be saved: %s" % (*module, reason))


# --- the file and its check -------------------------------------------------------------------------------------------

def write(path, input_shape, layers, tensors):
    """The layer list, then the tensors (numpy arrays by name), the largest first."""
    header = {"__metadata__": {"format": "pt", "ms_nn_version": "1", "ms_nn_input": json.dumps(list(input_shape)), "ms_nn_layers": json.dumps(layers)}}
    names, end = sorted(tensors, key=lambda name: -tensors[name].nbytes), 0
    for name in names:
        t = tensors[name]
        dtype = {"float32": "F32", "float16": "F16", "int8": "I8"}[str(t.dtype)]
        header[name] = {"dtype": dtype, "shape": list(t.shape), "data_offsets": [end, end := end + t.nbytes]}
    text = json.dumps(header).encode()
    text += b" " * (-(8 + len(text)) % 64)
    with open(path, "wb") as f:
        f.write(struct.pack("<Q", len(text)) + text)
        for name in names: f.write(np.ascontiguousarray(tensors[name]).tobytes())
        f.flush()
        os.fsync(f.fileno())


def stored(module, name, dtype, weight, bias):
    """The tensors of a layer: weights as float32, float16, or int8 with one scale for each index of their first dimension."""
    weight, tensors = np.asarray(weight, np.float64), {}
    for values, kind in ((weight, "float32" if dtype == "int8" else dtype), (np.asarray(0 if bias is None else bias, np.float64), "float32")):
        largest = abs(values).max(initial=0)
        require(largest <= np.finfo(kind).max, module, "its largest weight, %g, is not finite in %s" % (largest, kind))
    if dtype == "int8":
        scale = np.maximum(abs(weight).reshape(len(weight), -1).max(1), 1e-30).astype(np.float32) / 127
        weight = np.rint(weight / scale.reshape((-1,) + (1,) * (weight.ndim - 1)))
        tensors[name + ".weight_scale"] = scale
    tensors[name + ".weight"] = weight.astype(dtype)
    if bias is not None: tensors[name + ".bias"] = np.asarray(bias, np.float32)
    return tensors


def nn_run(_found=[]):
    """The program that runs a saved file: build/nn_run, or one that is compiled from its source."""
    if not _found:
        program = os.path.join(ROOT, "build", "nn_run")
        if not os.path.exists(program):
            compiler = os.environ.get("CC") or shutil.which("cc") or shutil.which("gcc") or shutil.which("clang")
            program = os.path.join(tempfile.mkdtemp(), "nn_run")
            source = os.path.join(HERE, "nn_run.c")
            if not compiler or not os.path.exists(source) or subprocess.run([*compiler.split(), "-O2", "-I" + ROOT, "-I" + HERE, source, "-o", program, "-lm"]).returncode:
                raise RuntimeError("the file cannot be checked, so it is not saved: there is no build/nn_run, and no C compiler that makes it from %s" % source)
        _found.append(program)
    return _found[0]


def error_of(path, network, x, y):
    """The largest difference between the saved file's outputs for x and y, in units of the largest of y."""
    with tempfile.TemporaryDirectory() as folder:
        rows = os.path.join(folder, "x.csv")
        np.savetxt(rows, x.reshape(len(x), -1), "%.9g", ",")
        ran = subprocess.run((nn_run(), path, rows), capture_output=True, text=True)
    require(ran.returncode == 0, network, "ms_nn.h refuses it: " + ran.stderr.strip())
    ours, y = np.array([line.split(",") for line in ran.stdout.split()], np.float64), np.asarray(y, np.float64).reshape(len(x), -1)
    require(ours.shape == y.shape, network, "it has %d outputs, and the saved one %d" % (y.shape[1], ours.shape[1]))
    require(np.isfinite(y).all(), network, "its outputs for random inputs are not finite")
    return abs(ours - y).max() / max(abs(y).max(), 1e-30)


def save(path, network, input_shape, layers, weights, dtype, tolerance, forward):
    """network: name and type. weights: by a layer's index, (module, weight, bias). forward: what the network computes for a batch."""
    require(layers, network, "it has no layers")
    samples = np.random.default_rng(1).normal(size=(4, *input_shape)) * np.reshape([0.3, 1, 3, 1], (-1,) + (1,) * len(input_shape))
    samples[3] = np.random.default_rng(2).uniform(size=input_shape)
    x = samples.astype(np.float32)
    y = forward(x)
    unchecked = "%s.new-%d" % (path, os.getpid())
    try:
        for kind in dict.fromkeys(("float32", dtype)):  # in float32 first: a narrow type's rounding would hide a small mistake
            tensors = {}
            for i, weight in weights.items(): tensors.update(stored(weight[0], layers[i]["name"], kind, *weight[1:]))
            write(unchecked, input_shape, layers, tensors)
            error = error_of(unchecked, network, x, y)
            bound = TOLERANCE[kind] if tolerance is None or kind != dtype else tolerance
            require(error <= bound, network, "saved as %s, its outputs would differ by %.2g of the largest (at most %g is allowed)" % (kind, error, bound))
        os.replace(unchecked, path)
    finally:
        if os.path.exists(unchecked): os.remove(unchecked)
    return error


# --- PyTorch ----------------------------------------------------------------------------------------------------------

def array(x): return None if x is None else np.asarray(x.detach().numpy(), np.float64)
def first_line(e): return str(e).strip().split("\n")[0]
def numbers(x): return [int(v) for v in x] if np.ndim(x) else int(x)


def traced(net, x):
    """The torch.fx graph of net run on x. Each node has ms_module, name and type of the module whose forward() it stands in, and ms_value."""
    import torch.fx, torch.nn.modules.module as hooks
    own = lambda m: type(m).forward.__module__.startswith("torch.nn.modules") and not isinstance(m, torch.nn.Sequential)

    class Tracer(torch.fx.Tracer):
        path = [("the network", type(net).__name__)]

        def is_leaf_module(self, m, name): return own(m)

        def call_module(self, m, forward, args, kwargs):
            self.path.append((self.path_of_module(m), type(m).__name__))
            result = super().call_module(m, forward, args, kwargs)
            self.path.pop()  # an exception leaves it
            return result

        def create_node(self, *args, **kwargs):
            node = super().create_node(*args, **kwargs)
            node.ms_module = self.path[-1]
            return node

    class Run(torch.fx.Interpreter):
        def run_node(self, node):
            node.ms_value = super().run_node(node)
            return node.ms_value

    require(not (hooks._global_forward_hooks or hooks._global_forward_pre_hooks), Tracer.path[0], "there are hooks on all modules")
    for name, m in net.named_modules():
        me = name or "the network", type(m).__name__
        require(not (m._forward_pre_hooks or m._forward_hooks), me, "it has hooks; remove them first (remove_weight_norm, remove_spectral_norm)")
        require("forward" not in vars(m), me, "its forward() was replaced")
    try: root = copy.deepcopy(net).cpu().double().eval()
    except Exception as e: raise Unsupported("module 'the network' of type %s cannot be saved: it cannot be copied: %s" % (type(net).__name__, e)) from e
    if own(root): root = torch.nn.Sequential(root)
    tracer = Tracer()
    try: graph = tracer.trace(root)
    except Exception as e: raise Unsupported("module '%s' of type %s cannot be saved: torch.fx cannot trace it: %s" % (*tracer.path[-1], first_line(e))) from e
    module = torch.fx.GraphModule(root, graph)
    try:
        with torch.no_grad(): Run(module).run(x)
    except Exception as e:
        me = next((node.ms_module for node in graph.nodes if not hasattr(node, "ms_value")), tracer.path[0])
        raise Unsupported("module '%s' of type %s cannot be saved: PyTorch cannot run it in double precision on inputs of the shape %s: %s" %
                          (*me, tuple(x.shape[1:]), first_line(e))) from e
    return module, root


def functions():
    """The module that does the same as a function, called with the function's arguments but the first. None: nothing."""
    from torch import nn
    def dropout(p=0.5, training=True, inplace=False): return None if not training else nn.Dropout
    def max_pool(kind): return lambda kernel_size, stride=None, padding=0, dilation=1, ceil_mode=False, return_indices=False: kind(kernel_size, stride, padding, dilation, return_indices, ceil_mode)
    def interpolate(size=None, scale_factor=None, mode="nearest", align_corners=None, recompute_scale_factor=None, antialias=False):
        if antialias: raise TypeError("antialias")
        return nn.Upsample(size, scale_factor, mode, align_corners)
    known = {"relu": nn.ReLU, "leaky_relu": nn.LeakyReLU, "elu": nn.ELU, "tanh": nn.Tanh, "sigmoid": nn.Sigmoid, "softplus": nn.Softplus, "silu": nn.SiLU,
             "gelu": nn.GELU, "max_pool1d": max_pool(nn.MaxPool1d), "max_pool2d": max_pool(nn.MaxPool2d), "avg_pool1d": nn.AvgPool1d,
             "avg_pool2d": nn.AvgPool2d, "adaptive_avg_pool1d": nn.AdaptiveAvgPool1d, "adaptive_avg_pool2d": nn.AdaptiveAvgPool2d,
             "adaptive_max_pool1d": nn.AdaptiveMaxPool1d, "adaptive_max_pool2d": nn.AdaptiveMaxPool2d, "interpolate": interpolate,
             "dropout": dropout, "dropout2d": dropout, "alpha_dropout": dropout, "contiguous": lambda: None, "clone": lambda: None}
    return {**known, **{name + "_": known[name] for name in ("relu", "leaky_relu", "elu", "tanh", "sigmoid")}}


SHAPES = ("flatten", "view", "reshape", "squeeze", "Flatten", "Unflatten")  # what keeps the order of the elements
NOTHING = ("Identity", "Dropout", "Dropout1d", "Dropout2d", "Dropout3d", "AlphaDropout", "FeatureAlphaDropout")


def torch_layer(m, kind, me, x, y):
    """The layers that do what a module does, at most two, for an input of shape x and an output of shape y, without the batch; its weights."""
    rank, layer = len(x), {}
    if kind in NOTHING or x == y and kind in SHAPES: return [], None
    if kind in SHAPES:
        require(y == (int(np.prod(x)),), me, "it turns the shape %s into %s; only flattening is known" % (x, y))
        return [{"type": "flatten"}], None
    if kind in ACTIVATIONS or kind == "PReLU" and m.weight.numel() == 1:
        require(getattr(m, "beta", 1) == 1 and getattr(m, "threshold", 20) == 20, me, "beta is not 1, or threshold is not 20")
        require(getattr(m, "approximate", "none") == "none", me, "approximate is %s" % getattr(m, "approximate", ""))
        layer.update(type="activation", activation=ACTIVATIONS.get(kind, "leaky_relu"))
        if kind in ("LeakyReLU", "ELU"): layer["alpha"] = float(m.negative_slope if kind == "LeakyReLU" else m.alpha)
        if kind == "PReLU": layer["alpha"] = float(m.weight)
        return [layer], None
    if kind == "Linear":
        require(rank == 1, me, "its input has the shape %s; flatten it first" % (x,))
        return [{"type": "dense"}], (array(m.weight), array(m.bias))
    if kind in ("Conv1d", "Conv2d", "ConvTranspose1d", "ConvTranspose2d"):
        transposed = "Transpose" in kind
        require(m.padding_mode == "zeros", me, "padding_mode is %s" % m.padding_mode)
        layer.update(type="conv" + kind[-2:] + "_transpose" * transposed, kernel=numbers(m.kernel_size), stride=numbers(m.stride), dilation=numbers(m.dilation), groups=int(m.groups))
        if transposed: layer.update(filters=int(m.out_channels), extra=numbers(m.output_padding))
        if isinstance(m.padding, str): layer["padding"] = m.padding
        else: layer["zeros"] = numbers(m.padding)
        return [layer], (array(m.weight), array(m.bias))
    if kind in ("BatchNorm1d", "BatchNorm2d"):
        require(m.running_var is not None, me, "it has no running statistics")
        gain = 1 / np.sqrt(array(m.running_var) + m.eps) * (1 if m.weight is None else array(m.weight))
        shift = (0 if m.bias is None else array(m.bias)) - gain * array(m.running_mean)
        if rank == 1: return [{"type": "dense"}], (np.diag(gain), shift)
        return [{"type": "conv%dd" % (rank - 1), "groups": len(gain)}], (gain.reshape((-1, 1) + (1,) * (rank - 1)), shift)
    if kind in ("MaxPool1d", "MaxPool2d", "AvgPool1d", "AvgPool2d"):
        require(not np.any(m.padding) and not m.ceil_mode, me, "it pads or rounds up")
        require(np.all(np.equal(getattr(m, "dilation", 1), 1)) and not getattr(m, "divisor_override", None), me, "it dilates or divides by another number")
        return [dict(type=kind.lower(), size=numbers(m.kernel_size), stride=numbers(m.stride))], None
    if kind in ("AdaptiveAvgPool1d", "AdaptiveAvgPool2d", "AdaptiveMaxPool1d", "AdaptiveMaxPool2d"):
        require(y is not None and np.all(np.mod(x[1:], y[1:]) == 0), me, "output_size is %s, which does not divide %s" % (m.output_size, x[1:]))
        size = numbers(np.floor_divide(x[1:], y[1:])) if rank == 3 else x[1] // y[1]
        return [dict(type=kind[8:11].lower() + "pool" + kind[-2:], size=size, stride=size)], None
    if kind in ("Upsample", "UpsamplingNearest2d", "UpsamplingBilinear2d"):
        require(m.mode in ("nearest", "linear", "bilinear"), me, "mode is %s; nearest, linear and bilinear are known" % m.mode)
        require(rank in (2, 3) and np.all(np.mod(y[1:], x[1:]) == 0) and np.all(np.mod(1 if m.scale_factor is None else m.scale_factor, 1) == 0), me,
                "it scales %s to %s; only whole factors are known" % (x[1:], y[1:]))
        layer.update(type="upsample%dd" % (rank - 1), factor=numbers(np.floor_divide(y[1:], x[1:])) if rank == 3 else y[1] // x[1])
        if m.mode != "nearest": layer.update(mode="linear", align_corners=bool(m.align_corners))
        return [layer], None
    if kind == "mean":
        axes = m["dim"] if "dim" in m else None
        require(axes is not None and rank > 1 and sorted(int(a) % (rank + 1) for a in np.atleast_1d(axes)) == list(range(2, rank + 1)), me,
                "only the mean of all elements of a channel is known")
        return [{"type": "globalpool"}] + [{"type": "flatten"}] * (len(y) == 1), None
    require(False, me, "ms_nn.h has no such layer")


def fold(layer, weight, bias, gain, shift):
    """Weights of a layer with an affine map of each output behind it."""
    if "transpose" in layer["type"]:  # [inputs][outputs of a group]...
        turn = np.repeat(gain.reshape(layer["groups"], -1), len(weight) // layer["groups"], 0).reshape(weight.shape[:2] + (1,) * (weight.ndim - 2))
    else: turn = gain.reshape((-1,) + (1,) * (weight.ndim - 1))
    return weight * turn, shift + (0 if bias is None else gain * bias)


def save_torch(path, net, input_shape, dtype="float32", tolerance=None):
    import torch, torch.fx
    module, root = traced(net, torch.rand(2, *input_shape, dtype=torch.float64))
    network, nodes = ("the network", type(net).__name__), list(module.graph.nodes)
    known, layers, weights, at = functions(), [], {}, {}  # at: the layer whose output a node is, by its index; -1: the input
    named = {}  # the module of each layer
    tensor = lambda a: isinstance(a, torch.fx.Node) and isinstance(a.ms_value, torch.Tensor)
    value = lambda a: torch.fx.node.map_arg(a, lambda n: n.ms_value)
    shape = lambda a: tuple(a.ms_value.shape[1:])

    def refer(i):  # the name of a layer that another one reads
        if i >= 0 and "name" not in layers[i]:
            name = "l" + named[i]
            layers[i]["name"] = name if name not in [l.get("name") for l in layers] else "%s_%d" % (name, i)
        return "input" if i < 0 else layers[i]["name"]

    def emit(me, layer, weight=None):
        layers.append(layer)
        named[len(layers) - 1] = me[0] if me[0] != network[0] else str(len(layers) - 1)
        if weight is not None:
            layer["bias"] = weight[1] is not None
            refer(len(layers) - 1)
            weights[len(layers) - 1] = (me, *weight)

    for node in nodes:  # before unused nodes go: what works in place may change a value that others read
        m = module.get_submodule(node.target) if node.op == "call_module" else None
        in_place = getattr(m, "inplace", False) or node.kwargs.get("inplace") or node.op != "call_module" and str(getattr(node.target, "__name__", node.target)).rstrip(" ").endswith("_")
        in_place = in_place or getattr(node.target, "__name__", "") in ("iadd", "imul", "isub", "itruediv")
        me = (node.target, type(m).__name__) if m is not None else node.ms_module
        require(not in_place or not node.args or not tensor(node.args[0]) or set(node.args[0].users) == {node}, me, "it changes in place what another module reads")
    module.graph.eliminate_dead_code()
    for node in module.graph.nodes:
        name = getattr(node.target, "__name__", str(node.target))
        me = node.ms_module if node.op != "call_module" else (node.target, type(module.get_submodule(node.target)).__name__)
        if node.op == "placeholder":
            require(not at, me, "it has more than one input")
            at[node] = -1
            continue
        if node.op == "output":
            require(tensor(node.args[0]), me, "its output is not one tensor")
            require(at[node.args[0]] == len(layers) - 1, me, "its output is not that of its last layer")
            continue
        if node.op == "get_attr" or not tensor(node) and node.op != "call_module":
            continue  # sizes; parameters, which no function below takes
        if node.op != "call_module":
            me = me[0], "%s (its forward() calls %s)" % (me[1], name)
            require(node.op == "call_method" or (getattr(node.target, "__module__", None) or "torch").split(".")[0] in ("torch", "_operator"), me, "it is no function of PyTorch")
        inputs = [a for a in node.all_input_nodes if tensor(a)]
        require(tensor(node) and inputs and all(a in at for a in inputs), me, "ms_nn.h has no such layer")
        if node.op != "call_module" and name in ("add", "iadd", "add_", "cat", "concat"):
            adds = "add" in name
            parts = node.args[:2] if adds else node.args[0] if node.args else node.kwargs["tensors"]
            require(isinstance(parts, (list, tuple)) and all(map(tensor, parts)), me, "it takes what is no tensor")
            require(not adds or len(parts) == 2 and not node.kwargs and shape(parts[0]) == shape(parts[1]), me, "only two tensors of one shape are added")
            dim = 1 if adds else value(node.kwargs.get("dim", node.args[1] if len(node.args) > 1 else 0))
            require(dim % (len(shape(node)) + 1) == 1, me, "it joins along dimension %d; only channels (1) are known" % dim)
            last, own = len(layers) - 1, [at[a] for a in parts]
            require(last in own, me, "none of its inputs is the output of the layer before it")
            k = own.index(last)
            sources = [refer(i) for i in own]
            for j in [*range(k - 1, -1, -1), *range(k + 1, len(own))]:
                emit(me, {"type": "add", "from": sources[j]} if adds else {"type": "concat", "from": sources[j], "order": "before" if j < k else "after"})
            at[node] = len(layers) - 1
            continue
        require(len(inputs) == 1 and node.args and node.args[0] is inputs[0], me, "it has more than one input")
        source = inputs[0]
        if node.op == "call_module": m, kind = module.get_submodule(node.target), None
        elif name in SHAPES: m, kind = None, name
        elif name == "mean": m, kind = {**dict(zip(("dim", "keepdim"), value(node.args[1:]))), **value(node.kwargs)}, name
        else:
            require(name in known, me, "ms_nn.h has no such layer, or it is known as a module only")
            try: m = known[name](*value(node.args[1:]), **value(node.kwargs))
            except TypeError as e: require(False, me, "its arguments are not known: %s" % e)
            require(m is not torch.nn.Dropout, me, "it drops in eval() as well")
            kind = "Identity" if m is None else None
        kind = kind or next((c.__name__ for c in type(m).__mro__ if c.__module__.startswith("torch.nn.modules")), type(m).__name__)
        made, weight = torch_layer(m, kind, me, shape(source), shape(node))
        last = len(layers) - 1
        require(not made or at[source] == last, me, "its input is not the output of the layer before it; only additions and torch.cat read earlier outputs")
        if kind.startswith("BatchNorm") and last in weights and len(source.users) == 1 and source.op == "call_module" and weights[last][0][0] == source.target:
            weights[last] = (weights[last][0], *fold(layers[last], *weights[last][1:], weight[0].sum(1).reshape(-1), weight[1]))
            layers[last]["bias"] = True
        else:
            for layer in made: emit(me, layer, weight)
        at[node] = len(layers) - 1 if made else at[source]

    def forward(x):
        with torch.no_grad(): return root(torch.from_numpy(x).double()).numpy()

    return save(path, network, input_shape, layers, weights, dtype, tolerance, forward)


# --- Keras ------------------------------------------------------------------------------------------------------------

def save_keras(path, net, dtype="float32", tolerance=None):
    layers, weights, shape = [], {}, tuple(net.input_shape[1:])
    for m in net.layers:
        kind, c, layer = type(m).__name__, m.get_config(), {"name": m.name}
        me = m.name, kind
        if kind in ("InputLayer", "Dropout"): continue
        if kind in ("Conv1D", "Conv2D"):
            require(c["padding"] == "valid" or c["padding"] == "same" and set(c["strides"]) == {1}, me,
                    "padding is %s with strides %s" % (c["padding"], c["strides"]))
            require(set(np.atleast_1d(c.get("dilation_rate", 1))) == {1} and c.get("groups", 1) == 1, me,
                    "it has dilation or groups")
            layer.update(type=kind.lower(), kernel=list(c["kernel_size"]), stride=list(c["strides"]),
                         padding=c["padding"])
        elif kind in ("MaxPooling1D", "MaxPooling2D") and c["padding"] == "valid":
            layer.update(type="maxpool" + kind[-2:].lower(), size=np.atleast_1d(c["pool_size"]).tolist(),
                         stride=np.atleast_1d(c["strides"]).tolist())
        elif kind in ("UpSampling1D", "UpSampling2D") and c.get("interpolation", "nearest") == "nearest":
            layer.update(type="upsample" + kind[-2:].lower(), factor=np.atleast_1d(c["size"]).tolist())
        elif kind in ACTIVATIONS and not (c.get("max_value") or c.get("threshold") or
                                          kind == "ReLU" and c.get("negative_slope")):
            layer.update(type="activation", activation=ACTIVATIONS[kind],
                         alpha=float(c.get("negative_slope", c.get("alpha", 1.0))))
        else:
            plain = {"Dense": "dense", "Activation": "activation", "Flatten": "flatten"}
            require(kind in plain, me, "ms_nn.h has no such layer, or not with these settings: %s" % c)
            layer["type"] = plain[kind]
        if kind == "Flatten": layer["order"] = "channels_last"
        known = {"linear", "leaky_relu", *ACTIVATIONS.values()}
        require(c.get("activation", "linear") in known, me, "activation is %s" % c.get("activation"))
        if "activation" in c:
            layer.update(activation=c["activation"], alpha=0.2 if c["activation"] == "leaky_relu" else 1.0)
        if m.get_weights():  # [kernel...][inputs][outputs] becomes [outputs][inputs][kernel...]
            weight, *bias = m.get_weights()
            weights[len(layers)] = me, np.moveaxis(np.asarray(weight), (-1, -2), (0, 1)), bias[0] if bias else None
            layer["bias"] = bool(bias)
        layers.append(layer)

    def forward(x):
        y = np.asarray(net.predict(np.moveaxis(x, 1, -1)))
        return np.moveaxis(y, -1, 1)

    return save(path, (getattr(net, "name", "the network"), type(net).__name__), shape[-1:] + shape[:-1], layers,
                weights, dtype, tolerance, forward)
