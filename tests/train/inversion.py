"""Trains inversion networks: a picture of 64 x 64 -> the 19 parameters whose picture by the neural renderer is nearest.

The loss is the error of that picture, through the frozen renderer, in its features: with u = Q'(picture - mean), Q the
orthonormal basis of the pixels' layer, the squared error is that of u plus what no material could show. Networks of one
group share the work: the one that is best for a picture learns most from it (multiple choice learning, Guzman-Rivera et al.
2012), because the user of nine takes the best. Pictures are drawn afresh for each step by the renderer, a part from the
data set, and many are edited: contrast, black level, colours mixed between channels."""
import argparse, os, time
import numpy as np
import torch
from torch import nn
import data, save

SIZE = 64


def materials(n):
    """As `make dataset` draws them: half uniform, half sharp; every fourth with smooth glass."""
    x = torch.rand(n, 19)
    x[1::2, [7, 16, 17]] = x[1::2, [7, 16, 17]].round()
    x[1::4, 11] = 0.3 * x[1::4, 11] ** 2
    return x


class Renderer:
    """The frozen renderer in coordinates u [n][3][rank] of its orthonormal basis."""

    def __init__(self, path):
        net = save.load_renderer(path)
        for p in net.hidden:
            [t.requires_grad_(False) for t in p]
        self.net, self.mean = net, net.mean
        r = torch.linalg.cholesky((net.basis.double().T @ net.basis.double())).T.float()  # basis = q r
        self.r, self.q = r, torch.linalg.solve_triangular(r.T, net.basis.T, upper=False).T
        self.ones, self.mean_u = self.q.sum(0), self.mean @ self.q

    def u(self, x):
        return (self.net.features(data.channels(x)) @ self.r.T).reshape(len(x), 3, -1)

    def picture(self, u):
        return u @ self.q.T + self.mean


def edit(u, renderer):
    """What painters do, where it is linear in display values: gain g, offset o, and channels mixed by rows of sum 1."""
    n = len(u)
    mix = 0.35 * torch.randn(n, 3, 3) * torch.rand(n, 1, 1)
    mix = torch.eye(3) + mix - mix.mean(2, keepdim=True)
    g, o = 1 + 0.25 * (torch.rand(n, 1, 1) - 0.5), 0.08 * (torch.rand(n, 1, 1) - 0.5)
    return g * (mix @ u) + (g - 1) * renderer.mean_u + o * renderer.ones


class Dense(nn.Module):
    """FC(first) on the picture - whose weights stay in the span of the basis - then FC(width) twice, FC(19)."""

    def __init__(self, renderer, first, width):
        super().__init__()
        self.renderer = renderer
        rank = renderer.q.shape[1]
        sizes = [3 * rank, first, width, width, 19]
        self.register_buffer("scale", 1 / renderer.u(materials(512)).std())
        self.layers = nn.ModuleList(nn.Linear(a, b) for a, b in zip(sizes, sizes[1:]))

    def forward(self, u):
        x = u.reshape(len(u), -1) * self.scale
        for layer in self.layers[:-1]:
            x = nn.functional.elu(layer(x))
        return torch.sigmoid(self.layers[-1](x))

    def save(self, path):
        layers, tensors = [{"type": "flatten"}], {}
        q, first = self.renderer.q, self.layers[0]
        a = (first.weight * self.scale).reshape(len(first.weight), 3, -1)
        weight = (a @ q.T).reshape(len(a), -1)
        bias = first.bias - (a @ self.renderer.mean_u).sum(1)
        save.dense(layers, tensors, "picture", weight, bias, "elu", "I8")
        for i, layer in enumerate(self.layers[1:-1]):
            save.dense(layers, tensors, "hidden%d" % (i + 1), layer.weight, layer.bias, "elu", "I8")
        save.dense(layers, tensors, "parameters", self.layers[-1].weight, self.layers[-1].bias, "sigmoid", "F16")
        save.ms.write(path, [3, SIZE, SIZE], layers, tensors)


class Convolution(nn.Module):
    """The thesis's form at this size: Conv2D(12,3,1), MaxPool(2,2), Conv2D(16,3,1), MaxPool(2,2), Conv2D(24,3,1),
    MaxPool(2,2), FC(width) twice, FC(19)."""

    def __init__(self, renderer, first, width):
        super().__init__()
        self.renderer = renderer
        filters = [3, first, first + first // 2, 2 * first]
        self.convolutions = nn.ModuleList(nn.Conv2d(a, b, 3, padding=1) for a, b in zip(filters, filters[1:]))
        sizes = [filters[-1] * (SIZE // 8) ** 2, width, width, 19]
        self.layers = nn.ModuleList(nn.Linear(a, b) for a, b in zip(sizes, sizes[1:]))

    def forward(self, u):
        x = self.renderer.picture(u).reshape(-1, 3, SIZE, SIZE)
        for layer in self.convolutions:
            x = nn.functional.max_pool2d(nn.functional.elu(layer(x)), 2)
        x = x.flatten(1)
        for layer in self.layers[:-1]:
            x = nn.functional.elu(layer(x))
        return torch.sigmoid(self.layers[-1](x))

    def save(self, path):
        layers, tensors = [], {}
        for i, c in enumerate(self.convolutions):
            name = "conv%d" % (i + 1)
            layers.append({"type": "conv2d", "name": name, "filters": c.out_channels, "kernel": 3, "padding": "same", "activation": "elu"})
            layers.append({"type": "maxpool2d", "size": 2})
            tensors[name + ".weight"] = c.weight.detach().numpy().astype(np.float16)
            tensors[name + ".bias"] = c.bias.detach().numpy()
        layers.append({"type": "flatten"})
        save.dense(layers, tensors, "hidden1", self.layers[0].weight, self.layers[0].bias, "elu", "I8")
        save.dense(layers, tensors, "hidden2", self.layers[1].weight, self.layers[1].bias, "elu", "I8")
        save.dense(layers, tensors, "parameters", self.layers[2].weight, self.layers[2].bias, "sigmoid", "F16")
        save.ms.write(path, [3, SIZE, SIZE], layers, tensors)


def errors(renderer, nets, u):
    """[nets][n] mean squared error of the pictures."""
    return torch.stack([((renderer.u(net(u)) - u) ** 2).sum((1, 2)) for net in nets]) / (3 * SIZE * SIZE)


def main():
    p = argparse.ArgumentParser()
    p.add_argument("--renderer", default="build/renderer_64.safetensors")
    p.add_argument("--data", default="build/dataset")
    p.add_argument("--kind", choices=["dense", "convolution"], default="dense")
    p.add_argument("--first", type=int, default=64)
    p.add_argument("--width", type=int, default=256)
    p.add_argument("--from-number", type=int, default=1)
    p.add_argument("--count", type=int, default=5)
    p.add_argument("--share", type=float, default=0.1, help="what every network learns from every picture; the best learns all of it")
    p.add_argument("--minutes", type=float, default=20)
    p.add_argument("--batch", type=int, default=128)
    p.add_argument("--rate", type=float, default=1e-3)
    p.add_argument("--seed", type=int, default=1)
    p.add_argument("--start", action="store_true", help="from the networks that an earlier run saved")
    p.add_argument("--out", default="build", help="folder")
    a = p.parse_args()
    torch.manual_seed(a.seed + a.from_number)

    renderer = Renderer(a.renderer)
    _, linear = data.read(a.data)
    real = (torch.from_numpy(data.display(linear, SIZE)) - renderer.mean) @ renderer.q
    del linear
    Net = Dense if a.kind == "dense" else Convolution
    nets = [Net(renderer, a.first, a.width) for _ in range(a.count)]
    paths = [os.path.join(a.out, "inversion_%d" % (a.from_number + i)) for i in range(a.count)]
    if a.start:
        for net, path in zip(nets, paths):
            net.load_state_dict(torch.load(path + ".pt"))
    held = renderer.u(materials(1024))

    optimizer = torch.optim.Adam([p for net in nets for p in net.parameters()], a.rate)
    start, step, curve, spent = time.time(), 0, [], 0.0
    while spent < 1:
        spent = (time.time() - start) / (60 * a.minutes)
        for group in optimizer.param_groups:  # warm up, then half a cosine
            group["lr"] = a.rate * min(1.0, (step + 1) / 200) * (0.5 + 0.5 * np.cos(np.pi * min(spent, 1))) + 1e-7
        with torch.no_grad():
            n = a.batch // 4
            u = torch.cat([renderer.u(materials(3 * n)), real[torch.randint(len(real), (n,))]])
            some = torch.rand(len(u)) < 0.3
            u[some] = edit(u[some], renderer)
        error = (errors(renderer, nets, u) + 2e-5).sqrt()
        loss = (error.min(0)[0] + a.share * error.sum(0)).mean()
        optimizer.zero_grad()
        loss.backward()
        optimizer.step()
        step += 1
        if step % 200 == 0:
            with torch.no_grad():
                e = 255 * errors(renderer, nets, held).sqrt()
            row = (step, time.time() - start, float(e.min(0)[0].mean()), float(e.mean()))
            curve.append(row)
            print("step %6d  %6.0f s  RMSE of 255: best %.2f, one %.2f" % row, flush=True)
    for net, path in zip(nets, paths):
        net.save(path + ".safetensors")
        torch.save(net.state_dict(), path + ".pt")
    with open(os.path.join(a.out, "inversion_%d.csv" % a.from_number), "w") as f:
        f.write("step,seconds,best,one\n" + "".join("%d,%.0f,%.3f,%.3f\n" % row for row in curve))


if __name__ == "__main__":
    main()
