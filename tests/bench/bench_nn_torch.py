#!/usr/bin/env python3
"""PyTorch's side of tests/bench/bench_nn.c: prints its version, then runs a network for each line "network side threads" and
prints the seconds, so that its runs and ours can take turns. Thread CPU time for one thread, else by the wall."""
import sys, time
import torch
from torch import nn

torch.set_grad_enabled(False)


def renderer(side):
    layers = []
    for i in range(4):
        layers += [nn.Conv1d(1 if i == 0 else 64, 64, 3, padding=1), nn.ELU(), nn.Upsample(scale_factor=2)]
    return nn.Sequential(*layers, nn.Flatten(), nn.Linear(64 * 304, 1000), nn.ELU(), nn.Linear(1000, 3 * side * side)), torch.rand(1, 1, 19)


def inversion(side):
    return nn.Sequential(nn.Conv2d(3, 32, 3, padding=1), nn.ReLU(), nn.MaxPool2d(2), nn.Conv2d(32, 32, 3, padding=1), nn.ReLU(), nn.MaxPool2d(2), nn.Flatten(),
                         nn.Linear(32 * (side // 4) ** 2, 1000), nn.ReLU(), nn.Linear(1000, 1000), nn.ReLU(), nn.Linear(1000, 19)), torch.rand(1, 3, side, side)


def convolution(side):
    return nn.Sequential(nn.Conv2d(32, 32, 3, padding=1)), torch.rand(1, 32, 205, 205)


def main():
    print("version", torch.__version__, flush=True)
    made = {}
    for line in sys.stdin:
        name, side, threads = line.split()
        if name not in made:
            made = {name: {"renderer": renderer, "inversion": inversion, "convolution": convolution}[name](int(side))}
        net, x = made[name]
        torch.set_num_threads(int(threads))
        clock = time.thread_time if threads == "1" else time.perf_counter
        start = clock()
        net(x)
        print(clock() - start, flush=True)


main()
