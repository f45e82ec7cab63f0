"""Material taste: score galleries, get materials that you like. The panel and its operators; taste.py learns and draws,
preview.py knows Blender's sockets, library.py the materials of the file, overlay.py is the plane in the viewport.
Everything that is kept is in scene.taste, so Blender saves and undoes it."""
import os
import tempfile
import textwrap

import bpy
import bpy.utils.previews
import numpy as np
from bpy.props import (BoolProperty, BoolVectorProperty, CollectionProperty, EnumProperty, FloatProperty,
                       FloatVectorProperty, IntProperty, PointerProperty, StringProperty)

from . import library, overlay, preview, taste

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
# Answers before which there is no recommendation, and stars after which it hardly gets better: with 12, 24, 36, 48, 60
# stars, 12 recommended materials had 1.0, 3.0, 4.7, 4.3, 4.2 of 5 true stars (golden polished metal, mean of 6).
EARLY, WANTED = 24, 60
LARGE = 1000  # width of the large gallery
LOCKS = ("color", "metallic", "roughness", "transmission", "ior")

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
    value = np.array((*t.color, *(preview.unit(name, getattr(t, name)) for name in LOCKS[1:])))
    locked = np.repeat(t.locked, (3, 1, 1, 1, 1))
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
    """A new gallery; what was given stars before shows them."""
    known = {tuple(a.x): int(a.score) for a in t.answers}
    t.gallery.clear()
    for row in x:
        item = t.gallery.add()
        item.x = row
        item.score = known.get(tuple(item.x), -1)


def shown(t, index):
    if not 0 <= index < len(t.gallery):
        raise RuntimeError("The gallery has no material %d" % index)
    return t.gallery[index]


def answer(t, x):
    """The row of a material among the answers, a new one where it was not asked about before."""
    for k, a in enumerate(t.answers):
        if tuple(a.x) == tuple(x):
            return k
    t.answers.add().x = x
    return len(t.answers) - 1


def stars(t):
    return sum(a.score >= 0 for a in t.answers)


def advice(t):
    """What to do next."""
    if not t.gallery and not t.answers:
        return "Start with Next gallery: materials to give stars to."
    if len(t.answers) < EARLY:
        return "Give each material stars, then press Next gallery."
    if len(t.answers) < WANTED:
        return "Recommend works from now on; more stars make it surer."
    return "Press Recommend: materials to your taste."


def icons(name, key, make):
    """Icons of the pictures that make() answers, when the key is another than before."""

    def draw():
        collection = name + " icons"
        if collection not in kept:
            kept[collection] = bpy.utils.previews.new()
        kept[collection].clear()
        ids = []
        for k, picture in enumerate(make()):
            icon = kept[collection].new(str(k))
            library.paint(icon, picture)
            ids.append(icon.icon_id)
        return ids

    return once(name, key, draw)


def plane_picture(t):
    """The plane's materials, MAP x MAP squared in one picture."""
    where = [((c + 0.5) / MAP, 1 - (r + 0.5) / MAP) for r in range(MAP) for c in range(MAP)]
    x = at(t, where)

    def draw():
        pictures = renderer().pictures(x)
        return np.vstack([np.hstack(pictures[r * MAP:(r + 1) * MAP]) for r in range(MAP)])

    return once("plane picture", x.tobytes(), draw)


def with_mark(picture, where):
    """The picture with a ring at a place (from 0 to 1, from the bottom left): white, black around it."""
    height, width = picture.shape[:2]
    y, x = np.mgrid[:height, :width] + 0.5
    far = np.hypot(x - where[0] * width, y - (1 - where[1]) * height) / width
    picture = picture.copy()
    picture[(far > 0.018) & (far < 0.046)] = 0
    picture[(far > 0.024) & (far < 0.040)] = 1
    return picture


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
    """The walk in the plane sets the active object's material: its own copy, which the add-on made."""
    try:
        library.walk(context.object, at(t, [t.walk])[0])
    except RuntimeError:  # the panel says it: a property has no error bar
        pass


def locked(t, context):
    """A parameter that becomes locked has the value of the active material."""
    try:
        x = preview.read(active_material(context))
        if t.locked[0] and not t.was_locked[0]:
            t.color = x[:3]
        for k, name in enumerate(LOCKS[1:], 1):
            if t.locked[k] and not t.was_locked[k]:
                setattr(t, name, preview.value(name, x[2 + k]))
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
    said: StringProperty(description="What the last button did")
    quality: FloatProperty(name="Quality", default=0.7, min=0.1, max=0.95, subtype="FACTOR",
                           description="Low: more variety. High: the best alone")
    count: IntProperty(name="Count", default=12, min=1, max=200)
    locked: BoolVectorProperty(name="Lock", size=len(LOCKS), update=locked,
                               description="Keep this value in all that is made")
    was_locked: BoolVectorProperty(size=len(LOCKS))
    color: FloatVectorProperty(name="Base Color", size=3, default=(0.5,) * 3, min=0, max=1, subtype="COLOR")
    metallic: FloatProperty(name="Metallic", default=0, min=0, max=1, subtype="FACTOR")
    roughness: FloatProperty(name="Roughness", default=0.5, min=0, max=1, subtype="FACTOR")
    transmission: FloatProperty(name="Transmission", default=0, min=0, max=1, subtype="FACTOR")
    ior: FloatProperty(name="IOR", default=1.45, min=preview.LOW[6], max=preview.HIGH[6], precision=3, step=1)
    walk: FloatVectorProperty(name="Walk", size=2, default=(0.5, 0.5), min=0, max=1, step=1, update=walked,
                              description="A place in the plane of what you like. The active object gets a material "
                              "of its own for it; yours is kept")
    image: PointerProperty(name="Picture", type=bpy.types.Image, description="A picture of the preview's ball")


# --- operators: what they did stands in the panel, what goes wrong in Blender's error bar ---


class Work:
    bl_options = {"UNDO"}
    level = "INFO"

    def execute(self, context):
        t = context.scene.taste
        try:
            t.said = self.work(context, t) or ""
        except (RuntimeError, OSError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        if t.said:
            self.report({self.level}, t.said)
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
        item = shown(t, self.index)
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
        return "Taken: %d better than the other %d." % (len(best), len(rest))


class TASTE_OT_recommend(Work, bpy.types.Operator):
    """Materials to your taste, as assets of this file (catalog Taste) and as the next gallery"""
    bl_idname, bl_label = "taste.recommend", "Recommend"

    def work(self, context, t):
        model = learnt(t)
        if len(t.answers) < EARLY or not t.pairs and len({a.score for a in t.answers}) < 2:
            return self.too_early(t)
        x, mean = model.recommend(t.count, t.quality, 0.3, t.asked + 1, *box(t))
        pictures = renderer().pictures(x)
        t.asked += 1
        for row, score, picture in zip(x, mean, pictures):
            library.asset(row, picture, "predicted: %.1f of 5 stars" % min(max(score, 0), 5))
        show(t, x)
        library.keep_catalog()
        return "%d materials, in the Asset Browser's catalog Taste." % len(x)

    def too_early(self, t):
        """Variants of the liked material instead: few answers tell nothing of the rest."""
        liked = max(t.answers, key=lambda a: a.score)
        if liked.score <= 0:
            if not t.pairs:
                raise RuntimeError("Too early, and no material has a star yet: give the ones that you like some")
            liked = t.answers[t.pairs[-1].better]
        x = tuple(liked.x)
        show(t, np.vstack([x, taste.variants(None, renderer(), x, max(1, t.count - 1), 0, *box(t), seed=t.asked + 1)]))
        t.asked += 1
        self.level = "WARNING"
        why = "%d of %d answers" % (len(t.answers), EARLY) if len(t.answers) < EARLY else "all have the same stars"
        return "Too early to recommend: %s. Here are variants of the one that you like best." % why


class TASTE_OT_variants(Work, bpy.types.Operator):
    """Variants, from the most similar to the best by your taste; without an index, of the active material"""
    bl_idname, bl_label = "taste.variants", "Variants"
    index: IntProperty(default=-1)

    def work(self, context, t):
        x = preview.read(active_material(context)) if self.index < 0 else tuple(shown(t, self.index).x)
        model = learn(t) if len(t.answers) >= EARLY else None
        made = taste.variants(model, renderer(), x, max(1, t.count - 1), t.quality, *box(t))
        show(t, np.vstack([x, made]))
        if len(made) < t.count - 1:
            return "%d variants: there are no more that look different." % len(made)


class TASTE_OT_use(Work, bpy.types.Operator):
    """Puts this material on the selected objects"""
    bl_idname, bl_label = "taste.use", "Use"
    index: IntProperty()

    def work(self, context, t):
        x = tuple(shown(t, self.index).x)
        objects = library.takers(context)
        if not objects:
            raise RuntimeError("Select an object that takes a material")
        material = library.material(x, renderer().pictures([x])[0])
        for o in objects:
            library.put(o, material)
        return "%s: on %d object%s." % (material.name, len(objects), "s"[:len(objects) > 1])


class TASTE_OT_paint(Work, bpy.types.Operator):
    """The picture of this material as an image, to paint on and to match"""
    bl_idname, bl_label = "taste.paint", "Paint"
    index: IntProperty()

    def work(self, context, t):
        x, size = tuple(shown(t, self.index).x), renderer().size
        t.image = bpy.data.images.new(preview.describe(x), size, size)
        library.paint(t.image, renderer().pictures([x])[0])
        t.image["taste"] = t.image.name
        t.image.pack()
        return "Paint on '%s' in the Image Editor, then match it." % t.image.name


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
        if picture.std((0, 1)).max() < 0.02:  # the previews' least is 0.1: the floor
            raise RuntimeError("'%s' is of one color: it does not show the ball of the previews" % image.name)
        x, found, rmse = renderer().match(picture, None, *box(t))
        show(t, [x])
        decibels = -20 * np.log10(max(rmse, 1e-6))
        if decibels < 20:
            self.level = "WARNING"
            return "Only %.0f dB from '%s': does it show the ball of the previews, in their light?" % (decibels,
                                                                                                     image.name)
        return "%.1f dB from '%s'." % (decibels, image.name)


class TASTE_OT_walk(bpy.types.Operator):
    """Shows the plane in the viewport: drag in it, and the active object's material follows. Escape ends it"""
    bl_idname, bl_label = "taste.walk", "Walk in the viewport"

    def invoke(self, context, event):
        try:
            if not library.takers(context):
                raise RuntimeError("Select an object that takes a material")
            picture = plane_picture(context.scene.taste)
        except (RuntimeError, OSError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        self.dragging = False
        self.overlay = overlay.Overlay(context.area, picture, tuple(context.scene.taste.walk))
        context.window_manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        t, mouse = context.scene.taste, event.type == "LEFTMOUSE"
        if self.overlay.area not in context.screen.areas[:]:  # another workspace
            self.overlay.remove()
            return {"FINISHED", "PASS_THROUGH"}
        where = self.overlay.place(event.mouse_x, event.mouse_y)
        inside = 0 <= where[0] <= 1 and 0 <= where[1] <= 1
        if event.value == "PRESS" and (event.type in ("ESC", "RET", "RIGHTMOUSE") or mouse and not inside):
            self.overlay.remove()
            return {"FINISHED", "PASS_THROUGH"} if mouse else {"FINISHED"}
        if mouse and event.value == "PRESS":
            self.dragging = True
        if self.dragging and (mouse or event.type == "MOUSEMOVE"):
            t.walk = np.clip(where, 0, 1)
        if mouse and self.dragging and event.value == "RELEASE":
            self.dragging = False
            bpy.ops.ed.undo_push(message="Walk in the plane")
        self.overlay.show(tuple(t.walk))
        return {"RUNNING_MODAL"} if self.dragging or mouse else {"PASS_THROUGH"}


class TASTE_OT_large(bpy.types.Operator):
    """The gallery in a window of its own"""
    bl_idname, bl_label = "taste.large", "Large gallery"

    def invoke(self, context, event):
        return context.window_manager.invoke_props_dialog(self, width=LARGE)

    def execute(self, context):
        return {"FINISHED"}

    def draw(self, context):
        draw_top(self.layout, context, LARGE)
        draw_gallery(self.layout, context, LARGE)


class TASTE_OT_unused(Work, bpy.types.Operator):
    """Removes the materials of the add-on that no object uses. Those that you renamed or changed are yours, and stay"""
    bl_idname, bl_label = "taste.unused", "Remove unused"

    def work(self, context, t):
        return "Removed %d materials that no object uses." % library.remove_unused()


class TASTE_OT_forget(Work, bpy.types.Operator):
    """Forgets all stars and comparisons of this scene"""
    bl_idname, bl_label = "taste.forget", "Forget all stars"

    def work(self, context, t):
        for collection in (t.gallery, t.answers, t.pairs):
            collection.clear()


# --- the panel ---


def draw_text(layout, text, icon, width):
    """A sentence in as many lines as it needs: 7 pixels a letter."""
    column = layout.column(align=True)
    column.scale_y = 0.8
    for k, line in enumerate(textwrap.wrap(text, max(12, int((width - 60) / 7)))):
        column.label(text=line, icon=icon if k == 0 else "BLANK1")


def draw_top(layout, context, width):
    t = context.scene.taste
    row = layout.column() if width < 280 else layout.row()
    count = "%d of %d stars" % (stars(t), WANTED)
    if t.pairs:
        count += ", %d pairs" % len(t.pairs)
    row.label(text=count, icon="SOLO_ON")
    if width < LARGE:
        row.operator("taste.large", icon="WINDOW")
    draw_text(layout, advice(t), "INFO", width)
    wide = width > 500
    buttons = layout.row(align=True) if wide else layout.column(align=True)
    buttons.scale_y = 1.3
    buttons.operator("taste.gallery", icon="FILE_REFRESH")
    buttons.operator("taste.recommend", icon="ASSET_MANAGER")
    row = (buttons if wide else layout).row(align=True)
    row.prop(t, "count")
    row.prop(t, "quality")
    if t.said:
        draw_text(layout, t.said, "CHECKMARK", width)


def draw_gallery(layout, context, width):
    t = context.scene.taste
    if not t.gallery:
        return
    x = [tuple(i.x) for i in t.gallery]
    try:
        ids = icons("gallery", str(x), lambda: renderer().pictures(x))
    except (RuntimeError, OSError) as error:
        layout.label(text=str(error), icon="ERROR")
        return
    columns = 6 if width == LARGE else max(2, int(width - 40) // 120)
    roomy = width / columns > 135  # or there are words alone
    grid = layout.grid_flow(row_major=True, columns=columns, even_columns=True)
    for k, (item, icon) in enumerate(zip(t.gallery, ids)):
        cell = grid.box().column(align=True)
        cell.template_icon(icon, scale=7 if width == LARGE else 5 if roomy else 4)  # of 20 pixels
        row = cell.row(align=True)
        for score in range(6):
            symbol = "X" if score == 0 else "SOLO_ON" if score <= item.score else "SOLO_OFF"
            button = row.operator("taste.score", text="", icon=symbol, emboss=score == 0,
                                  depress=item.score == 0 == score)
            button.index, button.score = k, score
        four = cell.grid_flow(row_major=True, columns=2, even_columns=True, align=True)
        four.prop(item, "best", text="Best", toggle=True,
                  icon="NONE" if not roomy else "FUND" if item.best else "HEART")
        four.operator("taste.use", icon="MATERIAL" if roomy else "NONE").index = k
        four.operator("taste.variants", text="Vary", icon="PARTICLES" if roomy else "NONE").index = k
        four.operator("taste.paint", icon="BRUSH_DATA" if roomy else "NONE").index = k
    marked = sum(i.best for i in t.gallery)
    row = layout.row()
    row.enabled = 0 < marked < len(t.gallery)
    row.operator("taste.best", text="Best of these: %d marked" % marked, icon="FUND")


class Panel:
    bl_space_type, bl_region_type, bl_category = "VIEW_3D", "UI", "Taste"

    def width(self, context):
        """Of the sidebar, in pixels of a usual screen."""
        return context.region.width / context.preferences.system.ui_scale


class TASTE_PT_panel(Panel, bpy.types.Panel):
    bl_label = "Material taste"

    def draw(self, context):
        draw_top(self.layout, context, self.width(context))


class TASTE_PT_locks(Panel, bpy.types.Panel):
    bl_label, bl_parent_id, bl_options = "Locks", "TASTE_PT_panel", {"DEFAULT_CLOSED"}

    def draw(self, context):
        t, column = context.scene.taste, self.layout.column(align=True)
        for k, name in enumerate(LOCKS):
            row = column.row(align=True)
            row.prop(t, "locked", index=k, text="", icon="LOCKED" if t.locked[k] else "UNLOCKED")
            value = row.row(align=True)
            value.active = t.locked[k]
            if name == "color":
                value.label(text="Base Color")
                value.prop(t, name, text="")
            else:
                value.prop(t, name)


class TASTE_PT_plane(Panel, bpy.types.Panel):
    bl_label, bl_parent_id, bl_options = "Plane of what you like", "TASTE_PT_panel", {"DEFAULT_CLOSED"}

    def draw(self, context):
        t, layout = context.scene.taste, self.layout
        try:
            picture = plane_picture(t)
        except (RuntimeError, OSError) as error:
            draw_text(layout, str(error), "ERROR", self.width(context))
            return
        icon = icons("plane", (id(picture), tuple(t.walk)), lambda: [with_mark(picture, t.walk)])
        layout.template_icon(icon[0], scale=min(16, (self.width(context) - 60) / 20))
        layout.operator("taste.walk", icon="MOUSE_LMB_DRAG")
        row = layout.row(align=True)
        row.prop(t, "walk", index=0, text="Right", slider=True)
        row.prop(t, "walk", index=1, text="Up", slider=True)


class TASTE_PT_match(Panel, bpy.types.Panel):
    bl_label, bl_parent_id, bl_options = "Match a picture", "TASTE_PT_panel", {"DEFAULT_CLOSED"}

    def draw(self, context):
        layout = self.layout
        layout.template_ID(context.scene.taste, "image", open="image.open")
        row = layout.row(align=True)
        row.operator("taste.match", text="Match picture").source = "IMAGE"
        row.operator("taste.match", text="Match render").source = "RENDER"


class TASTE_PT_file(Panel, bpy.types.Panel):
    bl_label, bl_parent_id, bl_options = "Materials of the file", "TASTE_PT_panel", {"DEFAULT_CLOSED"}

    def draw(self, context):
        layout = self.layout
        layout.operator("taste.variants", text="Variants of the active material", icon="PARTICLES").index = -1
        layout.operator("taste.unused", icon="ORPHAN_DATA")
        layout.operator("taste.forget", icon="TRASH")


class TASTE_PT_gallery(Panel, bpy.types.Panel):
    bl_label, bl_parent_id = "Gallery", "TASTE_PT_panel"

    def draw(self, context):
        draw_gallery(self.layout, context, self.width(context))


CLASSES = (TasteItem, TasteAnswer, TastePair, TasteState, TASTE_OT_gallery, TASTE_OT_score, TASTE_OT_best,
           TASTE_OT_recommend, TASTE_OT_variants, TASTE_OT_use, TASTE_OT_paint, TASTE_OT_match, TASTE_OT_walk,
           TASTE_OT_large, TASTE_OT_unused, TASTE_OT_forget, TASTE_PT_panel, TASTE_PT_locks, TASTE_PT_plane,
           TASTE_PT_match, TASTE_PT_file, TASTE_PT_gallery)


@bpy.app.handlers.persistent
def saved(*_):
    library.keep_catalog()


def register():
    for c in CLASSES:
        bpy.utils.register_class(c)
    bpy.types.Scene.taste = PointerProperty(type=TasteState)
    bpy.app.handlers.save_post.append(saved)


def unregister():
    if saved in bpy.app.handlers.save_post:
        bpy.app.handlers.save_post.remove(saved)
    for value in kept.values():
        if isinstance(value, bpy.utils.previews.ImagePreviewCollection):
            bpy.utils.previews.remove(value)
    kept.clear()
    del bpy.types.Scene.taste
    for c in reversed(CLASSES):
        bpy.utils.unregister_class(c)
