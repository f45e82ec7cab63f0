"""examples/web/babylon.html as somebody opens it, in headless Chromium with a local Babylon.js (BABYLON=1 make deps), and what its two
passes leave of light whose scattering is known: python3 tests/babylon.py OUT"""
import os, re, subprocess, sys
import browser

root = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
packages = os.path.join(os.path.expanduser(os.environ.get("MS_PACKAGES") or "~/.cache/ms/npm"), "node_modules")
local = os.path.join(packages, "babylonjs", "babylon.js")
out = os.path.abspath(sys.argv[1])
passed = failed = 0


def check(name, good, what=""):
    global passed, failed
    passed, failed = passed + bool(good), failed + (not good)
    if not good:
        print("FAIL %s: %s" % (name, what))


os.makedirs(out, exist_ok=True)
os.chdir(root)
now = subprocess.run(["sh", "examples/web/build.sh", "hash", "babylon"], capture_output=True, text=True).stdout.strip()
for name in ("babylon.html", "sss_babylon.js"):
    made = re.search(r"sources (\d+)", open("examples/web/" + name).read(300)).group(1)
    check(name + ": of these sources (make web renews it)", made == now, (made, now))
page, module = open("examples/web/babylon.html").read(), open("examples/web/sss_babylon.js").read()
address = "https://cdn.jsdelivr.net/npm/babylonjs@9.35.0/babylon.js"
check("one script from elsewhere, and its own beside it", re.findall(r'<script src="([^"]*)"', page) == [address, "sss_babylon.js"])
check("the module holds the shader file", open("examples/engine/shader/ms_sss.glsl").read() in module)
if not browser.find():
    print("%d passed, %d failed, 1 skipped\nno Chromium on this machine" % (passed, failed))
    sys.exit(failed > 0)


def copy(name, engine):
    with open("%s/%s.html" % (out, name), "w") as f:
        f.write(page.replace(address, engine).replace('src="sss_babylon.js"', 'src="file://%s/examples/web/sss_babylon.js"' % root))
    return "%s/%s.html?by=1&draws=1" % (out, name)


message = "(document.getElementById('message') || {}).textContent"
with browser.Browser(out) as b:
    b.open(copy("alone", "nowhere.js"), 400, 800)
    b.until("/network/.test(%s)" % message, 60)
    check("without a network the page says what is missing", "Babylon.js 9.35 was not loaded" in b.value(message), b.value(message))
if not os.path.exists(local):
    print("%d passed, %d failed, 1 skipped\nno Babylon.js on this machine (BABYLON=1 make deps)" % (passed, failed))
    sys.exit(failed > 0)
with browser.Browser(out) as b:
    b.open(copy("babylon", "file://" + local), 400, 800)
    b.until("window.view && (view.ready || view.refused)", 600)
    check("drawn without a complaint", b.problems == [] and b.value("view.ready"), (b.problems[:5], b.value(message)))
    if b.value("view.ready"):
        # The first three figures of the page: unfiltered light, Babylon's pass where its lengths are best, ours. Of the head 19.5, 16.4 and
        # 11.0, of the knot 9.2, 5.9 and 5.6 when this was written; what must hold is their order, and that ours is nearer by a margin.
        r = b.value("view.measured")
        for i, name in enumerate(("head", "knot")):
            check(name + ": ours is nearer to the walk than Babylon's, which is nearer than no filter", r["ours"][i] < r["theirs"][i] < 0.95 * r["none"][i], r)
        check("the head: two thirds of Babylon's error, or a little more", r["ours"][0] < 0.75 * r["theirs"][0], r)
        check("the best scale lies within those tried", all(0.26 < s < 7.9 for s in r["scale"]), r)
        check("times stand in the page", b.value("view.time.ours > 0 && view.time.theirs > 0 && /times ours/.test(document.getElementById('timing').textContent)"))
        picture = "(view.sss.enabled = %s, view.scene.render(), view.scene.render(), document.getElementById('view').toDataURL())"
        ours, theirs = b.value(picture % "true"), b.value(picture % "false")
        check("another picture by ours", ours != theirs)
        check("and the same when it comes back", b.value(picture % "true") == ours)
        b.value("view.scene.materials.forEach(m => { m.subSurface.isScatteringEnabled = false; }), 1")
        check("both scatter", b.value(picture % "true") not in (ours, theirs))
        said = b.value("(() => { try { view.sss.apply(new BABYLON.StandardMaterial('', view.scene), 0); return ''; } catch (e) { return e.message; } })()")
        check("refuses a material that it does not know", said.startswith("BabylonSubsurface: wants"), said)
    b.picture(out + "/babylon.png", True)
print("%d passed, %d failed" % (passed, failed))
sys.exit(failed > 0)
