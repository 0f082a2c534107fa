"""Pictures against a reference."""

import collections.abc
import json
import os
import pathlib
import tempfile

import numpy

from ._errors import UsageError
from ._library import call_for_json
from ._nodes import plain_value, shown
from ._picture import Picture
from ._tables import Rows


class Comparison(Rows):
    """A row for each picture: its name and its metrics (docs/compare.md). `bias` has the test for bias of each, or None;
    `conditions` what the metrics were measured with, `warnings` what is unusual."""

    def __init__(self, names, found):
        super().__init__(
            {"picture": name, **picture["metrics"]} for name, picture in zip(names, found["pictures"], strict=True)
        )
        self.bias = {name: picture["bias"] for name, picture in zip(names, found["pictures"], strict=True)}
        self.conditions = found["conditions"]
        self.warnings = found["warnings"]

    def __getitem__(self, which):
        """A row by its number, or by the name of its picture."""
        if not isinstance(which, str):
            return super().__getitem__(which)
        for row in self:
            if row["picture"] == which:
                return row
        raise KeyError(f'there is no picture "{which}"; there are: {", ".join(row["picture"] for row in self)}')


def _write_pfm(path, array):
    if array.ndim == 2:
        array = numpy.repeat(array[:, :, None], 3, axis=2)
    if array.ndim != 3 or array.shape[2] != 3 or array.dtype.kind != "f":
        raise UsageError(f"pixels are floats of height x width x 3, not {array.dtype} of {array.shape}")
    height, width, _ = array.shape
    with open(path, "wb") as file:
        file.write(f"PF\n{width} {height}\n-1.0\n".encode())
        file.write(numpy.ascontiguousarray(array[::-1], "<f4").tobytes())


def _file_of(picture, folder, number):
    """A picture as a file, which the metrics are made for."""
    if isinstance(picture, Picture):
        path = folder / f"{number}.exr"
        picture.save(path)
        return str(path)
    if isinstance(picture, numpy.ndarray):
        path = folder / f"{number}.pfm"
        _write_pfm(path, picture)
        return str(path)
    if not isinstance(picture, (str, os.PathLike)):
        raise TypeError(f"a picture is an ajar.Picture, an array or the name of a file, not {shown(picture)}")
    return plain_value(os.fsdecode(picture), "picture")


def compare(reference, *pictures, metrics=(), pixels_per_degree=None):
    """Measures pictures against a reference: a `Comparison`. Each is a `Picture`, an array of scene-linear light or the name of a
    file. Instead of pictures one by one, a mapping of names to them. `metrics`: names, as of `ajar compare --metrics`; all by
    default."""
    named = {}
    for number, picture in enumerate(pictures, 1):
        if isinstance(picture, collections.abc.Mapping):
            named.update(picture)
        else:
            named[os.fspath(picture) if isinstance(picture, (str, os.PathLike)) else f"picture {number}"] = picture
    if not named:
        raise UsageError("compare needs a reference and at least one picture")
    with tempfile.TemporaryDirectory(prefix="ajar-compare-") as text:
        folder = pathlib.Path(text)
        request = {
            "reference": _file_of(reference, folder, 0),
            "pictures": [_file_of(picture, folder, n) for n, picture in enumerate(named.values(), 1)],
            "metrics": plain_value(metrics, "metrics"),
        }
        if pixels_per_degree is not None:
            request["pixels_per_degree"] = plain_value(pixels_per_degree, "pixels_per_degree")
        return Comparison(list(named), call_for_json("ajar_compare", json.dumps(request).encode()))
