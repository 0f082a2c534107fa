"""All models of shapes, made of the library's own list (`ajar list shapes`)."""

from ._nodes import functions as _functions

globals().update(_functions("shape"))
__all__ = sorted(_functions("shape"))
