"""Meshes and the shapes that the built-in scenes are made of. Lengths are metres, y is up.

A mesh is three arrays: positions P (n, 3), unit vertex normals N (n, 3), triangles F (m, 3). Every
maker sets normals that point out of the object; `write` turns each triangle so that it agrees.
"""
import numpy as np


class Mesh:
    def __init__(self, P, N, F):
        self.P = np.asarray(P, float).reshape(-1, 3)
        self.N = np.asarray(N, float).reshape(-1, 3)
        self.F = np.asarray(F, int).reshape(-1, 3)

    def moved(self, x=0.0, y=0.0, z=0.0):
        return Mesh(self.P + (x, y, z), self.N, self.F)

    def scaled(self, x, y=None, z=None):
        s = np.array([x, x if y is None else y, x if z is None else z], float)
        return Mesh(self.P * s, unit(self.N / s), self.F)

    def turned(self, axis, degrees):
        a = np.radians(degrees)
        c, s = np.cos(a), np.sin(a)
        i, j = {"x": (1, 2), "y": (2, 0), "z": (0, 1)}[axis]
        R = np.eye(3)
        R[i, i], R[i, j], R[j, i], R[j, j] = c, -s, s, c
        return Mesh(self.P @ R.T, self.N @ R.T, self.F)

    def pointing(self, direction):
        """Turned so that the old +y axis points along `direction`."""
        y = unit(np.asarray(direction, float))
        x = unit(np.cross(y, (0.0, 0.0, 1.0) if abs(y[2]) < 0.9 else (1.0, 0.0, 0.0)))
        R = np.stack([x, y, np.cross(x, y)], 1)
        return Mesh(self.P @ R.T, self.N @ R.T, self.F)

    def warped(self, f):
        """Each point moved by f((n, 3) array); normals found anew, smooth across all edges."""
        return smooth_normals(Mesh(f(self.P), self.N, self.F))


def unit(v):
    v = np.asarray(v, float)
    return v / np.maximum(np.linalg.norm(v, axis=-1, keepdims=True), 1e-30)


def join(*meshes):
    flat = []
    for m in meshes:
        flat.extend(m if isinstance(m, (list, tuple)) else [m])
    starts = np.cumsum([0] + [len(m.P) for m in flat[:-1]])
    return Mesh(np.concatenate([m.P for m in flat]), np.concatenate([m.N for m in flat]),
                np.concatenate([m.F + s for m, s in zip(flat, starts)]))


def face_normals(m):
    a, b, c = (m.P[m.F[:, i]] for i in range(3))
    return np.cross(b - a, c - a)


def smooth_normals(m):
    """Area-weighted vertex normals; vertices at the same place share one."""
    flip = (face_normals(m) * m.N[m.F].sum(1)).sum(1) < 0
    F = m.F.copy()
    F[flip] = F[flip][:, ::-1]
    m = Mesh(m.P, m.N, F)
    _, where = np.unique(np.round(m.P * 1e6).astype(np.int64), axis=0, return_inverse=True)
    total = np.zeros((where.max() + 1, 3))
    n = face_normals(m)
    for i in range(3):
        np.add.at(total, where[m.F[:, i]], n)
    return Mesh(m.P, unit(total[where]), m.F)


def write(path, mesh, limit=1_500_000):
    """Binary little-endian PLY; drops triangles without area and vertices without a triangle."""
    m = join(mesh)
    P32 = m.P.astype("<f4").astype(float)
    area = np.linalg.norm(face_normals(Mesh(P32, m.N, m.F)), axis=1)
    F = m.F[area > 1e-12]
    used, F = np.unique(F, return_inverse=True)
    m = Mesh(P32[used], m.N[used], F.reshape(-1, 3))
    flip = (face_normals(m) * m.N[m.F].sum(1)).sum(1) < 0
    m.F[flip] = m.F[flip][:, ::-1]
    vertices = np.concatenate([m.P, unit(m.N)], 1).astype("<f4")
    faces = np.empty(len(m.F), np.dtype([("n", "u1"), ("i", "<i4", 3)]))
    faces["n"], faces["i"] = 3, m.F
    header = ("ply\nformat binary_little_endian 1.0\ncomment Ajar contributors, Apache-2.0\n"
              f"element vertex {len(vertices)}\n"
              + "".join(f"property float {p}\n" for p in ("x", "y", "z", "nx", "ny", "nz"))
              + f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n")
    data = header.encode() + vertices.tobytes() + faces.tobytes()
    assert np.isfinite(vertices).all() and len(data) <= limit, (path, len(data))
    path.write_bytes(data)


# ---------------------------------------------------------------- surfaces from arrays of points

def sheet(X, closed=False, sign=1.0):
    """Surface through X[row, column]; normals are sign · ∂X/∂column × ∂X/∂row."""
    X = np.asarray(X, float)
    rows, cols = X.shape[:2]
    if closed:
        du = np.roll(X, -1, 1) - np.roll(X, 1, 1)
    else:
        du = np.gradient(X, axis=1)
    dv = np.gradient(X, axis=0)
    N = sign * np.cross(du, dv)
    length = np.linalg.norm(N, axis=2)
    N = unit(N)
    for row in np.where(length.max(1) < 1e-12)[0]:  # poles: take the mean of the next row
        near = row + 1 if row == 0 else row - 1
        N[row] = unit(N[near].mean(0))
    i, j = np.meshgrid(np.arange(cols if closed else cols - 1), np.arange(rows - 1))
    a, b = j * cols + i, j * cols + (i + 1) % cols
    c, d = a + cols, b + cols
    F = np.concatenate([np.stack([a, b, d], -1).reshape(-1, 3), np.stack([a, d, c], -1).reshape(-1, 3)])
    return Mesh(X.reshape(-1, 3), N.reshape(-1, 3), F)


def curve(points, count):
    """Centripetal-free Catmull–Rom spline through `points`, evenly resampled to `count` points."""
    p = np.asarray(points, float)
    p = np.concatenate([2 * p[:1] - p[1:2], p, 2 * p[-1:] - p[-2:-1]])
    t = np.linspace(0, 1, 24, endpoint=False)[:, None]
    out = []
    for a, b, c, d in zip(p, p[1:], p[2:], p[3:]):
        out.append(0.5 * (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t**2
                          + (3 * b - a - 3 * c + d) * t**3))
    fine = np.concatenate(out + [p[-2:-1]])
    s = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(fine, axis=0), axis=1))])
    at = np.linspace(0, s[-1], count)
    return np.stack([np.interp(at, s, fine[:, k]) for k in range(fine.shape[1])], 1)


def lathe(*runs, segs=64):
    """Surface of revolution about y. Each run is a smooth list of (radius, height); creases lie
    between runs. The outside is to the right when a run is walked with y up and radius right."""
    phi = np.arange(segs) * (2 * np.pi / segs)
    parts = []
    for run in runs:
        r, y = np.asarray(run, float).T
        r = np.maximum(r, 0)
        X = np.stack([r[:, None] * np.cos(phi), np.repeat(y[:, None], segs, 1),
                      r[:, None] * np.sin(phi)], -1)
        parts.append(sheet(X, closed=True, sign=-1))
    return join(parts)


def tube(path, radius, segs=16, ends="round", closed=False, bore=0.03):
    """Round bar along `path` (n, 3). `ends`: round | flat | open | spout (its far end is hollow)."""
    path = np.asarray(path, float)
    n = len(path)
    radius = np.broadcast_to(np.asarray(radius, float), n)
    if closed:
        T = unit(np.roll(path, -1, 0) - np.roll(path, 1, 0))
    else:
        T = unit(np.gradient(path, axis=0))
    a = np.cross(T[0], (0.0, 1.0, 0.0) if abs(T[0][1]) < 0.9 else (1.0, 0.0, 0.0))
    A = [unit(a)]
    for t in T[1:]:
        A.append(unit(A[-1] - t * np.dot(A[-1], t)))
    A = np.array(A)
    phi = np.arange(segs) * (2 * np.pi / segs)

    def ring(c, t, a, r):
        b = np.cross(t, a)
        return c + r * (np.cos(phi)[:, None] * a + np.sin(phi)[:, None] * b)

    rings = [ring(path[k], T[k], A[k], radius[k]) for k in range(n)]
    if closed:
        return sheet(np.array(rings + rings[:1]), closed=True)
    def round_end(k, direction, angles):
        return [ring(path[k] + direction * T[k] * radius[k] * np.sin(q), T[k], A[k],
                     radius[k] * np.cos(q)) for q in np.radians(angles)]
    if ends == "round":
        rings = round_end(0, -1, (90, 75, 50, 25)) + rings + round_end(-1, 1, (25, 50, 75, 90))
    elif ends == "flat":
        rings = [ring(path[0], T[0], A[0], radius[0] * q) for q in (0, 0.97)] + rings \
            + [ring(path[-1], T[-1], A[-1], radius[-1] * q) for q in (0.97, 0)]
    elif ends == "spout":
        c, t, a_, r = path[-1], T[-1], A[-1], radius[-1]
        rings = rings + [ring(c + t * r * 0.10, t, a_, r * 0.93), ring(c + t * r * 0.04, t, a_, r * 0.83),
                         ring(c - t * r * 0.25, t, a_, r * 0.78), ring(c - t * bore, t, a_, r * 0.75),
                         ring(c - t * bore * 1.01, t, a_, 0)]
    return sheet(np.array(rings), closed=True)


def loft(rings, segs=72, power=None):
    """Rounded-rectangle rings (y, half width x, half depth z, exponent) joined from first to last,
    walked bottom, outside, rim, inside as in `lathe`."""
    phi = np.arange(segs) * (2 * np.pi / segs)
    c, s = np.cos(phi), np.sin(phi)
    X = []
    for y, a, b, n in rings:
        e = 2.0 / n
        X.append(np.stack([a * np.sign(c) * np.abs(c)**e, np.full(segs, y), b * np.sign(s) * np.abs(s)**e], -1))
    return smooth_normals(sheet(np.array(X), closed=True, sign=-1))


# ---------------------------------------------------------------- boxes and tiles

def rounded_box(lo, hi, r=0.004, segs=2, flat=1):
    """Box from lo to hi with rounded edges of radius r; `flat` subdivides the flat part of its faces."""
    lo, hi = np.asarray(lo, float), np.asarray(hi, float)
    r = min(r, 0.499 * (hi - lo).min())
    inner_lo, inner_hi = lo + r, hi - r
    arc = np.tan(np.radians(np.linspace(-45, 0, segs + 1)))
    steps = np.linspace(0, 1, flat + 1)[1:-1]
    d = np.concatenate([arc, 0 * steps, -arc[::-1]])
    blend = np.concatenate([0 * arc, steps, 0 * arc + 1])
    parts = []
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        for side in (-1.0, 1.0):
            D = np.zeros((len(d), len(d), 3))
            D[..., axis], D[..., u], D[..., v] = side, d[None, :], d[:, None]
            D = unit(D)
            C = np.zeros_like(D)
            C[..., axis] = inner_hi[axis] if side > 0 else inner_lo[axis]
            C[..., u] = (inner_lo[u] + blend * (inner_hi[u] - inner_lo[u]))[None, :]
            C[..., v] = (inner_lo[v] + blend * (inner_hi[v] - inner_lo[v]))[:, None]
            m = sheet(C + r * D)
            parts.append(Mesh(m.P, D.reshape(-1, 3), m.F))
    return join(parts)


def bar(a, b, width, height, r=0.003, up=(0.0, 1.0, 0.0)):
    """Rounded box along the segment a–b."""
    a, b = np.asarray(a, float), np.asarray(b, float)
    length = np.linalg.norm(b - a)
    x = unit(b - a)
    z = unit(np.cross(x, up))
    y = np.cross(z, x)
    m = rounded_box((0, -height / 2, -width / 2), (length, height / 2, width / 2), r)
    R = np.stack([x, y, z], 1)
    return Mesh(a + m.P @ R.T, m.N @ R.T, m.F)


def cushion(w, h, d, puff=0.35, edge=0.45, flat=8):
    """Soft box, w × h × d, centred; fuller in the middle than at its seams."""
    m = rounded_box((-w / 2, -h / 2, -d / 2), (w / 2, h / 2, d / 2), edge * h, segs=4, flat=flat)
    def fill(P):
        q = P.copy()
        u, v = 2 * P[:, 0] / w, 2 * P[:, 2] / d
        q[:, 1] *= 1 + puff * np.clip(1 - u**2, 0, 1) * np.clip(1 - v**2, 0, 1)
        q[:, 0] *= 1 - 0.03 * np.clip(v**2, 0, 1) * (1 - np.clip(u**2, 0, 1)) + 0.02 * (1 - v**2)
        return q
    return m.warped(fill)


def tile(corners, normal, bevel, height):
    """Convex flat tile: corners (k, 3) of its foot, top raised by `height`, edge bevelled inwards."""
    c = np.asarray(corners, float)
    n = unit(np.asarray(normal, float))
    k = len(c)
    mid = c.mean(0)
    before, after = unit(np.roll(c, 1, 0) - c), unit(np.roll(c, -1, 0) - c)
    inward = unit(before + after)
    step = bevel / np.sqrt(np.clip((1 - (before * after).sum(1)) / 2, 0.05, 1))
    top = c + inward * step[:, None] + n * height
    out = unit(unit(c - mid) + 0.8 * n)
    P = np.concatenate([top, c])
    N = np.concatenate([np.tile(n, (k, 1)), out])
    F = [(0, i, i + 1) for i in range(1, k - 1)]
    for i in range(k):
        j = (i + 1) % k
        F += [(i, j, k + j), (i, k + j, k + i)]
    return Mesh(P, N, F)


def tiled(origin, u, v, normal, w, h, nu, nv, grout=0.003, bevel=0.0025, height=0.004, bond=0.0, keep=None):
    """Rectangle of tiles, each w × h including half a grout line all round; returns the list of tiles
    with their (column, row). With `bond` every second row is shifted by that part of a tile and cut
    at the ends."""
    origin, u, v = (np.asarray(q, float) for q in (origin, u, v))
    out = []
    for row in range(nv):
        shift = bond * w * (row % 2)
        edges = np.clip(np.arange(nu + 2) * w - shift, 0, nu * w)
        for col, (a, b) in enumerate(zip(edges, edges[1:])):
            if b - a < 4 * bevel + grout:
                continue
            if keep is not None and not keep((a + b) / 2, (row + 0.5) * h):
                continue
            s0, s1, t0, t1 = a + grout / 2, b - grout / 2, row * h + grout / 2, (row + 1) * h - grout / 2
            corners = [origin + s * u + t * v for s, t in ((s0, t0), (s1, t0), (s1, t1), (s0, t1))]
            out.append(((col, row), tile(corners, normal, bevel, height)))
    return out


def quad(a, b, c, d, toward):
    """Flat four-cornered sheet whose normal is on the side of the direction `toward`."""
    P = np.array([a, b, c, d], float)
    n = unit(np.cross(P[1] - P[0], P[2] - P[0]))
    n = n if np.dot(n, toward) > 0 else -n
    return Mesh(P, np.tile(n, (4, 1)), [(0, 1, 2), (0, 2, 3)])


def room(lo, hi, sides="xXyYzZ"):
    """Inner faces of a box; small letters are the low sides."""
    (x0, y0, z0), (x1, y1, z1) = lo, hi
    q = {
        "x": quad((x0, y0, z0), (x0, y1, z0), (x0, y1, z1), (x0, y0, z1), (1, 0, 0)),
        "X": quad((x1, y0, z0), (x1, y1, z0), (x1, y1, z1), (x1, y0, z1), (-1, 0, 0)),
        "y": quad((x0, y0, z0), (x1, y0, z0), (x1, y0, z1), (x0, y0, z1), (0, 1, 0)),
        "Y": quad((x0, y1, z0), (x1, y1, z0), (x1, y1, z1), (x0, y1, z1), (0, -1, 0)),
        "z": quad((x0, y0, z0), (x1, y0, z0), (x1, y1, z0), (x0, y1, z0), (0, 0, 1)),
        "Z": quad((x0, y0, z1), (x1, y0, z1), (x1, y1, z1), (x0, y1, z1), (0, 0, -1)),
    }
    return join([q[s] for s in sides])


def planks(x0, x1, z0, z1, width, rng, kinds, lengths=(0.9, 2.0), along="z", gap=0.0012, bevel=0.0018):
    """Floor boards at y = 0 in `kinds` lots, so that each lot can have a tint of its own."""
    lots = [[] for _ in range(kinds)]
    lo, hi = (z0, z1) if along == "z" else (x0, x1)
    side = np.arange(x0, x1, width) if along == "z" else np.arange(z0, z1, width)
    last = -1
    for s in side:
        at = lo - rng.uniform(0, lengths[0])
        while at < hi:
            end = at + rng.uniform(*lengths)
            a, b = max(at, lo), min(end, hi)
            if b - a > 0.02:
                e = min(s + width, x1 if along == "z" else z1)
                if e - s > 0.02:
                    g = gap / 2
                    c = [(s + g, a + g), (e - g, a + g), (e - g, b - g), (s + g, b - g)]
                    foot = [(p, -bevel, q) if along == "z" else (q, -bevel, p) for p, q in c]
                    kind = rng.integers(kinds - 1)
                    kind += kind >= last
                    last = kind
                    lots[kind].append(tile(foot, (0, 1, 0), bevel, bevel))
            at = end
    return [join(lot) for lot in lots]


def torus(R, r, nu=96, nv=40, arc=(0.0, 360.0)):
    closed = arc[1] - arc[0] >= 360
    t = np.radians(np.linspace(*arc, nu, endpoint=not closed))
    path = np.stack([R * np.cos(t), 0 * t, R * np.sin(t)], 1)
    return tube(path, r, nv, closed=closed, ends="flat")


def ball(r, segs=48):
    q = np.radians(np.linspace(-90, 90, segs // 2 + 1))
    return lathe(np.stack([r * np.cos(q), r * np.sin(q)], 1), segs=segs)


def arc_points(centre, r, a0, a1, n):
    """(radius, height) points on a circle; angles in degrees, 0 outwards, 90 up."""
    q = np.radians(np.linspace(a0, a1, n))
    return np.stack([centre[0] + r * np.cos(q), centre[1] + r * np.sin(q)], 1)


def agave(count, length, rng, width=0.05, lift=1.0):
    """A rosette of fleshy leaves growing from the origin."""
    leaves = []
    for k in range(count):
        ring = k / count
        phi = k * 2.39996 + rng.uniform(-0.1, 0.1)
        size = length * (0.65 + 0.35 * ring) * rng.uniform(0.92, 1.08)
        rise = lift * (1.25 - 0.95 * ring)
        t = np.linspace(0, 1, 11)
        reach = size * (0.12 + 0.88 * t) * np.cos(rise * (1 - 0.55 * t))
        height = size * t * np.sin(rise) * (1 - 0.30 * t)
        half = width * (0.75 + 0.8 * t) * np.sqrt(np.clip(1 - t, 0, 1)) * (1 - 0.25 * t)
        out = np.array([np.cos(phi), 0, np.sin(phi)])
        side = np.array([-np.sin(phi), 0, np.cos(phi)])
        rows = []
        for s, w, h in zip(reach, half, height):
            c = s * out + np.array([0, h, 0])
            thick = 0.35 * w
            q = np.radians(np.arange(10) * 36)
            rows.append([c + w * np.cos(a) * side + np.array([0, 1, 0]) * (thick * np.sin(a) + 0.35 * abs(np.cos(a)) * w)
                         for a in q])
        leaves.append(smooth_normals(sheet(np.array(rows), closed=True, sign=1)))
    return join(leaves)
