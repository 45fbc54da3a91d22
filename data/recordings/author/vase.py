"""A footed vase: lathe, leaves and vine in relief, a carved meander, glaze bands, hollow inside."""
import math
import sys
from sculpt import *

r = Recording()
CLAY, GLAZE, DEEP, CREAM, GOLD, LEAF = ("#b5673c", "#1d5f74", "#123a52", "#efe3c6", "#d79a32",
                                        "#55794c")
# Outer profile, foot to lip: radius, height.
PROFILE = [(50, -128), (52, -120), (46, -112), (30, -104), (24, -96), (28, -86), (44, -72),
           (62, -50), (74, -24), (79, 2), (76, 28), (66, 50), (50, 66), (37, 80), (31, 94),
           (31, 106), (36, 116), (45, 124), (48, 128)]
OUTER = curve(PROFILE, 6)


def radius_at(y):
    for (r0, y0), (r1, y1) in zip(OUTER, OUTER[1:]):
        if min(y0, y1) <= y <= max(y0, y1) and y0 != y1:
            return r0 + (r1 - r0) * (y - y0) / (y1 - y0)
    return OUTER[-1][0]


def at(degrees, y, lift=0.0):
    """A point on the wall."""
    a = math.radians(degrees)
    slope = (radius_at(y + 1) - radius_at(y - 1)) / 2
    n = unit((1, -slope, 0))
    rad, height = radius_at(y) + n[0] * lift, y + n[1] * lift
    return (rad * math.sin(a), height, rad * math.cos(a))


def lathe():
    """The wall: rings of clay, each a stroke, as a potter coils."""
    y = -126
    while y <= 127:
        rad = radius_at(y)
        wall = min(7.5, rad - 14)
        r.line(ring(rad - wall, y, 40), wall, CLAY, strength=0.6, spacing=0.33)
        y += 4
    # A solid foot and floor.
    r.blob((0, -118, 0), (44, 9, 44), CLAY, shape="cylinder")
    r.line([(0, -112, 0), (0, -84, 0)], 24, CLAY)
    r.line(ring(20, -72, 24), 15, CLAY)
    for y in range(-120, 128, 11):  # drawn smooth, inside and out
        r.tool(18)
        r.action("smooth", 1)
        r.stroke(ring(radius_at(y) - 3, y, 40), 0.22)


def lips():
    r.line(ring(46, 127, 48), 7, CLAY)
    r.line(ring(50, -124, 48), 7, CLAY)
    r.line(ring(25, -96, 40), 6.5, CLAY)
    r.line(ring(31, 84, 40, ), 8, CLAY)


def beads():
    for place, size, count in ((at(0, 65, 1), 7.5, 24), (at(0, -104, 2), 6.5, 16)):
        r.press(place, size, CREAM, 2, profile="box", radial=("y", count))
        r.press(place, size, CREAM, 2, "paint_soft", 0.8, profile="box", radial=("y", count))


def leaves():
    """A calyx of long leaves round the bowl, each with a vein, and small ones between."""
    n = 10
    def leaf(turned, low, high, width, lift):
        q = turn((0, 1, 0), turned)
        spine = [at(turned, low + (high - low) * k / 8, lift + 4 * (k / 8) ** 3) for k in range(9)]
        for side in (-1, -0.5, 0, 0.5, 1):
            points = []
            for k in range(9):
                t = k / 8
                w = width * math.sin(math.pi * min(1, 0.12 + 0.88 * t)) ** 0.8
                y = low + (high - low) * (t - 0.07 * abs(side) * t)
                shift = math.degrees(side * w / max(radius_at(y), 20))
                points.append(at(turned + shift, y, lift + 3.5 * t ** 3 - 1.2 * abs(side)) +
                              (1 - 0.6 * t ** 3,))
            r.line(points, 4.2, LEAF, radial=("y", n), strength=0.5)
        r.line(tapered([add(p, rotate(q, (0, 0, 1)), 4) for p in spine[:-1]], 1, 0.4), 2.4,
               name="remove", strength=0.3, radial=("y", n))
        for k in (2, 3, 4, 5, 6):
            t = k / 8
            y = low + (high - low) * t
            for side in (-1, 1):
                end = at(turned + side * math.degrees(width * 0.7 / radius_at(y + 7)), y + 7,
                         lift + 3)
                r.line([add(spine[k], rotate(q, (0, 0, 1)), 3.5), end], 2, name="remove",
                       strength=0.2, radial=("y", n))
    leaf(18, -80, -34, 8, 0.5)
    leaf(0, -84, -14, 12, 2.5)


def vine():
    """A wave round the belly with a curl, a leaf and berries in every bend."""
    n, y0, swing = 6, 19, 12
    stem = []
    for k in range(31):
        t = k / 30
        stem.append(at(-30 + 60 * t, y0 + swing * math.sin(2 * math.pi * t), 2))
    r.line(stem, 3.6, GOLD, radial=("y", n), strength=0.5)
    for up, base in ((1, -15), (-1, 15)):
        curl = []
        for k in range(33):
            t = k / 32
            a = math.pi * (0.5 + 2.6 * t)
            rad = 10.5 * (1 - 0.75 * t)
            curl.append(at(base + math.degrees(rad * math.cos(a) / 78), y0 + up *
                           (2.5 + rad * math.sin(a) - 3), 2) + (1 - 0.45 * t,))
        r.line(curl, 3.0, GOLD, radial=("y", n), strength=0.5)
        for dx, dy in ((0, 0), (4.5, -5), (-4.5, -5), (0, -9.5)):
            p = at(base + 14 + math.degrees(dx / 78), y0 + up * (17 + dy * 0.8), 2)
            r.press(p, 5.4, "#9c2f3a", 2, profile="box", radial=("y", n))
            r.press(p, 5.4, "#9c2f3a", 2, "paint_soft", 0.9, profile="box", radial=("y", n))


def meander():
    """A Greek key scratched through the slip under the shoulder."""
    r.tool(11, profile="box")
    r.action("paint_soft", 0.7, CREAM)
    r.stroke(ring(radius_at(49), 49, 48), 0.3)
    n, y0, h = 10, 42, 14
    w = 360 / n
    key = [(0, 0), (0.1, 0), (0.1, 1), (0.8, 1), (0.8, 0.34), (0.45, 0.34), (0.45, 0.66)]
    base = [(0.1, 0), (1.02, 0)]
    for path in (key, base):
        points = []
        for (ax, ay), (bx, by) in zip(path, path[1:]):
            points += [at(w * (ax + (bx - ax) * k / 6), y0 + h * (ay + (by - ay) * k / 6), 0.3)
                       for k in range(7)]
        r.line(points, 2.2, name="remove", strength=0.16, radial=("y", n))
        r.line(points, 2.2, DEEP, name="paint_soft", strength=0.6, radial=("y", n))


def handles():
    path = curve([(34, 100, 0), (52, 112, 0), (72, 108, 0), (83, 88, 0), (80, 64, 0),
                  (70, 48, 0)], 6)
    r.mirror = "x"
    r.line(tapered(path, 0.9, 1.15), 7.2, CLAY, squash=(1, 1, 1.25))
    r.line(spiral((74, 46, 0), (0, 0, 1), 10, 3, 0, 1.3, 200), 4.5, CLAY)
    for k in range(3, len(path) - 8, 3):
        d = unit(sub(path[k + 1], path[k - 1]))
        loop = [add(path[k], rotate(between((0, 1, 0), d), p)) for p in ring(7.4, 0, 14)]
        r.line(loop, 2, name="remove", strength=0.09)
    r.line(path[2:-6], 7.5, GLAZE, name="paint_soft", strength=0.4)
    r.mirror = ""


def hollow():
    """Cut out by a tool smaller than the neck, going round ever wider."""
    for y in range(-60, 140, 6):
        inner = (radius_at(min(y, 127)) if y < 128 else 50) - 15
        size = 12
        if inner <= size + 1:
            continue
        rad = inner - size
        r.tool(size, profile="box")
        r.action("erase", 1)
        while rad > 0:
            r.stroke(ring(rad, y, max(16, int(rad))), 0.5)
            rad -= 16
        r.stroke([(0, y, 0)])
    # Erasing leaves the grid's own steps: a soft cut and a smoothing take them away.
    for y in range(-60, 128, 5):
        rad = radius_at(y) - 13
        if rad < 14:
            continue
        r.tool(13)
        r.action("remove", 0.5)
        r.stroke(ring(rad - 6, y, max(16, int(rad))), 0.25)
    for y in range(-66, 128, 9):
        rad = max(radius_at(y) - 12, 8)
        r.tool(13)
        r.action("smooth", 1)
        r.stroke(ring(rad, y, max(16, int(rad))), 0.14)
    r.tool(24)
    r.stroke(ring(8, -66, 12), 0.06)


def glaze():
    def band(y, height, colour, strength=0.6):
        r.tool((height, height, height), profile="box")
        r.action("paint_soft", strength, colour)
        r.stroke(ring(radius_at(y), y, 48), 0.3)
    for y in range(92, 122, 5):
        band(y, 6, GLAZE)
    for y in range(112, 134, 5):
        r.tool(9, profile="box")
        r.action("paint_soft", 0.6, DEEP)
        r.stroke(ring(46, y + 2, 48), 0.3)
    for y in (2, 37):
        band(y, 4.5, DEEP, 0.8)
    for y in range(-126, -108, 4):
        r.tool(9, profile="box")
        r.action("paint_soft", 0.6, GLAZE)
        r.stroke(ring(50, y, 48), 0.3)


lathe()
lips()
hollow()
glaze()
meander()
handles()
leaves()
vine()
beads()
r.write(sys.argv[1])
