"""Experiments at equal time or equal samples, as `ajar study` makes them."""

import collections.abc
import csv
import json
import os
import pathlib
import subprocess
import tempfile

from ._errors import Error, FileError, SceneError, UsageError
from ._library import program
from ._tables import Rows


def _value(text):
    if text == "":
        return None
    try:
        number = float(text)
    except ValueError:
        return text
    return int(number) if text.isdigit() else number


class Study(Rows):
    """A row for each scene, method and budget, as `study.csv` has them; `folder` holds all files, among them a report for each
    scene; `result` is `study.json`."""

    def __init__(self, folder):
        with open(folder / "study.csv", newline="", encoding="utf-8") as file:
            super().__init__({name: _value(text) for name, text in row.items()} for row in csv.DictReader(file))
        self.folder = folder
        self.result = json.loads((folder / "study.json").read_text(encoding="utf-8"))


def _error_of(code, lines):
    kind = {2: UsageError, 3: SceneError, 4: FileError}.get(code, Error)
    said = [line.removeprefix("ajar: ").removeprefix("error: ") for line in lines if line.strip()]
    return kind("; ".join(said[-3:]) or f"ajar study ended with {code}")


def study(plan, out=None, *, progress=None):
    """Carries out a study (docs/studies.md) and returns its tables. `plan`: the content of a study file, or its name. `out`: the
    folder for what it makes; a study that was interrupted goes on there. `progress`: called with each line of what is done.

    Every render is a process of its own, so that none finds caches warm from another."""
    if isinstance(plan, collections.abc.Mapping):
        folder = pathlib.Path(out) if out is not None else pathlib.Path(tempfile.mkdtemp(prefix="ajar-study-"))
        folder.mkdir(parents=True, exist_ok=True)
        # Files that a plan names count from its own folder: from here.
        descriptor, name = tempfile.mkstemp(prefix=".ajar-study-", suffix=".json", dir=".")
        with os.fdopen(descriptor, "w") as file:
            json.dump(plan, file)
        try:
            return _carry_out(name, folder, progress)
        finally:
            os.unlink(name)
    path = pathlib.Path(plan)
    return _carry_out(str(path), pathlib.Path(out) if out is not None else pathlib.Path(path.stem + "-results"), progress)


def _carry_out(file, folder, progress):
    command = [str(program()), "study", file, "--out", str(folder)]
    lines = []
    with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, errors="replace") as process:
        try:
            for line in process.stderr:
                lines.append(line.rstrip("\n"))
                if progress is not None:
                    progress(lines[-1])
        except KeyboardInterrupt:
            # It was told, too, and keeps what is finished.
            process.wait()
            raise
    if process.returncode not in (0, 1):
        raise _error_of(process.returncode, lines)
    if process.returncode == 1 and not (folder / "study.csv").exists():
        raise _error_of(1, lines)
    return Study(folder)
