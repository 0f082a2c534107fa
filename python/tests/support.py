"""What the tests share: small renders."""

import os
import pathlib
import subprocess
import sys

import ajar
from ajar._library import program

ROOT = pathlib.Path(__file__).resolve().parents[2]
SMALL = {"integrator": "pt", "resolution": (24, 18), "spp": 8}


def command_line(*arguments):
    """Runs the program that belongs to the library."""
    return subprocess.run([program(), *map(str, arguments)], check=True, capture_output=True, text=True)


def run_python(code, **options):
    """Another interpreter with the same package."""
    path = str(pathlib.Path(ajar.__file__).parent.parent)
    environment = dict(os.environ, PYTHONPATH=os.pathsep.join([path, os.environ.get("PYTHONPATH", "")]))
    return subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, env=environment, timeout=120, **options)
