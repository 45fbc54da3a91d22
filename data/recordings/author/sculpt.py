"""Writes recordings, and knows where the clay is.

A Recording appends operations and keeps every dab, so that a script can ask where the surface lies
(`cast`, `front`, `toward`) and draw on it. What it knows is the program's own arithmetic without
the grid; smoothing is not followed.
"""
import json
import math
from collections import defaultdict


# Vectors are tuples.
def add(a, b, t=1.0):
    return (a[0] + b[0] * t, a[1] + b[1] * t, a[2] + b[2] * t)


def sub(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def length(a):
    return math.sqrt(dot(a, a))


def unit(a):
    n = length(a) or 1.0
    return (a[0] / n, a[1] / n, a[2] / n)


def mix(a, b, t):
    return tuple(x + (y - x) * t for x, y in zip(a, b))


# Rotations: quaternions w, x, y, z.
def turn(axis, degrees):
    h = math.radians(degrees) / 2
    a = unit(axis)
    return (math.cos(h), a[0] * math.sin(h), a[1] * math.sin(h), a[2] * math.sin(h))


def after(q, p):
    """p first, then q."""
    v, w = q[1:], p[1:]
    return (q[0] * p[0] - dot(v, w),) + add(add(cross(v, w), w, q[0]), v, p[0])


def between(a, b):
    """The shortest rotation that takes direction a to b."""
    a, b = unit(a), unit(b)
    c = dot(a, b)
    if c < -0.99999:
        return turn(cross(a, (1, 0, 0) if abs(a[0]) < 0.9 else (0, 1, 0)), 180)
    return unit4((1 + c,) + cross(a, b))


def unit4(q):
    n = math.sqrt(sum(x * x for x in q))
    return tuple(x / n for x in q)


def rotate(q, p):
    t = cross(q[1:], p)
    t = (2 * t[0], 2 * t[1], 2 * t[2])
    return add(add(p, t, q[0]), cross(q[1:], t))


# Curves.
def curve(points, n=8, closed=False):
    """A smooth line through the points (Catmull-Rom), n pieces between two; any dimension."""
    k = len(points)
    out = []
    for i in range(k if closed else k - 1):
        p = [points[(i + d) % k] if closed else points[min(max(i + d, 0), k - 1)]
             for d in (-1, 0, 1, 2)]
        for s in range(n):
            t = s / n
            out.append(tuple(
                0.5 * (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t * t
                       + (3 * b - a - 3 * c + d) * t ** 3) for a, b, c, d in zip(*p)))
    out.append(tuple(points[0] if closed else points[-1]))
    return out


def ring(radius, y=0.0, n=48, centre=(0, 0, 0), start=0.0, degrees=360.0):
    """Points of a circle about y, from +z towards +x."""
    return [add(centre, (radius * math.sin(a), y, radius * math.cos(a))) for a in
            (math.radians(start + degrees * i / n) for i in range(n + 1))]


def spiral(centre, axis, r0, r1, rise, turns, start=0.0, n=14):
    """A helix about `axis` whose radius goes from r0 to r1."""
    q = between((0, 0, 1), axis)
    out = []
    for i in range(int(turns * n) + 1):
        t = i / (turns * n)
        a, r = math.radians(start) + 2 * math.pi * turns * t, r0 + (r1 - r0) * t
        out.append(add(centre, rotate(q, (r * math.cos(a), r * math.sin(a), rise * t))))
    return out


def tapered(points, first, last, middle=1.0):
    """The points with pressure first → middle → last along the line."""
    n = max(len(points) - 1, 1)
    def at(t):
        if t < 0.5:
            return first + (middle - first) * t * 2
        return middle + (last - middle) * (2 * t - 1)
    return [tuple(p[:3]) + (at(i / n),) for i, p in enumerate(points)]


def wyvill(u2):
    return 1 + u2 * (-22 / 9 + u2 * (17 / 9 - u2 * 4 / 9)) if u2 < 1 else 0.0


def flat(u2):
    if u2 >= 1:
        return 0.0
    t = (math.sqrt(u2) - 0.7) / 0.3
    return 1.0 if t <= 0 else 1 - t * t * (3 - 2 * t)


def gauge2(shape, radii, x, y, z):
    """The square of the gauge, roughly for shapes other than the ellipsoid."""
    if shape == "ellipsoid":
        return x * x + y * y + z * z
    if shape == "cylinder":
        return max(x * x + z * z, y * y)
    if shape == "box":
        return max(x * x, y * y, z * z)
    cap = min(math.sqrt(radii[0] * radii[2]) / radii[1], 1.0)
    y = max(abs(y) - (1 - cap), 0.0) / cap
    return x * x + y * y + z * z


def number(x, digits=3):
    x = round(x, digits)
    return int(x) if x == int(x) else x


class Recording:
    def __init__(self, spacing=1.0, emit_scene=True):
        self.lines = ['{"bozzetto":"recording","version":1}']
        self.strokes = 0
        self.dabs = []
        self.scale = spacing
        self.digits = 3 if spacing > 0.1 else 5
        self.cell = 20.0 * spacing
        self.grid = defaultdict(list)
        self.last = {}
        self.mirror, self.mirror_at = "", (0, 0, 0)
        if emit_scene:
            self.op(op="scene", spacing=spacing, iso=0.5)

    # Operations.
    def op(self, **fields):
        def plain(v):
            if isinstance(v, dict):
                return {k: plain(x) for k, x in v.items()}
            if isinstance(v, (list, tuple)):
                return [plain(x) for x in v]
            return number(v, self.digits) if isinstance(v, float) else v
        self.lines.append(json.dumps({k: plain(v) for k, v in fields.items()},
                                     separators=(",", ":")))

    def once(self, **fields):
        if self.last.get(fields["op"]) != fields:
            self.last[fields["op"]] = fields
            self.op(**fields)

    def tool(self, radii, rotation=(1, 0, 0, 0), shape="ellipsoid", profile="wyvill"):
        if isinstance(radii, (int, float)):
            radii = (radii,) * 3
        radii = tuple(max(float(r), 2 * self.scale) for r in radii)
        self.once(op="tool", shape=shape, profile=profile, radii=radii,
                  rotation=tuple(map(float, rotation)))

    def action(self, name, strength=0.5, colour=None):
        fields = dict(op="action", name=name, strength=float(strength))
        if colour and name in ("add", "paint", "paint_soft"):
            fields["colour"] = colour
        self.once(**fields)

    def stroke(self, points, spacing=0.25, mirror=None, radial=None, pressure=()):
        points = [tuple(map(float, p)) for p in points]
        fields = dict(op="stroke", points=points, spacing=spacing)
        mirror = self.mirror if mirror is None else mirror
        if mirror:
            fields["mirror"] = mirror
        if radial:
            fields["radial"] = dict(axis=radial[0], count=radial[1])
        if (mirror or radial) and any(self.mirror_at):
            fields["mirror_at"] = self.mirror_at
        if pressure:
            fields["pressure"] = list(pressure)
        self.op(**fields)
        self.strokes += 1
        self.follow(points, spacing, mirror, radial, pressure)

    def write(self, path):
        with open(path, "w") as f:
            f.write("\n".join(self.lines) + "\n")
        size = sum(len(line) + 1 for line in self.lines)
        print(f"{path}: {self.strokes} strokes, {len(self.dabs)} dabs, {size // 1024} KiB")

    # Common gestures. Radii are of the surface they leave.
    def press(self, centre, radii, colour=None, times=1, name="add", strength=1.0,
              rotation=(1, 0, 0, 0), shape="ellipsoid", profile="wyvill", mirror=None, radial=None):
        """The tool pressed `times` times on the spot, its limit at `radii`."""
        self.tool(radii, rotation, shape, profile)
        self.action(name, strength, colour)
        least = min(self.last["tool"]["radii"])
        end = add(centre, (0, 0.01 * least * (times - 0.5), 0))
        if times == 1:
            self.stroke([centre], 0.25, mirror, radial)
        else:
            self.stroke([centre, end], 0.01, mirror, radial)

    def blob(self, centre, radii, colour, rotation=(1, 0, 0, 0), times=2, **more):
        """A hard round form: its surface at `radii`."""
        if isinstance(radii, (int, float)):
            radii = (radii,) * 3
        k = {1: 0.85, 2: 0.9, 3: 0.922}[times]
        self.press(centre, tuple(r / k for r in radii), colour, times, rotation=rotation,
                   profile="box", **more)

    def soft(self, centre, radii, colour, rotation=(1, 0, 0, 0), **more):
        """A soft round form that fuses with what is near: its surface at `radii`."""
        if isinstance(radii, (int, float)):
            radii = (radii,) * 3
        self.press(centre, tuple(r * 2 for r in radii), colour, 1, rotation=rotation, **more)

    def line(self, points, radius, colour=None, name="add", strength=0.6, spacing=0.25,
             pressure=None, rotation=(1, 0, 0, 0), squash=(1, 1, 1), **more):
        """A roll of clay (or a furrow) along a line; fourth numbers are taken as size."""
        most = max([p[3] for p in points if len(p) > 3], default=1.0)
        if most > 1:  # a pressure is at most 1
            points, radius = [tuple(p[:3]) + (p[3] / most,) for p in points], radius * most
        self.tool(tuple(radius / 0.64 * s for s in squash), rotation)
        if pressure is None:
            pressure = ["size"] if len(points[0]) > 3 else ()
        if "size" in pressure and spacing == 0.25:
            spacing, strength = 0.125, strength * 0.6
        self.action(name, strength, colour)
        self.stroke(points, spacing, pressure=pressure, **more)

    # Where the clay is.
    def images(self, mirror, radial):
        maps = [((1, 0, 0), (0, 1, 0), (0, 0, 1))]
        for i, letter in enumerate("xyz"):
            if letter in (mirror or ""):
                maps += [tuple(tuple(-v if j == i else v for j, v in enumerate(row)) for row in m)
                         for m in maps]
        if radial and radial[1] > 1:
            i = "xyz".index(radial[0])
            j, k = (i + 1) % 3, (i + 2) % 3
            base, maps = maps, []
            for n in range(radial[1]):
                c, s = math.cos(2 * math.pi * n / radial[1]), math.sin(2 * math.pi * n / radial[1])
                for m in base:
                    rows = []
                    for row in m:
                        r = list(row)
                        r[j], r[k] = c * row[j] - s * row[k], s * row[j] + c * row[k]
                        rows.append(tuple(r))
                    maps.append(tuple(rows))
        return maps  # rows are images of the axes

    def follow(self, points, spacing, mirror, radial, pressure):
        tool, action = self.last["tool"], self.last["action"]
        if action["name"] not in ("add", "remove", "erase"):
            return
        axes = [rotate(tool["rotation"], a) for a in ((1, 0, 0), (0, 1, 0), (0, 0, 1))]
        maps = self.images(mirror, radial)
        for position, force in resample(points, spacing * min(tool["radii"])):
            size = force if "size" in pressure else 1.0
            radii = tuple(max(r * size, 2 * self.scale) for r in tool["radii"])
            strength = action["strength"] * (force if "strength" in pressure else 1.0)
            for m in maps:
                def image(v):
                    return tuple(sum(v[a] * m[a][b] for a in range(3)) for b in range(3))
                centre = add(self.mirror_at, image(sub(position, self.mirror_at)))
                rows = [tuple(x / r for x in image(a)) for a, r in zip(axes, radii)]
                self.keep(centre, rows, radii, (tool["shape"], tool["profile"]),
                          (action["name"], strength))

    def keep(self, centre, rows, radii, kind, deed):
        reach = []
        for b in range(3):
            r = [rows[a][b] * radii[a] * radii[a] for a in range(3)]
            reach.append(math.sqrt(sum(x * x for x in r)) if kind[0] == "ellipsoid"
                         else sum(abs(x) for x in r))
        index = len(self.dabs)
        self.dabs.append((centre, rows, radii, kind, deed))
        low = [math.floor((c - e) / self.cell) for c, e in zip(centre, reach)]
        high = [math.floor((c + e) / self.cell) for c, e in zip(centre, reach)]
        for i in range(low[0], high[0] + 1):
            for j in range(low[1], high[1] + 1):
                for k in range(low[2], high[2] + 1):
                    self.grid[i, j, k].append(index)

    def value(self, p):
        v = 0.0
        x, y, z = p
        c = self.cell
        for i in self.grid.get((math.floor(x / c), math.floor(y / c), math.floor(z / c)), ()):
            (cx, cy, cz), (a, b, d), radii, (shape, profile), (name, s) = self.dabs[i]
            dx, dy, dz = x - cx, y - cy, z - cz
            u2 = gauge2(shape, radii, a[0] * dx + a[1] * dy + a[2] * dz,
                        b[0] * dx + b[1] * dy + b[2] * dz, d[0] * dx + d[1] * dy + d[2] * dz)
            if u2 >= 1:
                continue
            w = wyvill(u2) if profile == "wyvill" else flat(u2)
            if name == "add":
                v = min(1.0, v + s * w)
            elif name == "remove":
                v = max(0.0, v - s * w)
            else:
                v = 0.0
        return v

    def cast(self, origin, direction, far=400.0):
        """The first point of the surface along a ray, or None."""
        d = unit(direction)
        step, t = 2.0 * self.scale, 0.0
        while t < far * self.scale:
            if self.value(add(origin, d, t)) >= 0.5:
                low, high = t - step, t
                for _ in range(8):
                    middle = (low + high) / 2
                    if self.value(add(origin, d, middle)) >= 0.5:
                        high = middle
                    else:
                        low = middle
                return add(origin, d, high)
            t += step
        return None

    def front(self, x, y, z=160.0):
        return self.cast((x, y, z), (0, 0, -1))

    def toward(self, centre, direction, reach=150.0):
        """The surface seen from outside towards `centre`, which lies in `direction` from it."""
        return self.cast(add(centre, unit(direction), reach), sub((0, 0, 0), direction))

    def normal(self, p, h=2.0):
        h *= self.scale
        g = [self.value(add(p, e, -h)) - self.value(add(p, e, h))
             for e in ((1, 0, 0), (0, 1, 0), (0, 0, 1))]
        return unit(tuple(g)) if any(g) else (0, 0, 1)

    def front_line(self, points, lift=0.0):
        """Points (x, y[, pressure]) laid on the clay from the front, `lift` above it."""
        out = []
        for p in points:
            hit = self.front(p[0], p[1])
            if hit:
                out.append(add(hit, self.normal(hit), lift) + tuple(p[2:3]))
        return out


def resample(points, step):
    """Positions at equal distances and their pressure, as the program does it."""
    yield points[0][:3], points[0][3] if len(points[0]) > 3 else 1.0
    due = step
    for a, b in zip(points, points[1:]):
        n = length(sub(b[:3], a[:3]))
        pa, pb = (a[3] if len(a) > 3 else 1.0), (b[3] if len(b) > 3 else 1.0)
        while due <= n:
            t = due / n
            yield mix(a[:3], b[:3], t), pa + (pb - pa) * t
            due += step
        due -= n
