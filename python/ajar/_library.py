"""The shared library and its C face (include/ajar/c.h), as `ctypes` calls it: without the lock of the interpreter, so that
other threads of Python go on meanwhile."""

import ctypes
import json
import os
import pathlib
import reprlib

from ._errors import UsageError, error_of

_C_VERSION = 3


class Array(ctypes.Structure):
    """ajar_array."""

    _fields_ = [
        ("data", ctypes.c_void_p),
        ("type", ctypes.c_int),
        ("dimensions", ctypes.c_int),
        ("shape", ctypes.c_size_t * 3),
    ]


def _path():
    own = pathlib.Path(__file__).parent / "lib" / "libajar.so"
    given = os.environ.get("AJAR_LIBRARY")
    path = pathlib.Path(given) if given else own
    if not path.exists():
        raise ImportError(
            f"Ajar's library is not at {path}: install the package with pip, or set AJAR_LIBRARY to the libajar.so of a build"
        )
    return path


_text = ctypes.c_char_p
_handle = ctypes.c_void_p
_out = ctypes.POINTER(ctypes.c_void_p)
_int = ctypes.c_int

# Arguments of the functions that answer with a code.
_FUNCTIONS = {
    "ajar_catalog": [_text, _out],
    "ajar_node_check": [_text, _text],
    "ajar_scene_load": [_text, _out],
    "ajar_scene_change": [_handle, _text, ctypes.POINTER(Array), ctypes.c_size_t, _out],
    "ajar_scene_information": [_handle, _out],
    "ajar_scene_parts": [_handle, _out],
    "ajar_render_start": [_handle, _text, _out],
    "ajar_render_wait": [_handle, ctypes.c_double, ctypes.POINTER(_int)],
    "ajar_render_stop": [_handle],
    "ajar_render_picture": [_handle, _out],
    "ajar_render_progress": [_handle, _out],
    "ajar_render_statistics": [_handle, _out],
    "ajar_render_messages": [_handle, _out],
    "ajar_picture_layers": [_handle, _out],
    "ajar_picture_pixels": [_handle, _text, ctypes.POINTER(_int), _out],
    "ajar_picture_metadata": [_handle, _out],
    "ajar_picture_save": [_handle, _text, _text],
    "ajar_picture_load": [_text, _out],
    "ajar_compare": [_text, _out],
}


def _open():
    library = ctypes.CDLL(str(_path()))
    library.ajar_c_version.restype = _int
    if library.ajar_c_version() < _C_VERSION:
        raise ImportError(f"{_path()} is older than this package")
    for name, arguments in _FUNCTIONS.items():
        function = getattr(library, name)
        function.argtypes = arguments
        function.restype = _int
    for name in ("ajar_text_free", "ajar_scene_free", "ajar_render_free", "ajar_picture_free"):
        function = getattr(library, name)
        function.argtypes = [_handle]
        function.restype = None
    for name in ("ajar_picture_width", "ajar_picture_height"):
        function = getattr(library, name)
        function.argtypes = [_handle]
        function.restype = _int
    for name in ("ajar_version", "ajar_last_error"):
        getattr(library, name).restype = _text
    return library


library = _open()


def encoded(text, what="the name of a file"):
    """Text for the library; what is no text of UTF-8, as names of files may be, goes through as it is."""
    if not isinstance(text, (str, os.PathLike)):
        raise TypeError(f"{what} is text or a path, not {reprlib.repr(text)}")
    try:
        made = os.fsencode(text) if isinstance(text, os.PathLike) else text.encode("utf-8", "surrogateescape")
    except UnicodeEncodeError:
        raise UsageError(f"{what} cannot be {text!r}: this is no text of UTF-8") from None
    if b"\0" in made:
        raise UsageError(f"{text!r} has a zero in it")
    return made


def call(name, *arguments):
    """Calls a function and raises what it says."""
    code = getattr(library, name)(*arguments)
    if code != 0:
        raise error_of(code, library.ajar_last_error().decode("utf-8", "replace"))


def call_for_json(name, *arguments):
    """Calls a function whose last argument is a text that it makes, and reads that as JSON."""
    text = ctypes.c_void_p()
    call(name, *arguments, ctypes.byref(text))
    try:
        return json.loads(ctypes.string_at(text.value))
    finally:
        library.ajar_text_free(text)


def call_for_handle(name, *arguments):
    """Calls a function whose last argument is a handle that it makes. None for none."""
    handle = ctypes.c_void_p()
    call(name, *arguments, ctypes.byref(handle))
    return handle.value


class Handle:
    """Something of the library's, freed with this object. Not in a child of `fork`, where threads of renders are gone."""

    def __init__(self, pointer, free):
        self.pointer = pointer
        self._free = getattr(library, free)
        self._process = os.getpid()

    def __del__(self, getpid=os.getpid):
        if self.pointer and getpid() == self._process:
            self._free(self.pointer)
            self.pointer = None


def version():
    return library.ajar_version().decode()


def program():
    """The `ajar` that belongs to the library: beside it in a build, in bin/ where both are installed."""
    beside = _path().parent / "ajar"
    return beside if beside.is_file() else _path().parent.parent / "bin" / "ajar"
