"""Renders that go on while Python does something else."""

import atexit
import ctypes
import dataclasses
import json
import typing
import weakref

from ._errors import UsageError
from ._library import Handle, call, call_for_handle, call_for_json
from ._nodes import plain_value
from ._picture import Picture

# How long it takes at most until Ctrl-C is noticed, seconds.
_PATIENCE = 0.1

# What is called otherwise here than in the library.
_NAMES = {"time": "seconds", "spp": "samples_per_pixel"}
_SETTINGS = (
    "integrator",
    "target_error",
    "resolution",
    "scale",
    "crop",
    "filter",
    "layers",
    "seed",
    "threads",
    "checkpoint_every",
    "resume",
)

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


def _text_of(value):
    """A value of an integrator's parameter, as the command line has it."""
    value = plain_value(value)
    if isinstance(value, bool):
        return "true" if value else "false"
    return repr(value) if isinstance(value, float) else str(value)


def settings_json(given):
    """Settings of `Scene.render` as the library takes them."""
    settings = {"parameters": {}}
    for name, value in given.items():
        if value is None:
            continue
        if name in _NAMES:
            settings[_NAMES[name]] = plain_value(value)
        elif name in _SETTINGS:
            settings[name] = plain_value(value)
        elif name == "checkpoint":
            settings[name] = str(value)
        elif name == "depth":
            least, most = value if isinstance(value, (tuple, list)) else (None, value)
            settings["min_depth"], settings["max_depth"] = plain_value(least), plain_value(most)
        elif name == "denoise":
            settings["denoise"] = value if isinstance(value, str) else "auto" if value else "none"
        elif name == "parameters":
            settings["parameters"].update({key: _text_of(item) for key, item in value.items()})
        else:
            settings["parameters"][name] = _text_of(value)
    if isinstance(settings.get("layers"), str):
        raise UsageError(f"layers is a list of names, not \"{settings['layers']}\"")
    return json.dumps(settings)


class Session:
    """A render that was begun. It may be asked from any thread; as a context it is stopped when it is left."""

    def __init__(self, scene, given):
        self._handle = None
        settings = settings_json(given)
        self._handle = Handle(call_for_handle("ajar_render_start", scene.pointer, settings.encode()), "ajar_render_free")
        _running.add(self)

    def wait(self, seconds=None):
        """Waits for the end, at most so many seconds, and says whether it came. Raises what the render raised."""
        done = ctypes.c_int()
        left = seconds
        while True:
            # In pieces, so that Ctrl-C is noticed.
            piece = _PATIENCE if left is None else min(left, _PATIENCE)
            call("ajar_render_wait", self._handle.pointer, piece, ctypes.byref(done))
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

    @property
    def warnings(self):
        """What was unusual, one sentence each."""
        return call_for_json("ajar_render_messages", self._handle.pointer)["warnings"]

    @property
    def notes(self):
        """Choices that were made, one sentence each."""
        return call_for_json("ajar_render_messages", self._handle.pointer)["notes"]

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
