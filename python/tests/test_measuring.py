import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy
from support import ROOT, SMALL, command_line

import ajar


class Measuring(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        scene = ajar.load("builtin:cornell")
        cls.reference = scene.render(**{**SMALL, "spp": 64})
        cls.picture = scene.render(**SMALL)

    def test_compares_as_the_command_line_does(self):
        with tempfile.TemporaryDirectory() as folder:
            paths = [f"{folder}/reference.exr", f"{folder}/picture.exr"]
            self.reference.save(paths[0])
            self.picture.save(paths[1])
            theirs = json.loads(command_line("compare", *paths, "--json").stdout)["pictures"][0]["metrics"]
            of_files = ajar.compare(*paths)
        ours = ajar.compare(self.reference, self.picture)
        self.assertEqual({name: value for name, value in ours[0].items() if name != "picture"}, theirs)
        self.assertEqual({**of_files[0], "picture": "picture 1"}, ours[0])

    def test_compares_pictures_arrays_and_files_by_name(self):
        rows = ajar.compare(
            self.reference,
            {"same": self.reference.pixels, "noisy": self.picture, "black": numpy.zeros((18, 24, 3))},
            metrics=["relmse", "psnr"],
        )
        self.assertEqual([row["picture"] for row in rows], ["same", "noisy", "black"])
        self.assertEqual(rows["same"]["relmse"], 0)
        self.assertIsNone(rows["same"]["psnr"])
        self.assertLess(rows["noisy"]["relmse"], rows["black"]["relmse"])
        self.assertIn("<table>", rows._repr_html_())
        self.assertEqual(len(rows.table), 3)
        with self.assertRaises(KeyError):
            rows["grey"]
        with self.assertRaisesRegex(ajar.UsageError, 'did you mean "relmse"'):
            ajar.compare(self.reference, self.picture, metrics=["relmsa"])
        with self.assertRaises(ajar.UsageError):
            ajar.compare(self.reference, self.picture.pixels[1:])
        with self.assertRaises(ajar.UsageError):
            ajar.compare(self.reference)

    def test_carries_out_studies(self):
        plan = {
            "scenes": ["builtin:cornell"],
            "resolution": "24x18",
            "integrators": ["pt", "bdpt"],
            "seeds": 2,
            "budgets": [{"spp": 4}],
            "reference": {"integrator": "pt", "spp": 16},
            "metrics": ["relmse"],
        }
        lines = []
        with tempfile.TemporaryDirectory() as folder:
            study = ajar.study(plan, folder, progress=lines.append)
            self.assertEqual([row["method"] for row in study], ["pt", "bdpt"])
            self.assertGreater(study[0]["relmse"], 0)
            self.assertTrue((study.folder / "study.md").exists())
            self.assertTrue(lines)
            with self.assertRaisesRegex(ajar.UsageError, "ptt"):
                ajar.study({**plan, "integrators": ["ptt"]}, folder)
        with self.assertRaises(ajar.FileError):
            ajar.study("/no/such/study.json", "/tmp/nothing")


class Package(unittest.TestCase):
    def test_has_stubs_that_are_up_to_date(self):
        outcome = subprocess.run(
            [sys.executable, ROOT / "python/make_stubs.py", "--check"], capture_output=True, text=True, check=False
        )
        self.assertEqual((outcome.returncode, outcome.stderr), (0, ""))

    def test_has_the_program(self):
        outcome = subprocess.run([sys.executable, "-m", "ajar", "--version"], capture_output=True, text=True, check=True)
        self.assertIn(ajar.__version__, outcome.stdout)

    def test_runs_the_notebook(self):
        try:
            import nbclient
            import nbformat
        except ImportError:
            self.skipTest("nbclient is not installed")
        notebook = nbformat.read(ROOT / "docs/python.ipynb", as_version=4)
        for cell in notebook.cells:
            self.assertFalse(cell.get("outputs"), "the notebook is kept without what it puts out")
        with tempfile.TemporaryDirectory() as folder:
            client = nbclient.NotebookClient(
                notebook, timeout=120, kernel_name="python3", resources={"metadata": {"path": folder}}
            )
            client.execute()
            self.assertTrue((pathlib.Path(folder) / "glass.exr").exists())


if __name__ == "__main__":
    unittest.main()
