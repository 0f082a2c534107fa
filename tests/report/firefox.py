"""A headless Firefox, driven through its Marionette protocol: standard library only, a port of its own choice on this machine."""
import base64
import json
import os
import pathlib
import shutil
import socket
import subprocess
import tempfile
import time

PREFERENCES = {
    "marionette.port": 0,
    "browser.shell.checkDefaultBrowser": False,
    "datareporting.policy.dataSubmissionEnabled": False,
    "toolkit.telemetry.reportingpolicy.firstRun": False,
    "app.update.disabledForTesting": True,
    # Nothing but the page.
    "network.captive-portal-service.enabled": False,
    "network.connectivity-service.enabled": False,
    "services.settings.server": "data:,",
}


def find_firefox():
    """Path of the browser, or None. AJAR_FIREFOX names another."""
    names = [os.environ.get("AJAR_FIREFOX"), "firefox-esr", "firefox"]
    return next(filter(None, (shutil.which(name) for name in names if name)), None)


class Firefox:
    """One window."""

    def __init__(self, program, width=1440, height=900, dark=True):
        self._folder = tempfile.TemporaryDirectory(prefix="ajar-firefox-", ignore_cleanup_errors=True)
        profile = pathlib.Path(self._folder.name)
        preferences = PREFERENCES | {"layout.css.prefers-color-scheme.content-override": 0 if dark else 1}
        profile.joinpath("user.js").write_text(
            "".join(f"user_pref({json.dumps(name)}, {json.dumps(value)});\n" for name, value in preferences.items()))
        self._process = subprocess.Popen(
            [program, "--headless", "--no-remote", "--marionette", "--profile", str(profile)],
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env=os.environ | {"HOME": str(profile)})
        self._socket = None
        self._buffer = b""
        self._next_id = 0
        try:
            self._connect(profile / "MarionetteActivePort")
            self.call("WebDriver:NewSession", capabilities={})
            self.call("WebDriver:Navigate", url="about:blank")  # scripts are forbidden where it starts
            self.resize(width, height)
        except BaseException:
            self.close()
            raise

    def _connect(self, port_file):
        end = time.monotonic() + 60
        while True:
            try:
                self._socket = socket.create_connection(("127.0.0.1", int(port_file.read_text())), 60)
                self._receive()  # a greeting
                return
            except (OSError, ValueError):
                if time.monotonic() > end or self._process.poll() is not None:
                    raise
                time.sleep(0.1)

    def close(self):
        if self._socket:
            self._socket.close()
        self._process.terminate()
        try:
            self._process.wait(10)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        self._folder.cleanup()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def call(self, command, **parameters):
        self._next_id += 1
        text = json.dumps([0, self._next_id, command, parameters]).encode()
        self._socket.sendall(str(len(text)).encode() + b":" + text)
        _, _, error, result = self._receive()
        if error:
            raise RuntimeError(f"{command}: {error['message']}")
        return result.get("value") if isinstance(result, dict) else result

    def _receive(self):
        """A message: its length, a colon, JSON."""
        while b":" not in self._buffer:
            self._read()
        length, self._buffer = self._buffer.split(b":", 1)
        while len(self._buffer) < int(length):
            self._read()
        text, self._buffer = self._buffer[:int(length)], self._buffer[int(length):]
        return json.loads(text)

    def _read(self):
        part = self._socket.recv(1 << 20)
        if not part:
            raise EOFError("the browser has ended")
        self._buffer += part

    def resize(self, width, height):
        """Of the page, not of the window around it."""
        self.call("WebDriver:SetWindowRect", width=width, height=height)
        inner = self.evaluate("[innerWidth, innerHeight]")
        self.call("WebDriver:SetWindowRect", width=2 * width - inner[0], height=2 * height - inner[1])

    def open(self, url):
        # Another fragment alone would not load the page anew.
        self.call("WebDriver:Navigate", url="about:blank")
        self.call("WebDriver:Navigate", url=url)
        self.wait("typeof ajar === 'object' && ajar.data")

    def evaluate(self, expression):
        """The value of a JavaScript expression."""
        # In the page itself: Marionette's own scope does not see what the page declares with const.
        text = self.call("WebDriver:ExecuteScript", script="return window.eval(arguments[0]);",
                         args=[f"JSON.stringify(({expression}) ?? null)"])
        return json.loads(text)

    def wait(self, condition, seconds=30):
        """Until the JavaScript condition holds."""
        end = time.monotonic() + seconds
        while not self.evaluate(f"Boolean({condition})"):
            if time.monotonic() > end:
                raise TimeoutError(f"never came true: {condition}")
            time.sleep(0.03)

    def key(self, key):
        """A key as KeyboardEvent.key names it, of those that are one character."""
        press = [{"type": kind, "value": key} for kind in ("keyDown", "keyUp")]
        self.call("WebDriver:PerformActions", actions=[{"type": "key", "id": "keyboard", "actions": press}])

    def screenshot(self, path):
        data = self.call("WebDriver:TakeScreenshot", full=False)
        pathlib.Path(path).write_bytes(base64.b64decode(data))
