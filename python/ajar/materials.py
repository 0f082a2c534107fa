"""All models of materials, made of the library's own list (`ajar list materials`)."""

from ._nodes import functions as _functions

globals().update(_functions("material"))
__all__ = sorted(_functions("material"))
