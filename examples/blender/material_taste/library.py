"""The add-on's materials in the artist's file: made once, put on objects, kept as assets, removed when unused.

A material is the add-on's as long as it has the name and the sockets that the add-on gave it (the property "taste" says
which). What the artist renamed or changed is the artist's, and is neither overwritten nor removed."""
import os

import bpy
import numpy as np

from . import preview

CATALOG = "4b6f1d7f-6cac-4d39-857a-116f9ca1db8c"  # of the Asset Browser; chosen once, by chance
HEAD = "# This is an Asset Catalog Definition file for Blender.\n\nVERSION 1\n\n"


def paint(target, picture):
    """A picture [height][width][3] from the top into an image, or into an icon or preview."""
    height, width = picture.shape[:2]
    pixels = np.ones((height, width, 4), np.float32)
    pixels[:, :, :3] = picture[::-1]
    if isinstance(target, bpy.types.Image):
        target.pixels.foreach_set(pixels.ravel())
        return
    target.image_size = target.icon_size = (width, height)
    target.image_pixels_float.foreach_set(pixels.ravel())
    target.icon_pixels_float.foreach_set(pixels.ravel())


def signature(material):
    """The name and the values; None where they are not the material's own, such as with a texture."""
    try:
        return "%s: %s" % (material.name, " ".join("%.4f" % v for v in preview.read(material)))
    except RuntimeError:
        return None


def ours(material):
    return "taste" in material and material["taste"] == signature(material)


def sign(material):
    material["taste"] = signature(material)


def material(x, picture):
    """The add-on's material of these values, a new one only where the file has none."""
    for m in bpy.data.materials:
        if ours(m) and not m.get("taste_walk") and np.allclose(preview.read(m), x, atol=1e-5):
            return m
    made = bpy.data.materials.new(preview.describe(x))
    preview.write(made, x)
    paint(made.preview_ensure(), picture)
    sign(made)
    return made


def asset(x, picture, description):
    made = material(x, picture)
    made.asset_mark()
    made.asset_data.description = description
    made.asset_data.catalog_id = CATALOG
    made.asset_data.tags.new("taste", skip_if_exists=True)
    paint(made.preview_ensure(), picture)  # the mark may have asked for another
    return made


def takers(context):
    """The selected objects and the active one, as far as they take a material."""
    objects = list(context.view_layer.objects.selected)
    if context.object is not None and context.object not in objects:
        objects.append(context.object)
    return [o for o in objects if hasattr(o.data, "materials") and not o.library and not o.data.library]


def put(o, material):
    """The material in the object's active slot. An artist's own that loses its last user there is kept in the file."""
    before = o.active_material
    if len(o.data.materials):
        o.active_material = material
    else:
        o.data.materials.append(material)
    if before is not None and before.users == 0 and not ours(before):
        before.use_fake_user = True


def walk(o, x):
    """The active object's material becomes x: the walk's own material, made at the first step as a copy of the active
    one."""
    if o is None or not hasattr(o.data, "materials"):
        raise RuntimeError("Select an object that takes a material")
    before = o.active_material
    if before is not None and before.get("taste_walk") and ours(before):
        made = before
    else:
        own = before is not None and signature(before) is not None
        made = before.copy() if own else bpy.data.materials.new("Walk")
        made.name = "Walk"
        made["taste_walk"] = True
        made.use_fake_user = False
        if made.asset_data:
            made.asset_clear()
        put(o, made)
    preview.write(made, x)
    sign(made)


def remove_unused():
    """Removes the add-on's materials and pictures that nothing uses; how many materials."""
    unused = [m for m in bpy.data.materials if ours(m) and m.users <= m.use_fake_user]
    pictures = [i for i in bpy.data.images if i.get("taste") == i.name and i.users == 0]
    bpy.data.batch_remove(unused + pictures)
    return len(unused)


def keep_catalog():
    """The catalog Taste in the asset library of the saved file, where it has materials of it."""
    if not bpy.data.filepath or not any(m.asset_data and m.asset_data.catalog_id == CATALOG
                                        for m in bpy.data.materials):
        return
    folder = os.path.dirname(os.path.abspath(bpy.data.filepath))
    for known in bpy.context.preferences.filepaths.asset_libraries:
        root = os.path.abspath(bpy.path.abspath(known.path)) if known.path else ""
        if root and (folder + os.sep).startswith(root.rstrip(os.sep) + os.sep):
            folder = root
    path = os.path.join(folder, "blender_assets.cats.txt")
    text = HEAD
    if os.path.exists(path):
        with open(path, encoding="utf-8") as f:
            text = f.read()
    if CATALOG not in text:
        with open(path, "w", encoding="utf-8") as f:
            f.write(text.rstrip("\n") + "\n\n" * (text == HEAD) + "\n" * (text != HEAD) + CATALOG + ":Taste:Taste\n")
