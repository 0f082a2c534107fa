"""Renders that go on while Python does something else."""

import atexit
import collections.abc
import ctypes
import dataclasses
import functools
import json
import os
import typing
import warnings
import weakref

import numpy

from ._catalog import catalog
from ._errors import UsageError
from ._library import Handle, call, call_for_handle, call_for_json
from ._nodes import calling_place, plain_value, shown
from ._picture import Picture

# How long it takes at most until Ctrl-C is noticed, seconds.
_PATIENCE = 0.1

# What is called otherwise here than in the library.
_NAMES = {"time": "seconds", "spp": "samples_per_pixel"}
_OUR_NAMES = {"seconds": "time", "samples_per_pixel": "spp", "min_depth": "depth", "max_depth": "depth"}


@functools.lru_cache(maxsize=None)
def _settings():
    """Names of the library's settings that have none of their own here."""
    return {option["name"] for option in catalog("options") if option["in_settings"]} - set(_OUR_NAMES)


_running = weakref.WeakSet()


@atexit.register
def _stop_all():
    """No thread outlives the interpreter."""
    for session in list(_running):
        session._handle.__del__()


@dataclasses.dataclass(frozen=True)
class Progress:
    """How far a render is."""

    preparing: bool
    seconds: float
    samples_per_pixel: float
    fraction: typing.Optional[float]
    estimated_error: typing.Optional[float]
    error_is_lower_bound: bool
    done: bool


def _text_of(value, name):
    """A value of an integrator's parameter, as the command line has it."""
    value = plain_value(value, name)
    if isinstance(value, bool):
        return "true" if value else "false"
    return repr(value) if isinstance(value, float) else str(value)


def _checkpoint(value):
    if not isinstance(value, (str, os.PathLike)):
        raise TypeError(f"checkpoint: the name of a file, not {shown(value)}")
    return plain_value(os.fsdecode(value), "checkpoint")


def _denoiser(value):
    if isinstance(value, (bool, numpy.bool_)):
        return "auto" if value else "none"
    if not isinstance(value, str):
        raise TypeError(f"denoise: True, False, or the name of a filter, not {shown(value)}")
    return plain_value(value, "denoise")


def settings_json(given):
    """Settings of `Scene.render` as the library takes them."""
    settings = {"parameters": {}}
    for name, value in given.items():
        if value is None:
            continue
        if name in _NAMES:
            settings[_NAMES[name]] = plain_value(value, name)
        elif name == "checkpoint":
            settings[name] = _checkpoint(value)
        elif name == "depth":
            depths = plain_value(value, name)
            least, most = depths if isinstance(depths, list) and len(depths) == 2 else (None, depths)
            settings["min_depth"], settings["max_depth"] = least, most
        elif name == "denoise":
            settings["denoise"] = _denoiser(value)
        elif name == "parameters":
            if not isinstance(value, collections.abc.Mapping):
                raise TypeError(f"parameters: names and values of the integrator's, not {shown(value)}")
            for key, item in value.items():
                settings["parameters"][plain_value(key, name)] = _text_of(item, str(key))
        elif name in _settings():
            settings[name] = plain_value(value, name)
        else:
            settings["parameters"][name] = _text_of(value, name)
    if isinstance(settings.get("layers"), str):
        raise UsageError(f"layers is a list of names, not \"{settings['layers']}\"")
    return json.dumps(settings)


def _started(scene, settings):
    try:
        return call_for_handle("ajar_render_start", scene.pointer, settings.encode())
    except UsageError as error:
        name, colon, rest = str(error).partition(": ")
        raise UsageError(_OUR_NAMES.get(name, name) + colon + rest) from None


def checked_seconds(value, name):
    """A number of seconds from 0 on."""
    if isinstance(value, bool) or not isinstance(value, (int, float, numpy.integer, numpy.floating)):
        raise TypeError(f"{name}: seconds, not {shown(value)}")
    seconds = float(value)
    if not seconds >= 0:
        raise UsageError(f"{name}: seconds from 0 on, not {seconds}")
    return seconds


class Session:
    """A render that was begun. It may be asked from any thread; as a context it is stopped when it is left."""

    def __init__(self, scene, given):
        self._handle = None
        settings = settings_json(given)
        self._handle = Handle(_started(scene, settings), "ajar_render_free")
        self._troubles_said = 0
        _running.add(self)

    def wait(self, seconds=None):
        """Waits for the end, at most so many seconds, and says whether it came. Raises what the render raised."""
        done = ctypes.c_int()
        left = None if seconds is None else checked_seconds(seconds, "wait")
        while True:
            # In pieces, so that Ctrl-C is noticed.
            piece = _PATIENCE if left is None else min(left, _PATIENCE)
            try:
                call("ajar_render_wait", self._handle.pointer, piece, ctypes.byref(done))
            finally:
                self._say_troubles()
            if done.value:
                return True
            if left is not None:
                left -= piece
                if left <= 0:
                    return False

    @property
    def done(self):
        return self.progress().done

    def picture(self):
        """The picture as it is. Waits for the end of the pass that runs. Before the first pass, a rough look of 0 samples
        per pixel if the method has one, without other layers; else None."""
        done = self.done
        self._say_troubles()
        pointer = call_for_handle("ajar_render_picture", self._handle.pointer)
        if pointer is None:
            return None
        # What is known while it renders is in the picture's metadata; to ask would wait for another pass.
        return Picture(pointer, self.statistics() if done else None)

    def progress(self):
        return Progress(**call_for_json("ajar_render_progress", self._handle.pointer))

    def statistics(self):
        """All that is known, as `ajar render --stats` writes it."""
        return call_for_json("ajar_render_statistics", self._handle.pointer)

    def _messages(self):
        return call_for_json("ajar_render_messages", self._handle.pointer)

    def _say_troubles(self):
        """Warns of what would be found out too late."""
        troubles = self.troubles
        said, self._troubles_said = self._troubles_said, len(troubles)
        for text in troubles[said:]:
            warnings.warn_explicit(text, RuntimeWarning, *calling_place())

    @property
    def warnings(self):
        """What was unusual, one sentence each."""
        return self._messages()["warnings"]

    @property
    def troubles(self):
        """Files that could not be written, such as the checkpoint, and where they are instead, one sentence each."""
        return self._messages()["troubles"]

    @property
    def notes(self):
        """Choices that were made, one sentence each."""
        return self._messages()["notes"]

    def stop(self):
        """Ends it after the pass that runs; called twice, within it. Does not wait."""
        call("ajar_render_stop", self._handle.pointer)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self._handle.pointer and not self.done:
            self.stop()
            self.stop()
        return False
