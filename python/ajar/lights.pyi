"""All models of lights. Made by python/make_stubs.py from the library's own list."""

from typing import Literal

from ._types import ArrayLike, Color, File, Node, Number, TexturedColor, TexturedNumber, Transform, Vector

def distant(
    *,
    irradiance: Color = 1.0,
    name: str = '',
) -> Node:
    """parallel light from the direction of z."""

def environment(
    *,
    radiance: Color = 1.0,
    image: File | None = None,
    projection: Literal["longitude_latitude", "equal_area"] = 'longitude_latitude',
    decoding_exponent: Number | None = None,
    nearest: bool = False,
    rows_at_poles: bool = False,
    irradiance: Number | None = None,
    name: str = '',
) -> Node:
    """light from all around, the same or by an image."""

def goniometric(
    *,
    intensity: Color = 1.0,
    image: File | None = None,
    gray: bool = False,
    projection: Literal["longitude_latitude", "equal_area"] = 'longitude_latitude',
    power: Number | None = None,
    name: str = '',
) -> Node:
    """from one point, by an image of all directions."""

def point(
    *,
    intensity: Color = 1.0,
    name: str = '',
) -> Node:
    """the same in all directions from one point."""

def projection(
    *,
    intensity: Color = 1.0,
    fov: Number = 45.0,
    fov_axis: Literal["shorter", "longer", "x", "y", "diagonal"] = 'shorter',
    image: File | None = None,
    image_is: Literal["intensity", "irradiance"] = 'intensity',
    decoding_exponent: Number | None = None,
    power: Number | None = None,
    name: str = '',
) -> Node:
    """a slide projector along z."""

def sky(
    *,
    turbidity: Number = 3.0,
    elevation: Number = 45.0,
    scale: Number = 1.0,
    name: str = '',
) -> Node:
    """the clear sky without its sun, which is over x; up is z."""

def spot(
    *,
    intensity: Color = 1.0,
    cone_angle: Number = 30.0,
    falloff_start: Number = 25.0,
    falloff: Literal["quartic", "smoothstep", "quadratic", "angle"] = 'quartic',
    name: str = '',
) -> Node:
    """a cone of light along z from one point, with a soft edge."""
