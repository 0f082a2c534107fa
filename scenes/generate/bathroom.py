"""A corner of a tiled bathroom. The room is x 0–2.88, y 0–2.5, z 0–3.24; the window is in the wall
x = 0, mirror and washbasin are at the wall z = 3.24."""
import numpy as np

from meshlib import (Mesh, agave, arc_points, bar, curve, cushion, join, lathe, quad, room,
                     rounded_box, sheet, smooth_normals, tile, torus, tube, unit)

WIDTH, HEIGHT, DEPTH = 2.88, 2.5, 3.24
TILE = (0.18, 0.09)
SAGE_ROWS, ROWS = 13, 17
WINDOW_Z, WINDOW_Y = (1.53, 2.34), (1.17, 2.10)
REVEAL = 0.16
COUNTER = 0.84


def wall_tiles(rng, origin, u, normal, length, cut):
    """Bevelled tiles in running bond, each a little out of plane as if laid by hand; `cut(row)` is
    the part of the row without tiles, or None. Returns two lots of sage tiles and one of white."""
    origin, u, n = (np.asarray(q, float) for q in (origin, u, normal))
    v = np.array([0.0, 1.0, 0.0])
    w, h = TILE
    gap = 0.003
    lots = [[], [], []]
    for row in range(ROWS):
        edges = np.clip(np.arange(-1, length / w + 1) * w + (row % 2) * w / 2, 0, length)
        for a, b in zip(edges, edges[1:]):
            pieces = [(a, b)]
            hole = cut(row)
            if hole is not None:
                pieces = [(a, min(b, hole[0])), (max(a, hole[1]), b)]
            for s0, s1 in pieces:
                if s1 - s0 < 0.02:
                    continue
                s0, s1, t0, t1 = s0 + gap / 2, s1 - gap / 2, row * h + gap / 2, (row + 1) * h - gap / 2
                foot = [origin + s * u + t * v for s, t in ((s0, t0), (s1, t0), (s1, t1), (s0, t1))]
                m = tile(foot, n, 0.006, 0.007)
                tilt = rng.normal(0, 0.0035, 2)
                away = m.P - m.P.mean(0)
                m = Mesh(m.P + np.outer(away @ u * tilt[0] + away @ v * tilt[1], n),
                         unit(m.N - tilt[0] * u - tilt[1] * v), m.F)
                lots[2 if row >= SAGE_ROWS else int(rng.random() < 0.35)].append(m)
    return lots


def walls():
    """The tiled walls as one mesh per colour, the grout behind, plaster above."""
    rng = np.random.default_rng(7)
    z0, z1 = WINDOW_Z
    back = wall_tiles(rng, (0, 0, DEPTH), (1, 0, 0), (0, 0, -1), WIDTH, lambda row: None)
    left = wall_tiles(rng, (0, 0, 0), (0, 0, 1), (1, 0, 0), DEPTH,
                      lambda row: (z0, z1) if row >= SAGE_ROWS else None)
    sage, sage2, white = (join(a, b) for a, b in zip(back, left))
    top = ROWS * TILE[1]
    y0, y1 = WINDOW_Y

    def left_part(ya, yb, za, zb):
        return quad((0, ya, za), (0, yb, za), (0, yb, zb), (0, ya, zb), (1, 0, 0))

    def back_part(ya, yb):
        return quad((0, ya, DEPTH), (WIDTH, ya, DEPTH), (WIDTH, yb, DEPTH), (0, yb, DEPTH), (0, 0, -1))

    grout = join(back_part(0, top), left_part(0, y0, 0, DEPTH), left_part(y0, top, 0, z0),
                 left_part(y0, top, z1, DEPTH))
    x = -REVEAL
    reveal = [quad((x, y0, z0), (0, y0, z0), (0, y1, z0), (x, y1, z0), (0, 0, 1)),
              quad((x, y0, z1), (0, y0, z1), (0, y1, z1), (x, y1, z1), (0, 0, -1)),
              quad((x, y1, z0), (0, y1, z0), (0, y1, z1), (x, y1, z1), (0, -1, 0)),
              quad((x, y0, z0), (0, y0, z0), (0, y0, z1), (x, y0, z1), (0, 1, 0))]
    plaster = join(back_part(top, HEIGHT), left_part(top, y1, 0, z0), left_part(top, y1, z1, DEPTH),
                   left_part(y1, HEIGHT, 0, DEPTH), reveal,
                   room((0, 0, 0), (WIDTH, HEIGHT, DEPTH), "XYz"))
    trim = join(bar((0, top + 0.008, DEPTH - 0.006), (WIDTH, top + 0.008, DEPTH - 0.006), 0.016, 0.018, 0.006),
                bar((0.006, top + 0.008, 0), (0.006, top + 0.008, z0), 0.016, 0.018, 0.006),
                bar((0.006, top + 0.008, z1), (0.006, top + 0.008, DEPTH), 0.016, 0.018, 0.006))
    return sage, sage2, white, grout, plaster, trim


def floor():
    w, gap = 0.36, 0.004
    lots = [[], []]
    for i in range(round(WIDTH / w)):
        for j in range(round(DEPTH / w)):
            g = gap / 2
            c = [(i * w + g, j * w + g), ((i + 1) * w - g, j * w + g),
                 ((i + 1) * w - g, (j + 1) * w - g), (i * w + g, (j + 1) * w - g)]
            lots[(i + j) % 2].append(tile([(x, -0.003, z) for x, z in c], (0, 1, 0), 0.002, 0.003))
    return join(lots[0]), join(lots[1])


def window():
    """Casing, frame and a cross of bars, and a sill that stands into the room."""
    (z0, z1), (y0, y1) = WINDOW_Z, WINDOW_Y
    zm, ym, x = (z0 + z1) / 2, y0 + 0.64 * (y1 - y0), -REVEAL + 0.03
    f = 0.05
    parts = [bar((x, y0 + f / 2, z0), (x, y0 + f / 2, z1), 0.05, f),
             bar((x, y1 - f / 2, z0), (x, y1 - f / 2, z1), 0.05, f)]
    for z in (z0 + f / 2, z1 - f / 2):
        parts.append(bar((x, y0, z), (x, y1, z), f, 0.05, up=(1, 0, 0)))
    parts += [bar((x, y0, zm), (x, y1, zm), 0.034, 0.04, up=(1, 0, 0)),
              bar((x, ym, z0), (x, ym, z1), 0.04, 0.026)]
    sill = rounded_box((-REVEAL + 0.05, y0 - 0.004, z0 - 0.05), (0.05, y0 + 0.022, z1 + 0.05), 0.006)
    return join(parts, sill)


def outdoors():
    """Haze, hedge with a leafy outline, roof light, and the disk of the sun. All are just as
    large as the room sees them: light that misses the window costs samples and shows nothing."""
    x, z0, z1 = -1.7, -2.4, 4.0
    haze = quad((x, 0.5, z0), (x, 0.5, z1), (x, 2.45, z1), (x, 2.45, z0), (1, 0, 0))
    roof = quad((0.8, HEIGHT - 0.004, 0.9), (2.0, HEIGHT - 0.004, 0.9), (2.0, HEIGHT - 0.004, 2.0),
                (0.8, HEIGHT - 0.004, 2.0), (0, -1, 0))
    rng = np.random.default_rng(3)
    z = np.linspace(z0, z1, 300)
    top = 1.45 + sum(a * np.sin(k * z + rng.uniform(0, 6)) for a, k in
                     ((0.09, 2.1), (0.06, 4.3), (0.04, 9.1), (0.02, 19.0), (0.014, 41.0), (0.01, 77.0)))
    X = np.stack([np.stack([0 * z + x + 0.03, 0 * z + 0.5, z], -1), np.stack([0 * z + x + 0.03, top, z], -1)])
    m = sheet(X)
    hedge = Mesh(m.P, np.tile((1.0, 0.0, 0.0), (len(m.P), 1)), m.F)
    q = np.arange(32) * (2 * np.pi / 32)
    P = np.concatenate([[(0, 0, 0)], np.stack([np.cos(q), 0 * q, np.sin(q)], 1) * 0.06])
    disk = Mesh(P, np.tile((0.0, 1.0, 0.0), (33, 1)), [(0, 1 + i, 1 + (i + 1) % 32) for i in range(32)])
    at = np.array([-2.7, 3.1, 0.0])
    sun = disk.pointing(np.array([0.0, 1.6, 1.9]) - at).moved(*at)
    return haze, hedge, roof, sun


def mirror():
    centre = (0.80, 1.63, DEPTH - 0.012)
    r = 0.36
    glass = lathe([(0, 0.012), (r, 0.012)], segs=128).pointing((0, 0, -1)).moved(*centre)
    glass.N[:] = (0, 0, -1)
    frame = join(torus(r, 0.011, 96, 12).scaled(1, 1.4, 1), lathe([(r, -0.01), (r, 0.012)], segs=128))
    return glass, frame.pointing((0, 0, -1)).moved(centre[0], centre[1], centre[2] - 0.01)


def washbasin():
    outside = [(0, 0), (0.075, 0), (0.085, 0.004)]
    wall = curve([(0.085, 0.004), (0.14, 0.022), (0.185, 0.065), (0.208, 0.132)], 16)
    rim = arc_points((0.203, 0.132), 0.005, 0, 180, 9)
    inside = curve([(0.198, 0.132), (0.175, 0.068), (0.13, 0.030), (0.06, 0.018), (0.022, 0.015)], 20)
    bowl = lathe(outside, wall, rim, inside, segs=72).moved(0.80, COUNTER, 2.965)
    drain = lathe([(0.024, 0.0155), (0.022, 0.019), (0.016, 0.0205), (0, 0.021)], segs=40)
    return bowl, drain.moved(0.80, COUNTER, 2.965)


def tap():
    x, z = 0.80, 3.19 - 0.02
    neck = curve([(x, COUNTER, z), (x, COUNTER + 0.14, z), (x, COUNTER + 0.225, z - 0.004),
                  (x, COUNTER + 0.285, z - 0.04), (x, COUNTER + 0.295, z - 0.09),
                  (x, COUNTER + 0.265, z - 0.14), (x, COUNTER + 0.215, z - 0.155)], 48)
    base = lathe([(0.030, 0.0), (0.030, 0.004), (0.028, 0.007), (0.022, 0.008)],
                 [(0.022, 0.008), (0.021, 0.085), (0.019, 0.090), (0.012, 0.092)], segs=48).moved(x, COUNTER, z)
    lever = tube(curve([(x + 0.018, COUNTER + 0.055, z), (x + 0.045, COUNTER + 0.058, z),
                        (x + 0.075, COUNTER + 0.075, z - 0.004)], 20), 0.0065)
    return join(tube(neck, 0.0125, 22, "spout"), base, lever)


def vanity():
    top = rounded_box((0.012, COUNTER - 0.04, 2.70), (1.66, COUNTER, DEPTH - 0.009), 0.005)
    body = [rounded_box((0.03, 0.40, 2.73), (1.64, COUNTER - 0.045, DEPTH - 0.012), 0.004)]
    knobs = []
    for a, b in ((0.035, 0.832), (0.838, 1.635)):
        body.append(rounded_box((a, 0.405, 2.712), (b, COUNTER - 0.05, 2.73), 0.004))
        knob = lathe([(0.006, 0), (0.006, 0.012), (0.012, 0.016), (0.015, 0.022), (0.012, 0.027), (0, 0.029)], segs=32)
        knobs.append(knob.pointing((0, 0, -1)).moved((a + b) / 2, 0.62, 2.712))
    return top, join(body), join(knobs)


SHELF = 1.26


def shelf():
    glass = rounded_box((1.36, SHELF - 0.010, 3.085), (1.92, SHELF, DEPTH - 0.011), 0.0015)
    holders = []
    for x in (1.43, 1.85):
        holders.append(tube([(x, SHELF - 0.017, DEPTH - 0.002), (x, SHELF - 0.017, DEPTH - 0.05)], 0.0065, 20))
        holders.append(lathe([(0.016, 0), (0.016, 0.005), (0.013, 0.008), (0.0065, 0.009)], segs=32)
                       .pointing((0, 0, -1)).moved(x, SHELF - 0.017, DEPTH - 0.006))
    return glass, join(holders)


def bottle(outer, inner):
    """A vessel with thickness: outer profile upwards, a round lip, inner profile downwards."""
    (ro, y), ri = outer[-1], inner[0][0]
    lip = arc_points(((ro + ri) / 2, y), (ro - ri) / 2, 0, 180, 7)
    return lathe([(0, 0), (outer[0][0], 0)], curve(outer, 34), lip, curve(inner, 34), segs=44)


def bottles():
    # Round-shouldered, with coloured liquid and a cork.
    inner = [(0.0105, 0.150), (0.0105, 0.122), (0.018, 0.110), (0.034, 0.092), (0.0365, 0.075),
             (0.0365, 0.015), (0.033, 0.007), (0.0, 0.006)]
    a = bottle([(0.036, 0.0), (0.0395, 0.004), (0.0400, 0.03), (0.040, 0.075), (0.037, 0.095),
                (0.021, 0.114), (0.0135, 0.124), (0.0135, 0.150)], inner)
    liquid = lathe([(0, 0.0064), (0.0325, 0.0074)], curve([(0.0325, 0.0074), (0.0361, 0.015), (0.0361, 0.078)], 16),
                   [(0.0361, 0.078), (0, 0.078)], segs=56)
    cork = lathe([(0.0, 0.135), (0.0095, 0.135)], [(0.0095, 0.135), (0.0115, 0.165)],
                 [(0.0115, 0.165), (0.0105, 0.167), (0, 0.167)], segs=40)
    # Slender, empty, with a ball for a stopper.
    b = bottle([(0.024, 0.0), (0.027, 0.003), (0.0275, 0.03), (0.0275, 0.125), (0.024, 0.145), (0.0115, 0.165),
                (0.0105, 0.176), (0.0105, 0.192)],
               [(0.0075, 0.192), (0.0075, 0.172), (0.0095, 0.162), (0.0215, 0.141), (0.0245, 0.122),
                (0.0245, 0.014), (0.021, 0.008), (0.0, 0.007)])
    ball = lathe(arc_points((0, 0.208), 0.0165, -90, 90, 25), segs=40)
    at_a, at_b = (1.56, SHELF + 0.0004, 3.155), (1.70, SHELF + 0.0004, 3.15)
    return a.moved(*at_a), liquid.moved(*at_a), cork.moved(*at_a), join(b, ball).moved(*at_b)


def soap():
    dish = lathe([(0, 0), (0.040, 0)], curve([(0.040, 0), (0.055, 0.006), (0.066, 0.022)], 12),
                 arc_points((0.0635, 0.022), 0.0025, 0, 180, 7),
                 curve([(0.061, 0.022), (0.050, 0.009), (0.0, 0.006)], 14), segs=64).scaled(1.15, 1, 0.8)
    bar_ = cushion(0.085, 0.026, 0.055, puff=0.25, flat=5).turned("y", 14).moved(0, 0.026, 0)
    return dish.moved(1.22, COUNTER, 2.86), bar_.moved(1.22, COUNTER, 2.86)


RAIL_Y, RAIL_Z = 1.16, 3.165


def towel():
    """Cloth over the rail: down in front, a shorter part behind; folds grow with the way down."""
    r = 0.014
    over = np.radians(np.linspace(180, 0, 11))
    front = np.linspace(0, 0.60, 50)[1:]
    back = np.linspace(0.42, 0, 22)[:-1]
    s = np.concatenate([back, 0 * over, front])
    side = np.concatenate([0 * back + 1, np.cos(np.pi - over), 0 * front - 1])
    z = RAIL_Z + np.concatenate([0 * back + r, r * np.cos(np.pi - over) * -1, 0 * front - r])
    y = RAIL_Y + np.concatenate([-back, r * np.sin(over), -front])
    u = np.linspace(0, 1, 52)
    S, U = s[:, None], u[None, :]
    amount = 0.017 * (1 - np.exp(-S / 0.16)) * (0.6 + S)
    fold = np.sin(2 * np.pi * (2.6 * U + 0.25 * S)) + 0.45 * np.sin(2 * np.pi * (5.7 * U - 0.4 * S) + 1.0)
    is_front = (side < 0)[:, None]
    Z = z[:, None] + np.where(is_front, amount * (fold - 0.9), 0.25 * amount * fold)
    X = 1.99 + 0.42 * (U + 0.016 * np.sin(7 * S + 4 * U) * np.sqrt(S))  + 0.012 * S
    Y = y[:, None] + 0.006 * np.sin(2 * np.pi * 2.6 * U) * S
    cloth = sheet(np.stack([X + 0 * Z, Y + 0 * Z, Z], -1))
    # A band woven into the towel, as part of the same surface.
    band = (S > 0.47) & (S < 0.51) & is_front
    rows = np.where(band[:, 0])[0]
    cols = len(u)
    row_of = cloth.F.min(1) // cols
    inside = (row_of >= rows[0]) & (row_of < rows[-1])
    rail = join(tube([(1.92, RAIL_Y, RAIL_Z), (2.50, RAIL_Y, RAIL_Z)], 0.010, 24),
                [tube([(x, RAIL_Y, RAIL_Z), (x, RAIL_Y, DEPTH)], 0.008, 20) for x in (1.935, 2.485)],
                [lathe([(0.022, 0), (0.022, 0.006), (0.018, 0.010), (0.008, 0.011)], segs=36)
                 .pointing((0, 0, -1)).moved(x, RAIL_Y, DEPTH - 0.006) for x in (1.935, 2.485)])
    return Mesh(cloth.P, cloth.N, cloth.F[~inside]), Mesh(cloth.P, cloth.N, cloth.F[inside]), rail


def stool():
    """Three-legged stool with two rolled towels."""
    x, z, h = 1.89, 2.86, 0.42
    seat = lathe([(0, h - 0.03), (0.15, h - 0.03)], arc_points((0.15, h - 0.015), 0.015, -90, 90, 13),
                 [(0.15, h), (0, h - 0.003)], segs=64)
    legs = []
    for k in range(3):
        q = np.radians(120 * k + 20)
        d = np.array([np.cos(q), 0, np.sin(q)])
        legs.append(tube(np.linspace(d * 0.16, d * 0.10 + (0, h - 0.02, 0), 6), np.linspace(0.011, 0.016, 6), 18, "flat"))

    def roll(radius, length):
        t = np.linspace(0, 1, 110)
        q = 2 * np.pi * 3.4 * t
        rad = radius * (0.22 + 0.78 * t)
        spiral = np.stack([rad * np.cos(q), rad * np.sin(q), 0 * t], 1)
        rows = [spiral + (0, 0, zz) for zz in np.linspace(-length / 2, length / 2, 3)]
        inner = [spiral * ((rad - 0.011) / rad)[:, None] + (0, 0, zz) for zz in (length / 2, -length / 2)]
        return smooth_normals(sheet(np.array(rows + inner + rows[:1])))
    rolls = [roll(0.056, 0.25).turned("y", 12).moved(-0.058, h + 0.056, 0),
             roll(0.054, 0.25).turned("z", 70).turned("y", 6).moved(0.060, h + 0.054, 0)]
    return join(seat, legs).moved(x, 0, z), join(rolls).moved(x, 0, z)


def plant():
    rng = np.random.default_rng(11)
    pot = lathe([(0, 0), (0.042, 0)], [(0.042, 0), (0.056, 0.085)], arc_points((0.054, 0.085), 0.003, 0, 180, 7),
                [(0.051, 0.085), (0.049, 0.072)], segs=56)
    earth = lathe([(0.0495, 0.074), (0, 0.078)], segs=32)
    leaves = agave(20, 0.17, rng, 0.018, 1.05).moved(0, 0.075, 0)
    return [m.moved(0.25, COUNTER, 2.99) for m in (pot, earth, leaves)]


def meshes():
    sage, sage2, white, grout, plaster, trim = walls()
    floor1, floor2 = floor()
    haze, hedge, roof, sun = outdoors()
    glass, frame = mirror()
    bowl, drain = washbasin()
    top, body, knobs = vanity()
    shelf_glass, holders = shelf()
    bottle1, liquid, cork, bottle2 = bottles()
    dish, soap_bar = soap()
    cloth, band, rail = towel()
    seat, rolls = stool()
    pot, earth, leaves = plant()
    bed = quad((0, -0.0025, 0), (WIDTH, -0.0025, 0), (WIDTH, -0.0025, DEPTH), (0, -0.0025, DEPTH), (0, 1, 0))
    return {
        "tiles-sage": sage, "tiles-sage2": sage2, "tiles-white": white, "grout": join(grout, bed), "plaster": plaster,
        "trim": trim, "floor1": floor1, "floor2": floor2, "window": window(), "haze": haze, "hedge": hedge, "roof-light": roof,
        "sun": sun, "mirror": glass, "mirror-frame": frame, "ceramic": join(bowl, dish), "chrome": join(tap(), drain,
        holders, rail), "brass": knobs, "counter": top, "cabinet": body, "shelf": shelf_glass, "bottle1": bottle1,
        "liquid": liquid, "cork": cork, "bottle2": bottle2, "soap": soap_bar, "towel": join(cloth, rolls),
        "towel-band": band, "stool": seat, "pot": pot, "earth": earth, "leaves": leaves,
    }
