"""A dim room, x −2.3…2.0, z −2.6…3.0, 2.6 m high, beside a bright one behind its far wall. The door in
that wall is hinged on the right and stands 24° open."""
import numpy as np

from meshlib import (Mesh, arc_points, ball, bar, curve, join, lathe, loft, planks, quad, room,
                     rounded_box, tube, unit)

OPENING = (0.70, 1.60, 2.08)  # left, right, top


def wall_with_opening():
    left, right, top = OPENING
    def face(z, x0, x1, y1, n):
        return [quad((x0, 0, z), (left, 0, z), (left, y1, z), (x0, y1, z), n),
                quad((right, 0, z), (x1, 0, z), (x1, y1, z), (right, y1, z), n),
                quad((left, top, z), (right, top, z), (right, y1, z), (left, y1, z), n)]
    return join(face(3.0, -2.3, 2.0, 2.6, (0, 0, -1)), face(3.12, -0.9, 3.4, 2.6, (0, 0, 1)))


def door_frame():
    left, right, top = OPENING
    parts = [rounded_box((left, 0, 2.985), (left + 0.02, top, 3.135), 0.002),
             rounded_box((right - 0.02, 0, 2.985), (right, top, 3.135), 0.002),
             rounded_box((left, top - 0.02, 2.985), (right, top, 3.135), 0.002)]
    for z, s in ((3.0, -1), (3.12, 1)):  # architraves of two steps
        for w, d in ((0.085, 0.014), (0.055, 0.020), (0.018, 0.027)):
            z0, z1 = min(z, z + s * d), max(z, z + s * d)
            parts += [rounded_box((left - w + 0.008, 0, z0), (left + 0.008, top + w - 0.008, z1), 0.003),
                      rounded_box((right - 0.008, 0, z0), (right + w - 0.008, top + w - 0.008, z1), 0.003),
                      rounded_box((left - w + 0.008, top - 0.008, z0), (right + w - 0.008, top + w - 0.008, z1), 0.003)]
    return join(parts)


def raised_panel(x0, x1, y0, y1, thick):
    """Field with sloping margins on both faces."""
    out = []
    m, lift = 0.045, 0.011
    for s in (-1, 1):
        zf, zb = s * thick / 2, s * (thick / 2 - lift)
        o = [(x0, y0, zb), (x1, y0, zb), (x1, y1, zb), (x0, y1, zb)]
        i = [(x0 + m, y0 + m, zf), (x1 - m, y0 + m, zf), (x1 - m, y1 - m, zf), (x0 + m, y1 - m, zf)]
        out.append(quad(*i, (0, 0, s)))
        for a in range(4):
            b = (a + 1) % 4
            out.append(quad(o[a], o[b], i[b], i[a], (0, 0, s)))
    return out


def door():
    w, h, t = 0.85, 2.045, 0.040
    x0, x1 = -w, 0.0
    y0, y1 = 0.008, h
    stile, rail = 0.11, 0.12
    parts = [rounded_box((x0, y0, -t / 2), (x0 + stile, y1, t / 2), 0.003),
             rounded_box((x1 - stile, y0, -t / 2), (x1, y1, t / 2), 0.003),
             rounded_box((-w / 2 - 0.05, y0, -t / 2 + 0.0005), (-w / 2 + 0.05, y1, t / 2 - 0.0005), 0.003)]
    rails = [(y0, y0 + 0.20), (0.92, 0.92 + 0.16), (1.60, 1.60 + rail), (y1 - rail, y1)]
    for a, b in rails:
        parts.append(rounded_box((x0 + stile - 0.004, a, -t / 2 + 0.001), (x1 - stile + 0.004, b, t / 2 - 0.001), 0.003))
    for (_, a), (b, _) in zip(rails, rails[1:]):
        for p0, p1 in ((x0 + stile, -w / 2 - 0.05), (-w / 2 + 0.05, x1 - stile)):
            parts += raised_panel(p0, p1, a, b, 0.030)
    return join(parts), w, t


def knob_set(w, t):
    """Knobs and plates on both faces, in the door's own space."""
    profile = np.concatenate([curve([(0.021, 0), (0.021, 0.004), (0.012, 0.007), (0.0095, 0.018), (0.012, 0.027),
                                     (0.023, 0.036), (0.0275, 0.047), (0.024, 0.057), (0.012, 0.062), (0, 0.063)], 40)])
    plate = curve([(0.030, 0.0), (0.030, 0.0025), (0.027, 0.005), (0.018, 0.006), (0, 0.006)], 16)
    one = join(lathe(profile, segs=48), lathe(plate, segs=48))
    hole = lathe(curve([(0.014, 0.0), (0.014, 0.002), (0.011, 0.0035), (0, 0.004)], 12), segs=32)
    x, y = -w + 0.055, 1.0
    parts = []
    for s in (-1, 1):
        parts.append(one.pointing((0, 0, s)).moved(x, y, s * t / 2))
        parts.append(hole.pointing((0, 0, s)).moved(x, y - 0.075, s * t / 2))
    return join(parts)


def skirting():
    left, right, _ = OPENING
    profile = [(0, 0), (0.016, 0), (0.016, 0.085), (0.0145, 0.092), (0.010, 0.097), (0.009, 0.104), (0.005, 0.110), (0, 0.112)]
    runs = [((-2.3, 3.0), (left - 0.08, 3.0), (0, -1)), ((right + 0.08, 3.0), (2.0, 3.0), (0, -1)),
            ((-2.3, -2.6), (-2.3, 3.0), (1, 0)), ((2.0, -2.6), (2.0, 3.0), (-1, 0)),
            ((left - 1.6, 3.12), (left - 0.08, 3.12), (0, 1)), ((right + 0.08, 3.12), (3.4, 3.12), (0, 1)),
            ((-0.9, 6.4), (3.4, 6.4), (0, -1))]
    out = []
    for a, b, n in runs:
        for (d0, h0), (d1, h1) in zip(profile, profile[1:]):
            if h0 == h1 == 0:
                continue
            pts = [(a[0] + n[0] * d0, h0, a[1] + n[1] * d0), (b[0] + n[0] * d0, h0, b[1] + n[1] * d0),
                   (b[0] + n[0] * d1, h1, b[1] + n[1] * d1), (a[0] + n[0] * d1, h1, a[1] + n[1] * d1)]
            toward = np.array([n[0], 0.0, n[1]]) * (h1 - h0 + 1e-9) + np.array([0, 1.0, 0]) * (d0 - d1)
            out.append(quad(*pts, toward))
    return join(out)


def leg(height):
    """Turned table leg."""
    p = [(0.016, 0.0), (0.019, 0.006), (0.018, 0.016), (0.0135, 0.028), (0.0150, 0.10), (0.0215, 0.30), (0.0245, 0.44),
         (0.0225, 0.50), (0.0170, 0.53), (0.0165, 0.54), (0.0230, 0.555), (0.0235, 0.565), (0.0165, 0.585), (0.0195, 0.61)]
    round_part = lathe(curve(p, 90), segs=32)
    return join(round_part, rounded_box((-0.027, 0.60, -0.027), (0.027, height, 0.027), 0.003))


def table(half_x, half_z, height):
    rim = arc_points((0, 0), 0.012, -90, 90, 9)
    rings = [(height - 0.032, 0.001, 0.001, 6.0), (height - 0.032, half_x - 0.02, half_z - 0.02, 9.0),
             (height - 0.030, half_x - 0.014, half_z - 0.014, 9.0)]
    rings += [(height - 0.013 + y, half_x - 0.012 + r, half_z - 0.012 + r, 9.0) for r, y in rim]
    rings += [(height - 0.0006, half_x - 0.016, half_z - 0.016, 9.0), (height, half_x - 0.019, half_z - 0.019, 9.0),
              (height, half_x - 0.05, half_z - 0.05, 9.0), (height, 0.001, 0.001, 6.0)]
    top = loft(rings, segs=160)
    under = height - 0.031
    parts = [top]
    x, z = half_x - 0.07, half_z - 0.07
    for sx in (-1, 1):
        for sz in (-1, 1):
            parts.append(leg(under).moved(sx * x, 0, sz * z))
        parts.append(rounded_box((sx * x - 0.010, under - 0.085, -z), (sx * x + 0.010, under, z), 0.002))
    for sz in (-1, 1):
        parts.append(rounded_box((-x, under - 0.085, sz * z - 0.010), (x, under, sz * z + 0.010), 0.002))
    return join(parts)


# ---------------------------------------------------------------- the three pots

def on_body(mesh, body, clearance, rows):
    """Pushes the named vertices outwards until they rest `clearance` from the lathe profile `body`."""
    P = mesh.P.copy()
    for row in rows:
        p = P[row]
        r = np.hypot(p[:, 0], p[:, 2])
        scale = (np.interp(p[:, 1], body[:, 1], body[:, 0]) + clearance) / np.maximum(r, 1e-9)
        p[:, 0] *= scale
        p[:, 2] *= scale
        P[row] = p
    return Mesh(P, mesh.N, mesh.F)


def handle_path(r0, y0, r1, y1, reach):
    """From the body at (r0, y0) out and back to (r1, y1), on the −x side."""
    return curve([(-r0, y0, 0), (-r0 - 0.45 * reach, y0 + 0.012, 0), (-r0 - 0.95 * reach, y0 - 0.002, 0),
                  (-r0 - 1.05 * reach, (y0 + y1) / 2, 0), (-r1 - 0.62 * reach, y1 + 0.006, 0), (-r1, y1 - 0.002, 0)], 40)


def ceramic_pot():
    body = curve([(0.052, 0.0), (0.053, 0.003), (0.058, 0.007), (0.082, 0.028), (0.0985, 0.062), (0.095, 0.098),
                  (0.074, 0.126), (0.052, 0.138)], 70)
    lip = curve([(0.052, 0.138), (0.0505, 0.1425), (0.0465, 0.1405), (0.046, 0.134)], 10)
    foot = [(0.0, 0.004), (0.040, 0.004), (0.044, 0.0), (0.052, 0.0)]
    lid = curve([(0.0455, 0.137), (0.0475, 0.1395), (0.045, 0.147), (0.030, 0.157), (0.012, 0.1615), (0.0075, 0.1655), (0.009, 0.171),
                 (0.0148, 0.178), (0.0152, 0.185), (0.0095, 0.191), (0.0, 0.1925)], 60)
    spout = tube(curve([(0.075, 0.045, 0), (0.112, 0.056, 0), (0.134, 0.088, 0), (0.146, 0.122, 0), (0.168, 0.142, 0)], 36),
                 np.interp(np.linspace(0, 1, 36), [0, 0.3, 0.8, 1], [0.029, 0.020, 0.0115, 0.0118]), 28, ends="spout")
    handle = tube(handle_path(0.078, 0.115, 0.090, 0.045, 0.062), 0.0078, 20).scaled(1, 1, 1.25)
    return join(lathe(foot, body, lip, lid, segs=88), spout, handle)


def metal_pot():
    """Tall coffee pot with a waist, a swan-neck spout and a pointed finial."""
    foot = [(0.0, 0.003), (0.052, 0.003), (0.058, 0.0)]
    base = curve([(0.058, 0.0), (0.0605, 0.0025), (0.059, 0.006), (0.051, 0.010), (0.0465, 0.016)], 20)
    body = curve([(0.0465, 0.016), (0.062, 0.032), (0.0735, 0.062), (0.070, 0.098), (0.053, 0.142), (0.0415, 0.182), (0.0405, 0.205),
                  (0.045, 0.224)], 80)
    bead = arc_points((0.0448, 0.2265), 0.0028, -80, 100, 10)
    lid = curve([(0.0436, 0.2292), (0.040, 0.240), (0.028, 0.254), (0.013, 0.262), (0.0065, 0.2665), (0.0058, 0.270), (0.0098, 0.277),
                 (0.0112, 0.284), (0.0075, 0.292), (0.0030, 0.300), (0.0, 0.306)], 60)
    spout = tube(curve([(0.050, 0.055, 0), (0.090, 0.060, 0), (0.110, 0.094, 0), (0.116, 0.150, 0), (0.130, 0.196, 0), (0.152, 0.214, 0)], 48),
                 np.interp(np.linspace(0, 1, 48), [0, 0.25, 0.6, 0.9, 1], [0.026, 0.0175, 0.0105, 0.0080, 0.0088]), 28, ends="spout")
    return join(lathe(foot, base, body, bead, lid, segs=88), spout)


def metal_pot_handle():
    path = curve([(-0.040, 0.200, 0), (-0.072, 0.212, 0), (-0.108, 0.200, 0), (-0.118, 0.150, 0), (-0.104, 0.095, 0), (-0.069, 0.075, 0)], 44)
    return tube(path, np.interp(np.linspace(0, 1, 44), [0, 0.15, 0.5, 0.85, 1], [0.0052, 0.0062, 0.0088, 0.0062, 0.0052]), 20)


def glass_pot():
    """Thin-walled pot; spout and handle stand a hair off the body so that no glass overlaps."""
    outer = curve([(0.0, 0.0), (0.030, 0.0), (0.050, 0.004), (0.079, 0.028), (0.093, 0.066), (0.086, 0.104),
                   (0.060, 0.134), (0.0475, 0.150), (0.0490, 0.160)], 84)
    t = 0.0028
    tangent = unit(np.gradient(outer, axis=0))
    inner = outer - t * np.stack([tangent[:, 1], -tangent[:, 0]], 1)
    inner[0] = (0.0, t)
    inner = inner[inner[:, 0] >= 0][::-1]
    rim = outer[-1] * 0.5 + inner[0] * 0.5
    radius = np.linalg.norm(outer[-1] - inner[0]) / 2
    lip = arc_points(rim, radius, 0, 180, 9)
    lip = lip + (outer[-1] - lip[0]) * np.linspace(1, 0, 9)[:, None] + (inner[0] - lip[-1]) * np.linspace(0, 1, 9)[:, None]
    vessel = lathe(np.concatenate([outer, lip[1:-1], inner]), segs=80)
    body = outer[(outer[:, 1] > 0.004)]

    segs = 28
    path = curve([(0.092, 0.052, 0), (0.116, 0.062, 0), (0.136, 0.096, 0), (0.147, 0.132, 0), (0.166, 0.150, 0)], 40)
    spout = tube(path, np.interp(np.linspace(0, 1, 40), [0, 0.3, 0.8, 1], [0.0185, 0.0150, 0.0098, 0.0100]), segs, ends="flat")
    first = [np.arange(0, segs), np.arange(segs, 2 * segs), np.arange(2 * segs, 3 * segs)]
    spout = smooth_end(on_body(spout, body, 0.0005, first))
    path = handle_path(0.0815, 0.112, 0.0925, 0.046, 0.060)
    path[0, 0] -= 0.004
    handle = tube(path, 0.0064, segs, ends="flat")
    n = len(handle.P)
    last = [np.arange(n - 3 * segs, n - 2 * segs), np.arange(n - 2 * segs, n - segs), np.arange(n - segs, n)]
    handle = smooth_end(on_body(handle, body, 0.0005, first + last))
    lid = lathe(curve([(0.0, 0.1652), (0.040, 0.1652), (0.0465, 0.1645), (0.0495, 0.1660), (0.0485, 0.169), (0.034, 0.1765), (0.012, 0.1815),
                       (0.0078, 0.185), (0.0085, 0.190), (0.0140, 0.1975), (0.0142, 0.205), (0.0085, 0.2115), (0.0, 0.213)], 64), segs=72)
    return join(vessel, spout, handle, lid.moved(0, 0.0003, 0))


def smooth_end(m):
    from meshlib import smooth_normals
    return smooth_normals(m)


def picture():
    """Frame, mount, and a landscape of flat shapes. Local: faces −z, centre at the origin."""
    w, h = 0.62, 0.46
    frame = []
    for inset, depth, width in ((0.0, 0.018, 0.035), (0.006, 0.024, 0.016), (0.028, 0.020, 0.012)):
        a, b = w / 2 - inset, h / 2 - inset
        frame += [rounded_box((-a, b - width, -depth), (a, b, 0), 0.003), rounded_box((-a, -b, -depth), (a, -b + width, 0), 0.003),
                  rounded_box((-a, -b + 0.001, -depth), (-a + width, b - 0.001, 0), 0.003),
                  rounded_box((a - width, -b + 0.001, -depth), (a, b - 0.001, 0), 0.003)]
    toward = (0, 0, -1)
    mount = quad((-w / 2, -h / 2, -0.004), (w / 2, -h / 2, -0.004), (w / 2, h / 2, -0.004), (-w / 2, h / 2, -0.004), toward)
    pw, ph = 0.42, 0.27
    def sheet_of(xy, z):
        P = np.array([(x, y, z) for x, y in xy])
        c = P.mean(0)
        n = len(P)
        return Mesh(np.concatenate([P, [c]]), np.tile((0, 0, -1.0), (n + 1, 1)), [(i, (i + 1) % n, n) for i in range(n)])
    def hills(base, amp, freq, phase, z):
        x = np.linspace(-pw / 2, pw / 2, 49)
        y = base + amp * np.sin(freq * x + phase) + 0.4 * amp * np.sin(2.3 * freq * x + 1.7 * phase)
        strips = [quad((x0, -ph / 2, z), (x1, -ph / 2, z), (x1, y1, z), (x0, y0, z), toward)
                  for x0, x1, y0, y1 in zip(x, x[1:], y, y[1:])]
        return join(strips)
    phi = np.linspace(0, 2 * np.pi, 48, endpoint=False)
    return {
        "picture_frame": join(frame), "picture_mount": mount,
        "picture_sky": sheet_of([(-pw / 2, -ph / 2), (pw / 2, -ph / 2), (pw / 2, ph / 2), (-pw / 2, ph / 2)], -0.0044),
        "picture_sun": sheet_of([(0.075 + 0.040 * np.cos(a), 0.040 + 0.040 * np.sin(a)) for a in phi], -0.0048),
        "picture_hill_far": hills(-0.005, 0.022, 14, 0.6, -0.0052),
        "picture_hill_near": hills(-0.065, 0.018, 11, 2.4, -0.0056),
    }


def meshes():
    rng = np.random.default_rng(7)
    out = {f"floor_{k}": m for k, m in enumerate(planks(-2.3, 2.0, -2.6, 3.12, 0.115, rng, 4))}
    out["walls"] = join(room((-2.3, 0, -2.6), (2.0, 2.6, 3.0), "xXz"), wall_with_opening())
    out["ceiling"] = room((-2.3, 0, -2.6), (2.0, 2.6, 3.0), "Y")
    out["bright_room"] = room((-0.9, -0.0018, 3.12), (3.4, 2.6, 6.4), "xXYZ")
    out["bright_floor"] = quad((-0.9, -0.0018, 3.12), (3.4, -0.0018, 3.12), (3.4, -0.0018, 6.4), (-0.9, -0.0018, 6.4), (0, 1, 0))
    out["under_floor"] = quad((-2.3, -0.0018, -2.6), (2.0, -0.0018, -2.6), (2.0, -0.0018, 3.12), (-2.3, -0.0018, 3.12), (0, 1, 0))
    out["woodwork"] = join(door_frame(), skirting())
    leaf, w, t = door()
    place = lambda m: m.moved(0, 0, t / 2).turned("y", -24.0).moved(1.572, 0, 2.992)
    out["door"] = place(leaf)
    out["knobs"] = place(knob_set(w, t))
    hinge = join([tube([(0, y, 0), (0, y + 0.09, 0)], 0.006, 16) for y in (0.22, 1.0, 1.76)])
    out["hinges"] = hinge.moved(1.576, 0, 2.985)
    top = 0.745
    spot = (-0.50, 0.0, 1.12)
    out["table"] = table(0.66, 0.36, top).moved(*spot)
    out["pot_ceramic"] = ceramic_pot().turned("y", 205).moved(-0.90, top, 1.10)
    out["pot_metal"] = metal_pot().turned("y", 150).moved(-0.50, top, 1.24)
    out["pot_metal_handle"] = metal_pot_handle().turned("y", 150).moved(-0.50, top, 1.24)
    out["pot_glass"] = glass_pot().turned("y", 12).moved(-0.20, top + 0.0004, 1.00)
    for name, mesh in picture().items():
        out[name] = mesh.moved(-0.72, 1.62, 2.999)
    return out
