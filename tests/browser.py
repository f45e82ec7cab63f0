"""A headless Chromium by its debugging pipe, as a person with a mouse: no package but Python's own.

    with Browser(folder) as b:
        b.open("page.html", 1600, 1000, dark=True)
        b.until("window.ready", 60)
        b.click("#button")
        b.value("1 + 1"); b.picture("shot.png"); b.problems
    b.tab("page.html")          another tab of the same browser; b.turn(SESSION) goes back
    b.dialogs                   what alert, confirm or a warning before leaving said; all are answered with yes
"""
import base64, json, os, select, shutil, signal, subprocess, tempfile, time

NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")


def find():
    return next((p for p in map(shutil.which, NAMES) if p), None)


class Browser:
    def __init__(self, folder):
        os.makedirs(folder, exist_ok=True)
        self.profile = tempfile.mkdtemp(dir=folder)
        held = [os.open(os.devnull, os.O_RDONLY)]
        while held[-1] < 5:  # 3 and 4 are to be nothing else
            held.append(os.open(os.devnull, os.O_RDONLY))
        theirs, self.out = os.pipe()  # they read at 3 and write at 4
        self.inp, answers = os.pipe()

        def places():
            os.dup2(theirs, 3)
            os.dup2(answers, 4)

        flags = ["--headless", "--no-sandbox", "--disable-gpu", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-quic",
                 "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync", "--hide-scrollbars",
                 "--disable-dev-shm-usage", "--allow-file-access-from-files", "--remote-debugging-pipe", "--user-data-dir=" + self.profile, "about:blank"]
        self.process = subprocess.Popen([find()] + flags, pass_fds=(3, 4), preexec_fn=places, start_new_session=True,
                                        stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        for fd in held + [theirs, answers]:
            os.close(fd)
        self.buffer, self.number, self.answers, self.problems, self.dialogs, self.session = b"", 0, {}, [], [], None
        self.attach()

    def attach(self):
        self.session = None
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log"):
            self.call(domain + ".enable")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        try:
            os.killpg(self.process.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
        self.process.wait()
        os.close(self.out)
        os.close(self.inp)
        shutil.rmtree(self.profile, ignore_errors=True)

    def send(self, method, session, **params):
        self.number += 1
        message = {"id": self.number, "method": method, "params": params}
        if session:
            message["sessionId"] = session
        os.write(self.out, json.dumps(message).encode() + b"\0")
        return self.number

    def call(self, method, **params):
        number = self.send(method, self.session, **params)
        end = time.monotonic() + 240
        while number not in self.answers:
            if not select.select([self.inp], [], [], max(0, end - time.monotonic()))[0]:
                raise TimeoutError(method)
            part = os.read(self.inp, 1 << 20)
            if not part:
                raise RuntimeError("the browser ended")
            self.buffer += part
            *whole, self.buffer = self.buffer.split(b"\0")
            for text in whole:
                self.heard(json.loads(text))
        answer = self.answers.pop(number)
        if "error" in answer:
            raise RuntimeError(method + ": " + answer["error"]["message"])
        return answer["result"]

    def heard(self, m):
        if "id" in m:
            self.answers[m["id"]] = m
            return
        p = m.get("params", {})
        if m["method"] == "Page.javascriptDialogOpening":
            self.dialogs.append(p["type"])
            self.send("Page.handleJavaScriptDialog", m.get("sessionId"), accept=True)
        if m["method"] == "Tracing.dataCollected":
            self.events += p["value"]
        if m["method"] == "Tracing.tracingComplete":
            self.traced = True
        if m["method"] == "Runtime.exceptionThrown":
            d = p["exceptionDetails"]
            self.problems.append(d.get("exception", {}).get("description", d["text"]))
        elif m["method"] == "Runtime.consoleAPICalled" and p["type"] in ("error", "warning", "assert"):
            self.problems.append(" ".join(str(a.get("value", a.get("description"))) for a in p["args"]))
        elif m["method"] == "Log.entryAdded" and p["entry"]["level"] == "error":
            self.problems.append(p["entry"]["text"])

    def look(self, width, height, dark=False):
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)
        self.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": "dark" if dark else "light"},
                                                            {"name": "prefers-reduced-motion", "value": "reduce"}])

    def open(self, path, width, height, dark=False):
        self.look(width, height, dark)
        self.call("Page.navigate", url="file://" + os.path.abspath(path.split("#")[0]) + path[len(path.split("#")[0]):])

    def tab(self, path, width, height):
        self.attach()
        self.open(path, width, height)
        return self.session

    def turn(self, session):
        self.session = session
        self.call("Page.bringToFront")

    def key(self, key, code=""):
        text = key if len(key) == 1 else "\r" if key == "Enter" else None
        self.call("Input.dispatchKeyEvent", type="keyDown", key=key, code=code or key, windowsVirtualKeyCode={"Tab": 9, "Enter": 13}.get(key, 0), **({"text": text} if text else {}))
        self.call("Input.dispatchKeyEvent", type="keyUp", key=key, code=code or key)

    def trace(self):
        self.events, self.traced = [], False
        self.call("Tracing.start", traceConfig={"includedCategories": ["toplevel", "__metadata"], "recordMode": "recordUntilFull"}, transferMode="ReportEvents")

    def tasks(self):
        """Processor time of each task of the page's own thread since trace(), in ms, the longest first: what may hold a frame up."""
        self.call("Tracing.end")
        while not self.traced:
            self.value("1")
        main = {(e["pid"], e["tid"]) for e in self.events if e.get("name") == "thread_name" and e["args"]["name"] == "CrRendererMain"}
        return sorted((e["tdur"] / 1000 for e in self.events if (e["pid"], e["tid"]) in main and "tdur" in e and e["name"].endswith("RunTask")), reverse=True)

    def value(self, expression):
        r = self.call("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in r:
            d = r["exceptionDetails"]
            raise RuntimeError(expression + ": " + d.get("exception", {}).get("description", d["text"]))
        return r["result"].get("value")

    def until(self, expression, seconds):
        end = time.monotonic() + seconds
        while True:
            try:
                value = self.value("!!(%s)" % expression)
            except RuntimeError as e:  # asked while the page was being loaded anew
                if "navigated" not in str(e):
                    raise
                value = None
            if value:
                return value
            if time.monotonic() > end:
                raise TimeoutError(expression)
            time.sleep(0.05)

    def place(self, expression):
        """Where the middle of an element is, scrolled into sight."""
        return self.value("(e => { e.scrollIntoView({block: 'center', behavior: 'instant'}); const r = e.getBoundingClientRect();"
                          "return [r.x + r.width / 2, r.y + r.height / 2, r.width, r.height]; })(%s)" % expression)

    def mouse(self, kind, x, y, pressed=False):
        self.call("Input.dispatchMouseEvent", type="mouse" + kind, x=x, y=y, button="left" if pressed or kind != "Moved" else "none",
                  buttons=1 if pressed or kind == "Pressed" else 0, clickCount=1)

    def click(self, selector):
        self.click_on("document.querySelector(%s)" % json.dumps(selector))

    def click_on(self, expression):
        x, y, _, _ = self.place(expression)
        self.mouse("Moved", x, y)
        self.mouse("Pressed", x, y)
        self.mouse("Released", x, y)

    def drag(self, points):
        self.mouse("Moved", *points[0])
        self.mouse("Pressed", *points[0])
        for p in points[1:]:
            self.mouse("Moved", *p, pressed=True)
        self.mouse("Released", *points[-1])

    def slide(self, selector, value):
        """A slider as the keyboard or a drag leaves it."""
        self.value("(e => { e.value = %r; e.dispatchEvent(new Event('input', {bubbles: true})); e.dispatchEvent(new Event('change', {bubbles: true})); })"
                   "(document.querySelector(%s))" % (value, json.dumps(selector)))

    def picture(self, path, whole=False):
        with open(path, "wb") as f:
            f.write(base64.b64decode(self.call("Page.captureScreenshot", captureBeyondViewport=whole, **({"clip": dict(
                zip(("x", "y", "width", "height", "scale"), self.value("[0, 0, innerWidth, document.documentElement.scrollHeight, 1]")))} if whole else {}))["data"]))
