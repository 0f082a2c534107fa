"""All models of textures. Made by python/make_stubs.py from the library's own list."""

from typing import Literal

from ._types import ArrayLike, Color, File, Node, Number, TexturedColor, TexturedNumber, Transform, Vector

def bilinear(
    *,
    v00: Color = 0.0,
    v01: Color = 1.0,
    v10: Color = 0.0,
    v11: Color = 1.0,
    mapping: Literal["uv", "spherical", "cylindrical", "planar"] = 'uv',
    scale_u: Number = 1.0,
    scale_v: Number = 1.0,
    rotation: Number = 0.0,
    offset_u: Number = 0.0,
    offset_v: Number = 0.0,
    axis_u: Vector = (1.0, 0.0, 0.0),
    axis_v: Vector = (0.0, 1.0, 0.0),
    height: Literal["cosine", "place"] = 'cosine',
    world_to_texture: Transform | None = None,
    name: str = '',
) -> Node:
    """four corners with blends between them."""

def checkerboard(
    *,
    first: TexturedColor = 1.0,
    second: TexturedColor = 0.0,
    mapping: Literal["uv", "spherical", "cylindrical", "planar"] = 'uv',
    scale_u: Number = 1.0,
    scale_v: Number = 1.0,
    rotation: Number = 0.0,
    offset_u: Number = 0.0,
    offset_v: Number = 0.0,
    axis_u: Vector = (1.0, 0.0, 0.0),
    axis_v: Vector = (0.0, 1.0, 0.0),
    height: Literal["cosine", "place"] = 'cosine',
    world_to_texture: Transform | None = None,
    name: str = '',
) -> Node:
    """squares of two textures by turns."""

def constant(
    *,
    value: Color = 1.0,
    name: str = '',
) -> Node:
    """the same value everywhere."""

def dots(
    *,
    inside: TexturedColor = 1.0,
    outside: TexturedColor = 0.0,
    mapping: Literal["uv", "spherical", "cylindrical", "planar"] = 'uv',
    scale_u: Number = 1.0,
    scale_v: Number = 1.0,
    rotation: Number = 0.0,
    offset_u: Number = 0.0,
    offset_v: Number = 0.0,
    axis_u: Vector = (1.0, 0.0, 0.0),
    axis_v: Vector = (0.0, 1.0, 0.0),
    height: Literal["cosine", "place"] = 'cosine',
    world_to_texture: Transform | None = None,
    name: str = '',
) -> Node:
    """dots, strewn at random."""

def fbm(
    *,
    octaves: int = 8,
    roughness: Number = 0.5,
    world_to_texture: Transform | None = None,
    name: str = '',
) -> Node:
    """fractal noise around 0 (fractional Brownian motion)."""

def image(
    *,
    file: File | None = None,
    channel: Literal["color", "red", "green", "blue", "alpha", "mean", "luminance", "alpha_or_mean", "varying_alpha_or_mean"] = 'color',
    wrap: Literal["repeat", "black", "clamp"] = 'repeat',
    decode_srgb: bool = True,
    decoding_exponent: Number | None = None,
    scale: Number = 1.0,
    offset: Number = 0.0,
    invert: bool = False,
    clamp: bool = False,
    filter: Literal["bilinear", "nearest"] = 'bilinear',
    mapping: Literal["uv", "spherical", "cylindrical", "planar"] = 'uv',
    scale_u: Number = 1.0,
    scale_v: Number = 1.0,
    rotation: Number = 0.0,
    offset_u: Number = 0.0,
    offset_v: Number = 0.0,
    axis_u: Vector = (1.0, 0.0, 0.0),
    axis_v: Vector = (0.0, 1.0, 0.0),
    height: Literal["cosine", "place"] = 'cosine',
    world_to_texture: Transform | None = None,
    name: str = '',
) -> Node:
    """an image file."""

def marble(
    *,
    octaves: int = 8,
    roughness: Number = 0.5,
    world_to_texture: Transform | None = None,
    scale: Number = 1.0,
    variation: Number = 0.2,
    name: str = '',
) -> Node:
    """layers of stone with veins."""

def mix(
    *,
    first: TexturedColor = 0.0,
    second: TexturedColor = 1.0,
    amount: TexturedNumber = 0.5,
    name: str = '',
) -> Node:
    """two textures, blended by a third."""

def product(
    *,
    first: TexturedColor = 1.0,
    second: TexturedColor = 1.0,
    name: str = '',
) -> Node:
    """two textures, multiplied."""

def solid_checkerboard(
    *,
    first: TexturedColor = 1.0,
    second: TexturedColor = 0.0,
    world_to_texture: Transform | None = None,
    name: str = '',
) -> Node:
    """cubes of two textures by turns."""

def threshold(
    *,
    value: TexturedNumber = 1.0,
    edge: Number = 0.5,
    name: str = '',
) -> Node:
    """1 where a texture is large enough, else 0."""

def uv(
    *,
    mapping: Literal["uv", "spherical", "cylindrical", "planar"] = 'uv',
    scale_u: Number = 1.0,
    scale_v: Number = 1.0,
    rotation: Number = 0.0,
    offset_u: Number = 0.0,
    offset_v: Number = 0.0,
    axis_u: Vector = (1.0, 0.0, 0.0),
    axis_v: Vector = (0.0, 1.0, 0.0),
    height: Literal["cosine", "place"] = 'cosine',
    world_to_texture: Transform | None = None,
    name: str = '',
) -> Node:
    """shows the coordinates of a mapping as red and green."""

def windy(
    *,
    world_to_texture: Transform | None = None,
    name: str = '',
) -> Node:
    """waves on water, where gusts of wind touch it."""

def wrinkled(
    *,
    octaves: int = 8,
    roughness: Number = 0.5,
    world_to_texture: Transform | None = None,
    name: str = '',
) -> Node:
    """fractal noise above 0 with creases (turbulence)."""
