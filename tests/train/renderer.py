"""Trains the shared-channel neural renderer: 11 parameters of a colour channel -> size x size display values.

The last layer is linear and its basis is known beforehand: the principal components of the training pictures are the best
one of that rank. So the trunk is trained on their coefficients, where the squared error is that of the picture, less what
lies outside the basis; an epoch then costs seconds. Materials without a lobe teach that its parameters do not matter."""
import argparse, os, time
import numpy as np
import torch
from torch import nn
import data, save


def basis(y, rank, passes=3):
    """Randomised principal components (Halko, Martinsson, Tropp 2011) of the rows of y [n][pixels] about their mean."""
    mean = y.mean(0)
    q = torch.linalg.qr(torch.randn(y.shape[1], rank + 32))[0]
    for _ in range(passes):
        q = torch.linalg.qr(y.T @ (y @ q) - torch.outer(mean, (y @ q).sum(0)))[0]
    c = y @ q - mean @ q
    s, v = torch.linalg.eigh(c.T @ c / len(c))
    order = torch.argsort(s, descending=True)[:rank]
    return mean, q @ v[:, order], s[order]


class Trunk(nn.Module):
    def __init__(self, width, depth, rank):
        super().__init__()
        sizes = [11] + [width] * depth
        self.hidden = nn.ModuleList(nn.Linear(a, b) for a, b in zip(sizes, sizes[1:]))
        self.out = nn.Linear(width, rank)

    def forward(self, x):
        for layer in self.hidden:
            x = nn.functional.elu(layer(x))
        return self.out(x)


def train(trunk, x, c, scale, a):
    """c [n][rank] coefficients; scale of the trunk's output."""
    optimizer = torch.optim.Adam(trunk.parameters(), a.rate)
    steps = a.epochs * ((len(x) + a.batch - 1) // a.batch)
    schedule = torch.optim.lr_scheduler.OneCycleLR(optimizer, a.rate, total_steps=steps, pct_start=0.05, final_div_factor=1e3)
    start, curve = time.time(), []
    for epoch in range(a.epochs):
        order, total = torch.randperm(len(x)), 0.0
        for i in range(0, len(x), a.batch):
            at = order[i:i + a.batch]
            error = ((trunk(data.free(x[at])) * scale - c[at]) ** 2).sum(1)
            # between the mean of the squares and that of their logarithms, which is the PSNR
            loss = (error + a.floor).sqrt().mean() if a.loss == "root" else (error + a.floor).log().mean()
            optimizer.zero_grad()
            loss.backward()
            optimizer.step()
            schedule.step()
            total += float(error.detach().sum())
        curve.append((epoch, total / len(x)))
        if epoch % 20 == 19 or epoch == a.epochs - 1:
            print("epoch %4d  %6.0f s  training error %.3e" % (epoch + 1, time.time() - start, total / len(x)), flush=True)
    return curve


def main():
    p = argparse.ArgumentParser()
    p.add_argument("--data", default="build/dataset")
    p.add_argument("--held-out", nargs=2, default=["build/heldout_0", "build/heldout_1"])
    p.add_argument("--size", type=int, default=64)
    p.add_argument("--rank", type=int, default=160)
    p.add_argument("--width", type=int, default=384)
    p.add_argument("--depth", type=int, default=3)
    p.add_argument("--epochs", type=int, default=200)
    p.add_argument("--batch", type=int, default=256)
    p.add_argument("--rate", type=float, default=2e-3)
    p.add_argument("--loss", choices=["root", "log"], default="root")
    p.add_argument("--floor", type=float, default=1e-2)
    p.add_argument("--seed", type=int, default=1)
    p.add_argument("--pixels", choices=["I8", "F16"], default="I8")
    p.add_argument("--out", default="build/renderer_64.safetensors")
    a = p.parse_args()
    torch.manual_seed(a.seed)

    x, linear = data.read(a.data)
    x = data.channels(torch.from_numpy(x.copy()))
    y = torch.from_numpy(data.display(linear, a.size)).reshape(len(x), -1)
    del linear
    print("%d channels of %d^2" % (len(x), a.size), flush=True)
    mean, b, variance = basis(y, a.rank)
    c = (y - mean) @ b
    outside = ((y - mean) ** 2).sum(1) - (c ** 2).sum(1)
    print("rank %d leaves %.2f dB" % (a.rank, -10 * np.log10(float(outside.mean()) / a.size ** 2)), flush=True)

    held = []
    for folder in a.held_out:
        hx, linear = data.read(folder)
        held.append(torch.from_numpy(data.display(linear, a.size)))
    hx = data.channels(torch.from_numpy(hx.copy()))
    hc = ((held[0] + held[1]).reshape(len(hx), -1) / 2 - mean) @ b
    picture = (hc @ b.T + mean).reshape(held[0].shape)
    data.report("the basis itself", data.psnr(picture, *held))

    trunk = Trunk(a.width, a.depth, a.rank)
    scale = float(variance.sum()) ** 0.5 / 8
    curve = train(trunk, x, c, scale, a)
    with torch.no_grad():
        picture = ((trunk(hx) * scale) @ b.T + mean).reshape(held[0].shape)
    dB = data.psnr(picture, *held)
    data.report("held out", dB)
    worst = torch.argsort(dB)[:8]
    print("worst:", " ".join("%d (%.1f)" % (i, dB[i]) for i in worst.tolist()), flush=True)
    with open(os.path.splitext(a.out)[0] + ".csv", "w") as f:
        f.write("epoch,error\n" + "".join("%d,%.6e\n" % row for row in curve))
    torch.save({"trunk": trunk.state_dict(), "shape": (a.width, a.depth, a.rank), "scale": scale, "basis": b, "mean": mean}, os.path.splitext(a.out)[0] + ".pt")
    save.renderer(a.out, trunk, scale, b, mean, variance, a.pixels)
    with torch.no_grad():
        again = save.load_renderer(a.out)(hx).reshape(held[0].shape)
    data.report("held out, as saved", data.psnr(again, *held))


if __name__ == "__main__":
    main()
