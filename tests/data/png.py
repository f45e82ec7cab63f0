#!/usr/bin/env python3
"""Writes tests/data/png/: a PNG of 13 x 7 pixels in every color type, depth and interlacing. Sample k of pixel (x, y) is
(37 x + 11 y + 50 k) mod 2^bits, for palettes an index into colors (7 i, 5 i, 3 i, 255 - i); filters and kinds of DEFLATE blocks change
from file to file. zlib does the packing: python3 tests/data/png.py"""
import os, struct, zlib

SAMPLES = {0: 1, 2: 3, 3: 1, 4: 2, 6: 4}
PASSES = [(0, 0, 8, 8), (4, 0, 8, 8), (0, 4, 4, 8), (2, 0, 4, 4), (0, 2, 2, 4), (1, 0, 2, 2), (0, 1, 1, 2)]
folder = os.path.join(os.path.dirname(os.path.abspath(__file__)), "png")
os.makedirs(folder, exist_ok=True)


def row(color, bits, xs, y):
    out, acc, n = bytearray(), 0, 0
    for x in xs:
        for k in range(SAMPLES[color]):
            v = (37 * x + 11 * y + 50 * k) % (1 << min(bits, 8 if color == 3 else 16))
            if bits >= 8: out += v.to_bytes(bits // 8, "big")
            else:
                acc, n = acc << bits | v, n + bits
                if n == 8: out.append(acc); acc = n = 0
    if n: out.append(acc << (8 - n))
    return bytes(out)


def filtered(rows, step, first):
    above, out = bytes(len(rows[0])), b""
    for i, r in enumerate(rows):
        f, line = (first + i) % 5, bytearray()
        for j, v in enumerate(r):
            a, b, c = r[j - step] if j >= step else 0, above[j], above[j - step] if j >= step else 0
            p = a + b - c
            paeth = min((abs(p - a), 0, a), (abs(p - b), 1, b), (abs(p - c), 2, c))[2]
            line.append((v - [0, a, b, (a + b) // 2, paeth][f]) & 255)
        out, above = out + bytes([f]) + line, r
    return out


def chunk(name, data): return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))


number = 0
for color, depths in ((0, (1, 2, 4, 8, 16)), (2, (8, 16)), (3, (1, 2, 4, 8)), (4, (8, 16)), (6, (8, 16))):
    for bits in depths:
        for interlaced in (0, 1):
            raw, step = b"", max(1, bits * SAMPLES[color] // 8)
            for x0, y0, dx, dy in PASSES if interlaced else [(0, 0, 1, 1)]:
                rows = [row(color, bits, range(x0, 13, dx), y) for y in range(y0, 7, dy)]
                if rows and rows[0]: raw += filtered(rows, step, number)
            packer = zlib.compressobj((0, 9, 9)[number % 3], zlib.DEFLATED, 15, 9, zlib.Z_FIXED if number % 3 == 1 else zlib.Z_DEFAULT_STRATEGY)
            data = packer.compress(raw) + packer.flush()
            n = min(256, 1 << bits)
            extra = chunk(b"PLTE", bytes(v & 255 for i in range(n) for v in (7 * i, 5 * i, 3 * i))) if color == 3 else b""
            if color == 3 and interlaced: extra += chunk(b"tRNS", bytes(255 - i for i in range(n)))
            with open(os.path.join(folder, "c%d_b%d_i%d.png" % (color, bits, interlaced)), "wb") as f:
                f.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", 13, 7, bits, color, 0, 0, interlaced)) + chunk(b"gAMA", b"\0\0\xb1\x8f") + extra +
                        chunk(b"IDAT", data[:20]) + chunk(b"IDAT", data[20:]) + chunk(b"IEND", b""))
            number += 1
