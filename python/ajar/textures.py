"""All models of textures, made of the library's own list (`ajar list textures`)."""

from ._nodes import functions as _functions

globals().update(_functions("texture"))
__all__ = sorted(_functions("texture"))
