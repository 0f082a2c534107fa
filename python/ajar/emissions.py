"""All models of emissions, made of the library's own list (`ajar list emissions`)."""

from ._nodes import functions as _functions

globals().update(_functions("emission"))
__all__ = sorted(_functions("emission"))
