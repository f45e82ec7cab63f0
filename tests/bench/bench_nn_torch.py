#!/usr/bin/env python3
"""PyTorch's times for tests/bench/bench_nn.c: prints a line "name threads seconds" for each network. Medians; thread CPU time
for one thread, as bench_nn.c has it, wall time for two."""
import sys, time
import numpy as np
import torch
from torch import nn

torch.set_grad_enabled(False)


def median(net, x, threads, n=9):
    clock, times = time.thread_time if threads == 1 else time.perf_counter, []
    for i in range(n + 1):
        start = clock()
        net(x)
        times.append(clock() - start)
    return float(np.median(times[1:]))


def renderer():
    layers = []
    for i in range(4):
        layers += [nn.Conv1d(1 if i == 0 else 64, 64, 3, padding=1), nn.ELU(), nn.Upsample(scale_factor=2)]
    return nn.Sequential(*layers, nn.Flatten(), nn.Linear(64 * 304, 1000), nn.ELU(), nn.Linear(1000, 3 * 410 * 410)), torch.rand(1, 1, 19)


def inversion():
    return nn.Sequential(nn.Conv2d(3, 32, 3, padding=1), nn.ReLU(), nn.MaxPool2d(2), nn.Conv2d(32, 32, 3, padding=1), nn.ReLU(), nn.MaxPool2d(2),
                         nn.Flatten(), nn.Linear(32 * 102 * 102, 1000), nn.ReLU(), nn.Linear(1000, 1000), nn.ReLU(), nn.Linear(1000, 19)), torch.rand(1, 3, 410, 410)


def convolution():
    return nn.Sequential(nn.Conv2d(32, 32, 3, padding=1)), torch.rand(1, 32, 205, 205)


print("version", 0, 0, torch.__version__)
for name, make in (("renderer", renderer), ("inversion", inversion), ("convolution", convolution)):
    net, x = make()
    net.eval()
    for threads in (1, 2):
        torch.set_num_threads(threads)
        print(name, threads, median(net, x, threads))
        sys.stdout.flush()
    del net
