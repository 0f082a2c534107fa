"""Uses the page of `ajar view` as a person would, with a server that renders nothing: try_page.py PAGE [PICTURES]
[INTEGRATORS]. PAGE has what `npm run build` wrote; PICTURES gets screenshots; INTEGRATORS is a file of
`ajar list integrators --json`. Exit code 1 with the reasons if something is wrong, 77 if there is no browser."""
import json
import pathlib
import shutil
import subprocess
import sys
import threading
import time

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "report"))
from browser import Browser, find_chromium  # noqa: E402
from page_trial import PageTrial  # noqa: E402

failures = []


def expect(holds, claim):
    if not holds:
        failures.append(claim)


class Server:
    """The mock server, and the messages that it got."""

    def __init__(self, page, integrators=None, port=0):
        command = ["node", str(HERE / "mock_server.mjs"), f"--page={page}", f"--port={port}"]
        if integrators:
            command.append(f"--integrators={integrators}")
        self._process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
        self.address = self._process.stdout.readline().strip()
        self.port = int(self.address.split(":")[2].split("/")[0])
        self.messages = []
        threading.Thread(target=self._read, daemon=True).start()

    def _read(self):
        for line in self._process.stdout:
            self.messages.append(json.loads(line))

    def close(self):
        self._process.terminate()
        self._process.wait()

    def wait_for(self, kind, holds=lambda message: True, seconds=5, after=0):
        """The newest message of the kind for which it holds, beyond the first `after`; or None."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            for message in reversed(self.messages[after:]):
                if message["type"] == kind and holds(message):
                    return message
            time.sleep(0.05)
        return None


class Trial(PageTrial):
    def __init__(self, browser, server, pictures):
        super().__init__(browser, pictures)
        self.server = server


def connects(trial):
    browser = trial.browser
    browser.wait("ajarView.frame > 2 && ajarView.state.samples > 6")
    expect(browser.evaluate("location.hash") == "", "the token stays in the address bar")
    expect(browser.evaluate("document.getElementById('offline').hidden"), "it says that it is not connected")
    expect(not browser.evaluate("document.getElementById('hint').hidden"), "there is no hint the first time")
    trial.picture("first")
    browser.click("#close-hint")
    first = browser.evaluate("ajarView.frame")
    browser.wait(f"ajarView.frame > {first} + 2")
    browser.call("Page.reload")
    browser.wait("typeof ajarView === 'object' && ajarView.frame > 1")
    expect(browser.evaluate("document.getElementById('hint').hidden"), "the hint comes back")


def exposes(trial):
    browser = trial.browser
    browser.evaluate("document.getElementById('viewer').focus()")
    before = trial.pixel(60, 60)
    browser.key("E", "KeyE", shift=True)
    browser.key("E", "KeyE", shift=True)
    after = trial.pixel(60, 60)
    expect(after[0] < before[0] - 15, f"a stop less exposure takes {before} to {after}")
    browser.key("e", "KeyE")
    browser.key("e", "KeyE")
    browser.evaluate("(() => { const one = document.getElementById('exposure'); one.value = 2; one.dispatchEvent(new Event('input')); })()")
    expect(trial.pixel(60, 60)[0] > before[0] + 15, "the slider of exposure changes nothing")
    browser.evaluate("document.getElementById('exposure').dispatchEvent(new Event('dblclick'))")


def shows_layers(trial):
    browser = trial.browser
    browser.key("l", "KeyL")
    browser.key("l", "KeyL")
    expect(trial.server.wait_for("layer", lambda one: one["name"] == "depth"), "l asks for no layer")
    frame = browser.evaluate("ajarView.frame")
    browser.wait(f"ajarView.frame > {frame} + 1")
    expect(not browser.evaluate("document.getElementById('legend').hidden"), "depth has no scale")
    trial.picture("depth")
    for _ in range(2):
        browser.key("L", "KeyL", shift=True)
    frame = browser.evaluate("ajarView.frame")
    browser.wait(f"ajarView.frame > {frame} + 1")


def chooses_regions(trial):
    browser, server = trial.browser, trial.server
    trial.tool("regions")
    place = trial.place(435, 252)
    browser.move(*place)
    browser.wait("!document.getElementById('tip').hidden", 5)
    trial.picture("regions")
    rule = {"kind": "object", "name": "glass ball with a long name in the file"}
    browser.click_at(*place)
    expect(server.wait_for("regions", lambda one: one["rules"] == [{**rule, "choice": "chain"}]), "a click gives an object no chains")
    browser.wait("ajarView.state.rules.length === 1")
    browser.click_at(*place)
    expect(server.wait_for("regions", lambda one: one["rules"] == [{**rule, "choice": "omc"}]), "a second click does not choose omc")
    browser.wait("ajarView.state.rules[0].choice === 'omc'")
    browser.click_at(*place, shift=True)
    expect(server.wait_for("regions", lambda one: one["rules"][-1:] == [{"kind": "material", "name": "glass", "choice": "chain"}]),
           "shift and a click choose no material")
    browser.evaluate("(() => { const one = document.querySelector('.rule[data-kind=material] input'); one.value = 0.25; one.dispatchEvent(new Event('change')); })()")
    expect(server.wait_for("regions", lambda one: one["rules"][-1:] == [{"kind": "material", "name": "glass", "choice": 0.25}]),
           "the slider sets no weight")
    trial.picture("rules")
    browser.click("#region-rules li:first-child button")
    expect(server.wait_for("regions", lambda one: len(one["rules"]) == 1 and one["rules"][0]["kind"] == "material"), "a rule cannot be removed")
    browser.wait("ajarView.state.rules.length === 1 && ajarView.state.can_undo")
    browser.click("#undo")
    browser.wait("ajarView.state.rules.length === 2", 5)


def paints(trial):
    trial.tool("brush")
    trial.browser.drag(trial.place(150, 220), trial.place(300, 240))
    mask = trial.server.wait_for("mask")
    expect(mask and mask["magic"] == "AJM1" and mask["width"] == 640 and mask["painted"] > 2000, f"the brush sends {mask}")
    trial.browser.wait("ajarView.state.masked")
    trial.picture("brush")
    trial.browser.click("#brush button")
    expect(trial.server.wait_for("mask", lambda one: one["width"] == 0), "the mask cannot be taken away")


def moves_camera(trial):
    browser, server = trial.browser, trial.server
    trial.tool("camera")
    browser.evaluate("document.querySelectorAll('#panel-regions, #panel-error, #panel-method').forEach((one) => one.open = false)")
    browser.evaluate("document.querySelectorAll('#panel-camera, #panel-picture, #panel-edits').forEach((one) => one.open = true)")
    # The wall in the middle is 6 away, so the camera turns about a point at z = -1.
    browser.wait("document.querySelector('#camera [aria-label=\"target, z\"]').value === '-1'", 5)
    browser.drag(trial.place(320, 180), trial.place(420, 180))
    last = server.wait_for("camera", lambda one: not one["moving"])
    radius = last and sum((a - b) ** 2 for a, b in zip(last["position"], last["target"])) ** 0.5
    expect(last and last["position"][0] < -0.5 and last["target"][2] == -1 and abs(radius - 6) < 0.01, f"a drag turns the camera to {last}")
    count = len(server.messages)
    browser.call("Input.dispatchKeyEvent", type="keyDown", key="w", code="KeyW")
    expect(server.wait_for("camera", lambda one: one["moving"], after=count), "w does not walk")
    browser.call("Input.dispatchKeyEvent", type="keyUp", key="w", code="KeyW")
    end = server.wait_for("camera", lambda one: not one["moving"], after=count)
    expect(end and end["position"][2] < last["position"][2], f"walking leads from {last} to {end}")
    expect(not any(one["type"] == "save" for one in server.messages), "a key that walks saves too")
    trial.picture("camera")
    trial.tool("focus")
    browser.click_at(*trial.place(60, 60))
    expect(server.wait_for("camera", lambda one: 4 < one["focal_distance"] < 6.1), "a click sets no focus")


def crops(trial):
    trial.tool("crop")
    trial.browser.drag(trial.place(100, 100), trial.place(400, 300))
    message = trial.server.wait_for("crop")
    expect(message and all(abs(a - b) <= 2 for a, b in zip(message["window"], [100, 100, 401, 301])), f"a rectangle crops to {message}")
    trial.browser.wait("ajarView.state.crop[0] > 90")
    trial.browser.wait("ajarView.frame > 0")
    time.sleep(0.6)
    trial.picture("crop")
    trial.browser.click("#no-crop")
    expect(trial.server.wait_for("crop", lambda one: one["window"] is None), "the crop cannot be taken away")
    trial.tool("move")


def edits(trial):
    browser, server = trial.browser, trial.server
    browser.evaluate("(() => { const one = document.getElementById('edit-part'); one.value = 1; one.dispatchEvent(new Event('change')); })()")
    set_roughness = "(() => { const one = document.querySelector('#edit-fields [aria-label=roughness]'); one.value = 0.4; one.dispatchEvent(new Event('change')); })()"
    browser.evaluate(set_roughness)
    expect(server.wait_for("edit", lambda one: one["kind"] == "materials" and one["index"] == 1 and one["parameters"] == {"roughness": 0.4}), "no edit is sent")
    browser.wait("ajarView.state.can_undo")
    browser.evaluate("document.getElementById('viewer').focus()")
    browser.key("z", "KeyZ")
    shown = browser.evaluate("document.querySelector('#edit-fields [aria-label=roughness]').value")
    expect(shown == "0.1", f"after undo the roughness is shown as {shown}")


def sets_method(trial):
    browser, server = trial.browser, trial.server
    chosen = browser.evaluate(
        "(() => { document.getElementById('panel-method').open = true; const one = document.getElementById('parameter-chain');"
        "one.selectedIndex = one.selectedIndex === 0 ? 1 : 0; one.dispatchEvent(new Event('change')); return one.value; })()")
    expect(server.wait_for("method", lambda one: one["parameters"] == {"chain": chosen}), "a parameter is not sent")
    expect(browser.evaluate("document.getElementById('parameter-regions') === null"), "a file of regions can be named")
    browser.evaluate("(() => { const one = document.getElementById('stop-samples'); one.value = 400; one.dispatchEvent(new Event('change')); })()")
    expect(server.wait_for("stop-at", lambda one: one["samples"] == 400 and one["error"] is None), "no budget is sent")


def compares(trial):
    browser = trial.browser
    browser.evaluate("document.getElementById('viewer').focus()")
    browser.key("a", "KeyA")
    expect(browser.evaluate("!document.getElementById('divider').hidden"), "there is no split view")
    trial.picture("split")
    browser.key("x", "KeyX")
    expect(browser.evaluate("document.getElementById('divider').hidden && !document.getElementById('label-a').hidden"), "x does not flip")
    browser.click("#drop")


def pauses_and_saves(trial):
    browser, server = trial.browser, trial.server
    browser.evaluate("document.getElementById('viewer').focus()")
    browser.key(" ", "Space")
    browser.wait("ajarView.state.phase === 'paused'", 5)
    browser.key(" ", "Space")
    browser.wait("ajarView.state.phase === 'rendering'", 5)
    browser.key("s", "KeyS")
    expect(server.wait_for("save", lambda one: one["format"] == "exr"), "s does not save")
    browser.wait("[...document.querySelectorAll('#notes li')].some((one) => one.textContent.includes('two-balls-1.exr'))", 5)


def shows_help(trial):
    browser = trial.browser
    browser.key("?", "Slash", shift=True)
    expect(browser.evaluate("document.getElementById('help').open"), "? opens no help")
    trial.picture("help")
    browser.key("Escape", "Escape")


def fits_windows(trial):
    browser = trial.browser
    browser.evaluate("document.querySelectorAll('.panels > details').forEach((one) => one.open = true)")
    for width, height in ((900, 600), (1280, 720), (1920, 1080), (2560, 1440), (3840, 2160)):
        browser.resize(width, height)
        browser.settle()
        wide = browser.evaluate("[...document.querySelectorAll('html, .top, .view-tools, .panels, .panels > details')].filter((one) => one.scrollWidth > one.clientWidth + 1).map((one) => one.id || one.className || one.tagName).join(' ')")
        expect(not wide, f"in a window of {width} too wide: {wide}")
        trial.picture(f"window-{width}")
        browser.evaluate("document.getElementById('panels').scrollTop = 1e6")
        trial.picture(f"window-{width}-end")
        browser.evaluate("document.getElementById('panels').scrollTop = 0")
    browser.resize(1280, 720)


def has_names(trial):
    nameless = trial.browser.evaluate(
        "[...document.querySelectorAll('button, input, select, meter, progress')].filter((one) => !one.textContent.trim() && !one.ariaLabel"
        " && !(one.labels?.length) && !one.title).map((one) => one.outerHTML.slice(0, 80)).join('; ')")
    expect(not nameless, f"controls without a name: {nameless}")


def connects_again(trial):
    """Losing the server is an error of the browser's console, so these are not held against the page."""
    browser = trial.browser
    failures.extend("the page reports: " + error for error in browser.errors)
    trial.server.close()
    browser.wait("!document.getElementById('offline').hidden", 5)
    expect("Trying again" in browser.evaluate("document.getElementById('offline').textContent"), "it does not say that it tries again")
    trial.picture("offline")
    trial.server = Server(trial.page, port=trial.server.port)
    browser.wait("document.getElementById('offline').hidden", 20)
    browser.wait("ajarView.frame > 0 && document.getElementById('phase').textContent === 'Rendering'")
    # Another run has another token.
    browser.open(trial.server.address.split("#")[0] + "#wrong", "typeof ajarView === 'object'")
    browser.wait("document.getElementById('offline-reason').textContent.includes('refused')", 5)
    trial.picture("refused")


def main():
    program = find_chromium()
    if program is None or shutil.which("node") is None:
        print("there is no Chromium (AJAR_CHROMIUM names another) or no node")
        return 77
    pictures = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else None
    if pictures:
        pictures.mkdir(parents=True, exist_ok=True)
    server = Server(sys.argv[1], sys.argv[3] if len(sys.argv) > 3 else None)
    with Browser(program, 1280, 720) as browser:
        trial = Trial(browser, server, pictures)
        trial.page = sys.argv[1]
        try:
            browser.open(server.address, "typeof ajarView === 'object'")
            for part in (connects, exposes, shows_layers, chooses_regions, paints, moves_camera, crops, edits, sets_method, compares,
                         pauses_and_saves, shows_help, has_names, fits_windows, connects_again):
                part(trial)
        finally:
            trial.server.close()
            if sys.exc_info()[0]:
                print("\n".join(failures + browser.errors))
    print("\n".join(failures))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
