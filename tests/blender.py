"""blender -b --factory-startup --python tests/blender.py -- OUT: the add-on of examples/blender, headless."""
import os
import sys
import traceback

import bpy
import numpy as np

OUT = os.path.abspath(sys.argv[sys.argv.index("--") + 1])
sys.path.insert(0, os.path.join(os.getcwd(), "examples/blender"))
import material_taste as addon
from material_taste import preview

passed = failed = 0


def check(name, truth, seen=""):
    global passed, failed
    if truth:
        passed += 1
    else:
        failed += 1
        print("FAIL %s %s" % (name, seen), flush=True)


def refused(name, sentence, call, **options):
    try:
        call(**options)
        check(name, False, "was not refused")
    except RuntimeError as error:  # what Blender shows in its error bar
        check(name, sentence in str(error), error)


def stars(x):
    """Golden polished metal, 0 to 5."""
    x = np.asarray(x)
    polished, gold = x[..., 3] * (1 - x[..., 4]) * (1 - x[..., 5]), 0.6 + x[..., 0] + 0.3 * x[..., 1] - x[..., 2]
    return np.rint(5 * np.clip(polished * gold, 0, 1))


def shown(t):
    return np.array([tuple(i.x) for i in t.gallery])


def score_galleries(t, count):
    for _ in range(count):
        bpy.ops.taste.gallery()
        for k, s in enumerate(stars(shown(t))):
            bpy.ops.taste.score(index=k, score=int(s))


def loop():
    ops, t = bpy.ops.taste, bpy.context.scene.taste
    t.count = 12
    refused("recommend first", "Give some materials stars", ops.recommend)
    refused("score first", "no material 0", ops.score, index=0, score=1)
    refused("match first", "Choose a picture", ops.match)
    refused("match no render", "image data", ops.match, source="RENDER")
    score_galleries(t, 5)
    check("60 answers", len(t.answers) == 60 and sum(a.score >= 0 for a in t.answers) == 60, len(t.answers))

    # two of a gallery are better than the other ten
    bpy.ops.taste.gallery()
    refused("none marked", "Mark some", ops.best)
    for k in np.argsort(-stars(shown(t)))[:2]:
        t.gallery[int(k)].best = True
    ops.best()
    check("20 pairs", len(t.pairs) == 20, len(t.pairs))

    # uniform materials have a mean of 0.5 stars by this taste
    before = len(bpy.data.materials)
    ops.recommend()
    mean = stars(shown(t)).mean()
    made = [m for m in bpy.data.materials if m.name.startswith("Taste")]
    check("recommended", mean > 3, mean)
    check("assets", len(made) == 12 and len(bpy.data.materials) == before + 12 and all(m.asset_data for m in made))
    check("previews", all(m.preview and tuple(m.preview.image_size) == (64, 64) for m in made))
    check("sockets", np.allclose([preview.read(m) for m in made], shown(t), atol=1e-5))
    print("recommended: %.2f stars" % mean, flush=True)

    # a locked parameter keeps the active material's value
    ops.use(index=0)
    material = bpy.context.object.active_material
    preview.write(material, [0.5, 0.5, 0.5, 1, 0.25, 0, 0.5])
    t.locked[4] = True
    check("locked value", abs(t.value[4] - 0.25) < 1e-6, t.value[4])
    ops.recommend()
    check("locked", np.allclose(shown(t)[:, 4], 0.25), shown(t)[:, 4])
    ops.gallery()
    check("locked gallery", np.allclose(shown(t)[:, 4], 0.25), shown(t)[:, 4])
    t.locked[4] = False

    ops.variants()  # of the active material
    x, pictures = shown(t), addon.renderer().pictures(shown(t))
    far = ((pictures - pictures[0])**2).mean((1, 2, 3))
    check("variants: itself first", np.allclose(x[0], [0.5, 0.5, 0.5, 1, 0.25, 0, 0.5], atol=1e-5), x[0])
    check("variants: from similar to good", far[1] <= far[-1] + 1e-6, far)
    t.walk = (0.3, 0.6)
    check("walk", np.allclose(preview.read(material), addon.at(t, [(0.3, 0.6)])[0], atol=1e-5))
    return material


def match():
    """The material of a painted picture, and of a render."""
    ops, t, scene = bpy.ops.taste, bpy.context.scene.taste, bpy.context.scene
    picture, size = addon.renderer().pictures(shown(t)[:1])[0], addon.renderer().size
    ops.paint(index=0)
    pixels = np.empty(size * size * 4, np.float32)
    t.image.pixels.foreach_get(pixels)
    pixels = pixels.reshape(size, size, 4)
    check("painting", np.abs(pixels[::-1, :, :3] - picture).max() < 0.51 / 255)
    pixels[40:44, 20:40, :3] = (1, 0, 0)  # a stroke that no material explains
    t.image.pixels.foreach_set(pixels.ravel())
    ops.match()
    error = np.sqrt(((addon.renderer().pictures(shown(t))[0] - picture)**2).mean())
    check("match", error < 0.01, error)
    t.image = None


def kept():
    """Save, load, undo."""
    t = bpy.context.scene.taste
    before = [tuple(a.x) + (a.score,) for a in t.answers], [(p.better, p.worse) for p in t.pairs], shown(t).tolist()
    path = os.path.join(OUT, "taste.blend")
    bpy.ops.wm.save_as_mainfile(filepath=path)
    bpy.ops.wm.read_homefile(use_factory_startup=True)
    check("another file has none", len(bpy.context.scene.taste.answers) == 0)
    bpy.ops.wm.open_mainfile(filepath=path)
    t = bpy.context.scene.taste
    after = [tuple(a.x) + (a.score,) for a in t.answers], [(p.better, p.worse) for p in t.pairs], shown(t).tolist()
    check("the file keeps it", before == after)
    bpy.ops.taste.recommend()
    check("recommended after loading", stars(shown(t)).mean() > 3, stars(shown(t)))

    count = len(t.answers)
    bpy.ops.ed.undo_push(message="before")
    bpy.ops.taste.forget()
    bpy.ops.ed.undo_push(message="forgotten")
    check("forgotten", len(bpy.context.scene.taste.answers) == 0)
    bpy.ops.ed.undo()
    check("undo", len(bpy.context.scene.taste.answers) == count, len(bpy.context.scene.taste.answers))


def refusals():
    material = bpy.data.materials.new("driven")
    node = preview.principled(material)
    ramp = material.node_tree.nodes.new("ShaderNodeValue")
    material.node_tree.links.new(ramp.outputs[0], node.inputs["Roughness"])
    bpy.context.object.active_material = material
    refused("a texture", "comes from another node", bpy.ops.taste.variants)
    material.node_tree.nodes.remove(node)
    refused("no Principled BSDF", "no Principled BSDF", bpy.ops.taste.variants)
    others = ("/nowhere.safetensors", "cannot open"), ("examples/data/renderer_64.safetensors", "Principled")
    for path, sentence in others:
        addon.kept.pop("renderer", None)
        network = os.environ.get("MS_NETWORK")
        os.environ["MS_NETWORK"] = path
        refused("network " + path, sentence, bpy.ops.taste.gallery)
        os.environ.pop("MS_NETWORK")
        if network:
            os.environ["MS_NETWORK"] = network


def cycles():
    """Four materials by Cycles against the network: two renderings of 64 samples each, whose noise cancels."""
    renderer = addon.renderer()
    # plastic, metal, glass and paint: none of them smooth
    x = [[0.8, 0.2, 0.1, 0, 0.4, 0, 0.5], [0.9, 0.7, 0.3, 1, 0.3, 0, 0.5], [0.9, 0.9, 0.9, 0, 0.4, 1, 0.5],
         [0.1, 0.3, 0.8, 0, 0.8, 0, 0.5]]
    scene, material = preview.build(renderer.size, 64)
    settings = scene.render.image_settings
    settings.file_format, settings.color_depth = "OPEN_EXR", "32"
    scene.render.filepath = os.path.join(OUT, "cycles.exr")
    for k, row in enumerate(x):
        preview.write(material, row)
        product = renderer.pictures([row])[0] * 0 + 1
        for seed in (1, 2):
            scene.cycles.seed = seed
            bpy.ops.render.render(write_still=True)
            image = bpy.data.images.load(scene.render.filepath)
            product *= renderer.pictures([row])[0] - addon.read_picture(image, renderer.size, scene)
            bpy.data.images.remove(image)
        decibels = -10 * np.log10(max(product.mean(), 1e-6))
        print("material %d: %.1f dB" % (k, decibels), flush=True)
        # the least of 26 held-out materials that are no smooth glass or metal is 29.7 dB; a wrong socket is below 20
        check("picture %d" % k, decibels > 25, decibels)


try:
    addon.register()
    bpy.context.scene.taste  # it is there
    loop()
    match()
    kept()
    refusals()
    addon.unregister()
    check("unregistered", not hasattr(bpy.types.Scene, "taste"))
    addon.register()
    addon.unregister()
    cycles()
except BaseException:
    traceback.print_exc()
    failed += 1
print("%d passed, %d failed" % (passed, failed), flush=True)
os._exit(1 if failed else 0)
