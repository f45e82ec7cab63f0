"""recommended.png: eight materials that the add-on recommends after 60 stars for gold and copper, polished, by Cycles.

    make blender
    blender -b --factory-startup --python examples/blender/recommended.py -- OUT.png [SAMPLES [WIDTH]]"""
import math
import os
import sys

import bpy
import numpy as np
from mathutils import Vector

sys.path.insert(0, "build")
from material_taste import NETWORK, preview, taste

GALLERY, SEED = 12, 3


def stars(x):
    """Polished metal, the nearer to gold and copper the better, 0 to 5."""
    polished = x[:, 3] * (1 - x[:, 4]) * (1 - x[:, 5])
    off = (x[:, 0] - 0.9)**2 + (x[:, 1] - 0.55)**2 + (x[:, 2] - 0.2)**2
    return np.rint(5 * np.clip(1.3 * polished * np.exp(-2 * off), 0, 1))


def recommended(count):
    """count materials that look different."""
    x, model = np.empty((0, len(preview.NAMES))), None
    for k in range(5):
        x = np.vstack([x, taste.gallery(model, x.shape[1], GALLERY, SEED + k)])
        model = taste.Taste(x, stars(x))
    found, predicted = model.recommend(4 * count, 0.8, 0.6, SEED)
    found = found[np.argsort(-predicted)[:2 * count]]
    print("true stars of %d: %.2f" % (len(found), stars(found).mean()), flush=True)
    pictures = taste.Renderer(NETWORK).pictures(found).reshape(len(found), -1)
    chosen = [0]
    while len(chosen) < count:  # next the one that is farthest from all before it
        far = ((pictures[:, None] - pictures[chosen][None])**2).mean(2).min(1)
        chosen.append(int(far.argmax()))
    return found[chosen]


def knot(p, q, radius, tube):
    curve = bpy.data.curves.new("knot", "CURVE")
    curve.dimensions, curve.bevel_depth, curve.bevel_resolution = "3D", tube, 12
    spline = curve.splines.new("POLY")
    steps = 400
    spline.points.add(steps - 1)
    for k, point in enumerate(spline.points):
        t = 2 * math.pi * k / steps
        r = radius * (1 + 0.45 * math.cos(q * t))
        point.co = (r * math.cos(p * t), 0.55 * radius * math.sin(q * t), r * math.sin(p * t), 1)
    spline.use_cyclic_u = True
    o = bpy.data.objects.new("knot", curve)
    bpy.context.scene.collection.objects.link(o)
    return o


def surface(name, f, columns=192, rows=96):
    """A closed surface: f(u, v) from 0 to 1, u around."""
    points = [f(u / columns, v / (rows - 1)) for v in range(rows) for u in range(columns)]
    faces = [(v * columns + u, v * columns + (u + 1) % columns, (v + 1) * columns + (u + 1) % columns,
              (v + 1) * columns + u) for v in range(rows - 1) for u in range(columns)]
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(points, [], faces)
    mesh.polygons.foreach_set("use_smooth", [True] * len(faces))
    o = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(o)
    return o


# Radius and height of a vase: the foot, the belly, the neck, the lip and the inside.
PROFILE = np.array(((0, 0), (0.36, 0), (0.45, 0.1), (0.66, 0.5), (0.62, 0.85), (0.3, 1.25), (0.26, 1.4), (0.42, 1.72),
                    (0.4, 1.74), (0.22, 1.4), (0.24, 1.2), (0, 1)))


def vase(u, v):
    # a quadratic B-spline, with eight soft ribs on the belly
    at, n = v * (len(PROFILE) - 2), len(PROFILE)
    k = min(int(at), n - 3)
    t = at - k
    r, z = 0.5 * (1 - t)**2 * PROFILE[k] + (0.5 + t - t * t) * PROFILE[k + 1] + 0.5 * t * t * PROFILE[k + 2]
    r *= 1 + 0.06 * math.cos(8 * 2 * math.pi * (u + 0.2 * z)) * max(0, 1 - abs(z - 0.6) / 0.6)
    return (r * math.cos(2 * math.pi * u), r * math.sin(2 * math.pi * u), z - 0.9)


def pebble(u, v):
    a, b = 2 * math.pi * u, math.pi * v
    n = (math.cos(a) * math.sin(b), math.sin(a) * math.sin(b), math.cos(b))
    r = 0.82 * (1 + 0.11 * math.sin(3 * n[0] + 1) * math.sin(4 * n[1]) + 0.09 * math.sin(5 * n[2] + 2 * n[0]))
    return tuple(r * c for c in n)


def monkey():
    bpy.ops.mesh.primitive_monkey_add(size=1.75)
    o = bpy.context.object
    o.modifiers.new("smooth", "SUBSURF").render_levels = 3
    bpy.ops.object.shade_smooth()
    return o


def torus():
    bpy.ops.mesh.primitive_torus_add(major_radius=0.6, minor_radius=0.26, major_segments=128, minor_segments=64)
    bpy.ops.object.shade_smooth()
    bpy.context.object.rotation_euler = (1.2, 0.3, 0)
    return bpy.context.object


def main():
    a = sys.argv[sys.argv.index("--") + 1:]
    samples, width = int(a[1]) if len(a) > 1 else 256, int(a[2]) if len(a) > 2 else 1200
    scene, _ = preview.build(width, samples, threads=int(os.environ.get("THREADS", 2)))
    scene.render.resolution_y = width * 9 // 20
    scene.render.image_settings.file_format = "PNG"
    scene.render.filepath = os.path.abspath(a[0])
    scene.cycles.use_adaptive_sampling, scene.cycles.adaptive_threshold = True, 0.01
    scene.cycles.max_bounces = 10
    bpy.data.objects.remove(bpy.data.objects["Sphere"])

    objects = [monkey(), knot(2, 3, 0.62, 0.2), surface("vase", vase), torus(), surface("pebble", pebble),
               knot(3, 2, 0.62, 0.13), monkey(), surface("vase", vase)]
    for k, (o, x) in enumerate(zip(objects, recommended(len(objects)))):
        row, column = k // 4, k % 4
        o.location = ((column - 1.5) * (2.45 - 0.15 * row) + 1.2 * row - 0.7, -2.1 * row, 0.9)
        o.rotation_euler.z += 0.45 - 0.3 * column
        material = bpy.data.materials.new(preview.describe(x))
        preview.write(material, x)
        o.data.materials.clear()
        o.data.materials.append(material)
        print(material.name, np.round(x, 2), flush=True)

    camera = scene.camera
    camera.data.lens = 52
    camera.location = (0, -15, 6.5)
    camera.rotation_euler = (Vector((0, -0.9, 0.62)) - camera.location).to_track_quat("-Z", "Y").to_euler()
    key = bpy.data.objects["key"]
    key.location, key.data.size, key.data.energy = (-5, -5, 7), 3, 1500
    key.rotation_euler = (Vector((0, -1, 0.5)) - key.location).to_track_quat("-Z", "Y").to_euler()
    bpy.ops.render.render(write_still=True)


main()
