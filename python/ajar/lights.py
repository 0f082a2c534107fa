"""All models of lights, made of the library's own list (`ajar list lights`)."""

from ._nodes import functions as _functions

globals().update(_functions("light"))
__all__ = sorted(_functions("light"))
