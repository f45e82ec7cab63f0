"""What the training scripts share: the data set of `make dataset`, display values, the parameters of a channel, PSNR."""
import glob, os, struct
import numpy as np
import torch

# the 11 of the 19 parameters that one colour channel depends on: its four albedos, then the scalars
CHANNELS = [[c, 3 + c, 8 + c, 13 + c, 6, 7, 11, 12, 16, 17, 18] for c in range(3)]
NAMES = ["diffuse red", "diffuse green", "diffuse blue", "glossy red", "glossy green", "glossy blue", "glossy roughness", "glossy share", "glass red",
         "glass green", "glass blue", "glass roughness", "index of refraction", "translucent red", "translucent green", "translucent blue",
         "translucent share", "transmissive share", "absorption"]


def read(folder):
    """-> parameters [n][19] f32, linear pictures [n][size][size][3] f16, in the order of the materials."""
    x, pictures = [], []
    for path in sorted(glob.glob(os.path.join(folder, "part_*.bin"))):
        with open(path, "rb") as f:
            assert f.read(4) == b"msds", path
            version, size, _, _, n = struct.unpack("<5I", f.read(20))
            assert version == 1, path
            x.append(np.frombuffer(f.read(n * 19 * 4), "<f4").reshape(n, 19))
            pictures.append(np.frombuffer(f.read(n * size * size * 6), "<f2").reshape(n, size, size, 3))
    assert x, "no data set in %s: run `make dataset`" % folder
    return np.concatenate(x), np.concatenate(pictures)


def display(linear, size):
    """Linear pictures [n][s][s][3] -> display values [n][3][size * size]: box average, clip to [0, 1], sRGB curve.
    The average comes first: clipping noisy pixels would darken them."""
    n, s, factor = len(linear), linear.shape[1], linear.shape[1] // size
    assert factor * size == s
    out = np.empty((n, 3, size * size), np.float32)
    for i in range(0, n, 64):  # a block at a time keeps the float copies small
        v = linear[i:i + 64].astype(np.float32).reshape(-1, size, factor, size, factor, 3).mean((2, 4))
        v = np.clip(v, 0, 1)
        v = np.where(v <= 0.0031308, 12.92 * v, 1.055 * np.maximum(v, 1e-9) ** (1 / 2.4) - 0.055)
        out[i:i + 64] = v.transpose(0, 3, 1, 2).reshape(-1, 3, size * size)
    return out


def channels(x):
    """[n][19] -> [n * 3][11], a row a channel."""
    return x[:, torch.tensor(CHANNELS).reshape(-1)].reshape(-1, 11)


def free(x):
    """Redraws what a picture does not depend on, in place: parameters [n][11] of lobes whose share is zero."""
    glossy, glass, through = x[:, 5], x[:, 8], x[:, 9]
    idle = {0: (glossy == 1) | (through == 1), 1: (glossy == 0) | (through == 1), 4: (glossy == 0) | (through == 1),
            2: (glass == 1) | (through == 0), 6: (glass == 1) | (through == 0), 7: (glass == 1) | (through == 0),
            3: (glass == 0) | (through == 0), 5: through == 1, 8: through == 0, 10: through == 0}
    for column, where in idle.items():
        x[:, column] = torch.where(where, torch.rand(len(x)), x[:, column])
    return x


def psnr(picture, a, b):
    """[n] dB of display values [n][...] against two independent renders: their noise cancels in the product."""
    n = len(picture)
    error = ((picture - a) * (picture - b)).reshape(n, -1).mean(1)
    return -10 * torch.log10(error.clamp_min(1e-7))


def report(name, dB):
    q = torch.quantile(dB, torch.tensor([0.0, 0.05, 0.5, 0.95]))
    print("%s: mean %.2f dB, min %.2f, 5%% %.2f, median %.2f, 95%% %.2f of %d pictures" % ((name, dB.mean()) + tuple(q) + (len(dB),)), flush=True)
