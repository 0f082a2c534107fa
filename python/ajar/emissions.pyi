"""All models of emissions. Made by python/make_stubs.py from the library's own list."""

from typing import Literal

from ._types import ArrayLike, Color, File, Node, Number, TexturedColor, TexturedNumber, Transform, Vector

def area(
    *,
    radiance: TexturedColor = 1.0,
    scale: Color = 1.0,
    two_sided: bool = False,
    name: str = '',
) -> Node:
    """the same radiance in all directions from every point of a surface."""
