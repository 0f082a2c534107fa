"""A diffuse box with two blocks. The room is 2.2 m wide; its walls are in the scene file."""
from meshlib import rounded_box


def meshes():
    tall = rounded_box((-0.33, 0, -0.33), (0.33, 1.32, 0.33), 0.012, segs=3)
    short = rounded_box((-0.33, 0, -0.33), (0.33, 0.66, 0.33), 0.012, segs=3)
    lamp = rounded_box((-0.36, 2.185, -0.29), (0.36, 2.215, 0.29), 0.006)
    return {
        "tall": tall.turned("y", 17).moved(-0.38, 0, 1.42),
        "short": short.turned("y", -18).moved(0.42, 0, 0.72),
        "lamp": lamp.moved(0, 0, 1.1),
    }
