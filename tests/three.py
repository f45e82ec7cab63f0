"""examples/web/three.html as somebody opens it, in headless Chromium without a network, and the passes of sss_three.js against
ms_sss_filter on the same light: python3 tests/three.py OUT"""
import array, base64, math, os, re, subprocess, sys
import browser

root = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
out = os.path.abspath(sys.argv[1])
passed = failed = 0


def check(name, good, what=""):
    global passed, failed
    passed, failed = passed + bool(good), failed + (not good)
    if not good:
        print("FAIL %s: %s" % (name, what))


os.makedirs(out, exist_ok=True)
os.chdir(root)
for name in ("three.html", "sss_three.js"):
    made = subprocess.run("sed -n 's/.*sources \\([0-9]*\\).*/\\1/p' examples/web/%s | head -1" % name, shell=True, capture_output=True, text=True).stdout.strip()
    now = subprocess.run(["sh", "examples/web/build.sh", "hash", "three"], capture_output=True, text=True).stdout.strip()
    check(name + ": of these sources (make web renews it)", made == now, (made, now))
page = open("examples/web/three.html").read()
check("three.js is in the page, with its license", "Copyright © 2010-2026 three.js authors" in page and "The above copyright notice and this permission notice shall be included" in page)
check("which asks for nothing else", not re.search(r'(src|href)="|importmap|https?://[^ ]*\.js', page))
module = open("examples/web/sss_three.js").read()
check("the module takes the program's own three.js", "import * as THREE from 'three';" in module and "export class Subsurface" in module)
if not browser.find():
    print("%d passed, %d failed, 1 skipped\nno Chromium on this machine" % (passed, failed))
    sys.exit(failed > 0)
compiler = os.environ.get("CC", "cc").split()
subprocess.run(compiler + ["-std=c99", "-O2", "-I.", "tests/three_filter.c", "-o", out + "/three_filter", "-lm"], check=True)

READ = """(() => { const t = view.sss['%s'], a = new Float32Array(4 * t.width * t.height);
view.sss.renderer.readRenderTargetPixels(t, 0, 0, t.width, t.height, a);
let s = ''; const b = new Uint8Array(a.buffer); for (let i = 0; i < b.length; i += 32768) s += String.fromCharCode(...b.subarray(i, i + 32768));
return [t.width, t.height, btoa(s)]; })()"""


def read(b, target):
    w, h, text = b.value(READ % target)
    return w, h, array.array("f", base64.b64decode(text))


def streaks(w, h, light, ours, theirs, lit):
    """In the dark, where unscattered light and depth bend little, taps show as a ripple, a fourth difference, along x: at half
    resolution less than half of it is left. All in all it differs in less than a quarter of what scattering moves."""
    row = range(-8, 12, 4)
    bend = lambda a, i: sum(f * a[i + d] for f, d in zip((1, -4, 6, -4, 1), row))
    inside = [4 * i for i in lit if 1 < i % w < w - 2]
    dark = [i for i in inside if all(light[i + d + 1] < 0.1 and light[i + d + 3] > 0 for d in row) and abs(bend(light, i + 3)) < 1e-3 * light[i + 3]]
    rms = lambda values: math.sqrt(sum(v * v for v in values) / len(dark))
    left, taps = (rms(bend(a, i + 1) for i in dark) for a in (ours, theirs))
    other, moved = (rms(a[4 * i + 1] - theirs[4 * i + 1] for i in lit) for a in (ours, light))
    return len(dark) > len(lit) / 10 and left < 0.5 * taps and other < moved / 4, (len(dark), left, taps, other, moved)


def compare(b, name, shift=(0, 0)):
    """The scattered light on the card against ms_sss_filter: 1e-4 of the brightest, room for 32-bit sums in another order."""
    w, h, light = read(b, "light")
    _, _, ours = read(b, "scattered")
    with open(out + "/in", "wb") as f:
        light.tofile(f)
    fov, mm, taps, radius = b.value("[360 / Math.PI * Math.atan(1 / view.camera.projectionMatrix.elements[5]), view.sss.mmPerUnit, view.sss.taps, view.sss.radius]")
    materials = b.value("view.sss.given.map(m => [...m.reflectance, ...m.path].join(' ')).join('\\n')")
    subprocess.run([out + "/three_filter"] + [repr(v) for v in (w, h, fov, mm, taps, radius, *shift)] + [out + "/in", out + "/out"], input=materials,
                   text=True, check=True)
    theirs = array.array("f")
    with open(out + "/out", "rb") as f:
        theirs.fromfile(f, 4 * w * h)
    top = max(max(max(light[c::4]), max(theirs[c::4])) for c in range(3))  # elevation lifts light above what came in
    lit = [i for i in range(w * h) if light[4 * i + 3] > 0]
    if b.value("view.sss.half"):
        check(name + ": near ms_sss_filter, with fewer streaks", *streaks(w, h, light, ours, theirs, lit))
        return w, h
    worst = max(abs(ours[4 * i + c] - theirs[4 * i + c]) for i in lit for c in range(3)) / top
    moved = max(abs(light[4 * i + c] - theirs[4 * i + c]) for i in lit for c in range(3)) / top
    check(name + ": as ms_sss_filter", len(lit) > w * h / 20 and worst < 1e-4 < 0.05 < moved, (len(lit), worst, moved))
    return w, h


picture = "(view.draw(), view.sss.renderer.domElement.toDataURL())"
with browser.Browser(out) as b:
    b.open("examples/web/three.html", 240, 135)
    b.until("window.view && view.ready", 60)
    check("240 x 135", compare(b, "240 x 135") == (240, 135))
    b.look(167, 151)
    b.until("view.sss.renderer.domElement.width === 167", 10)
    check("after a resize", compare(b, "after a resize") == (167, 151))
    whole = b.value(picture)
    b.value("document.getElementById('thin').click(), 1")
    thick = b.value(picture)
    check("a lamp shines through thin parts", thick != whole)
    b.value("document.getElementById('scatter').click(), 1")
    plain = b.value(picture)
    check("scattering changes the picture", plain != thick)
    b.value("document.getElementById('scatter').click(), document.getElementById('thin').click(), 1")
    check("and comes back", b.value(picture) == whole)
    for what, code in (("a material that it does not know", "view.sss.apply(new view.THREE.MeshBasicMaterial(), 0)"), ("an index that is not there", "view.sss.apply(new view.THREE.MeshStandardMaterial(), 2)")):
        said = b.value("(() => { try { %s; return ''; } catch (e) { return e.message; } })()" % code)
        check("refuses " + what, said.startswith("Subsurface: wants"), said)
    check("leaves the renderer's target and the scene's materials", b.value("view.sss.renderer.getRenderTarget() === null && view.scene.children.every(o => !o.material || o.material.isMeshStandardMaterial)"))
    check("no complaint on the console", b.problems == [], b.problems[:5])
    b.value("window.onerror('', '', 0, 0, new Error('no light')), 1")
    check("what goes wrong stands in the page", b.value("document.getElementById('message').textContent") == "no light")
    b.open("examples/web/three.html", 960, 620)
    b.until("window.view && view.ready", 60)
    check("a wide kernel: at half resolution", b.value("view.sss.half && view.sss.radius > 16"))
    compare(b, "960 x 620")
    check("no complaint on the console there", b.problems == [], b.problems[:5])
    b.picture(out + "/three.png")
print("%d passed, %d failed" % (passed, failed))
sys.exit(failed > 0)
