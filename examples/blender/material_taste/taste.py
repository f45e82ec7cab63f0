"""A person's taste in materials, and a neural renderer, for numpy: ms_gpr.h, ms_nn.h and ms_pme.h through flat.c.

Works without Blender. Materials are arrays [count, parameters] in [0, 1]. What fails raises RuntimeError with the
header's own sentence. MS_FLAT (environment) names another library than the one beside this file."""
import ctypes
import os
import sys

import numpy as np

_NAME = {"win32": "ms_flat.dll", "darwin": "libms_flat.dylib"}.get(sys.platform, "libms_flat.so")
_FOLDER = os.path.dirname(os.path.abspath(__file__))
_library = ctypes.CDLL(os.environ.get("MS_FLAT", os.path.join(_FOLDER, _NAME)))
_library.flat_metadata.restype = ctypes.c_char_p


def _array(a, kind=np.float64):
    return np.ascontiguousarray(a, kind)


def _pass(value):
    if isinstance(value, np.ndarray):
        return ctypes.c_void_p(value.ctypes.data)
    return ctypes.c_double(value) if isinstance(value, float) else value


def _call(name, *values):
    why = ctypes.create_string_buffer(240)
    if getattr(_library, "flat_" + name)(*[_pass(v) for v in values], why):
        raise RuntimeError(why.value.decode())


class _Owner:
    """Holds what the library made, and gives it back."""

    def __init__(self):
        self.handle = ctypes.c_void_p()

    def __del__(self):
        getattr(_library, "flat_%s_free" % type(self).__name__.lower())(self.handle)


def _box(m, low, high):
    """[m] each, or one number for all: [0, 1] for None."""
    return [_sized(end if given is None else given, m, "the box") for end, given in enumerate((low, high))]


def _sized(a, m, what):
    if np.ndim(a) and np.shape(a) != (m,):
        raise RuntimeError("%s has %s numbers, a material has %d" % (what, " x ".join(map(str, np.shape(a))), m))
    return _array(np.broadcast_to(a, m))


class Taste(_Owner):
    """Learnt from scores from 0 up (NaN: none) and from pairs of rows of x, the better one first."""

    def __init__(self, x, scores, pairs=()):
        super().__init__()
        x, scores = np.atleast_2d(_array(x)), np.array(scores, np.float64)
        pairs = _array(pairs, np.int32).reshape(-1, 2)
        self.m = x.shape[1]
        if len(scores) != len(x):
            raise RuntimeError("%d materials, but %d scores" % (len(x), len(scores)))
        _call("taste", x, scores, *x.shape, pairs, len(pairs), ctypes.byref(self.handle))

    def predict(self, x):
        """Scores and their standard deviations."""
        x = np.atleast_2d(_array(x))
        if x.shape[1] != self.m:
            raise RuntimeError("materials of %d parameters, the taste has %d" % (x.shape[1], self.m))
        mean, variance = np.empty(len(x)), np.empty(len(x))
        _call("predict", self.handle, x, len(x), mean, variance)
        return mean, np.sqrt(variance)

    def recommend(self, count, quality=0.6, seed=1, low=None, high=None):
        """Materials whose predicted scores reach `quality` of the best (while too little is known: variants of what is
        liked), and these scores."""
        x, mean = np.empty((count, self.m)), np.empty(count)
        box = _box(self.m, low, high)
        _call("recommend", self.handle, count, float(quality), seed, *box, x, mean)
        return x, mean


def gallery(taste, m, count, seed=1, low=None, high=None):
    """Materials of m parameters to be scored next; taste None: the first."""
    if taste and taste.m != m:
        raise RuntimeError("materials of %d parameters, the taste has %d" % (m, taste.m))
    x = np.empty((count, m))
    _call("gallery", taste.handle if taste else None, m, count, seed, *_box(m, low, high), x)
    return x


class Renderer(_Owner):
    """A network from materials to their pictures."""

    def __init__(self, path):
        super().__init__()
        m, size = ctypes.c_int(), ctypes.c_int()
        _call("renderer", os.fsencode(path), ctypes.byref(self.handle), ctypes.byref(m), ctypes.byref(size))
        self.m, self.size = m.value, size.value

    def metadata(self, key):
        return (_library.flat_metadata(self.handle, key.encode()) or b"").decode()

    def pictures(self, x):
        """[count, size, size, 3], rows from the top, as displayed."""
        x = np.atleast_2d(_array(x, np.float32))
        if x.shape[1] != self.m:
            raise RuntimeError("materials of %d parameters, the renderer has %d" % (x.shape[1], self.m))
        planes = np.empty((len(x), 3, self.size, self.size), np.float32)
        _library.flat_pictures(self.handle, _pass(x), len(x), _pass(planes))
        return planes.transpose(0, 2, 3, 1).clip(0, 1)

    def match(self, picture, source=None, low=None, high=None):
        """The material whose picture is nearest to one of [size, size, 3], that picture, and the RMS difference."""
        if np.shape(picture) != (self.size, self.size, 3):
            raise RuntimeError("a picture of %d x %d pixels and three channels is wanted" % (self.size, self.size))
        target = _array(np.moveaxis(picture, 2, 0), np.float32)
        x, found, rmse = np.empty(self.m), np.empty_like(target), ctypes.c_double()
        source = None if source is None else _sized(source, self.m, "the source")
        box = _box(self.m, low, high)
        _call("match", self.handle, target, None, source, *box, x, found, ctypes.byref(rmse))
        return x, np.moveaxis(found, 0, 2).clip(0, 1), rmse.value


class Plane(_Owner):
    """Liked materials [count, m] laid out in a plane, so that neighbors are alike. box: x0, y0, x1, y1."""

    def __init__(self, liked, low=None, high=None):
        super().__init__()
        liked, self.box = np.atleast_2d(_array(liked)), np.empty(4)
        self.m = liked.shape[1]
        _call("plane", liked, *liked.shape, *_box(self.m, low, high), ctypes.byref(self.handle), self.box)

    def materials(self, at):
        """Materials at points [count, 2] of the plane."""
        at = np.atleast_2d(_array(at))
        if at.shape[1] != 2:
            raise RuntimeError("points of %d coordinates, a plane has 2" % at.shape[1])
        x = np.empty((len(at), self.m))
        _call("plane_map", self.handle, at, len(at), x)
        return x


def variants(taste, renderer, material, count, quality=0.7, low=None, high=None, step=0.02, seed=1):
    """At most count variants of a material, from the most similar to the best by taste (None: the least similar), whose
    pictures all differ by step or more, from each other and from the material's: RMS, of 1. 0.02 is plain to see."""
    random, (low, high) = np.random.default_rng(seed), _box(renderer.m, low, high)
    material = np.clip(material, low, high)
    # candidates: some of the parameters changed by chance, and points of the way to materials that are liked
    width = random.choice((0.03, 0.06, 0.12, 0.25), (480, 1)) * (random.random((480, renderer.m)) < 0.5)
    tried = [material + width * random.standard_normal(width.shape)]
    if taste is not None:
        try:
            liked = taste.recommend(40, quality, 0, 1, low, high)[0]
            tried += [material + part * (liked - material) for part in np.linspace(0.125, 1, 8)]
        except RuntimeError:  # nothing in the box is liked: chance alone
            pass
    tried = np.clip(np.vstack(tried), low, high)
    pictures = renderer.pictures(np.vstack([material, tried])).reshape(1 + len(tried), -1)
    far = np.sqrt(((pictures[1:] - pictures[0])**2).mean(1))
    worth = -far if taste is None else taste.predict(tried)[0]

    # rings of equal width around the material, out to the best candidate: the best of each that is a step from all
    # before it
    best = far[np.argmax(worth)] if taste is not None else 6 * step
    rings, chosen = np.linspace(step, max(best, 4 * step), count + 1), []
    for inner, outer in zip(rings, rings[1:]):
        inside = np.flatnonzero((far >= inner) & (far <= outer))
        for k in inside[np.argsort(-worth[inside], kind="stable")]:
            if all(((pictures[1 + k] - pictures[1 + j])**2).mean() >= step * step for j in chosen):
                chosen.append(k)
                break
    return tried[chosen]
