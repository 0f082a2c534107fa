"""Values that cannot be are told with their names, whatever they are."""

import math
import os
import pathlib
import tempfile
import unittest
import warnings

import ajar
import numpy
from support import SMALL, run_python

NESTED = []
NESTED.append(NESTED)
DEEP = []
for _ in range(100):
    DEEP = [DEEP]
# Values that are neither a number, a text nor a flag.
NOTHING = [object(), {}, {"a": 1}, NESTED, DEEP, b"bytes", 1j, numpy.array(["a"]), numpy.array([object()]), set(), len]
NUMBERS = [math.nan, math.inf, -math.inf, 1e300, -1, -0.5, 10**30, -(10**30), 2**63, 2**31, numpy.float32("nan")]

# Values that each setting refuses.
SETTINGS = {
    "spp": [0, 1.5, True, "5", [1], *NUMBERS[:-3], *NOTHING],
    "time": [0, True, "5", [1], math.nan, math.inf, 1e300, -1, *NOTHING],
    "target_error": [0, 1.5, "1%", *NUMBERS, *NOTHING],
    "resolution": [5, "4x3", (4,), (4, 3, 2), (0, 3), (4, 65537), (4.5, 3), (None, 3), (math.nan, 3), *NOTHING],
    "scale": [0, "2", *NUMBERS, *NOTHING],
    "depth": [0, 1001, 1.5, "5", (5, 3), (1, 2, 3), [], *NUMBERS, *NOTHING],
    "crop": [5, "1,2,3,4", (0, 0, 4), (0, 0, 0, 4), (-1, 0, 4, 4), (0, 0, 4, 65537), (0, 0, 1.5, 2), *NOTHING],
    "filter": [5, True, "round", "box:nan", "\ud800", "box\0", *NOTHING],
    "layers": ["depth", [5], ["deepth"], [["depth"]], 5, ["\ud800"], *NOTHING],
    "seed": [-1, 0.5, "5", True, 2**64, math.nan, *NOTHING],
    "threads": [-1, 4097, 10**6, 1.5, "2", *NUMBERS, *NOTHING],
    "checkpoint": [5, True, 1.5, [], "a\0b", "\ud800", *NOTHING],
    "checkpoint_every": [0, "1s", *NUMBERS[:6], *NOTHING],
    "resume": [5, "yes", 0, *NOTHING],
    "denoise": [5, 0, [], "yes", 1.5, "\ud800", *NOTHING],
    "integrator": [5, True, "ptt", "\ud800", *NOTHING],
    "parameters": [5, "a", [1], [("a", 1)], {5: 1}, {"a": object()}, {"a": NESTED}, object()],
    "of-no-integrator": [5, "a", *NOTHING],
}
ACCEPTED = (ajar.UsageError, TypeError)


class Refusals(unittest.TestCase):
    def setUp(self):
        self.scene = ajar.load("builtin:cornell")

    def test_of_settings(self):
        for name, values in SETTINGS.items():
            for value in values:
                with self.subTest(name=name, value=repr(value)[:60]):
                    given = {"integrator": "pt", "resolution": (4, 3), "spp": 1, name: value}
                    if name == "scale":
                        del given["resolution"]
                    with self.assertRaises(ACCEPTED) as raised:
                        self.scene.render(**given)
                    said = str(raised.exception)
                    # Unknown names are told by themselves.
                    self.assertTrue(name in said or '"' in said or name == "parameters", said)
                    self.assertNotIn("json.exception", said)

    def test_of_waiting(self):
        with self.scene.start(integrator="pt", time=1000) as session:
            for value in (math.nan, -1, "5", [1], object()):
                with self.subTest(value=repr(value)), self.assertRaises(ACCEPTED):
                    session.wait(value)
        for value in (math.nan, -1, "x", object()):
            with self.subTest(value=repr(value)), self.assertRaises(ACCEPTED):
                next(self.scene.render_iter(every=value, **SMALL))
        with self.assertRaises(TypeError):
            self.scene.render(progress=5, **SMALL)

    def test_of_pictures(self):
        picture = self.scene.render(**SMALL)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "a.png")
            for exposure in (math.nan, math.inf, 65, -1e300, "1", [1], object(), NESTED, True):
                with self.subTest(exposure=repr(exposure)), self.assertRaisesRegex(ACCEPTED, "exposure"):
                    picture.save(path, exposure=exposure)
            for curve in (5, "none", object(), "\ud800"):
                with self.subTest(curve=repr(curve)), self.assertRaisesRegex(ACCEPTED, "tone.map"):
                    picture.save(path, tone_map=curve)
            self.assertEqual(os.listdir(folder), [])
        for path in (5, None, b"a.png", object(), "a\0.png", "\ud800.png", "", "a", "a.nothing"):
            with self.subTest(path=repr(path)), self.assertRaises(ACCEPTED):
                picture.save(path)
        for path in (5, None, b"a.exr", "a\0.exr", "\ud800", "", pathlib.Path("\ud800")):
            for function in (ajar.load, ajar.open_picture):
                if path == "" and function is ajar.load:
                    continue
                with self.subTest(path=repr(path), function=function.__name__), self.assertRaises(ACCEPTED):
                    function(path)
        for metrics in (5, "mse", ["none"], [5], NESTED, object()):
            with self.subTest(metrics=repr(metrics)), self.assertRaises(ACCEPTED):
                ajar.compare(picture, picture, metrics=metrics)
        for pixels in (0, -1, math.nan, "5", 1001, object()):
            with self.subTest(pixels=repr(pixels)), self.assertRaisesRegex(ACCEPTED, "pixels_per_degree"):
                ajar.compare(picture, picture, pixels_per_degree=pixels)
        for other in (5, None, object(), [1, 2], b"a.exr", "\ud800.exr"):
            with self.subTest(other=repr(other)), self.assertRaises(ACCEPTED):
                ajar.compare(picture, other)

    def test_of_meshes(self):
        corners = numpy.zeros((3, 3), numpy.float32)
        corners[1, 0] = corners[2, 1] = 1
        for indices, said in (
            ([[0, 1, 2**31]], "refers to vertex 2147483648 of 3"),
            ([[0, 1, 2**32]], "indices"),
            ([[0, 1, -1]], "indices"),
            ([[0, 1, 1.5]], "indices"),
            ([[0, 1], [2]], "indices"),
            ("abc", "indices"),
            (5, "indices"),
            (numpy.zeros((1, 1, 1, 3), int), "indices"),
        ):
            scene = ajar.Scene()
            with self.subTest(indices=repr(indices)), self.assertRaisesRegex(ajar.SceneError, said):
                scene.add(ajar.shapes.mesh(positions=corners, indices=indices))
                scene.render(**SMALL)
        for positions in ("abc", 5, [[1, 2], [3]], [[math.nan] * 3] * 3, [[1e300] * 3] * 3, [object()]):
            scene = ajar.Scene()
            with self.subTest(positions=repr(positions)), warnings.catch_warnings():
                warnings.simplefilter("ignore")  # numpy's, of the overflow
                with self.assertRaisesRegex(ajar.SceneError, "position"):
                    scene.add(ajar.shapes.mesh(positions=positions, indices=[[0, 1, 2]]))
                    scene.render(**SMALL)

    def test_of_scenes(self):
        for name, value in (("radius", NESTED), ("radius", object()), ("radius", math.nan), ("radius", "1")):
            with self.subTest(value=repr(value)[:60]), self.assertRaisesRegex((ajar.Error, TypeError), name):
                ajar.shapes.sphere(**{name: value})
        scene = ajar.Scene()
        sphere = ajar.shapes.sphere()
        for given in (
            {"material": 5},
            {"emission": 5},
            {"emission": ajar.materials.diffuse()},
            {"inside": 5},
            {"to_world": "abc"},
            {"to_world": [[math.nan] * 4] * 4},
            {"to_world": numpy.eye(3)},
            {"name": object()},
            {"name": "\ud800"},
        ):
            with self.subTest(given=repr(given)), self.assertRaises((ajar.Error, TypeError)):
                scene.add(sphere, **given)
        for size in (5, None, "ab", (1,), (0, 5), (1, math.nan), NESTED):
            with self.subTest(size=repr(size)), self.assertRaisesRegex((ajar.Error, TypeError), "resolution"):
                scene = ajar.Scene()
                scene.resolution = size
                scene.name
        for settings in ({"fov": math.nan}, {"fov": "5"}, {"fov": 0}, {"fov": 1e-60}, {"focal_distance": 1e300}, {"model": 5}):
            with self.subTest(settings=settings), self.assertRaises((ajar.Error, TypeError)):
                ajar.Scene(camera=ajar.Camera(**settings)).name
        for which in (1.5, [0], object(), True, -1, 10**30, "none"):
            with self.subTest(which=repr(which)), self.assertRaises((ajar.Error, TypeError)):
                self.scene.edit(material=which, reflectance=0.5)
        with self.assertRaisesRegex(ajar.SceneError, "there is no light 0"):
            ajar.Scene().edit(light=0, intensity=1)

    def test_a_million_threads_end_nothing(self):
        code = "import ajar\ntry:\n ajar.load('builtin:cornell').render(integrator='pt', resolution=(4, 3), spp=1, threads=10**6)\n"
        result = run_python(code + "except ajar.UsageError as error:\n print(error)")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("threads: must be a whole number from 0 to 4096, not 1000000", result.stdout)


class Troubles(unittest.TestCase):
    @unittest.skipUnless(os.path.exists("/dev/full"), "needs a device that is full")
    def test_a_checkpoint_that_could_not_be_written_is_warned_of(self):
        scene = ajar.load("builtin:cornell")
        before = os.getcwd()
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)  # where it is rescued
            try:
                os.symlink("/dev/full", "room.checkpoint")
                with warnings.catch_warnings(record=True) as said:
                    warnings.simplefilter("always")
                    picture = scene.render(checkpoint="room.checkpoint", **SMALL)
                self.assertEqual(picture.width, SMALL["resolution"][0])
                self.assertEqual([warning.category for warning in said], [RuntimeWarning])
                text = str(said[0].message)
                self.assertIn("No space left", text)
                rescued = os.path.join(os.path.realpath(folder), f"room-rescued-{os.getpid()}.checkpoint")
                self.assertIn(f"the checkpoint is in {rescued}", text)
                self.assertTrue(os.path.exists(rescued))
                self.assertEqual(said[0].filename, __file__)
            finally:
                os.chdir(before)

    def test_a_folder_that_is_not_there_is_told_before_the_render(self):
        with self.assertRaises(ajar.FileError):
            ajar.load("builtin:cornell").start(checkpoint="/no/such/folder/a.checkpoint", **SMALL)
