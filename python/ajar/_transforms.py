"""Matrices of 4 × 4 that columns are multiplied with: what is to the right comes first, as in `translate(0, 1, 0) @
rotate(90, (0, 1, 0))`. The world is right-handed."""

import numpy

from ._errors import SceneError


def translate(x, y, z):
    """Moves."""
    matrix = numpy.eye(4)
    matrix[:3, 3] = x, y, z
    return matrix


def scale(x, y=None, z=None):
    """Makes larger, along each axis or along all."""
    y = x if y is None else y
    z = x if z is None else z
    return numpy.diag([float(x), float(y), float(z), 1.0])


def rotate(degrees, axis):
    """Turns counter-clockwise around an axis through the origin."""
    axis = numpy.asarray(axis, float)
    length = numpy.linalg.norm(axis)
    if not length > 0:
        raise SceneError(f"rotate: {axis} is no axis")
    x, y, z = axis / length
    # Rodrigues' formula.
    k = numpy.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    angle = numpy.radians(degrees)
    matrix = numpy.eye(4)
    matrix[:3, :3] += numpy.sin(angle) * k + (1 - numpy.cos(angle)) * k @ k
    return matrix


def look_at(origin, target, up=(0, 1, 0)):
    """Where a camera stands at `origin` and looks at `target`; a spot or a projector shines there."""
    origin, target, up = (numpy.asarray(v, float) for v in (origin, target, up))
    forward = target - origin
    right = numpy.cross(forward, up)
    if not (numpy.linalg.norm(forward) > 0 and numpy.linalg.norm(right) > 0):
        raise SceneError(f"look_at: from {origin} to {target} with {up} up is no direction")
    forward /= numpy.linalg.norm(forward)
    right /= numpy.linalg.norm(right)
    matrix = numpy.eye(4)
    matrix[:3, 0] = right
    matrix[:3, 1] = numpy.cross(right, forward)
    matrix[:3, 2] = forward
    matrix[:3, 3] = origin
    return matrix
