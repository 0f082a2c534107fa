"""Lights a scene with `ajar view` as a person would: drive_viewer.py AJAR [PICTURES]. PICTURES gets screenshots. Exit code 1 with
the reasons if something is wrong, 77 if there is no browser, or the program was built without its page."""
import pathlib
import signal
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "report"))
from browser import Browser, find_chromium  # noqa: E402
from page_trial import PageTrial  # noqa: E402

READY = "typeof ajarView === 'object'"
failures = []


def expect(holds, claim):
    if not holds:
        failures.append(claim)


class Program:
    """`ajar view`, in a folder of its own."""

    def __init__(self, ajar, folder, *arguments):
        self._process = subprocess.Popen([ajar, "view", *arguments], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.address = self._process.stdout.readline().strip()
        if not self.address:
            self.failure = self._process.stderr.read()

    def interrupt(self):
        """The lines that it prints before it ends."""
        self._process.send_signal(signal.SIGINT)
        out, errors = self._process.communicate(timeout=60)
        return out.splitlines(), errors

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self._process.poll() is None:
            self._process.kill()
        self._process.communicate()


class Trial(PageTrial):
    def state(self, expression):
        return self.browser.evaluate(f"ajarView.state.{expression}")

    def wait(self, condition, seconds=60):
        self.browser.wait(condition, seconds)

    def wait_for_frames(self, count=2):
        frame = self.browser.evaluate("ajarView.frame")
        self.wait(f"ajarView.frame > {frame} + {count - 1}")

    def layer(self, name, frames=2):
        self.browser.evaluate(
            "(() => { const one = document.getElementById('layer'); one.value = '%s'; one.dispatchEvent(new Event('change')); })()" % name)
        self.wait_for_frames(frames)


def converges(trial):
    trial.wait("ajarView.frame > 0 && ajarView.state && ajarView.state.samples > 8")
    expect(trial.browser.evaluate("location.hash") == "", "the token stays in the address bar")
    expect(trial.state("phase") == "rendering", f"it is {trial.state('phase')}")
    trial.picture("converging")
    trial.browser.click("#close-hint")


def exposes(trial):
    trial.focus()
    before = trial.pixel(40, 30)
    for _ in range(2):
        trial.browser.key("e", "KeyE")
    after = trial.pixel(40, 30)
    expect(sum(after[:3]) > sum(before[:3]), f"more exposure takes {before} to {after}")
    trial.browser.evaluate("document.getElementById('exposure').dispatchEvent(new Event('dblclick'))")


def inspects(trial):
    trial.browser.move(*trial.place(60, 80))
    trial.wait("document.getElementById('pixel-facts').textContent.length > 20")


def sets_regions(trial):
    epoch = trial.state("epoch")
    samples = trial.state("samples")
    trial.tool("regions")
    trial.browser.click_at(*trial.place(60, 80))
    trial.wait("ajarView.state.rules.length === 1 && ajarView.state.phase === 'rendering'")
    expect(trial.state("epoch") == epoch, "a click throws away what was rendered")
    trial.wait(f"ajarView.state.samples > {samples}")
    trial.layer("importance")
    trial.picture("importance")
    trial.layer("")
    trial.browser.click_at(*trial.place(60, 80))
    trial.wait("ajarView.state.rules.length === 1 && ajarView.state.rules[0].choice === 'omc'")
    trial.browser.click("#undo")
    trial.wait("ajarView.state.rules[0].choice === 'chain'")
    trial.browser.click("#undo")
    trial.wait("ajarView.state.rules.length === 0")


def paints(trial):
    trial.tool("brush")
    trial.browser.drag(trial.place(20, 60), trial.place(100, 70))
    trial.wait("ajarView.state.masked && ajarView.state.phase === 'rendering'")
    trial.picture("brush")
    trial.browser.click("#undo")
    trial.wait("!ajarView.state.masked")
    trial.tool("move")
    trial.wait("(() => { const one = document.getElementById('overlay');"
               "return one.getContext('2d').getImageData(0, 0, one.width, one.height).data.every((byte) => byte === 0); })()", 10)
    trial.tool("move")


def moves_camera(trial):
    epoch = trial.state("epoch")
    trial.wait("ajarView.state.samples > 2")
    before = trial.pixel(60, 60)
    trial.tool("camera")
    trial.browser.drag(trial.place(60, 60), trial.place(63, 60))
    trial.wait(f"ajarView.state.epoch > {epoch} && ajarView.state.phase === 'rendering' && ajarView.state.samples > 2")
    trial.wait_for_frames()
    expect(trial.pixel(60, 60) != before and sum(trial.pixel(60, 60)[:3]) > 0, "another camera sees the same, or nothing")
    trial.picture("camera")
    trial.browser.click("#undo")
    trial.tool("move")


def edits(trial):
    epoch = trial.state("epoch")
    trial.browser.evaluate(
        "(() => { document.getElementById('panel-edits').open = true; const one = document.querySelector('#edit-fields input');"
        "if (one.type === 'color') one.value = '#2040ff'; else one.value = 0.9; one.dispatchEvent(new Event('change')); })()")
    trial.wait(f"ajarView.state.epoch > {epoch} && ajarView.state.phase === 'rendering' && ajarView.state.samples > 2")
    trial.picture("edit")
    trial.browser.click("#undo")
    trial.wait(f"ajarView.state.epoch > {epoch} + 1 && ajarView.state.samples > 2")


def denoises(trial):
    trial.layer("denoised")
    trial.wait_for_frames(2)
    trial.picture("denoised")
    trial.layer("")


def saves(trial, folder):
    trial.focus()
    trial.browser.key("s", "KeyS")
    trial.wait("[...document.querySelectorAll('#notes li')].some((one) => one.textContent.includes('.exr'))")
    expect(list(folder.glob("*.exr")), "there is no picture")


def reloads(trial):
    epoch = trial.state("epoch")
    trial.browser.call("Page.reload")
    trial.wait(f"{READY} && ajarView.frame > 0 && ajarView.state.samples > 0")
    expect(trial.state("epoch") == epoch, "a reload begins the render anew")


def serves_two(trial, program, address):
    with Browser(program, 1280, 720) as other:
        other.open(address, READY)
        other.wait("ajarView.frame > 0 && ajarView.state", 60)
        trial.focus()
        trial.browser.key(" ", "Space")
        other.wait("ajarView.state.phase === 'paused'", 60)
        trial.wait("ajarView.state.phase === 'paused'")
        trial.browser.key(" ", "Space")
        other.wait("ajarView.state.phase === 'rendering'", 60)
        failures.extend("the second page reports: " + error for error in other.errors)


def opens_a_picture(browser, ajar, folder, pictures):
    picture = next(folder.glob("*.exr"))
    with Program(ajar, folder, picture.name) as program:
        trial = Trial(browser, pictures)
        browser.open(program.address, READY)
        trial.wait("ajarView.frame > 0 && ajarView.state.phase === 'finished'")
        expect(trial.state("samples") > 0, "it does not know how many samples the picture has")
        trial.layer("depth", 1)
        trial.picture("finished")
        _, complaints = program.interrupt()
        expect(not complaints, f"ajar view PICTURE says: {complaints}")


def main():
    browser_program = find_chromium()
    if browser_program is None:
        print("there is no Chromium; AJAR_CHROMIUM names another")
        return 77
    ajar = str(pathlib.Path(sys.argv[1]).resolve())
    pictures = pathlib.Path(sys.argv[2]).resolve() if len(sys.argv) > 2 else None
    if pictures:
        pictures.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix="ajar-view-") as name:
        folder = pathlib.Path(name)
        with Program(ajar, folder, "builtin:cornell", "--resolution", "120x120", "--integrator", "selective") as program:
            if not program.address:
                print(program.failure)
                return 77
            with Browser(browser_program, 1280, 720) as browser:
                trial = Trial(browser, pictures)
                browser.open(program.address, READY)
                try:
                    for part in (converges, exposes, inspects, sets_regions, paints, moves_camera, edits, denoises):
                        part(trial)
                    saves(trial, folder)
                    reloads(trial)
                    serves_two(trial, browser_program, program.address)
                    failures.extend("the page reports: " + error for error in browser.errors)
                    browser.errors.clear()
                    files, _ = program.interrupt()
                    expect(len(files) == 2 and all(pathlib.Path(file).exists() for file in files), f"Ctrl-C saves {files}")
                    opens_a_picture(browser, ajar, folder, pictures)
                finally:
                    if sys.exc_info()[0]:
                        print("\n".join(failures + browser.errors))
    print("\n".join(failures))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
