"""The 64 validation pictures that ship, 8 x 8 tiles in two sizes, and their parameters: the mean of all takes of the held-out
materials, each weighted by its samples a pixel.
   validation.py OUT_FOLDER TAKE_FOLDER..."""
import glob, os, struct, sys
import numpy as np
import data

out, takes = sys.argv[1], sys.argv[2:]
total = weight = 0
for folder in takes:
    with open(sorted(glob.glob(os.path.join(folder, "part_*.bin")))[0], "rb") as f:
        samples = struct.unpack("<3I", f.read(16)[4:])[2]
    x, linear = data.read(folder)
    total, weight = total + samples * linear[:64].astype(np.float64), weight + samples
print("%d samples a pixel" % weight)
for name, size in ("materials.ppm", total.shape[1]), ("materials_64.ppm", 64):
    tiles = np.rint(255 * data.display((total / weight).astype(np.float32), size)).astype(np.uint8).reshape(8, 8, 3, size, size)
    with open(os.path.join(out, name), "wb") as f:
        f.write(b"P6\n%d %d\n255\n" % (8 * size, 8 * size) + tiles.transpose(0, 3, 1, 4, 2).tobytes())
np.savetxt(os.path.join(out, "materials.csv"), x[:64], fmt="%.6g", delimiter=",")
