import gc
import pathlib
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import numpy
from support import SMALL, command_line, run_python

import ajar


class Render(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scene = ajar.load("builtin:cornell")

    def test_gives_the_bits_of_the_command_line(self):
        cases = [
            ({"integrator": "pt", "spp": 8, "seed": 3}, ["--integrator", "pt", "--spp", 8, "--seed", 3]),
            (
                {"spp": 16, "split": 2.5, "depth": (2, 6), "denoise": "builtin", "layers": ["normal", "standard-error"]},
                ["--spp", 16, "--set", "split=2.5", "--depth", "2:6", "--denoise", "builtin", "--aov", "normal,standard-error"],
            ),
            (
                {"integrator": "mmlt", "spp": 8, "crop": (3, 2, 20, 15), "filter": "gaussian:1.5"},
                ["--integrator", "mmlt", "--spp", 8, "--crop", "3,2,20,15", "--filter", "gaussian:1.5"],
            ),
        ]
        for settings, options in cases:
            with self.subTest(settings), tempfile.TemporaryDirectory() as folder:
                path = pathlib.Path(folder) / "picture.exr"
                if "denoise" not in settings:
                    options = [*options, "--denoise", "none"]
                command_line("render", "builtin:cornell", "--resolution", "24x18", "-o", path, *options)
                theirs = ajar.open_picture(path)
                ours = self.scene.render(resolution=(24, 18), **settings)
                numpy.testing.assert_array_equal(ours.pixels, theirs.pixels)
                self.assertEqual(sorted(ours.layers), sorted(theirs.layers))
                for name in ours.layers:
                    numpy.testing.assert_array_equal(ours.layers[name], theirs.layers[name], name)

    def test_gives_pixels_without_a_copy(self):
        picture = self.scene.render(layers=["depth"], **SMALL)
        pixels = picture.pixels
        self.assertEqual((pixels.shape, pixels.dtype), ((18, 24, 3), numpy.float32))
        self.assertTrue(numpy.shares_memory(pixels, picture.pixels))
        self.assertTrue(numpy.shares_memory(pixels, numpy.asarray(picture)))
        self.assertEqual(numpy.asarray(picture, float).dtype, float)
        with self.assertRaises(ValueError):
            pixels[0, 0, 0] = 1
        copy = pixels.copy()
        self.assertEqual(picture.layers["depth"].shape, (18, 24))
        self.assertEqual((picture.width, picture.height), (24, 18))
        del picture
        gc.collect()
        self.scene.render(**SMALL)
        numpy.testing.assert_array_equal(pixels, copy)

    def test_says_what_is_known_of_the_picture(self):
        picture = self.scene.render(layers=["standard-error"], denoise="builtin", **SMALL)
        self.assertEqual(picture.stats["integrator"], "pt")
        self.assertEqual(picture.stats["seed"], 0)
        self.assertGreater(picture.estimated_error, 0)
        self.assertEqual(picture.metadata["ajar:samples_per_pixel"], "8")
        self.assertEqual(picture.standard_error.shape, (18, 24, 3))
        self.assertEqual(picture.denoised.shape, (18, 24, 3))
        self.assertIn("standard-error", repr(picture))
        self.assertEqual(picture._repr_png_()[:4], b"\x89PNG")
        plain = self.scene.render(**SMALL)
        self.assertIsNone(plain.denoised)
        with self.assertRaisesRegex(KeyError, "list_aovs"):
            plain.standard_error  # noqa: B018

    def test_saves_pictures(self):
        picture = self.scene.render(layers=["normal"], **SMALL)
        with tempfile.TemporaryDirectory() as folder:
            for name in ("a.exr", "a.png", "a.jpg", "a.pfm", "a.hdr"):
                path = pathlib.Path(folder) / name
                picture.save(path, exposure=1, tone_map="filmic")
                self.assertGreater(path.stat().st_size, 100)
            again = ajar.open_picture(f"{folder}/a.exr")
            numpy.testing.assert_array_equal(again.layers["normal"], picture.layers["normal"])
            self.assertEqual(again.stats["integrator"], "pt")
            self.assertAlmostEqual(again.estimated_error, picture.estimated_error, 5)
            with self.assertRaises(ajar.UsageError):
                picture.save(f"{folder}/a.nothing")
            with self.assertRaises(ajar.UsageError):
                picture.save(f"{folder}/a.png", tone_map="filmik")
            with self.assertRaises(OSError):
                picture.save("/no/such/folder/a.png")

    def test_raises_what_is_wrong(self):
        with self.assertRaisesRegex(ajar.UsageError, 'did you mean "pt"'):
            self.scene.render(integrator="ptt")
        with self.assertRaisesRegex(ajar.UsageError, "splitt.*split"):
            self.scene.render(resolution=(24, 18), splitt=2)
        with self.assertRaisesRegex(ajar.UsageError, "norml"):
            self.scene.render(layers=["norml"])
        with self.assertRaisesRegex(ajar.UsageError, "seed"):
            self.scene.render(seed=-1)
        with self.assertRaisesRegex(ajar.UsageError, "list of names"):
            self.scene.render(layers="normal")
        with self.assertRaises(ValueError):
            self.scene.render(resolution=(0, 4))
        with self.assertRaises(OSError):
            ajar.load("/no/such/scene.pbrt")
        with self.assertRaises(ajar.UsageError):
            ajar.load("a\0b.pbrt")
        with self.assertRaisesRegex(ajar.UsageError, "finite"):
            self.scene.render(time=float("nan"))
        with self.assertRaisesRegex(ajar.UsageError, "builtin:cornell|cornell"):
            ajar.load("builtin:cornel")
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "bad.pbrt"
            path.write_text('WorldBegin\nShape "sphere" "float radius" [ "one" ]\n')
            with self.assertRaisesRegex(ajar.SceneError, r"bad\.pbrt:2:"):
                ajar.load(path)

    def test_gives_pictures_while_it_renders(self):
        pictures = []
        for picture in self.scene.render_iter(integrator="pt", resolution=(24, 18), time=86400, every=0.02):
            pictures.append(picture)
            if len(pictures) == 3:
                break
        samples = [float(picture.metadata["ajar:samples_per_pixel"]) for picture in pictures]
        self.assertEqual(samples, sorted(samples))
        self.assertGreater(samples[-1], samples[0])
        last = list(self.scene.render_iter(every=1e-3, **SMALL))[-1]
        numpy.testing.assert_array_equal(last.pixels, self.scene.render(**SMALL).pixels)

    def test_calls_back(self):
        seen = []
        self.scene.render(integrator="pt", resolution=(24, 18), time=0.7, progress=seen.append)
        self.assertTrue(seen)
        self.assertGreater(seen[-1].seconds, 0)

    def test_lets_sessions_go_on(self):
        session = self.scene.start(integrator="pt", resolution=(24, 18), time=86400)
        self.assertFalse(session.wait(0.05))
        while session.picture() is None:
            time.sleep(0.01)
        self.assertEqual(session.statistics()["integrator"], "pt")
        self.assertFalse(session.done)
        self.assertGreater(session.progress().samples_per_pixel, 0)
        session.stop()
        self.assertTrue(session.wait(20))
        self.assertTrue(session.done)
        self.assertEqual(session.picture().stats["integrator"], "pt")
        self.assertEqual(session.warnings, [])
        with self.assertRaises(ajar.Stopped), self.scene.start(integrator="mmlt", time=86400) as stopped:
            stopped.stop()
            stopped.stop()
            stopped.wait()

    def test_is_asked_by_many_threads(self):
        alone = self.scene.render(**SMALL).pixels
        found = []

        def work():
            for _ in range(3):
                scene = ajar.load("builtin:cornell") if len(found) % 2 else self.scene
                found.append(scene.render(**SMALL).pixels)

        threads = [threading.Thread(target=work) for _ in range(4)]
        session = self.scene.start(integrator="pt", resolution=(24, 18), time=86400)
        for thread in threads:
            thread.start()
        while any(thread.is_alive() for thread in threads):
            session.progress()
            session.picture()
        session.stop()
        for thread in threads:
            thread.join()
        self.assertEqual(len(found), 12)
        for pixels in found:
            numpy.testing.assert_array_equal(pixels, alone)

    def test_goes_on_from_a_checkpoint(self):
        whole = self.scene.render(integrator="pt", resolution=(24, 18), spp=16)
        with tempfile.TemporaryDirectory() as folder:
            checkpoint = pathlib.Path(folder) / "render.checkpoint"
            settings = {"integrator": "pt", "resolution": (24, 18), "checkpoint": checkpoint}
            self.scene.render(spp=8, **settings)
            again = self.scene.render(spp=16, resume=True, **settings)
        numpy.testing.assert_array_equal(again.pixels, whole.pixels)


class Process(unittest.TestCase):
    def test_is_left_as_it_was(self):
        outcome = run_python(
            """
import re
import numpy  # which asks for a signal of the C library's own
def state():
    text = open("/proc/self/status").read()
    return re.findall(r"Sig(?:Cgt|Ign|Blk):\\s*(\\w+)", text)
before = state()
import ajar
assert state() == before, "signals after import"
ajar.load("builtin:cornell").render(spp=1, resolution=(12, 9), denoise=True)
assert state() == before, "signals after a render"
mapped = open("/proc/self/maps").read()
assert "malloc_proxy" not in mapped and "jemalloc" not in mapped
"""
        )
        self.assertEqual((outcome.returncode, outcome.stdout, outcome.stderr), (0, "", ""))

    def test_ends_on_ctrl_c(self):
        code = (
            # Who is started in the background is told to ignore it.
            "import signal; signal.signal(signal.SIGINT, signal.default_int_handler)\n"
            "import ajar\nprint('ready', flush=True)\n"
            "try:\n    ajar.load('builtin:cornell').render(time=600)\n"
            "except KeyboardInterrupt:\n    print('interrupted')\n"
        )
        process = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True)
        self.assertEqual(process.stdout.readline(), "ready\n")
        time.sleep(0.7)
        process.send_signal(signal.SIGINT)
        out, _ = process.communicate(timeout=30)
        self.assertEqual((process.returncode, out), (0, "interrupted\n"))

    def test_ends_with_renders_that_run(self):
        outcome = run_python(
            """
import ajar, os
session = ajar.load("builtin:cornell").start(time=600)
session.wait(0.3)
child = os.fork()
if child == 0:
    # Its threads are gone: nothing waits for them.
    del session
    os._exit(0)
assert os.waitpid(child, 0)[1] == 0
"""
        )
        self.assertEqual((outcome.returncode, outcome.stdout, outcome.stderr), (0, "", ""))

    def test_gives_memory_back(self):
        # 200 renders, of which each would leave 200 kB if its picture were kept; measured: nothing beyond noise of 1 MB.
        outcome = run_python(
            """
import ajar
def resident():
    return int(open("/proc/self/statm").read().split()[1]) * 4096
scene = ajar.load("builtin:cornell")
def render(count):
    for seed in range(count):
        picture = scene.render(integrator="pt", spp=1, resolution=(96, 72), seed=seed, layers=["normal", "albedo", "depth"])
        picture.pixels, picture.layers["depth"]
render(60)
before = resident()
render(140)
print((resident() - before) / 1e6)
"""
        )
        self.assertEqual(outcome.returncode, 0, outcome.stderr)
        self.assertLess(float(outcome.stdout), 8.0, "megabytes more after 140 renders")


if __name__ == "__main__":
    unittest.main()
