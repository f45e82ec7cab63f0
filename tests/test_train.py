#!/usr/bin/env python3
"""The training scripts of tests/train on a data set of coloured blobs: they run to the end, and build/nn_run computes from
the files that they save what PyTorch computes with the same weights. Skipped (exit 77) without PyTorch."""
import glob, os, struct, subprocess, sys
sys.path[:0] = ["tests/train", "examples"]
try:
    import numpy as np, torch
except ImportError as e:
    print("skip:", e)
    sys.exit(77)
import data, inversion, save

OUT = "build/test_train"
failed = 0


def data_set(folder, first, seed):
    """One part of 32 pictures of 64 x 64: a blob whose height is a channel's albedos, on noise that depends on the seed."""
    os.makedirs(folder, exist_ok=True)
    x = np.random.default_rng(first).random((32, 19), np.float32)
    y = np.mgrid[0:64, 0:64] / 63.0
    blob = np.exp(-8 * ((y[0] - 0.5) ** 2 + (y[1] - 0.5) ** 2))
    pictures = x[:, None, None, :3] * blob[None, :, :, None] + 0.2 * x[:, 6, None, None, None] * y[0][None, :, :, None]
    pictures += 0.01 * np.random.default_rng(seed).random(pictures.shape)
    with open("%s/part_%06d.bin" % (folder, first // 32), "wb") as f:
        f.write(b"msds" + struct.pack("<5I", 1, 64, 1, first, 32) + x.astype("<f4").tobytes() + pictures.astype("<f2").tobytes())


def python(*args):
    subprocess.run((sys.executable,) + args, check=True, stdout=subprocess.DEVNULL)


def check(name, path, x, theirs, tolerance):
    global failed
    np.savetxt(OUT + "/x.csv", x.reshape(len(x), -1), "%.9g", ",")
    out = subprocess.run(("build/nn_run", path, OUT + "/x.csv"), capture_output=True, text=True, check=True).stdout
    ours = np.array([[float(v) for v in line.split(",")] for line in out.split()])
    error = abs(ours - theirs).max() if ours.shape == theirs.shape else np.inf
    failed += not error <= tolerance
    print("%s %s: largest difference %.1e of %.0e" % ("ok  " if error <= tolerance else "FAIL", name, error, tolerance))


torch.manual_seed(4)
data_set(OUT + "/data", 0, 1)
for take in (0, 1):
    data_set("%s/held_%d" % (OUT, take), 1 << 30, 2 + take)
renderer = OUT + "/renderer_64.safetensors"
python("tests/train/renderer.py", "--data", OUT + "/data", "--held-out", OUT + "/held_0", OUT + "/held_1", "--rank", "8", "--width", "16",
       "--epochs", "3", "--out", renderer)
x = torch.rand(3, 19)
with torch.no_grad():
    theirs = save.load_renderer(renderer)(data.channels(x)).reshape(3, -1).numpy()
check("renderer", renderer, x.numpy(), theirs, 2e-5)  # the same rounded weights; I8 takes inputs in 21 bits

frozen = inversion.Renderer(renderer)
for number, kind, tolerance in ((1, "dense", 4e-2), (2, "convolution", 5e-3)):  # the file rounds to I8, by 1 in 254: three layers, two
    python("tests/train/inversion.py", "--renderer", renderer, "--data", OUT + "/data", "--kind", kind, "--from-number", str(number), "--count", "1",
           "--first", "4", "--width", "8", "--batch", "16", "--minutes", "0.01", "--out", OUT)
    net = (inversion.Dense if kind == "dense" else inversion.Convolution)(frozen, 4, 8)
    net.load_state_dict(torch.load("%s/inversion_%d.pt" % (OUT, number)))
    with torch.no_grad():
        u = frozen.u(x)
        check("inversion, " + kind, "%s/inversion_%d.safetensors" % (OUT, number), frozen.picture(u).numpy(), net(u).numpy(), tolerance)
print("%d passed, %d failed" % (3 - failed, failed))
sys.exit(failed != 0)
