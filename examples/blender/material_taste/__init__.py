"""Material taste: score galleries, get materials that you like. The panel and its operators; taste.py learns and draws,
preview.py knows Blender's sockets. Everything that is kept is in scene.taste, so Blender saves and undoes it."""
import os
import tempfile

import bpy
import bpy.utils.previews
import numpy as np
from bpy.props import (BoolProperty, BoolVectorProperty, CollectionProperty, EnumProperty, FloatProperty,
                       FloatVectorProperty, IntProperty, PointerProperty)

from . import preview, taste

bl_info = {
    "name": "Material taste",
    "author": "the authors of ms",
    "version": (0, 2, 0),
    "blender": (3, 4, 0),
    "location": "3D Viewport > Sidebar > Taste",
    "description": "Learns which materials you like from a few scores, and makes more of them",
    "category": "Material",
}

M = len(preview.NAMES)
NETWORK = os.path.join(os.path.dirname(os.path.abspath(__file__)), "renderer.safetensors")
MAP = 7  # the picture of the plane shows MAP x MAP materials

# What can be made again at any time: the renderer, the icons and what they show, the learnt taste, the plane.
kept = {}


def renderer():
    if "renderer" not in kept:
        kept["renderer"] = taste.Renderer(os.environ.get("MS_NETWORK", NETWORK))
        if kept["renderer"].m != M:
            del kept["renderer"]
            raise RuntimeError("the network is not one of the Principled BSDF's %d parameters" % M)
    return kept["renderer"]


def once(name, key, make):
    """make(), again only when the key is another than the last time."""
    if kept.get(name, (None,))[0] != key:
        kept[name] = (key, make())
    return kept[name][1]


def box(t):
    """The least and the largest of each parameter: a locked one has its value alone."""
    locked, value = np.array(t.locked), np.array(t.value)
    return np.where(locked, value, 0), np.where(locked, value, 1)


def learn(t):
    """The taste from all answers, or None where there is none yet."""
    if not any(a.score >= 0 for a in t.answers) and not t.pairs:
        return None
    x, score = [tuple(a.x) for a in t.answers], [a.score if a.score >= 0 else np.nan for a in t.answers]
    pairs = [(p.better, p.worse) for p in t.pairs]
    return once("taste", (tuple(x), str(score), tuple(pairs)), lambda: taste.Taste(x, score, pairs))


def learnt(t):
    model = learn(t)
    if model is None:
        raise RuntimeError("Give some materials stars first")
    return model


def plane(t):
    """The plane of 40 recommendations."""
    model, (low, high) = learnt(t), box(t)
    key = (id(model), t.quality, low.tobytes(), high.tobytes())
    return once("plane", key, lambda: taste.Plane(model.recommend(40, t.quality, 0, 1, low, high)[0], low, high))


def at(t, where):
    """Points of the plane; where [count][2] from 0 to 1."""
    p = plane(t)
    return p.materials(p.box[:2] + np.asarray(where) * (p.box[2:] - p.box[:2]))


def show(t, x):
    t.gallery.clear()
    for row in x:
        t.gallery.add().x = row


def answer(t, x):
    """The row of a material among the answers, a new one where it was not asked about before."""
    for k, a in enumerate(t.answers):
        if tuple(a.x) == tuple(x):
            return k
    t.answers.add().x = x
    return len(t.answers) - 1


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


def icons(name, x, tiles=1):
    """Icons of materials, drawn by the network when they are others than before; tiles: so many squared in one icon."""

    def draw():
        collection = kept.setdefault(name + " icons", bpy.utils.previews.new())
        collection.clear()
        pictures = renderer().pictures(x) if len(x) else []
        if tiles > 1:
            pictures = [np.vstack([np.hstack(pictures[r * tiles:(r + 1) * tiles]) for r in range(tiles)])]
        for k, picture in enumerate(pictures):
            paint(collection.new(str(k)), picture)
        return [collection[str(k)].icon_id for k in range(len(pictures))]

    return once(name, np.asarray(x).tobytes(), draw)


def active_material(context):
    material = context.object.active_material if context.object else None
    if material is None:
        raise RuntimeError("The active object has no material")
    return material


def read_picture(image, size, scene):
    """[size][size][3] as displayed, from the square in the middle of an image, or of the render region of a render."""
    left, bottom, right, top = 0.0, 0.0, 1.0, 1.0
    if image.type == "RENDER_RESULT":  # its pixels can be had through a file only
        if scene.render.use_border and not scene.render.use_crop_to_border:
            left, right = scene.render.border_min_x, scene.render.border_max_x
            bottom, top = scene.render.border_min_y, scene.render.border_max_y
        settings = scene.render.image_settings
        before = settings.file_format, settings.color_depth
        path = os.path.join(tempfile.mkdtemp(), "render.exr")
        try:
            settings.file_format, settings.color_depth = "OPEN_EXR", "32"
            image.save_render(path, scene=scene)
        finally:
            settings.file_format, settings.color_depth = before
        image = bpy.data.images.load(path)
        pixels = numbers(image)
        bpy.data.images.remove(image)
        os.remove(path)
        os.rmdir(os.path.dirname(path))
    else:
        pixels = numbers(image)
    height, width = pixels.shape[:2]
    side = min((right - left) * width, (top - bottom) * height)
    if side < 8:
        raise RuntimeError("The picture is smaller than 8 x 8 pixels")
    x0, y0 = (left + right) / 2 * width - side / 2, (bottom + top) / 2 * height - side / 2
    # means over boxes, or the nearest pixel where the picture is small
    fine = size * max(1, int(np.ceil(side / size)))
    step = (np.arange(fine) + 0.5) * side / fine
    rows, columns = (y0 + step).astype(int).clip(0, height - 1), (x0 + step).astype(int).clip(0, width - 1)
    square = pixels[rows][:, columns].reshape(size, fine // size, size, fine // size, 3).mean((1, 3))
    return square[::-1]


def numbers(image):
    """[height][width][3] of an image, as displayed, rows from the bottom."""
    width, height = image.size
    if width * height == 0 or image.channels < 3:
        raise RuntimeError("'%s' has no picture in color" % image.name)
    pixels = np.empty(width * height * image.channels, np.float32)
    image.pixels.foreach_get(pixels)
    pixels = pixels.reshape(height, width, -1)[:, :, :3]
    if image.is_float:  # linear light
        pixels = np.where(pixels < 0.0031308, 12.92 * pixels, 1.055 * np.maximum(pixels, 1e-9)**(1 / 2.4) - 0.055)
    return pixels.clip(0, 1)


# --- what the file keeps ---


def walked(t, context):
    """The walk in the plane sets the active material."""
    try:
        preview.write(active_material(context), at(t, [t.walk])[0])
    except RuntimeError:  # the panel says it: a property has no error bar
        pass


def locked(t, context):
    """A parameter that becomes locked has the value of the active material."""
    try:
        x = preview.read(active_material(context))
        for k in range(M):
            if t.locked[k] and not t.was_locked[k]:
                t.value[k] = x[k]
    except RuntimeError:
        pass
    t.was_locked = t.locked


class TasteItem(bpy.types.PropertyGroup):
    x: FloatVectorProperty(size=M)
    score: IntProperty(default=-1)
    best: BoolProperty(name="Best", description="One of the best of these")


class TasteAnswer(bpy.types.PropertyGroup):
    x: FloatVectorProperty(size=M)
    score: FloatProperty(default=-1)  # below 0: it was compared only


class TastePair(bpy.types.PropertyGroup):
    better: IntProperty()
    worse: IntProperty()


class TasteState(bpy.types.PropertyGroup):
    gallery: CollectionProperty(type=TasteItem)
    answers: CollectionProperty(type=TasteAnswer)
    pairs: CollectionProperty(type=TastePair)
    asked: IntProperty(description="Galleries and recommendations so far: the next seed")
    quality: FloatProperty(name="Quality", default=0.7, min=0.1, max=0.95, subtype="FACTOR",
                           description="Low: more variety. High: the best alone")
    count: IntProperty(name="Count", default=12, min=1, max=200)
    locked: BoolVectorProperty(name="Lock", size=M, update=locked, description="Keep this value in all that is made")
    was_locked: BoolVectorProperty(size=M)
    value: FloatVectorProperty(name="Value", size=M, default=(0.5,) * M, min=0, max=1)
    walk: FloatVectorProperty(name="Walk", size=2, default=(0.5, 0.5), min=0, max=1, step=1, update=walked,
                              description="A place in the plane of what you like; sets the active material")
    show_plane: BoolProperty(name="Plane", description="Materials that you like, laid out so that neighbors are alike")
    show_locks: BoolProperty(name="Locks")
    image: PointerProperty(name="Picture", type=bpy.types.Image, description="A picture of the preview's ball")


# --- operators: what goes wrong is said in Blender's error bar ---


class Work:
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context):
        try:
            self.work(context, context.scene.taste)
        except (RuntimeError, OSError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return {"FINISHED"}


class TASTE_OT_gallery(Work, bpy.types.Operator):
    """The materials whose stars would teach most"""
    bl_idname, bl_label = "taste.gallery", "Next gallery"

    def work(self, context, t):
        renderer()
        x = taste.gallery(learn(t), M, t.count, t.asked + 1, *box(t))
        t.asked += 1
        show(t, x)


class TASTE_OT_score(Work, bpy.types.Operator):
    """Stars of this material; none: the cross"""
    bl_idname, bl_label = "taste.score", "Stars"
    index: IntProperty()
    score: IntProperty(min=0, max=5)

    def work(self, context, t):
        if not 0 <= self.index < len(t.gallery):
            raise RuntimeError("The gallery has no material %d" % self.index)
        item = t.gallery[self.index]
        item.score = self.score
        t.answers[answer(t, item.x)].score = self.score


class TASTE_OT_best(Work, bpy.types.Operator):
    """The marked materials are better than the others of this gallery (mark two, say)"""
    bl_idname, bl_label = "taste.best", "Best of these"

    def work(self, context, t):
        best = [answer(t, i.x) for i in t.gallery if i.best]
        rest = [answer(t, i.x) for i in t.gallery if not i.best]
        if not best or not rest:
            raise RuntimeError("Mark some of the materials, not all")
        for b in best:
            for r in rest:
                pair = t.pairs.add()
                pair.better, pair.worse = b, r
        for i in t.gallery:
            i.best = False


class TASTE_OT_recommend(Work, bpy.types.Operator):
    """Materials to your taste, as assets of this file and as the next gallery"""
    bl_idname, bl_label = "taste.recommend", "Recommend"

    def work(self, context, t):
        x, mean = learnt(t).recommend(t.count, t.quality, 0.3, t.asked + 1, *box(t))
        pictures = renderer().pictures(x)
        t.asked += 1
        for row, score, picture in zip(x, mean, pictures):
            material = bpy.data.materials.new("Taste")
            preview.write(material, row)
            material.asset_mark()
            material.asset_data.description = "predicted: %.1f of 5 stars" % min(max(score, 0), 5)
            material.asset_data.tags.new("taste")
            paint(material.preview_ensure(), picture)
        show(t, x)
        self.report({"INFO"}, "%d materials, see the Asset Browser" % len(x))


class TASTE_OT_variants(Work, bpy.types.Operator):
    """Variants, from the most similar to the best by your taste; without an index, of the active material"""
    bl_idname, bl_label = "taste.variants", "Variants"
    index: IntProperty(default=-1)

    def work(self, context, t):
        if self.index >= len(t.gallery):
            raise RuntimeError("The gallery has no material %d" % self.index)
        x = preview.read(active_material(context)) if self.index < 0 else list(t.gallery[self.index].x)
        model, (low, high) = learnt(t), box(t)
        near = model.recommend(40, t.quality, 0, 1, low, high)[0]
        laid_out = taste.Plane(np.vstack([np.clip(x, low, high), near]), low, high)
        show(t, np.vstack([x, laid_out.variants(model, renderer(), x, max(2, t.count - 1))]))


class TASTE_OT_use(Work, bpy.types.Operator):
    """Puts this material on the active object"""
    bl_idname, bl_label = "taste.use", "Use"
    index: IntProperty()

    def work(self, context, t):
        if not 0 <= self.index < len(t.gallery):
            raise RuntimeError("The gallery has no material %d" % self.index)
        if context.object is None or not hasattr(context.object.data, "materials"):
            raise RuntimeError("The active object takes no material")
        material = bpy.data.materials.new("Taste")
        preview.write(material, t.gallery[self.index].x)
        paint(material.preview_ensure(), renderer().pictures([t.gallery[self.index].x])[0])
        if context.object.data.materials:
            context.object.active_material = material
        else:
            context.object.data.materials.append(material)


class TASTE_OT_paint(Work, bpy.types.Operator):
    """The picture of this material as an image, to paint on and to match"""
    bl_idname, bl_label = "taste.paint", "Paint"
    index: IntProperty()

    def work(self, context, t):
        if not 0 <= self.index < len(t.gallery):
            raise RuntimeError("The gallery has no material %d" % self.index)
        size = renderer().size
        t.image = bpy.data.images.new("Taste", size, size)
        paint(t.image, renderer().pictures([t.gallery[self.index].x])[0])
        t.image.pack()
        self.report({"INFO"}, "Paint on '%s' in the Image Editor, then match it" % t.image.name)


class TASTE_OT_match(Work, bpy.types.Operator):
    """The material whose picture is nearest"""
    bl_idname, bl_label = "taste.match", "Match"
    source: EnumProperty(items=(("IMAGE", "Picture", "The chosen image"),
                                ("RENDER", "Render", "The last render: its render region, or its middle")))

    def work(self, context, t):
        image = t.image if self.source == "IMAGE" else bpy.data.images.get("Render Result")
        if image is None:
            raise RuntimeError("Choose a picture" if self.source == "IMAGE" else "There is no render")
        picture = read_picture(image, renderer().size, context.scene)
        x, found, rmse = renderer().match(picture, None, *box(t))
        show(t, [x])
        self.report({"INFO"}, "%.1f dB from the picture" % (-20 * np.log10(max(rmse, 1e-6))))


class TASTE_OT_large(bpy.types.Operator):
    """The gallery in a window of its own"""
    bl_idname, bl_label = "taste.large", "Large gallery"

    def invoke(self, context, event):
        return context.window_manager.invoke_popup(self, width=680)

    def execute(self, context):
        return {"FINISHED"}

    def draw(self, context):
        draw_all(self, context, 5)


class TASTE_OT_forget(Work, bpy.types.Operator):
    """Forgets all stars and comparisons of this scene"""
    bl_idname, bl_label = "taste.forget", "Forget all"

    def work(self, context, t):
        for collection in (t.gallery, t.answers, t.pairs):
            collection.clear()


# --- the panel ---


def draw_gallery(layout, t, columns):
    ids = icons("gallery", [tuple(i.x) for i in t.gallery])
    grid = layout.grid_flow(row_major=True, columns=columns, even_columns=True)
    for k, (item, icon) in enumerate(zip(t.gallery, ids)):
        cell = grid.box().column(align=True)
        cell.template_icon(icon, scale=5)  # 100 pixels
        row = cell.row(align=True)
        for score in range(6):
            symbol = "X" if score == 0 else "SOLO_ON" if score <= item.score else "SOLO_OFF"
            button = row.operator("taste.score", text="", icon=symbol, emboss=score == 0,
                                  depress=item.score == 0 == score)
            button.index, button.score = k, score
        row = cell.row(align=True)
        row.prop(item, "best", text="", icon="FUND")
        row.operator("taste.use", text="", icon="MATERIAL").index = k
        row.operator("taste.variants", text="", icon="PARTICLES").index = k
        row.operator("taste.paint", text="", icon="BRUSH_DATA").index = k


def draw_all(self, context, columns):
    layout, t = self.layout, context.scene.taste
    buttons = layout.column(align=True) if columns < 3 else layout.row(align=True)
    buttons.prop(t, "count")
    buttons.prop(t, "quality")
    buttons.operator("taste.gallery", icon="FILE_REFRESH")
    buttons.operator("taste.recommend", icon="ASSET_MANAGER")
    buttons.operator("taste.best", icon="FUND")
    try:
        draw_gallery(layout, t, columns)
    except (RuntimeError, OSError) as error:
        layout.label(text=str(error), icon="ERROR")


class TASTE_PT_panel(bpy.types.Panel):
    bl_label, bl_category = "Material taste", "Taste"
    bl_space_type, bl_region_type = "VIEW_3D", "UI"

    def draw(self, context):
        width = context.region.width / context.preferences.system.ui_scale
        draw_all(self, context, max(1, int(width - 40) // 120))
        try:
            self.more(context.scene.taste)
        except (RuntimeError, OSError) as error:
            self.layout.label(text=str(error), icon="ERROR")

    def more(self, t):
        layout = self.layout
        layout.operator("taste.large", icon="WINDOW")
        layout.operator("taste.variants", text="Variants of active", icon="PARTICLES").index = -1
        layout.label(text="%d stars given, %d comparisons" % (sum(a.score >= 0 for a in t.answers), len(t.pairs)))

        layout.prop(t, "show_locks", icon="LOCKED")
        if t.show_locks:
            column = layout.column(align=True)
            for k, name in enumerate(preview.NAMES):
                row = column.row(align=True)
                row.prop(t, "locked", index=k, text="", icon="LOCKED" if t.locked[k] else "UNLOCKED")
                row.prop(t, "value", index=k, text=name.capitalize(), slider=True)
        layout.prop(t, "show_plane", icon="WORLD")
        if t.show_plane:
            where = [((c + 0.5) / MAP, 1 - (r + 0.5) / MAP) for r in range(MAP) for c in range(MAP)]
            layout.template_icon(icons("map", at(t, where), MAP)[0], scale=12)
            row = layout.row(align=True)
            row.prop(t, "walk", index=0, text="Right", slider=True)
            row.prop(t, "walk", index=1, text="Up", slider=True)
        layout.template_ID(t, "image", open="image.open")
        row = layout.row(align=True)
        row.operator("taste.match", text="Match picture").source = "IMAGE"
        row.operator("taste.match", text="Match render").source = "RENDER"
        layout.operator("taste.forget", icon="TRASH")


CLASSES = (TasteItem, TasteAnswer, TastePair, TasteState, TASTE_OT_gallery, TASTE_OT_score, TASTE_OT_best,
           TASTE_OT_recommend, TASTE_OT_variants, TASTE_OT_use, TASTE_OT_paint, TASTE_OT_match, TASTE_OT_large,
           TASTE_OT_forget, TASTE_PT_panel)


def register():
    for c in CLASSES:
        bpy.utils.register_class(c)
    bpy.types.Scene.taste = PointerProperty(type=TasteState)


def unregister():
    for name in ("gallery icons", "map icons"):
        if name in kept:
            bpy.utils.previews.remove(kept[name])
    kept.clear()
    del bpy.types.Scene.taste
    for c in reversed(CLASSES):
        bpy.utils.unregister_class(c)
