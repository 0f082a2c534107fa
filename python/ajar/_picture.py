"""Pictures."""

import collections.abc
import ctypes
import json
import pathlib
import tempfile

import numpy

from ._errors import UsageError
from ._library import Handle, call, call_for_handle, call_for_json, encoded, library
from ._nodes import plain_value


class _Memory:
    """Pixels of the library as NumPy takes them, which keep the picture."""

    def __init__(self, handle, address, shape):
        self.handle = handle
        self.__array_interface__ = {
            "data": (address, True),
            "shape": shape,
            "typestr": "<f4",
            "version": 3,
        }


class Layers(collections.abc.Mapping):
    """The layers of a picture beside the picture itself, by name: arrays of height × width × 3, or height × width."""

    def __init__(self, picture, names):
        self._picture = picture
        self._names = names

    def __getitem__(self, name):
        if name not in self._names:
            raise KeyError(
                f'there is no layer "{name}"; there are: {", ".join(self._names) or "none"}. '
                "Layers are asked for: render(layers=[…]); see ajar.list_aovs()"
            )
        return self._picture._array(name)

    def __iter__(self):
        return iter(self._names)

    def __len__(self):
        return len(self._names)

    def __repr__(self):
        return f"<layers {', '.join(self._names)}>"


class Picture:
    """A picture with its layers. It never changes; `numpy.asarray` of it is `pixels`."""

    def __init__(self, pointer, statistics=None):
        self._handle = Handle(pointer, "ajar_picture_free")
        self._names = call_for_json("ajar_picture_layers", pointer)
        self._statistics = statistics
        self.width = library.ajar_picture_width(pointer)
        self.height = library.ajar_picture_height(pointer)

    def _array(self, layer):
        channels = ctypes.c_int()
        address = ctypes.c_void_p()
        call(
            "ajar_picture_pixels",
            self._handle.pointer,
            encoded(layer),
            ctypes.byref(channels),
            ctypes.byref(address),
        )
        shape = (self.height, self.width, 3) if channels.value == 3 else (self.height, self.width)
        return numpy.asarray(_Memory(self._handle, address.value, shape))

    @property
    def pixels(self):
        """Scene-linear light, height × width × 3, float32: the renderer's own memory, read-only."""
        return self._array("")

    @property
    def layers(self):
        """What else there is, by name."""
        return Layers(self, self._names[1:])

    @property
    def denoised(self):
        """The layer without noise, height × width × 3; None unless it was asked for."""
        return self._array("denoised") if "denoised" in self._names else None

    @property
    def standard_error(self):
        """Of each value of `pixels`, as estimated; of the layer of that name."""
        return self.layers["standard-error"]

    @property
    def estimated_error(self):
        """Relative error of the whole picture, as estimated; None where it is not known."""
        if self._statistics is not None:
            return self._statistics.get("estimated_relative_error")
        text = self.metadata.get("ajar:estimated_relative_error")
        return None if text is None else float(text)

    @property
    def stats(self):
        """All that is known of the render, as `ajar render --stats` writes it; of files what is in their metadata."""
        if self._statistics is not None:
            return self._statistics
        return {name.removeprefix("ajar:"): text for name, text in self.metadata.items()}

    @property
    def metadata(self):
        """Texts that go into files: method, parameters, seed, samples, time, …."""
        return call_for_json("ajar_picture_metadata", self._handle.pointer)

    def save(self, path, exposure=0.0, tone_map="srgb"):
        """Writes `.exr` (all layers), `.pfm`, `.hdr` (scene-linear), `.png` or `.jpg` (for the eye; without noise, if the
        picture was denoised; `exposure` in stops; `tone_map` is srgb or filmic)."""
        display = {"exposure": plain_value(exposure, "exposure"), "tone_map": plain_value(tone_map, "tone_map")}
        call("ajar_picture_save", self._handle.pointer, encoded(path), json.dumps(display).encode())

    def _repr_png_(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "picture.png"
            self.save(path)
            return path.read_bytes()

    def __array__(self, dtype=None, copy=None):
        if copy is False and dtype not in (None, numpy.float32):
            raise ValueError("pixels of another type are a copy")
        pixels = self.pixels
        if dtype not in (None, numpy.float32):
            return pixels.astype(dtype)
        return pixels.copy() if copy else pixels

    def __repr__(self):
        return f"<ajar.Picture {self.width} x {self.height}, layers: {', '.join(self._names[1:]) or 'none'}>"


def open_picture(path):
    """A picture of a file: scene-linear, `.exr` with its layers, `.hdr` or `.pfm`."""
    name = encoded(path)
    if not name:
        raise UsageError("open_picture needs the name of a file")
    return Picture(call_for_handle("ajar_picture_load", name))
