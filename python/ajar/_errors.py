"""What Ajar raises. The message is ready to be shown; that of a scene begins with its place."""


class Error(Exception):
    """Base of all of Ajar's own errors."""


class UsageError(Error, ValueError):
    """An unknown name, or a value that cannot be."""


class SceneError(Error, ValueError):
    """A scene that cannot be used."""


class FileError(Error, OSError):
    """A file that cannot be read or written."""


class Stopped(Error):
    """A render that was stopped before there was a picture."""


def error_of(code, message):
    """The exception for a code of ajar/c.h."""
    if code == 5:
        return MemoryError(message)
    return {1: UsageError, 2: SceneError, 3: FileError, 4: Stopped}.get(code, Error)(message)
