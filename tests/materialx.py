#!/usr/bin/env python3
"""Checks FOLDER/workflow.mtlx of build/workflow against the CSV files beside it: python3 tests/materialx.py FOLDER [READ.json]

READ.json: what another program read (tests/materialx.mjs), in place of the file's own text.
Well-formed, names unique, every material has its shader, every input is one of standard_surface with the type and range of its
node definition, and the closure has the lobes of the 19-parameter shader (design: share of diffuse, glossy, glass, translucent)."""
import csv, json, math, re, sys
import xml.etree.ElementTree as xml

# name: type, least, most; from the node definition ND_standard_surface_surfaceshader
INPUTS = {"base": ("float", 0, 1), "base_color": ("color3", 0, 1), "metalness": ("float", 0, 1), "specular": ("float", 0, 1),
          "specular_color": ("color3", 0, 1), "specular_roughness": ("float", 0, 1), "specular_IOR": ("float", 1, 3),
          "transmission": ("float", 0, 1), "transmission_color": ("color3", 0, 1), "transmission_depth": ("float", 0, 100),
          "transmission_extra_roughness": ("float", -1, 1), "subsurface": ("float", 0, 1), "subsurface_color": ("color3", 0, 1)}
folder = sys.argv[1]
root = xml.parse(folder + "/workflow.mtlx").getroot()
assert root.tag == "materialx" and root.get("version") == "1.38" and root.get("colorspace") == "lin_rec709", root.attrib
shaders, materials, names = {}, [], set()
for e in root:
    name = e.get("name")
    assert re.fullmatch("[A-Za-z_][A-Za-z0-9_]*", name) and name not in names, name
    names.add(name)
    if e.tag == "standard_surface":
        assert e.get("type") == "surfaceshader"
        shaders[name] = values = {}
        for i in e:
            kind, least, most = INPUTS[i.get("name")]
            v = [float(t) for t in i.get("value").split(",")]
            assert i.tag == "input" and i.get("type") == kind and len(v) == (3 if kind == "color3" else 1), (name, i.attrib)
            assert all(math.isfinite(t) and least <= t <= most for t in v) and i.get("name") not in values, (name, i.attrib)
            values[i.get("name")] = v if kind == "color3" else v[0]
        assert len(values) == len(INPUTS), name
    else:
        (i,) = e
        assert e.tag == "surfacematerial" and e.get("type") == "material" and i.get("type") == "surfaceshader", name
        materials.append((name, shaders[i.get("nodename")]))

if len(sys.argv) > 2:
    with open(sys.argv[2]) as f:
        read = json.load(f)["materials"]
    assert [name for name, _ in materials] == list(read) and all(read[name].keys() == s.keys() for name, s in materials)
    materials = list(read.items())
    shaders = read

rows = [[float(t) for t in r[:19]] for f in ("recommended", "chosen") for r in list(csv.reader(open("%s/%s.csv" % (folder, f))))[1:]]
assert len(rows) == len(materials) == 309 and len(shaders) == 309, (len(rows), len(materials))
for x, (name, s) in zip(rows, materials):
    assert all(0 <= v <= 1 for v in x), name
    d, g, t, l = (1 - x[17]) * (1 - x[7]), (1 - x[17]) * x[7], x[17] * (1 - x[16]), x[17] * x[16]
    m, tr, sub = s["metalness"], s["transmission"], s["subsurface"]
    ours = ((1 - m) * (1 - tr) * (1 - sub), m, (1 - m) * tr, (1 - m) * (1 - tr) * sub)
    # five digits here, six in the CSV; near g = 1 the rest is divided by a small number and multiplied by it again
    assert max(abs(a - b) for a, b in zip(ours, (d, g, t, l))) < 1e-4, (name, ours, (d, g, t, l))
    assert abs(s["specular_IOR"] - 1 - max(x[12], 0.01)) < 1e-4, name
    assert abs(s["specular_roughness"] + s["transmission_extra_roughness"] - x[11]) < 1e-4, name
    for c in range(3):  # a path through the middle of a ball of radius 1: in, two radii of 4 x18 each, out
        through = x[8 + c] ** 2 * math.exp(-2 * 4 * x[18])
        assert abs(s["transmission_color"][c] - max(through, 1e-4)) < 1e-4, name
        a = 4 * x[18]  # from wall to wall by Lambert's law, in and out through the color
        beer = sum(math.exp(-2 * a * math.sqrt((i + 0.5) / 100)) / 100 for i in range(100))
        assert abs(s["subsurface_color"][c] - x[13 + c] ** 2 * beer) < 5e-4, name
        low, high = sorted((x[c], x[3 + c]))
        assert low - 1e-4 <= s["base_color"][c] <= high + 1e-4, name
print("%d materials" % len(materials))
