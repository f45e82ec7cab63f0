"""The preview scene of Blender's Principled BSDF: a ball on a checkered floor, the studio light of the user's own
Blender without its color, and a key light; and a material from its parameters. Runs inside Blender.

A material is x [7] in [0, 1]: red, green and blue of the base color (linear), metallic, roughness, transmission and
IOR (1.05 to 2). The preview shows the other sockets too little to learn them from it (specular, clearcoat, sheen and
anisotropy move it by less than 0.01): they keep what the material has."""
import colorsys
import os

import bpy
from mathutils import Vector

NAMES = ("red", "green", "blue", "metallic", "roughness", "transmission", "ior")
LOW = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.05)
HIGH = (1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 2.0)
# Blender 4.0 renamed sockets; the first name that a version has is taken.
SOCKETS = {
    "metallic": ("Metallic",),
    "roughness": ("Roughness",),
    "transmission": ("Transmission", "Transmission Weight"),
    "ior": ("IOR",),
}
# The hue in degrees up to which a color has the name.
HUES = (("red", 15), ("orange", 42), ("yellow", 68), ("green", 165), ("cyan", 195), ("blue", 255), ("violet", 290),
        ("pink", 345), ("red", 361))


def principled(material):
    """The material's Principled BSDF, or None."""
    if not material.use_nodes:
        material.use_nodes = True
    return next((n for n in material.node_tree.nodes if n.type == "BSDF_PRINCIPLED"), None)


def socket(node, name):
    if name in ("red", "green", "blue"):
        return node.inputs["Base Color"]
    return next(node.inputs[s] for s in SOCKETS[name] if s in node.inputs)


def describe(x):
    """A material's name: "Polished orange metal"."""
    shown = [12.92 * v if v < 0.0031308 else 1.055 * v**(1 / 2.4) - 0.055 for v in x[:3]]
    hue, saturation, brightness = colorsys.rgb_to_hsv(*shown)
    if saturation < 0.2 or brightness < 0.2:
        color = "black" if brightness < 0.25 else "gray" if brightness < 0.85 else "white"
    else:
        color = next(name for name, end in HUES if 360 * hue < end)
        if brightness < 0.6:
            color = "brown" if color == "orange" else "dark " + color
    kind = "metal" if x[3] > 0.5 else "glass" if x[5] > 0.5 else "plastic"
    finish = "polished" if x[4] < 0.2 else "satin" if x[4] < 0.5 else "rough"
    return ("clear" if finish == "polished" and kind == "glass" else finish).capitalize() + " %s %s" % (color, kind)


def value(name, x):
    k = NAMES.index(name)
    return LOW[k] + (HIGH[k] - LOW[k]) * float(min(max(x, 0.0), 1.0))


def unit(name, v):
    """The inverse: a socket's value as a parameter from 0 to 1."""
    k = NAMES.index(name)
    return min(max((v - LOW[k]) / (HIGH[k] - LOW[k]), 0.0), 1.0)


def write(material, x):
    """Sets the sockets of a material from x."""
    node = principled(material)
    if node is None:
        raise RuntimeError("'%s' has no Principled BSDF" % material.name)
    node.inputs["Base Color"].default_value = (value("red", x[0]), value("green", x[1]), value("blue", x[2]), 1.0)
    for name, v in zip(NAMES[3:], x[3:]):
        socket(node, name).default_value = value(name, v)
    material.diffuse_color = (value("red", x[0]), value("green", x[1]), value("blue", x[2]), 1.0)
    material.metallic, material.roughness = value("metallic", x[3]), value("roughness", x[4])


def read(material):
    """x of a material. A socket that a texture drives is refused by its name: its value is not what is seen."""
    node = principled(material)
    if node is None:
        raise RuntimeError("'%s' has no Principled BSDF" % material.name)
    x = []
    for k, name in enumerate(NAMES):
        s = socket(node, name)
        if s.is_linked:
            raise RuntimeError("'%s': %s comes from another node" % (material.name, s.name))
        x.append(unit(name, s.default_value[k] if k < 3 else s.default_value))
    return x


def studio_light():
    """The gray-balanced studio picture that every Blender brings along for its viewport."""
    for kind in ("SYSTEM", "LOCAL"):
        path = os.path.join(bpy.utils.resource_path(kind), "datafiles", "studiolights", "world", "studio.exr")
        if os.path.exists(path):
            return path
    path = "/usr/share/blender/datafiles/studiolights/world/studio.exr"  # Debian's package
    if os.path.exists(path):
        return path
    raise RuntimeError("this Blender has no datafiles/studiolights/world/studio.exr")


def build(size=64, samples=32, threads=1):
    """An empty file with the scene: (scene, material of the ball). Renders by Cycles, linear light."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.render.resolution_x = scene.render.resolution_y = size
    scene.render.resolution_percentage = 100
    scene.render.use_persistent_data = True
    scene.render.threads_mode = "FIXED"
    scene.render.threads = threads
    scene.view_settings.view_transform = "Standard"
    cycles = scene.cycles
    cycles.device = "CPU"
    cycles.samples = samples
    cycles.use_adaptive_sampling = cycles.use_denoising = False
    cycles.max_bounces = 8
    cycles.sample_clamp_indirect = 8
    cycles.blur_glossy = 0.5

    world = bpy.data.worlds.new("studio")
    scene.world = world
    world.use_nodes = True
    tree = world.node_tree
    picture = tree.nodes.new("ShaderNodeTexEnvironment")
    picture.image = bpy.data.images.load(studio_light())
    gray = tree.nodes.new("ShaderNodeRGBToBW")
    background = tree.nodes["Background"]
    tree.links.new(picture.outputs[0], gray.inputs[0])
    tree.links.new(gray.outputs[0], background.inputs[0])
    world.cycles.sampling_method = "MANUAL"
    world.cycles.sample_map_resolution = 256

    bpy.ops.mesh.primitive_uv_sphere_add(segments=96, ring_count=48, radius=1, location=(0, 0, 1))
    bpy.ops.object.shade_smooth()
    material = bpy.data.materials.new("preview")
    material.use_nodes = True
    bpy.context.object.data.materials.append(material)

    bpy.ops.mesh.primitive_plane_add(size=40)
    floor = bpy.data.materials.new("floor")
    floor.use_nodes = True
    bpy.context.object.data.materials.append(floor)
    checker = floor.node_tree.nodes.new("ShaderNodeTexChecker")
    checker.inputs["Scale"].default_value = 60
    checker.inputs["Color1"].default_value = (0.5, 0.5, 0.5, 1)
    checker.inputs["Color2"].default_value = (0.12, 0.12, 0.12, 1)
    place = floor.node_tree.nodes.new("ShaderNodeTexCoord")
    node = principled(floor)
    node.inputs["Roughness"].default_value = 1
    floor.node_tree.links.new(place.outputs["Generated"], checker.inputs["Vector"])
    floor.node_tree.links.new(checker.outputs["Color"], node.inputs["Base Color"])

    light = bpy.data.lights.new("key", "AREA")
    light.size, light.energy = 1.5, 250
    key = bpy.data.objects.new("key", light)
    key.location = (-2.5, -2.5, 4.5)
    key.rotation_euler = (Vector((0, 0, 1)) - key.location).to_track_quat("-Z", "Y").to_euler()
    scene.collection.objects.link(key)

    lens = bpy.data.cameras.new("camera")
    lens.lens = 100
    camera = bpy.data.objects.new("camera", lens)
    camera.location = (0, -6.2, 2.6)
    camera.rotation_euler = (Vector((0, 0, 0.97)) - camera.location).to_track_quat("-Z", "Y").to_euler()
    scene.collection.objects.link(camera)
    scene.camera = camera
    return scene, material
