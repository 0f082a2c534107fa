"""Materials, textures, lights, emissions and shapes: functions that are made of the library's own list of models."""

import inspect
import json
import math
import os
import reprlib
import sys

import numpy

from ._catalog import catalog
from ._errors import SceneError, UsageError
from ._library import call

# What stands in place of a parameter that is geometry.
GEOMETRY = {
    "mesh": ("positions", "indices", "normals", "tangents", "uvs"),
    "curves": ("control_points", "widths", "normals"),
}
RELIEFS = ("bump", "normal_map")
"""What any material may have: textures that tilt its normals."""

_PACKAGE = os.path.dirname(os.path.abspath(__file__))


def calling_place():
    """File and line outside of this package, for messages."""
    frame = sys._getframe(1)
    while frame is not None and os.path.dirname(os.path.abspath(frame.f_code.co_filename)) == _PACKAGE:
        frame = frame.f_back
    return [frame.f_code.co_filename, frame.f_lineno] if frame else ["python", 0]


class Node:
    """A part of a scene: of a model, with the parameters that were given. It never changes."""

    __slots__ = ("kind", "model", "parameters", "name", "relief", "where")

    def __init__(self, kind, model, parameters, name="", relief=None):
        self.kind = kind
        self.model = model
        self.parameters = parameters
        self.name = name
        self.relief = relief or {}
        self.where = calling_place()

    def __repr__(self):
        given = ", ".join(f"{name}={shown(value)}" for name, value in self.parameters.items())
        return f"ajar.{self.kind}s.{self.model}({given})"


class Medium:
    """What is inside of shapes: absorption and scattering, 1 per unit of length, red, green and blue; `g` from −1
    (back) to 1 (forward)."""

    __slots__ = ("name", "sigma_a", "sigma_s", "g", "where")

    def __init__(self, sigma_a=(0, 0, 0), sigma_s=(0, 0, 0), g=0.0, name=""):
        self.sigma_a = sigma_a
        self.sigma_s = sigma_s
        self.g = g
        self.name = name
        self.where = calling_place()


def shown(value):
    """A value for a message, however large it is."""
    if isinstance(value, numpy.ndarray) and value.size > 16:
        return f"<array {value.shape}>"
    return reprlib.repr(value)


def is_image(spec, value):
    """Whether a value is an image rather than a number, a colour or a matrix."""
    return isinstance(value, numpy.ndarray) and value.ndim >= 2 and (spec is None or spec["type"] != "transform")


def spec_of(kind, model, name):
    """What the library says of a parameter; None if there is none."""
    for entry in catalog(kind + "s"):
        if entry["name"] == model:
            return next((spec for spec in entry["parameters"] if spec["name"] == name), None)
    return None


_DEEPEST = 8
"""Lists in one another: no value has so many."""


def plain_value(value, name, depth=0):
    """A value as JSON has it; raises TypeError or UsageError, with its name, for what is none."""
    if isinstance(value, (numpy.bool_, numpy.integer, numpy.floating)):
        value = value.item()
    if isinstance(value, numpy.ndarray):
        if value.dtype.kind not in "biuf":
            raise TypeError(f"{name}: an array of numbers, not of {value.dtype}")
        value = value.astype(float) if value.dtype.kind == "f" else value
        value = value.ravel().tolist() if value.ndim else value.item()
    if isinstance(value, (tuple, list)):
        if depth == _DEEPEST:
            raise UsageError(f"{name}: lists in lists, more than {_DEEPEST} deep")
        return [plain_value(item, name, depth + 1) for item in value]
    if isinstance(value, os.PathLike):
        value = os.fsdecode(value)
    if isinstance(value, float) and not math.isfinite(value):
        raise UsageError(f"{name}: values are finite, not {value}")
    if isinstance(value, str):
        try:
            value.encode()
        except UnicodeEncodeError:
            raise UsageError(f"{name}: text that can be written as UTF-8, not {value!r}") from None
    if value is None or isinstance(value, (bool, int, float, str)):
        return value
    raise TypeError(f"{name}: {type(value).__name__} is no value of a parameter: {shown(value)}")


def _check(kind, model, parameters, specs):
    """Raises what the library has to say of names and values; arrays and what is referred to come later."""
    checked = {}
    for name, value in parameters.items():
        if any(name in GEOMETRY.get(spec["type"], ()) for spec in specs):
            continue
        spec = spec_of(kind, model, name)
        if isinstance(value, Node):
            fits = spec is None or value.kind == spec["type"] or (value.kind == "texture" and spec.get("textured"))
            if not fits:
                raise SceneError(f'{model}: "{name}" cannot be a {value.kind}')
            checked[name] = {value.kind: 0}
        elif is_image(spec, value):
            # Of unknown names the library says what there is.
            checked[name] = None
        else:
            checked[name] = plain_value(value, name)
    call("ajar_node_check", kind.encode(), json.dumps({"model": model, "parameters": checked}).encode())


def _signature(kind, specs):
    parameters = []
    for spec in specs:
        for name in GEOMETRY.get(spec["type"], (spec["name"],)):
            needed = name in ("positions", "indices", "control_points", "widths")
            default = inspect.Parameter.empty if needed else default_of(spec)
            parameters.append(inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=default))
    parameters.append(inspect.Parameter("name", inspect.Parameter.KEYWORD_ONLY, default=""))
    if kind == "material":
        for relief in RELIEFS:
            parameters.append(inspect.Parameter(relief, inspect.Parameter.KEYWORD_ONLY, default=None))
    return inspect.Signature(parameters)


def default_of(spec):
    """The default of a parameter as Python has it; None for none."""
    text = spec["default"]
    kind = spec["type"]
    if kind in ("text", "choice", "file"):
        return text or None
    if text == "" or kind in ("transform", "mesh", "curves", "material"):
        return None
    if kind == "bool":
        return text == "true"
    numbers = [float(number) for number in text.split()]
    if kind == "int":
        return int(numbers[0])
    return numbers[0] if len(numbers) == 1 else tuple(numbers)


def _documentation(entry):
    lines = [entry["summary"] + "."]
    if entry["source"]:
        lines.append(f"\nSource: {entry['source']}.")
    if entry["parameters"]:
        lines.append("")
    for spec in entry["parameters"]:
        about = [spec["unit"]] if spec["unit"] else []
        if spec.get("choices"):
            about.append("one of " + ", ".join(spec["choices"]))
        if spec.get("textured"):
            about.append("may be a texture or an image")
        names = ", ".join(GEOMETRY.get(spec["type"], (spec["name"],)))
        lines.append(f"{names}: {spec['help']}" + (f" ({'; '.join(about)})" if about else ""))
    return "\n".join(lines)


def _function(kind, entry):
    model = entry["name"]
    specs = entry["parameters"]

    def make(*, name="", **parameters):
        relief = {}
        if kind == "material":
            relief = {what: parameters.pop(what) for what in RELIEFS if what in parameters}
            relief = {what: texture for what, texture in relief.items() if texture is not None}
        _check(kind, model, parameters, specs)
        return Node(kind, model, parameters, name, relief)

    make.__name__ = make.__qualname__ = model
    make.__module__ = f"ajar.{kind}s"
    make.__doc__ = _documentation(entry)
    make.__signature__ = _signature(kind, specs)
    return make


def functions(kind):
    """One function for each model of a kind, by name."""
    return {entry["name"]: _function(kind, entry) for entry in catalog(kind + "s")}
