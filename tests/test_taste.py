"""taste.py and flat.c without Blender: what is of a wrong size is refused by name, as the library behind would read on."""
import os
import subprocess
import sys
import tempfile

folder = tempfile.mkdtemp()
os.environ["MS_FLAT"] = os.path.join(folder, "libms_flat.so")
subprocess.check_call([os.environ.get("CC", "cc"), "-std=c99", "-O1", "-fPIC", "-shared", "-fvisibility=hidden", "-I.",
                       "-Iexamples/tools", "examples/blender/flat.c", "-o", os.environ["MS_FLAT"], "-lm"])
sys.dont_write_bytecode = True
sys.path.insert(0, "examples/blender/material_taste")
import numpy as np
import taste

os.remove(os.environ["MS_FLAT"])  # it is loaded
os.rmdir(folder)
failed = 0


def check(name, good):
    global failed
    failed += not good
    if not good:
        print("FAIL " + name)


def refuses(name, words, call):
    try:
        call()
        check(name + ": was not refused", False)
    except RuntimeError as error:
        check("%s: %s" % (name, error), words in str(error))


random = np.random.default_rng(3)
x = random.random((60, 4))
model = taste.Taste(x, 10 * (x[:, 0] > 0.6), [(0, 1)] if x[0, 0] > x[1, 0] else [(1, 0)])
found, mean = model.recommend(20, low=[0, 0, 0.5, 0], high=[1, 1, 0.5, 1])
check("recommended to the taste", found.shape == (20, 4) and (found[:, 0] > 0.5).all())
check("one locked", (found[:, 2] == 0.5).all())
check("their scores", np.allclose(model.predict(found)[0], mean))
inner = taste.gallery(model, 4, 9, low=0.25, high=0.75)
check("one number for all", inner.min() >= 0.25 and inner.max() <= 0.75)
check("a first gallery", taste.gallery(None, 3, 5).shape == (5, 3))
plane = taste.Plane(found[:8])
check("a plane", plane.materials([plane.box[:2], plane.box[2:]]).shape == (2, 4))
refuses("a box of three", "the box has 3 numbers, a material has 4", lambda: model.recommend(5, low=[0, 0, 0]))
refuses("a gallery of others", "materials of 3 parameters, the taste has 4", lambda: taste.gallery(model, 3, 5))
refuses("points of one coordinate", "points of 1 coordinates", lambda: plane.materials([[0.1], [0.2]]))
refuses("materials of others", "materials of 3 parameters", lambda: model.predict(x[:, :3]))
refuses("a score too few", "60 materials, but 59 scores", lambda: taste.Taste(x, x[:59, 0]))
refuses("a box upside down", "expected low <= high", lambda: model.recommend(5, low=[1, 0, 0, 0], high=[0, 1, 1, 1]))
renderer = taste.Renderer("examples/data/renderer_64.safetensors")
picture = renderer.pictures(np.full(renderer.m, 0.5))[0]
refuses("a source of others", "the source has 4 numbers, a material has 19", lambda: renderer.match(picture, x[0]))
material, match, rmse = renderer.match(picture, source=np.full(19, 0.4))
check("a match", rmse < 0.01 and match.shape == picture.shape and material.shape == (19,))
print("ok taste" if failed == 0 else "%d failed" % failed)
sys.exit(failed > 0)
