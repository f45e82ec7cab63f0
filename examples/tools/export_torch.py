#!/usr/bin/env python3
"""Saves a PyTorch or Keras network for ms_nn.h: safetensors with the layer list in its metadata. Needs numpy.

    import export_torch as ms
    error = ms.save_torch("net.safetensors", net, (3, 410, 410))  # the shape of one input, channels first
    error = ms.save_keras("net.safetensors", net)  # channels last: inputs and kernels are transposed

PyTorch: torch.fx traces the network as it is in eval(). Any Module is saved whose forward() is a chain of layers that
ms_nn.h has, as modules or as functions (F.relu, x.tanh(), torch.flatten), with additions of earlier outputs. A layer that is used twice is stored twice. BatchNorm is folded into the linear or convolution layer before it,
or becomes a layer of its own. Keras: Sequential.

Every file is checked before it is kept: build/nn_run runs it (a C compiler builds that from examples/tools/nn_run.c
where it is missing), and its outputs for random inputs must equal the network's own within tolerance times the largest
output: 1e-4 by default, 0.01 for float16, 0.1 for int8. The result is that error of the saved file.

Everything else raises Unsupported with the name and type of the module, and leaves no file: what ms_nn.h cannot run,
hooks, control flow that depends on the input, weights that are not finite or too large for float16."""
import copy, json, os, shutil, struct, subprocess, tempfile
import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
ACTIVATIONS = {"ReLU": "relu", "LeakyReLU": "leaky_relu", "ELU": "elu", "Tanh": "tanh", "Sigmoid": "sigmoid",
               "Softplus": "softplus", "SiLU": "silu", "GELU": "gelu"}
TOLERANCE = {"float32": 1e-4, "float16": 1e-2, "int8": 1e-1}


class Unsupported(ValueError):
    """A network that cannot be saved."""


def require(good, module, reason):
    """Raises Unsupported with the module's name and type, unless good."""
    if not good: raise Unsupported("module '%s' of type %s cannot be saved: %s" % (*module, reason))


# --- the file and its check -------------------------------------------------------------------------------------------

def write(path, input_shape, layers, tensors):
    """The layer list, then the tensors (numpy arrays by name), the largest first."""
    header = {"__metadata__": {"format": "pt", "ms_nn_version": "1", "ms_nn_input": json.dumps(list(input_shape)),
                               "ms_nn_layers": json.dumps(layers)}}
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
    """The tensors of a layer: weights as float32, float16, or int8 with one scale for each index of the first dimension."""
    weight, offset, tensors = np.asarray(weight, np.float64), np.asarray(0 if bias is None else bias, np.float64), {}
    for values, kind in ((weight, "float32" if dtype == "int8" else dtype), (offset, "float32")):
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
            compiler = os.environ.get("CC") or shutil.which("cc") or shutil.which("gcc") or shutil.which("clang") or "cc"
            program, source = os.path.join(tempfile.mkdtemp(), "nn_run"), os.path.join(HERE, "nn_run.c")
            command = [*compiler.split(), "-O2", "-I" + ROOT, "-I" + HERE, source, "-o", program, "-lm"]
            if not shutil.which(command[0]) or not os.path.exists(source) or subprocess.run(command).returncode:
                raise RuntimeError("the file cannot be checked, so it is not saved: there is no build/nn_run, and no C "
                                   "compiler that makes it from %s" % source)
        _found.append(program)
    return _found[0]


def error_of(path, network, x, y):
    """The largest difference between the saved file's outputs for x and y, in units of the largest of y."""
    with tempfile.TemporaryDirectory() as folder:
        rows = os.path.join(folder, "x.csv")
        np.savetxt(rows, x.reshape(len(x), -1), "%.9g", ",")
        ran = subprocess.run((nn_run(), path, rows), capture_output=True, text=True)
    require(ran.returncode == 0, network, "ms_nn.h refuses it: " + ran.stderr.strip())
    ours = np.array([line.split(",") for line in ran.stdout.split()], np.float64)
    y = np.asarray(y, np.float64).reshape(len(x), -1)
    require(ours.shape == y.shape, network, "it has %d outputs, and the saved one %d" % (y.shape[1], ours.shape[1]))
    require(np.isfinite(y).all(), network, "its outputs for random inputs are not finite")
    return abs(ours - y).max() / max(abs(y).max(), 1e-30)


def save(path, network, input_shape, layers, weights, dtype, tolerance, forward):
    """network: name and type. weights: (module, weight, bias) by a layer's index. forward: the network, for a batch."""
    require(layers, network, "it has no layers")
    random = np.random.default_rng(1)
    x = [random.uniform(size=input_shape)] + [random.normal(size=input_shape) * scale for scale in (0.3, 1, 3)]
    x = np.stack(x).astype(np.float32)
    y = forward(x)
    unchecked = "%s.new-%d" % (path, os.getpid())
    try:
        for kind in dict.fromkeys(("float32", dtype)):  # float32 first: a narrow type's rounding would hide a small mistake
            tensors = {}
            for i, weight in weights.items(): tensors.update(stored(weight[0], layers[i]["name"], kind, *weight[1:]))
            write(unchecked, input_shape, layers, tensors)
            error = error_of(unchecked, network, x, y)
            bound = TOLERANCE[kind] if tolerance is None or kind != dtype else tolerance
            require(error <= bound, network, "saved as %s, its outputs would differ by %.2g of the largest (at most %g is "
                    "allowed)" % (kind, error, bound))
        os.replace(unchecked, path)
    finally:
        if os.path.exists(unchecked): os.remove(unchecked)
    return error


# --- PyTorch ----------------------------------------------------------------------------------------------------------

def array(x): return None if x is None else np.asarray(x.detach().numpy(), np.float64)
def first_line(e): return str(e).strip().split("\n")[0]
def numbers(x): return [int(v) for v in x] if np.ndim(x) else int(x)


def traced(net, x):
    """A copy of net in double precision and eval(), and its torch.fx graph, run on x. Each node has ms_value, its result,
    and ms_module, the name and type of the module whose forward() it belongs to."""
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

    everywhere = hooks._global_forward_hooks or hooks._global_forward_pre_hooks
    require(not everywhere, Tracer.path[0], "there are hooks on all modules")
    for name, m in net.named_modules():
        me = name or "the network", type(m).__name__
        require(not (m._forward_pre_hooks or m._forward_hooks), me,
                "it has hooks; remove them first (remove_weight_norm, remove_spectral_norm)")
        require("forward" not in vars(m), me, "its forward() was replaced")
    try: root = copy.deepcopy(net).cpu().double().eval()
    except Exception as e: require(False, Tracer.path[0], "it cannot be copied: %s" % first_line(e))
    if own(root): root = torch.nn.Sequential(root)
    tracer = Tracer()
    try: graph = tracer.trace(root)
    except Exception as e: require(False, tracer.path[-1], "torch.fx cannot trace it: %s" % first_line(e))
    module = torch.fx.GraphModule(root, graph)
    try:
        with torch.no_grad(): Run(module).run(x)
    except Exception as e:
        me = next((node.ms_module for node in graph.nodes if not hasattr(node, "ms_value")), tracer.path[0])
        require(False, me, "PyTorch cannot run it in double precision on inputs of the shape %s: %s" %
                (tuple(x.shape[1:]), first_line(e)))
    return root, module


def functions():
    """For a function's name, what makes the module that does the same from the arguments behind the first; None: nothing."""
    from torch import nn

    def dropout(p=0.5, training=True, inplace=False): return nn.Dropout(p) if training else None

    def interpolate(size=None, scale_factor=None, mode="nearest", align_corners=None, recompute_scale_factor=None,
                    antialias=False):
        if antialias: raise TypeError("antialias")
        return nn.Upsample(size, scale_factor, mode, align_corners)

    def max_pool(pool):  # the module's arguments have another order
        return lambda kernel_size, stride=None, padding=0, dilation=1, ceil_mode=False, return_indices=False: pool(
            kernel_size, stride, padding, dilation, return_indices, ceil_mode)

    known = {"relu": nn.ReLU, "leaky_relu": nn.LeakyReLU, "elu": nn.ELU, "tanh": nn.Tanh, "sigmoid": nn.Sigmoid,
             "softplus": nn.Softplus, "silu": nn.SiLU, "gelu": nn.GELU, "max_pool1d": max_pool(nn.MaxPool1d),
             "max_pool2d": max_pool(nn.MaxPool2d), "avg_pool1d": nn.AvgPool1d, "avg_pool2d": nn.AvgPool2d,
             "adaptive_avg_pool1d": nn.AdaptiveAvgPool1d, "adaptive_avg_pool2d": nn.AdaptiveAvgPool2d,
             "adaptive_max_pool1d": nn.AdaptiveMaxPool1d, "adaptive_max_pool2d": nn.AdaptiveMaxPool2d,
             "interpolate": interpolate, "dropout": dropout, "dropout2d": dropout, "alpha_dropout": dropout,
             "contiguous": lambda: None, "clone": lambda: None}
    return {**known, **{name + "_": known[name] for name in ("relu", "leaky_relu", "elu", "tanh", "sigmoid")}}


SHAPES = ("flatten", "view", "reshape", "squeeze", "Flatten", "Unflatten")  # what keeps the order of the elements
NOTHING = ("Identity", "Dropout", "Dropout1d", "Dropout2d", "Dropout3d", "AlphaDropout", "FeatureAlphaDropout")


def torch_layer(m, kind, me, x, y):
    """The layers, two at most, that do what a module does with an input of shape x and an output of shape y (without the
    batch), and the weight and bias of the first."""
    rank, layer = len(x), {}
    if kind in NOTHING or x == y and kind in SHAPES: return [], None
    if kind in SHAPES:
        require(y == (int(np.prod(x)),), me, "it turns the shape %s into %s; only flattening is known" % (x, y))
        return [{"type": "flatten"}], None
    if kind in ACTIVATIONS or kind == "PReLU" and m.weight.numel() == 1:
        require(kind != "Softplus" or (m.beta, m.threshold) == (1, 20), me, "beta is not 1, or threshold is not 20")
        require(kind != "GELU" or m.approximate == "none", me, "approximate is not none but tanh")
        layer.update(type="activation", activation=ACTIVATIONS.get(kind, "leaky_relu"))
        if kind in ("LeakyReLU", "ELU"): layer["alpha"] = float(m.negative_slope if kind == "LeakyReLU" else m.alpha)
        if kind == "PReLU": layer["alpha"] = float(m.weight)
        return [layer], None
    if kind == "Linear":
        require(rank == 1, me, "its input has the shape %s; flatten it first" % (x,))
        return [{"type": "dense"}], (array(m.weight), array(m.bias))
    if kind in ("Conv1d", "Conv2d"):
        require(m.padding_mode == "zeros", me, "padding_mode is %s" % m.padding_mode)
        require(m.groups == 1, me, "it has groups")
        require(np.all(np.equal(m.dilation, 1)), me, "it dilates")
        layer.update(type="conv" + kind[-2:], kernel=numbers(m.kernel_size), stride=numbers(m.stride))
        if isinstance(m.padding, str): layer["padding"] = m.padding
        else: layer["zeros"] = numbers(m.padding)
        return [layer], (array(m.weight), array(m.bias))
    if kind in ("BatchNorm1d", "BatchNorm2d"):
        require(m.running_var is not None, me, "it has no running statistics")
        gain = 1 / np.sqrt(array(m.running_var) + m.eps) * (1 if m.weight is None else array(m.weight))
        shift = (0 if m.bias is None else array(m.bias)) - gain * array(m.running_mean)
        if rank == 1: return [{"type": "dense"}], (np.diag(gain), shift)
        return [{"type": "conv%dd" % (rank - 1)}], (np.diag(gain).reshape((len(gain), -1) + (1,) * (rank - 1)), shift)
    if kind in ("MaxPool1d", "MaxPool2d", "AvgPool1d", "AvgPool2d"):
        require(not np.any(m.padding) and not m.ceil_mode, me, "it pads or rounds up")
        require(np.all(np.equal(getattr(m, "dilation", 1), 1)), me, "it dilates")
        require(not getattr(m, "divisor_override", None), me, "it divides by another number")
        return [dict(type=kind.lower(), size=numbers(m.kernel_size), stride=numbers(m.stride))], None
    if kind in ("AdaptiveAvgPool1d", "AdaptiveAvgPool2d", "AdaptiveMaxPool1d", "AdaptiveMaxPool2d"):
        whole = np.all(np.mod(x[1:], y[1:]) == 0)
        require(whole, me, "output_size is %s, which does not divide %s" % (m.output_size, x[1:]))
        size = numbers(np.floor_divide(x[1:], y[1:])) if rank == 3 else x[1] // y[1]
        return [dict(type=kind[8:11].lower() + "pool" + kind[-2:], size=size, stride=size)], None
    if kind in ("Upsample", "UpsamplingNearest2d", "UpsamplingBilinear2d"):
        require(m.mode == "nearest", me, "mode is %s; only nearest is known" % m.mode)
        whole = np.all(np.mod(y[1:], x[1:]) == 0) and not np.any(np.mod(m.scale_factor or 1, 1))
        require(rank in (2, 3) and whole, me, "it scales %s to %s; only whole factors are known" % (x[1:], y[1:]))
        factor = numbers(np.floor_divide(y[1:], x[1:]))
        layer.update(type="upsample%dd" % (rank - 1), factor=factor if rank == 3 else factor[0])
        return [layer], None
    if kind == "mean":
        axes = sorted(int(a) % (rank + 1) for a in np.atleast_1d(m.get("dim", ())))
        require(rank > 1 and axes == list(range(2, rank + 1)), me, "only the mean of all elements of a channel is known")
        return [{"type": "globalpool"}] + [{"type": "flatten"}] * (len(y) == 1), None
    require(False, me, "ms_nn.h has no such layer")


def fold(weight, bias, gain, shift):
    """Weights of a layer with an affine map of each output behind it."""
    return weight * gain.reshape((-1,) + (1,) * (weight.ndim - 1)), shift + (0 if bias is None else gain * bias)


class Chain:
    """The layers of a file: each runs on the output of the one before it; additions read others too."""
    def __init__(self): self.layers, self.weights, self.modules = [], {}, []

    def last(self): return len(self.layers) - 1

    def name(self, i):
        """The name by which layer i is read; -1 is the input."""
        if i < 0: return "input"
        if "name" not in self.layers[i]:
            name = "l%s" % (i if self.modules[i] == "the network" else self.modules[i])
            taken = name in [layer.get("name") for layer in self.layers]  # a module that is used twice
            self.layers[i]["name"] = "%s_%d" % (name, i) if taken else name
        return self.layers[i]["name"]

    def add(self, me, layer, weight=None):
        self.layers.append(layer)
        self.modules.append(me[0])
        if weight is not None:
            layer["bias"] = weight[1] is not None
            self.weights[self.last()] = (me, *weight)
            self.name(self.last())

    def join(self, me, sources):
        """The sum of outputs, of which one is that of the last layer."""
        require(self.last() in sources, me, "none of its inputs is the output of the layer before it")
        k, names = sources.index(self.last()), [self.name(i) for i in sources]
        for j in [*range(k - 1, -1, -1), *range(k + 1, len(names))]:
            self.add(me, {"type": "add", "from": names[j]})

    def normalize(self, me, layer, weight, foldable):
        """A BatchNorm, into the weights of the last layer where these are nobody else's."""
        if not foldable or self.last() not in self.weights: return self.add(me, layer, weight)
        owner, *own = self.weights[self.last()]
        self.weights[self.last()] = (owner, *fold(*own, weight[0].sum(1).reshape(-1), weight[1]))
        self.layers[-1]["bias"] = True


def save_torch(path, net, input_shape, dtype="float32", tolerance=None):
    import torch, torch.fx
    root, module = traced(net, torch.rand(2, *input_shape, dtype=torch.float64))
    network, known, chain = ("the network", type(net).__name__), functions(), Chain()
    output = {}  # the layer whose output a node is; -1: the input
    def tensor(a): return isinstance(a, torch.fx.Node) and isinstance(a.ms_value, torch.Tensor)
    def value(a): return torch.fx.node.map_arg(a, lambda n: n.ms_value)
    def shape(a): return tuple(a.ms_value.shape[1:])
    def name_of(node): return getattr(node.target, "__name__", str(node.target))
    def submodule(node): return module.get_submodule(node.target) if node.op == "call_module" else None

    def module_of(node):
        if node.op == "call_module": return node.target, type(submodule(node)).__name__
        if node.op not in ("call_function", "call_method"): return node.ms_module
        return node.ms_module[0], "%s (its forward() calls %s)" % (node.ms_module[1], name_of(node))

    for node in module.graph.nodes:
        in_place = getattr(submodule(node), "inplace", False) or node.kwargs.get("inplace")
        if node.op in ("call_function", "call_method"): in_place = in_place or name_of(node).endswith(("_", "iadd"))
        require(not in_place or not node.args or set(node.args[0].users) == {node}, module_of(node),
                "it changes in place what another module reads")
    module.graph.eliminate_dead_code()
    for node in module.graph.nodes:
        me, name, called = module_of(node), name_of(node), node.op in ("call_function", "call_method")
        inputs = [a for a in node.all_input_nodes if tensor(a)]
        if node.op == "placeholder":
            require(not output, me, "it has more than one input")
            output[node] = -1
            continue
        if node.op == "output":
            require(tensor(node.args[0]), me, "its output is not one tensor")
            require(output.get(node.args[0]) == chain.last(), me, "its output is not that of its last layer")
            continue
        if node.op == "get_attr" or called and not tensor(node): continue  # parameters and sizes, for those that read them
        require(tensor(node) and inputs and all(a in output for a in inputs), me, "ms_nn.h has no such layer")
        if node.op == "call_function":
            package = (getattr(node.target, "__module__", None) or "torch").split(".")[0]
            require(package in ("torch", "_operator"), me, "it is no function of PyTorch")
        if called and name in ("add", "add_", "iadd"):
            parts = node.args[:2]
            require(all(map(tensor, parts)), me, "it takes what is no tensor")
            same = len(parts) == 2 and not node.kwargs and shape(parts[0]) == shape(parts[1])
            require(same, me, "only two tensors of one shape are added")
            chain.join(me, [output[a] for a in parts])
            output[node] = chain.last()
            continue
        require(len(inputs) == 1 and node.args and node.args[0] is inputs[0], me, "it has more than one input")
        source, kind = inputs[0], name
        if not called: m = submodule(node)
        elif name in SHAPES: m = None
        elif name == "mean": m = {**dict(zip(("dim", "keepdim"), value(node.args[1:]))), **value(node.kwargs)}
        else:
            require(name in known, me, "ms_nn.h has no such layer, or it is known as a module only")
            try: m = known[name](*value(node.args[1:]), **value(node.kwargs))
            except TypeError as e: require(False, me, "its arguments are not known: %s" % e)
            require(not isinstance(m, torch.nn.Dropout), me, "it drops in eval() as well")
            if m is None: kind = "Identity"
        if isinstance(m, torch.nn.Module):  # a class derived from PyTorch's, too
            own = [c.__name__ for c in type(m).__mro__ if c.__module__.startswith("torch.nn.modules")]
            kind = own[0] if own else type(m).__name__
        made, weight = torch_layer(m, kind, me, shape(source), shape(node))
        require(not made or output[source] == chain.last(), me,
                "its input is not the output of the layer before it; only additions read earlier outputs")
        if kind.startswith("BatchNorm"):
            chain.normalize(me, made[0], weight, source.op == "call_module" and len(source.users) == 1 and
                            chain.modules[-1:] == [source.target])
        else:
            for layer in made: chain.add(me, layer, weight)
        output[node] = chain.last() if made else output[source]

    def forward(x):
        with torch.no_grad(): return root(torch.from_numpy(x).double()).numpy()

    return save(path, network, input_shape, chain.layers, chain.weights, dtype, tolerance, forward)


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
