r"""Pictures of random materials by Cycles, for build/train:

    blender -b --factory-startup -t 1 --python examples/blender/dataset.py -- \
        FOLDER COUNT SAMPLES SEED NOISE GLASS [SIZE]

writes FOLDER/00000.pfm ... (linear light) and FOLDER.csv (parameters from 0 to 1, as in preview.py). The materials
follow from SEED, their noise from NOISE, so that two runs of one SEED are the same materials with other noise. What is
there already is kept: a run that was interrupted goes on. PART of PARTS (environment) shares the work among processes.

Metallic and transmission are 0 or 1 in most materials, as on real ones. GLASS is the part of the materials that are
drawn as smooth glass in any case: its caustics change quickly with roughness and IOR, so that it needs more pictures
than the rest. 0 for the materials that a network is measured with."""
import os
import random
import sys

import bpy
import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "material_taste"))
import preview


def draw(r, glass):
    x = [r.random() for _ in preview.NAMES]
    if r.random() < glass:
        x[3], x[4], x[5] = 0.0, 0.3 * r.random()**1.5, 1.0
        if r.random() < 0.1:
            x[4] = 0.0
        if r.random() < 0.2:  # of mixtures, too
            x[5] = 1 - 0.6 * r.random()
        return x
    kind = r.random()
    if kind < 0.3:
        x[3], x[5] = 0.0, 0.0  # plastic, paint, stone
    elif kind < 0.55:
        x[3], x[5] = 1.0, 0.0  # metal
    elif kind < 0.8:
        x[3], x[5] = 0.0, 1.0  # glass
    elif kind < 0.9:
        x[3] = 0.0
    if r.random() < 0.25:
        x[4] = r.random() ** 3  # smooth
    if r.random() < 0.05:
        x[4] = 0.0
    return x


def main():
    a = sys.argv[sys.argv.index("--") + 1:]
    folder, count, samples, seed, noise, glass = a[0], int(a[1]), int(a[2]), int(a[3]), int(a[4]), float(a[5])
    size = int(a[6]) if len(a) > 6 else 64
    part, parts = int(os.environ.get("PART", 0)), int(os.environ.get("PARTS", 1))
    os.makedirs(folder, exist_ok=True)
    scene, material = preview.build(size, samples)
    settings = scene.render.image_settings
    settings.file_format, settings.color_depth, settings.exr_codec = "OPEN_EXR", "32", "NONE"
    exr = "%s.part%d.exr" % (folder, part)
    scene.render.filepath = exr
    rows = [draw(random.Random(seed * 1000003 + k), glass) for k in range(count)]
    with open(folder + ".csv.part%d" % part, "w") as f:
        f.write(",".join(preview.NAMES) + "\n")
        for x in rows:
            f.write(",".join("%.6g" % v for v in x) + "\n")
    os.replace(folder + ".csv.part%d" % part, folder + ".csv")
    with open(folder + ".version", "w") as f:
        f.write(bpy.app.version_string)
    for k, x in enumerate(rows):
        path = os.path.join(folder, "%05d.pfm" % k)
        if k % parts != part or os.path.exists(path):
            continue
        preview.write(material, x)
        scene.cycles.seed = noise * 100000 + k
        bpy.ops.render.render(write_still=True)
        image = bpy.data.images.load(exr)
        pixels = np.empty(size * size * 4, np.float32)
        image.pixels.foreach_get(pixels)
        bpy.data.images.remove(image)
        with open(path + ".new", "wb") as f:
            f.write(b"PF\n%d %d\n-1.0\n" % (size, size))
            f.write(pixels.reshape(size, size, 4)[:, :, :3].astype("<f4").tobytes())
        os.rename(path + ".new", path)
        if k % 100 == part:
            print("%s: %d of %d" % (folder, k, count), flush=True)
    if os.path.exists(exr):
        os.remove(exr)


main()
