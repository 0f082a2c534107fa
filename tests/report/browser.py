"""A headless Chromium, driven through its DevTools protocol over pipes: standard library only, no ports."""
import base64
import fcntl
import json
import os
import select
import shutil
import subprocess
import tempfile
import time


def find_chromium():
    """Path of the browser, or None. AJAR_CHROMIUM names another."""
    names = [os.environ.get("AJAR_CHROMIUM"), "chromium", "chromium-browser", "google-chrome", "chrome"]
    return next(filter(None, (shutil.which(name) for name in names if name)), None)


class Browser:
    """One page. `errors` collects what the page reports as wrong: exceptions, console errors and warnings, failed loads."""

    def __init__(self, program, width=1440, height=900, scale=1, dark=True):
        self.errors = []
        self._folder = tempfile.TemporaryDirectory(prefix="ajar-browser-")
        to_browser_read, self._to_browser = os.pipe()
        self._from_browser, from_browser_write = os.pipe()
        # The protocol's pipes are descriptors 3 and 4 of the browser. A shell may know no descriptors of two digits, which a
        # second browser has.
        above = [fcntl.fcntl(end, fcntl.F_DUPFD, 10) for end in (to_browser_read, from_browser_write)]
        self._process = subprocess.Popen(
            [program, "--headless", "--remote-debugging-pipe", "--no-sandbox", "--no-first-run", "--disable-dev-shm-usage",
             "--disable-background-networking", "--enable-unsafe-swiftshader", "--use-angle=swiftshader",
             "--user-data-dir=" + self._folder.name, "about:blank"],
            preexec_fn=lambda: [os.dup2(end, i + 3) for i, end in enumerate(above)], pass_fds=(3, 4),
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        for end in above:
            os.close(end)
        os.close(to_browser_read)
        os.close(from_browser_write)
        self._buffer = b""
        self._next_id = 0
        self._session = None
        targets = self.call("Target.getTargets")["targetInfos"]
        page = next(target for target in targets if target["type"] == "page")
        self._session = self.call("Target.attachToTarget", targetId=page["targetId"], flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log"):
            self.call(domain + ".enable")
        self.resize(width, height, scale)
        self.call("Emulation.setEmulatedMedia",
                  features=[{"name": "prefers-color-scheme", "value": "dark" if dark else "light"}])

    def close(self):
        try:
            self._session = None
            self.call("Browser.close")
            self._process.wait(10)
        except (OSError, EOFError, TimeoutError, subprocess.TimeoutExpired):
            self._process.kill()
            self._process.wait()
        os.close(self._to_browser)
        os.close(self._from_browser)
        # Helper processes may still be writing for a moment.
        for _ in range(20):
            try:
                self._folder.cleanup()
                break
            except OSError:
                time.sleep(0.1)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def call(self, method, **parameters):
        self._next_id += 1
        message = {"id": self._next_id, "method": method, "params": parameters}
        if self._session:
            message["sessionId"] = self._session
        os.write(self._to_browser, json.dumps(message).encode() + b"\0")
        while True:
            answer = self._receive(60)
            if answer.get("id") == self._next_id:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']['message']}")
                return answer["result"]

    def _receive(self, timeout):
        while b"\0" not in self._buffer:
            if not select.select([self._from_browser], [], [], timeout)[0]:
                raise TimeoutError("the browser does not answer")
            part = os.read(self._from_browser, 1 << 20)
            if not part:
                raise EOFError("the browser has ended")
            self._buffer += part
        text, self._buffer = self._buffer.split(b"\0", 1)
        message = json.loads(text)
        self._note(message.get("method"), message.get("params", {}))
        return message

    def _note(self, method, parameters):
        if method == "Runtime.exceptionThrown":
            details = parameters["exceptionDetails"]
            self.errors.append(details.get("exception", {}).get("description") or details["text"])
        elif method == "Runtime.consoleAPICalled" and parameters["type"] in ("error", "warning", "assert"):
            self.errors.append(" ".join(str(part.get("value", part.get("description"))) for part in parameters["args"]))
        elif method == "Log.entryAdded" and parameters["entry"]["level"] in ("error", "warning"):
            self.errors.append(parameters["entry"]["text"] + " " + parameters["entry"].get("url", ""))

    def resize(self, width, height, scale=1):
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=scale, mobile=False)

    def open(self, url, ready="location.protocol === 'file:' && typeof ajar === 'object' && ajar.data"):
        """Loads a page, a report by default, until the JavaScript condition `ready` holds."""
        # Another fragment alone would not load the page anew.
        self.call("Page.navigate", url="about:blank")
        self.call("Page.navigate", url=url)
        self.wait(f"document.readyState === 'complete' && ({ready})")

    def evaluate(self, expression):
        """The value of a JavaScript expression; promises are awaited."""
        result = self.call("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in result:
            raise RuntimeError(result["exceptionDetails"].get("exception", {}).get("description", expression))
        return result["result"].get("value")

    def wait(self, condition, seconds=30):
        """Until the JavaScript condition holds."""
        end = time.monotonic() + seconds
        while True:
            try:
                if self.evaluate(f"Boolean({condition})"):
                    return
            except RuntimeError:
                pass  # the page is being replaced
            if time.monotonic() > end:
                raise TimeoutError(f"never came true: {condition}; errors of the page: {self.errors}")
            time.sleep(0.03)

    def settle(self):
        """Until what was asked for is drawn."""
        self.evaluate("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")

    def key(self, key, code="", shift=False):
        """A key as KeyboardEvent.key names it."""
        common = {"key": key, "code": code, "modifiers": 8 if shift else 0}
        if len(key) == 1:
            common["text"] = key
        if key in ("Escape", "Enter", "Tab"):
            common["windowsVirtualKeyCode"] = {"Escape": 27, "Enter": 13, "Tab": 9}[key]
        self.call("Input.dispatchKeyEvent", type="keyDown", **common)
        self.call("Input.dispatchKeyEvent", type="keyUp", **common)
        self.settle()

    def move(self, x, y, buttons=0):
        self.call("Input.dispatchMouseEvent", type="mouseMoved", x=x, y=y, buttons=buttons, button="left" if buttons else "none")

    def drag(self, start, end):
        self.move(*start)
        self.call("Input.dispatchMouseEvent", type="mousePressed", x=start[0], y=start[1], button="left", buttons=1, clickCount=1)
        self.move((start[0] + end[0]) / 2, (start[1] + end[1]) / 2, 1)
        self.move(*end, 1)
        self.call("Input.dispatchMouseEvent", type="mouseReleased", x=end[0], y=end[1], button="left", buttons=0, clickCount=1)
        self.settle()

    def click(self, selector):
        self.click_at(*self.middle(selector))

    def click_at(self, x, y, shift=False):
        for kind in ("mousePressed", "mouseReleased"):
            self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", clickCount=1, modifiers=8 if shift else 0)
        self.settle()

    def wheel(self, x, y, pixels):
        self.call("Input.dispatchMouseEvent", type="mouseWheel", x=x, y=y, deltaX=0, deltaY=pixels)
        self.settle()

    def middle(self, selector):
        return self.evaluate(
            "(() => { const b = document.querySelector(%s).getBoundingClientRect();"
            "return [b.x + b.width / 2, b.y + b.height / 2]; })()" % json.dumps(selector))

    def screenshot(self, path=None):
        """PNG bytes, also written to `path` if there is one."""
        data = base64.b64decode(self.call("Page.captureScreenshot", format="png")["data"])
        if path:
            with open(path, "wb") as file:
                file.write(data)
        return data
