"""Meshes of the pool: basin with tiles, wavy water, coping, deck, ladder, things that float."""
import numpy as np

from meshlib import (Mesh, agave, curve, join, lathe, quad, room, rounded_box, sheet, tiled,
                     torus, tube, unit)

X, Z0, Z1 = 2.4, 0.0, 6.0  # the basin spans -X..X, Z0..Z1
WATER, FLOOR = -0.13, -1.55  # heights; the deck is at 0
TILE = 0.2


def water():
    """Sum of travelling sines with analytic normals. Curvature decides where caustics focus, so each
    octave of wavelengths gets a like share of it."""
    rng = np.random.default_rng(5)
    waves = []
    for wavelength in np.geomspace(0.34, 2.4, 17):
        k = 2 * np.pi / wavelength * rng.uniform(0.93, 1.07)
        heading = rng.normal(0.9, 0.85)
        waves.append((k * np.cos(heading), k * np.sin(heading), 0.44 / k**1.72, rng.uniform(0, 2 * np.pi)))
    x, z = np.meshgrid(np.linspace(-X - 0.003, X + 0.003, 124), np.linspace(Z0 - 0.003, Z1 + 0.003, 152))
    h, hx, hz = 0 * x, 0 * x, 0 * x
    for kx, kz, a, phase in waves:
        q = kx * x + kz * z + phase
        h, hx, hz = h + a * np.sin(q), hx + a * kx * np.cos(q), hz + a * kz * np.cos(q)
    grid = sheet(np.stack([x, WATER + h, z], -1))
    return Mesh(grid.P, unit(np.stack([-hx, 0 * h + 1, -hz], -1)).reshape(-1, 3), grid.F)


def tile_lots(rng):
    """Floor and walls in four tints, and a dark band at the water line."""
    lots = [[] for _ in range(4)]
    nx, nz, ny = round(2 * X / TILE), round((Z1 - Z0) / TILE), 7
    band_top = FLOOR + ny * TILE
    planes = [((-X, FLOOR, Z0), (1, 0, 0), (0, 0, 1), (0, 1, 0), nx, nz)]
    walls = [((-X, FLOOR, Z0), (0, 0, 1), (1, 0, 0), nz), ((X, FLOOR, Z0), (0, 0, 1), (-1, 0, 0), nz),
             ((-X, FLOOR, Z1), (1, 0, 0), (0, 0, -1), nx), ((-X, FLOOR, Z0), (1, 0, 0), (0, 0, 1), nx)]
    for origin, u, n, count in walls:
        planes.append((origin, u, (0, 1, 0), n, count, ny))
    for origin, u, v, n, nu, nv in planes:
        for _, t in tiled(origin, u, v, n, TILE, TILE, nu, nv, grout=0.008, bevel=0.004, height=0.004):
            lots[rng.choice(4, p=(0.36, 0.34, 0.22, 0.08))].append(t)
    band = []
    for (ox, _, oz), u, n, count in walls:
        rim = -0.01 - band_top
        band += [t for _, t in tiled((ox, band_top, oz), u, (0, 1, 0), n, TILE / 2, rim, 2 * count, 1,
                                     grout=0.006, bevel=0.004, height=0.004)]
    return lots, band


def coping(rng):
    stones = []
    depth, over = 0.36, 0.035

    def row(a, b, make):
        edges = np.linspace(a, b, max(1, round((b - a) / 0.6)) + 1)
        for s, t in zip(edges, edges[1:]):
            lift = rng.uniform(-0.001, 0.001)
            stones.append(make(s + 0.003, t - 0.003).moved(y=lift))

    lo, hi = -0.045, 0.012
    for x0, x1 in ((-X - depth, -X + over), (X - over, X + depth)):
        row(Z0 + over, Z1 - over, lambda s, t: rounded_box((x0, lo, s), (x1, hi, t), 0.016))
    for z0, z1 in ((Z0 - depth, Z0 + over), (Z1 - over, Z1 + depth)):
        row(-X - depth, X + depth, lambda s, t: rounded_box((s, lo, z0), (t, hi, z1), 0.016))
    return join(stones)


def deck(rng):
    """Stone pavers around the coping, two tints."""
    lots = [[], []]
    edge = 0.366
    w = 0.6
    for i in range(-9, 9):
        for j in range(-4, 13):
            s, z = i * w, j * w
            shift = 0.3 * (j % 2)
            x0, x1 = s + shift, s + shift + w
            if x1 > -X - edge and x0 < X + edge and z + w > Z0 - edge and z < Z1 + edge:
                pieces = []  # cut the paver where it meets the coping
                if x0 < -X - edge: pieces.append((x0, min(x1, -X - edge), z, z + w))
                if x1 > X + edge: pieces.append((max(x0, X + edge), x1, z, z + w))
                a, b = max(x0, -X - edge), min(x1, X + edge)
                if z < Z0 - edge: pieces.append((a, b, z, Z0 - edge))
                if z + w > Z1 + edge: pieces.append((a, b, Z1 + edge, z + w))
            else:
                pieces = [(x0, x1, z, z + w)]
            for a, b, c, d in pieces:
                if b - a > 0.03 and d - c > 0.03:
                    lot = lots[rng.integers(2)]
                    foot = [(a, -0.036, c), (b, -0.036, c), (b, -0.036, d), (a, -0.036, d)]
                    lot += [t for _, t in tiled(foot[0], (1, 0, 0), (0, 0, 1), (0, 1, 0), b - a, d - c, 1, 1,
                                                grout=0.007, bevel=0.007, height=0.036 + rng.uniform(-0.001, 0.001))]
    return [join(lot) for lot in lots]


def ladder(x=X, z=4.3):
    """Two bent rails over the coping at the right wall, three treads."""
    rails, feet = [], []
    for dz in (-0.25, 0.25):
        p = curve([(x + 0.55, -0.02, z + dz), (x + 0.55, 0.30, z + dz), (x + 0.53, 0.62, z + dz),
                   (x + 0.42, 0.80, z + dz), (x + 0.22, 0.86, z + dz), (x + 0.02, 0.80, z + dz),
                   (x - 0.09, 0.62, z + dz), (x - 0.11, 0.30, z + dz), (x - 0.11, -0.3, z + dz),
                   (x - 0.11, -0.75, z + dz), (x - 0.10, -0.95, z + dz), (x - 0.02, -1.04, z + dz)], 60)
        rails.append(tube(p, 0.021, 16))
        feet.append(lathe([(0.02, 0.024), (0.024, 0.022), (0.045, 0.012), (0.055, 0.004), (0.056, -0.002)],
                          segs=32).moved(x + 0.55, 0.0, z + dz))
    treads = [rounded_box((x - 0.16, y - 0.014, z - 0.25), (x - 0.07, y + 0.014, z + 0.25), 0.012, 3)
              for y in (-0.30, -0.58, -0.86)]
    return join(rails, treads, feet)


def sectors(r, count, segs=10, rows=24):
    """Ball in `count` gores about y."""
    q = np.radians(np.linspace(-90, 90, rows + 1))
    out = []
    for k in range(count):
        phi = np.linspace(k, k + 1, segs + 1) * 2 * np.pi / count
        P = np.stack([np.cos(q)[:, None] * np.cos(phi), np.repeat(np.sin(q)[:, None], segs + 1, 1),
                      np.cos(q)[:, None] * np.sin(phi)], -1)
        m = sheet(P * r)
        out.append(Mesh(m.P, unit(m.P), m.F))
    return out


def meshes():
    rng = np.random.default_rng(11)
    lots, band = tile_lots(rng)
    stone = deck(rng)
    out = {"water": water(), "band": join(band), "coping": coping(rng), "deck_0": stone[0], "deck_1": stone[1],
           "ladder": ladder()}
    for i, lot in enumerate(lots):
        out[f"tiles_{i}"] = join(lot)
    e = 0.02
    ground = [quad((-7, -0.036, Z0 - 3), (-X - e, -0.036, Z0 - 3), (-X - e, -0.036, 9), (-7, -0.036, 9), (0, 1, 0)),
              quad((X + e, -0.036, Z0 - 3), (7, -0.036, Z0 - 3), (7, -0.036, 9), (X + e, -0.036, 9), (0, 1, 0)),
              quad((-X - e, -0.036, Z0 - 3), (X + e, -0.036, Z0 - 3), (X + e, -0.036, Z0 - e), (-X - e, -0.036, Z0 - e), (0, 1, 0)),
              quad((-X - e, -0.036, Z1 + e), (X + e, -0.036, Z1 + e), (X + e, -0.036, 9), (-X - e, -0.036, 9), (0, 1, 0))]
    out["grout"] = join(room((-X, FLOOR, Z0), (X, -0.03, Z1), "xXyzZ"), ground)
    out["wall"] = join(rounded_box((-7, -0.04, 7.75), (7, 2.6, 8.0), 0.02, 2))
    out["wall_cap"] = join([rounded_box((s + 0.003, 2.6, 7.68), (s + 0.797, 2.66, 8.07), 0.015, 1) for s in np.arange(-7, 7, 0.8)])
    # A swim ring of eight parts, lying on the water, tipped a little; and a ball.
    red, white = [], []
    for k in range(8):
        (red if k % 2 else white).append(torus(0.31, 0.105, 13, 28, (45.0 * k, 45.0 * k + 45)))
    put = lambda m: m.turned("y", 20).turned("z", 4).turned("x", -3).moved(-0.55, WATER + 0.05, 2.75)
    out["ring_red"], out["ring_white"] = put(join(red)), put(join(white))
    gores = sectors(0.2, 6)
    roll = lambda m: m.turned("x", 38).turned("z", 27).moved(0.85, WATER + 0.155, 3.55)
    out["ball_white"] = roll(join(gores[0::2]))
    out["ball_yellow"] = roll(gores[1])
    out["ball_red"] = roll(gores[3])
    out["ball_blue"] = roll(gores[5])
    # Pots with agaves before the wall.
    pot = [[(0.0, 0.0), (0.17, 0.0), (0.185, 0.008), (0.19, 0.02)],
           [(0.19, 0.02), (0.235, 0.16), (0.265, 0.32), (0.275, 0.40)],
           [(0.275, 0.40), (0.292, 0.404), (0.297, 0.42), (0.297, 0.445), (0.29, 0.458), (0.278, 0.46), (0.266, 0.455), (0.262, 0.44)],
           [(0.262, 0.44), (0.255, 0.36)]]
    spots = ((-1.9, 7.15, 1.0), (2.35, 7.2, 1.15))
    out["pots"] = join([lathe(*pot, segs=48).scaled(s).moved(x, 0, z) for x, z, s in spots])
    out["soil"] = join([lathe([(0.26, 0.40), (0.1, 0.415), (0.0, 0.42)][::1], segs=24).scaled(s).moved(x, 0, z) for x, z, s in spots])
    out["agaves"] = join([agave(22, 0.62 * s, rng, 0.05).moved(x, 0.40 * s, z) for x, z, s in spots])
    return out
