"""Living-room corner at evening: an armchair and three lamps with bulbs of clear glass."""
import numpy as np

from meshlib import (agave, arc_points, bar, curve, cushion, join, lathe, planks, quad, room,
                     rounded_box, torus, tube)

EMITTER = 0.014  # radius of the glowing spheres in scene.pbrt
ROOM_LO, ROOM_HI = (-1.75, -0.01, -3.0), (2.5, 2.5, 1.6)
CHAIR = dict(x=-0.02, z=0.72)
TABLE = dict(x=-0.93, z=0.36)
CONE_LAMP = dict(x=-0.60, y=1.43, z=0.86)  # middle of the lower rim of the shade
CLOTH_LAMP = dict(x=0.92, z=1.02)

# Bulbs: the middle of the glowing sphere is the origin, the neck points down.
BULB_CONE = dict(x=CONE_LAMP["x"], y=CONE_LAMP["y"] + 0.06, z=CONE_LAMP["z"])
BULB_CLOTH = dict(x=CLOTH_LAMP["x"], y=1.37, z=CLOTH_LAMP["z"])
BULB_TABLE = dict(x=TABLE["x"], y=0.835, z=TABLE["z"])


def bulb():
    """Shell of glass 1.5 mm thick, open at the end of its neck, which sits in the socket."""
    def profile(d):
        neck = [(0.014 - d, -0.062), (0.014 - d, -0.053), (0.0152 - d, -0.043)]
        return np.concatenate([neck, arc_points((0, 0), 0.035 - d, -57, 90, 26)])
    rim = [(0.0125, -0.062), (0.014, -0.062)]
    return lathe(profile(0), profile(0.0015)[::-1], rim, segs=56)


def socket():
    body = lathe([(0, -0.102), (0.018, -0.102)], [(0.018, -0.102), (0.018, -0.054)],
                 [(0.018, -0.054), (0, -0.054)], segs=32)
    stem = tube([(0, -0.06, 0), (0, -EMITTER + 0.0005, 0)], 0.0022, 10, ends="flat")
    return join(body, stem)


def spokes(y, inner, outer, slope=0.0, count=3):
    out = []
    for k in range(count):
        a = 0.5 + k * 2 * np.pi / count
        d = np.array([np.cos(a), 0, np.sin(a)])
        out.append(tube([inner * d + (0, y, 0), outer * d + (0, y + slope, 0)], 0.002, 8, ends="flat"))
    return join(out)


def line(a, b, n=6):
    return np.linspace(a, b, n)


def plinth(r, h, edge=0.006):
    """Round foot of a lamp, standing on y = 0."""
    return lathe([(0, 0.0005), (r, 0.0005)], [(r, 0.0005), (r, h - edge)],
                 arc_points((r - edge, h - edge), edge, 0, 90, 6), [(r - edge, h), (0, h)], segs=64)


def cone_lamp():
    low, top, h = 0.17, 0.03, 0.25
    outside = lathe(line((low, 0), (top, h)), [(top, h), (top - 0.002, h)], segs=80)
    inside = lathe(line((top - 0.002, h), (low - 0.002, 0)), segs=80)
    rim = torus(low - 0.001, 0.0026, 80, 10)
    where = CONE_LAMP
    x, y, z = where["x"], where["y"], where["z"]
    foot = np.array([-1.36, 0, 1.22])
    way = lambda t, height: (foot[0] + t * (x - foot[0]), height, foot[2] + t * (z - foot[2]))
    pole = tube(curve([way(0, 0.02), way(0, 0.8), way(0, 1.25), way(0.06, 1.6), way(0.30, 1.87),
                       way(0.66, 1.96), way(0.93, 1.86), way(1, y + 0.30), way(1, y + 0.155)], 70), 0.009, 14)
    return {
        "cone-outside": join(outside, rim).moved(**where),
        "cone-inside": inside.moved(**where),
        "cone-pole": join(pole, plinth(0.15, 0.025).moved(*foot)),
        "cone-fittings": join(spokes(0.21, 0.005, 0.049).moved(**where),
                              socket().turned("x", 180).moved(**BULB_CONE)),
    }


def cloth_lamp():
    where = CLOTH_LAMP
    low, high, r0, r1 = 1.20, 1.52, 0.25, 0.19
    cloth = lathe(line((r0, low), (r1, high)), segs=96)
    rims = join(torus(r0, 0.0028, 96, 8).moved(y=low), torus(r1, 0.0028, 96, 8).moved(y=high))
    pole = tube([(0, 0.02, 0), (0, 0.7, 0), (0, 1.275, 0)], 0.011, 20)
    knob = lathe(curve([(0.011, 1.20), (0.02, 1.225), (0.024, 1.245), (0.013, 1.268)], 16), segs=32)
    ring = torus(0.02, 0.003, 40, 10).moved(y=1.245)
    return {
        "cloth-shade": cloth.moved(**where),
        "cloth-rims": rims.moved(**where),
        "cloth-pole": join(pole, knob, ring, plinth(0.16, 0.025)).moved(**where),
        "cloth-fittings": join(spokes(1.245, 0.018, 0.2415).moved(**where), socket().moved(**BULB_CLOTH)),
    }


def table_lamp():
    where = TABLE
    body = curve([(0.028, 0.512), (0.055, 0.535), (0.080, 0.580), (0.074, 0.630), (0.046, 0.680),
                  (0.024, 0.715), (0.021, 0.736)], 42)
    glass = lathe([(0, 0.512), (0.028, 0.512)], body, [(0.021, 0.736), (0, 0.736)], segs=80)
    cap = lathe([(0, 0.722), (0.029, 0.722)], [(0.029, 0.722), (0.029, 0.733)], [(0.029, 0.733), (0, 0.740)],
                segs=40)
    bell = curve([(0.175, 0.790), (0.165, 0.825), (0.135, 0.880), (0.090, 0.925), (0.055, 0.950)], 18)
    shade = lathe(bell, [(0.055, 0.950), (0.051, 0.950)], (bell - (0.004, 0))[::-1],
                  [(0.171, 0.790), (0.175, 0.790)], segs=80)
    return {
        "table-lamp-glass": glass.moved(**where),
        "table-lamp-brass": join(plinth(0.075, 0.017).moved(y=0.5), cap, spokes(0.786, 0.016, 0.172, 0.008)).moved(**where),
        "table-lamp-fittings": socket().moved(**BULB_TABLE),
        "table-lamp-shade": shade.moved(**where),
    }


def armchair():
    arm = rounded_box((-0.48, 0.14, -0.40), (-0.31, 0.60, 0.40), 0.08, segs=5)
    back = rounded_box((-0.46, 0.16, 0.20), (0.46, 0.92, 0.40), 0.085, segs=5).turned("x", 7)
    seat = rounded_box((-0.40, 0.14, -0.36), (0.40, 0.31, 0.36), 0.03, segs=3)
    soft = join(cushion(0.63, 0.16, 0.68, 0.22).moved(0, 0.385, -0.07),
                cushion(0.61, 0.15, 0.50, 0.35).turned("x", 98).moved(0, 0.67, 0.19))
    pillow = cushion(0.40, 0.07, 0.40, 1.7, 0.48).turned("z", 9).turned("x", 112).moved(0.09, 0.645, 0.035)
    legs = [lathe(line((0.013, 0.002), (0.022, 0.15)), [(0.022, 0.15), (0, 0.15)], segs=24).moved(x, 0, z)
            for x in (-0.37, 0.37) for z in (-0.32, 0.32)]
    put = lambda m: m.turned("y", -17).moved(**CHAIR)
    return {
        "chair": put(join(arm, arm.moved(x=0.79), back, seat)),
        "chair-cushions": put(soft),
        "chair-pillow": put(pillow),
        "chair-legs": put(join(legs)),
    }


def furniture():
    top = lathe([(0, 0.475), (0.27, 0.475)], arc_points((0.27, 0.4875), 0.0125, -90, 90, 10),
                [(0.27, 0.5), (0, 0.5)], segs=96)
    legs = []
    for k in range(3):
        a = 0.3 + k * 2 * np.pi / 3
        d = np.array([np.cos(a), 0, np.sin(a)])
        legs.append(tube([0.24 * d + (0, 0.012, 0), 0.13 * d + (0, 0.48, 0)], [0.011, 0.016], 20, ends="flat"))
    tumbler = lathe([(0, 0.5003), (0.029, 0.5003)], curve([(0.029, 0.5003), (0.031, 0.504), (0.036, 0.59)], 10),
                    arc_points((0.0352, 0.59), 0.0008, 0, 180, 7),
                    curve([(0.0344, 0.59), (0.030, 0.52), (0.027, 0.512)], 10),
                    [(0.027, 0.512), (0, 0.512)], segs=64)
    books = [rounded_box((-0.075, 0, -0.105), (0.075, 0.026, 0.105), 0.003).turned("y", 35),
             rounded_box((-0.065, 0.0265, -0.09), (0.065, 0.046, 0.09), 0.003).turned("y", 58)]
    at = dict(x=TABLE["x"] - 0.145, y=0.5003, z=TABLE["z"] + 0.02)
    pot = lathe([(0, 0.001), (0.11, 0.001)], line((0.11, 0.001), (0.155, 0.28)),
                arc_points((0.149, 0.28), 0.006, 0, 180, 8), line((0.143, 0.28), (0.14, 0.25)), segs=64)
    plant = dict(x=1.42, z=1.12)
    return {
        "side-table": join(top, legs).moved(**TABLE),
        "tumbler": tumbler.moved(x=TABLE["x"] + 0.155, z=TABLE["z"] - 0.09),
        "book-low": books[0].moved(**at),
        "book-high": books[1].moved(**at),
        "pot": pot.moved(**plant),
        "soil": lathe([(0.142, 0.255), (0, 0.26)], segs=40).moved(**plant),
        "plant": agave(17, 0.58, np.random.default_rng(3), 0.035, 1.15).moved(y=0.25, **plant),
    }


def picture():
    x0, x1, y0, y1, z = -0.42, 0.28, 1.27, 1.79, ROOM_HI[2]
    face = z - 0.012
    c = [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]
    frame = join([bar((*a, z - 0.014), (*b, z - 0.014), 0.026, 0.022, 0.003, up=(0, 0, 1))
                  for a, b in (((x0 - .011, y0), (x1 + .011, y0)), ((x0 - .011, y1), (x1 + .011, y1)))]
                 + [bar((x, y0, z - 0.014), (x, y1, z - 0.014), 0.022, 0.026, 0.003, up=(1, 0, 0)) for x in (x0, x1)])
    sun = lathe([(0.095, 0), (0, 0)], segs=64).turned("x", -90).moved(0.04, 1.60, face - 0.001)
    t = np.linspace(x0, x1, 40)
    def hill(height, depth):
        strips = [quad((a, y0, face - depth), (b, y0, face - depth), (b, height(b), face - depth),
                       (a, height(a), face - depth), (0, 0, -1)) for a, b in zip(t, t[1:])]
        return join(strips)
    return {
        "picture-frame": frame,
        "picture-sky": quad(*((a, b, face) for a, b in c), (0, 0, -1)),
        "picture-sun": sun,
        "picture-far": hill(lambda x: 1.48 + 0.07 * np.sin(7 * x + 1.9), 0.002),
        "picture-near": hill(lambda x: 1.40 + 0.05 * np.sin(6 * x - 0.7), 0.003),
    }


def meshes():
    rng = np.random.default_rng(11)
    (x0, _, z0), (x1, _, z1) = ROOM_LO, ROOM_HI
    boards = planks(x0, x1, z0, z1, 0.13, rng, 4, along="x")
    e, h = 0.016, 0.11
    skirting = join(rounded_box((x0, -0.003, z1 - e), (x1, h, z1 + 0.01), 0.005),
                    rounded_box((x0 - 0.01, -0.003, z0), (x0 + e, h, z1), 0.005))
    rug = {"rug-middle": (0, 0.86, 0.013), "rug-ring": (0.8601, 1.02, 0.0135), "rug-edge": (1.0201, 1.15, 0.013)}
    def carpet(a, b, y):
        inner = [] if a == 0 else [arc_points((a + 0.004, y - 0.004), 0.004, 90, 180, 5)]
        rim = arc_points((b - 0.004, y - 0.004), 0.004, 0, 90, 5)
        return lathe([(b, 0.0005), (b, y - 0.004)], rim, [(b - 0.004, y), (a + 0.004 * (a > 0), y)], *inner, segs=96)
    return {
        "bulb": bulb(),
        "walls": room(ROOM_LO, ROOM_HI, "xXzZ"),
        "ceiling": room(ROOM_LO, ROOM_HI, "Y"),
        "underfloor": room((x0, -0.004, z0), ROOM_HI, "y"),
        **{f"boards-{k}": m for k, m in enumerate(boards)},
        "skirting": skirting,
        **{k: carpet(*v).moved(0.05, 0, -0.02) for k, v in rug.items()},
        **armchair(), **furniture(), **picture(),
        **cone_lamp(), **cloth_lamp(), **table_lamp(),
    }
