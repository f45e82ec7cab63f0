"""A square picture over the 3D Viewport, with a mark: drawn, and the mouse's place in it."""
import blf
import bpy
import gpu
import numpy as np
from gpu_extras.batch import batch_for_shader

NEW = bpy.app.version >= (4, 0, 0)  # names of the shaders


class Overlay:
    """picture [side][side][3], rows from the top, as displayed; mark from 0 to 1, from the bottom left. remove() takes
    it away."""

    def __init__(self, area, picture, mark):
        self.area = area
        self.region = next(r for r in area.regions if r.type == "WINDOW")
        tools = next((r.width for r in area.regions if r.type == "TOOLS"), 0)
        scale = bpy.context.preferences.system.ui_scale
        self.left, self.bottom = tools + 20 * scale, 40 * scale
        self.side = min(448 * scale, 0.6 * self.region.height, 0.6 * self.region.width)
        self.mark = mark
        pixels = np.ones((*picture.shape[:2], 4), np.float32)
        shown = picture[::-1]  # the viewport's buffer is in linear light
        pixels[:, :, :3] = np.where(shown < 0.04045, shown / 12.92, ((shown + 0.055) / 1.055)**2.4)
        height, width = picture.shape[:2]
        self.texture = gpu.types.GPUTexture((width, height), format="RGBA16F",
                                            data=gpu.types.Buffer("FLOAT", pixels.size, pixels.ravel()))
        self.handle = bpy.types.SpaceView3D.draw_handler_add(self.draw, (), "WINDOW", "POST_PIXEL")
        area.tag_redraw()

    def remove(self):
        bpy.types.SpaceView3D.draw_handler_remove(self.handle, "WINDOW")
        self.area.tag_redraw()

    def place(self, mouse_x, mouse_y):
        """The mouse (of the window) in the picture: from 0 to 1 from the bottom left, beyond that outside."""
        return ((mouse_x - self.region.x - self.left) / self.side, (mouse_y - self.region.y - self.bottom) / self.side)

    def show(self, mark):
        if mark != self.mark:
            self.mark = mark
            self.area.tag_redraw()

    def draw(self):
        if bpy.context.region != self.region:
            return
        gpu.state.blend_set("ALPHA")
        x0, y0, x1, y1 = self.left, self.bottom, self.left + self.side, self.bottom + self.side
        self.fill([(x0 - 2, y0 - 2), (x1 + 2, y0 - 2), (x1 + 2, y1 + 2), (x0 - 2, y1 + 2)], (0, 0, 0, 1))
        shader = gpu.shader.from_builtin("IMAGE" if NEW else "2D_IMAGE")
        batch = batch_for_shader(shader, "TRI_FAN", {"pos": ((x0, y0), (x1, y0), (x1, y1), (x0, y1)),
                                                     "texCoord": ((0, 0), (1, 0), (1, 1), (0, 1))})
        shader.bind()
        shader.uniform_sampler("image", self.texture)
        batch.draw(shader)

        x, y = x0 + self.mark[0] * self.side, y0 + self.mark[1] * self.side
        for inner, outer, color in ((7, 16, (0, 0, 0, 1)), (9, 14, (1, 1, 1, 1))):
            self.ring(x, y, inner, outer, color)
        font, scale = 0, bpy.context.preferences.system.ui_scale
        blf.position(font, x0, y0 - 20 * scale, 0)
        blf.color(font, 1, 1, 1, 1)
        blf.size(font, *((14 * scale,) if NEW else (int(14 * scale), 72)))
        blf.draw(font, "Drag: the active object's material follows.  Escape: done")
        gpu.state.blend_set("NONE")

    def fill(self, corners, color, kind="TRI_FAN"):
        shader = gpu.shader.from_builtin("UNIFORM_COLOR" if NEW else "2D_UNIFORM_COLOR")
        batch = batch_for_shader(shader, kind, {"pos": corners})
        shader.bind()
        shader.uniform_float("color", color)
        batch.draw(shader)

    def ring(self, x, y, inner, outer, color):
        circle = [(np.cos(a), np.sin(a)) for a in np.linspace(0, 2 * np.pi, 33)]
        self.fill([(x + r * c, y + r * s) for c, s in circle for r in (inner, outer)], color, "TRI_STRIP")
