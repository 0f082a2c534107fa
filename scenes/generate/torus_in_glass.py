"""A torus inside a solid glass cube, on a floor of bevelled stone squares. The cube is 12 cm wide."""
from meshlib import join, rounded_box, tile, torus


def meshes():
    glass = rounded_box((-0.06, 0.0004, -0.06), (0.06, 0.1204, 0.06), 0.0035, segs=4)
    ring = torus(0.0345, 0.0125, 128, 48).turned("x", 62).turned("y", -12).moved(0, 0.061, 0)
    squares = {0: [], 1: []}
    size, gap = 0.05, 0.0004
    for i in range(-16, 16):
        for k in range(-10, 26):
            x0, x1, z0, z1 = i * size + gap, (i + 1) * size - gap, k * size + gap, (k + 1) * size - gap
            foot = [(x0, -0.0009, z0), (x1, -0.0009, z0), (x1, -0.0009, z1), (x0, -0.0009, z1)]
            squares[(i + k) % 2].append(tile(foot, (0, 1, 0), 0.0009, 0.0009))
    return {
        "glass": glass.turned("y", 30),
        "torus": ring,
        "squares_light": join(squares[0]).turned("y", 12),
        "squares_dark": join(squares[1]).turned("y", 12),
    }
