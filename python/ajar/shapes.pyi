"""All models of shapes. Made by python/make_stubs.py from the library's own list."""

from typing import Literal

from ._types import ArrayLike, Color, File, Node, Number, TexturedColor, TexturedNumber, Transform, Vector

def cone(
    *,
    radius: Number = 1.0,
    height: Number = 1.0,
    phi_max: Number = 360.0,
    name: str = '',
) -> Node:
    """a cone from the plane z = 0 to its tip."""

def curves(
    *,
    type: Literal["flat", "cylinder", "ribbon"] = 'flat',
    control_points: ArrayLike,
    widths: ArrayLike,
    normals: ArrayLike | None = None,
    name: str = '',
) -> Node:
    """hair and wires: cubic Bézier curves with widths; they cannot emit light."""

def cylinder(
    *,
    radius: Number = 1.0,
    z_min: Number = -1.0,
    z_max: Number = 1.0,
    phi_max: Number = 360.0,
    name: str = '',
) -> Node:
    """a cylinder around z, without lids."""

def disk(
    *,
    height: Number = 0.0,
    radius: Number = 1.0,
    inner_radius: Number = 0.0,
    phi_max: Number = 360.0,
    coordinates: Literal["angle_then_radius_inward", "radius_then_angle", "angle_then_radius"] = 'angle_then_radius_inward',
    name: str = '',
) -> Node:
    """a disk across z, with or without a hole."""

def hyperboloid(
    *,
    p1: Vector = (0.0, 0.0, 0.0),
    p2: Vector = (1.0, 1.0, 1.0),
    phi_max: Number = 360.0,
    name: str = '',
) -> Node:
    """what a line makes that turns around z."""

def mesh(
    *,
    positions: ArrayLike,
    indices: ArrayLike,
    normals: ArrayLike | None = None,
    tangents: ArrayLike | None = None,
    uvs: ArrayLike | None = None,
    name: str = '',
) -> Node:
    """triangles."""

def paraboloid(
    *,
    radius: Number = 1.0,
    z_min: Number = 0.0,
    z_max: Number = 1.0,
    phi_max: Number = 360.0,
    name: str = '',
) -> Node:
    """a bowl around z with its lowest point at the origin."""

def sphere(
    *,
    radius: Number = 1.0,
    z_min: Number | None = None,
    z_max: Number | None = None,
    phi_max: Number = 360.0,
    name: str = '',
) -> Node:
    """a sphere around the origin."""

def subdivision(
    *,
    levels: int = 3,
    positions: ArrayLike,
    indices: ArrayLike,
    normals: ArrayLike | None = None,
    tangents: ArrayLike | None = None,
    uvs: ArrayLike | None = None,
    name: str = '',
) -> Node:
    """a smooth surface that a coarse mesh controls."""
