"""Dresses the scanned rabbit (bunny00.off of CGAL's test data, which sits in ±0.5, Y up).
on_scan.py OUT.jsonl BUNNY.off"""
import math
import random
import sys
from scan import Scan
from sculpt import *

CELL = 1 / 192
rng = random.Random(1998)
scan = Scan(sys.argv[2], 0.03)
r = Recording(CELL, emit_scene=False)
RED, CREAM, ORANGE, GREEN, BROWN, PLUM, GOLD = ("#b3262b", "#f1e4c8", "#e8741e", "#4f8a38",
                                                "#5b3018", "#4b2f63", "#e2ac3a")


def smooth_parts():
    """The haunch made smooth for the letters, and the brow."""
    r.tool(0.075)
    r.action("smooth", 1)
    for y in (-0.13, -0.19, -0.25, -0.31):
        r.stroke(scan.front_line([(0.02 + 0.04 * k, y) for k in range(7)]), 0.04)


def patches():
    for points, radii in (([(0.27, 0.0), (0.33, -0.06)], (0.1, 0.09, 0.1)),
                          ([(0.36, -0.17)], (0.06, 0.055, 0.1)),
                          ([(0.02, 0.03)], (0.08, 0.06, 0.08)),
                          ([(-0.12, -0.3)], (0.06, 0.07, 0.06)),
                          ([(-0.29, 0.25), (-0.27, 0.2)], (0.075, 0.07, 0.07))):
        r.tool(radii, profile="box")
        r.action("paint_soft", 0.7, BROWN)
        r.stroke([scan.front(*p)[0] for p in points], 0.3)
    # The tail white, by the hard brush.
    r.tool((0.085, 0.12, 0.15))
    r.action("paint", 1, CREAM)
    r.stroke([(0.485, -0.34, 0.1)])
    r.tool((0.1, 0.13, 0.16), profile="box")
    r.action("paint_soft", 0.5, CREAM)
    r.stroke([(0.485, -0.34, 0.1)])
    # Socks.
    r.tool((0.13, 0.055, 0.2), profile="box")
    r.action("paint_soft", 0.5, CREAM)
    r.stroke([(-0.26, -0.49, 0.2), (-0.2, -0.49, -0.08)], 0.3)
    r.stroke([(0.02, -0.5, 0.33), (0.15, -0.5, 0.3)], 0.3)
    # The ear's inside and the nose.
    r.tool((0.028, 0.028, 0.05))
    r.action("paint_soft", 0.5, "#e88f8a")
    ear = scan.front_line(curve([(-0.16, 0.3), (-0.07, 0.36), (0.0, 0.42), (0.03, 0.45)], 4))
    r.stroke(ear, 0.3)


def eyes():
    for x, y in ((-0.295, 0.245),):
        p, n = scan.front(x, y)
        q = between((0, 0, 1), n)
        r.press(add(p, n, -0.004), (0.034, 0.03, 0.026), "#231611", 2, rotation=q, profile="box")
        r.press(add(add(p, n, 0.022), (0.008, 0.011, 0)), 0.0105, "#ffffff", 3, "paint_soft", 1)
        lid = [add(add(p, n, 0.006), rotate(q, (0.036 * math.cos(a), 0.032 * math.sin(a), 0)))
               for a in (math.radians(d) for d in range(10, 171, 20))]
        r.line(tapered(lid, 0.5, 0.5), 0.011, "#b5714a", spacing=0.12)


def scarf():
    centre, q = (-0.27, 0.065, 0.12), turn((0, 0, 1), 24)
    def loop(height, lift):
        out = []
        for k in range(49):
            a = 2 * math.pi * k / 48
            d = rotate(q, (math.sin(a), 0, math.cos(a)))
            found = scan.toward(add(centre, rotate(q, (0, height, 0))), d)
            out.append(add(found[0], d, lift))
        # Cloth spans hollows: take the running maximum of three.
        far = [length(sub(p, centre)) for p in out]
        return [add(centre, unit(sub(p, centre)), (far[i - 1] + far[i] + far[(i + 1) % 48]) / 3)
                for i, p in enumerate(out[:-1])] + [add(centre, unit(sub(out[0], centre)),
                                                        (far[47] + far[0] + far[1]) / 3)]
    for height, lift, colour in ((-0.042, 0.008, RED), (-0.014, 0.018, RED), (0.014, 0.016, CREAM),
                                 (0.04, 0.006, RED)):
        r.line(curve(loop(height, lift), 1), 0.021, colour, strength=0.5)
    # Ribs across it.
    for k in range(48):
        a = 2 * math.pi * k / 48
        d = rotate(q, (math.sin(a), 0, math.cos(a)))
        found = scan.toward(centre, d)
        p = add(found[0], d, 0.036)
        up = rotate(q, (0.012, 0.05, 0))
        r.line([add(p, up, -1), p, add(p, up)], 0.008, name="remove", strength=0.18)
    # Knot and two ends with fringes.
    knot = add(scan.toward(centre, rotate(q, (-0.25, -0.1, 1)))[0], (0, -0.01, 0.03))
    r.blob(knot, (0.05, 0.042, 0.036), RED)
    for lean, drop in ((-0.07, 0.24), (0.045, 0.2)):
        for side in (-0.036, -0.012, 0.012, 0.036):
            xs = [(knot[0] + lean * t + side * (0.4 + 0.6 * t), knot[1] - 0.02 - drop * t)
                  for t in (k / 6 for k in range(7))]
            r.line(scan.front_line(xs, 0.013), 0.017, RED, strength=0.5)
        for t in (0.62, 0.8):
            xs = [(knot[0] + lean * t + s * 0.05, knot[1] - 0.02 - drop * t) for s in
                  (-1, -0.5, 0, 0.5, 1)]
            r.line(scan.front_line(xs, 0.026), 0.012, CREAM, name="paint_soft", strength=0.8)
        for side in range(-3, 4):
            x, y = knot[0] + lean + side * 0.014, knot[1] - 0.02 - drop
            fringe = scan.front_line([(x, y), (x + side * 0.002, y - 0.02),
                                      (x + rng.uniform(-0.01, 0.01), y - 0.05)], 0.011)
            if len(fringe) > 1:
                r.line(tapered(fringe, 1, 0.7), 0.008, CREAM if side % 2 else RED)


def hat():
    """A top hat, radial strokes about its axis, a mirrored bow and a flower."""
    c = add(scan.cast((-0.32, 1, 0.14), (0, -1, 0))[0], (0, 0.005, 0))
    r.mirror_at = c
    r.press(c, (0.15, 0.016, 0.13), PLUM, 2, shape="cylinder", profile="box")
    r.line(ring(0.125, 0.006, 40, c), 0.014, PLUM)
    for k in range(5):
        y = 0.02 + 0.03 * k
        r.press(add(c, (0, y, 0)), (0.088 + 0.003 * k, 0.03, 0.088 + 0.003 * k), PLUM, 2,
                shape="cylinder", profile="box")
    r.line(ring(0.085, 0.155, 40, c), 0.013, PLUM)
    # The crown's flutes: one short furrow, twenty times.
    r.line([add(c, (0, 0.075, 0.093)), add(c, (0, 0.14, 0.096))], 0.0105, name="remove",
           strength=0.2, radial=("y", 20))
    r.line(ring(0.083, 0.045, 40, c), 0.017, GOLD)
    knot = add(c, (0, 0.047, 0.1))
    r.mirror_at = knot
    for lift in (0.018, -0.014):
        r.line(tapered([add(knot, (0.008, 0, 0)), add(knot, (0.035, lift, 0.006)),
                        add(knot, (0.055, lift * 1.3, -0.006))], 0.5, 1), 0.018, GOLD, mirror="x")
    r.blob(knot, 0.017, GOLD)
    r.mirror_at = (0, 0, 0)


def buttons():
    for y in (-0.07, -0.155, -0.24):
        p, n = scan.cast((-1.2, y, 1.0), (0.7, 0, -0.7))
        q = between((0, 1, 0), n)
        r.press(add(p, n, 0.004), (0.04, 0.02, 0.04), GOLD, 3, rotation=q, shape="cylinder",
                profile="box")
        r.line([add(p, rotate(q, v)) for v in ring(0.031, 0.018, 20)], 0.0105, GOLD)
        for d in (0.013, -0.013):
            r.press(add(p, rotate(q, (d, 0.022, 0))), (0.0115, 0.02, 0.0115), name="remove",
                    strength=0.8, rotation=q)


def letters():
    """F C, who had the idea, carved into the haunch with a heart."""
    x, y, h = 0.06, -0.2, 0.085
    f = [[(x, y - h / 2), (x, y + h / 2)], [(x, y + h / 2), (x + 0.055, y + h / 2)],
         [(x, y + 0.004), (x + 0.042, y + 0.004)]]
    c = [[(x + 0.135 + 0.04 * math.cos(a), y + 0.044 * math.sin(a)) for a in
          (math.radians(d) for d in range(48, 313, 12))]]
    for path in f + c:
        line = []
        for a, b in zip(path, path[1:]):
            line += [mix(a, b, k / 4) for k in range(4)]
        line = scan.front_line(line + [path[-1]], 0.004)
        r.line(line, 0.0105, name="remove", strength=0.35)
        r.line(line, 0.008, "#43200f", name="paint_soft", strength=0.6)
    heart = [(0, -0.03), (0.03, 0.005), (0.036, 0.022), (0.024, 0.036), (0.008, 0.03), (0, 0.014)]
    for side in (1, -1):
        line = scan.front_line([(x + 0.085 + side * a, y - 0.105 + b * 0.8) for a, b in
                                curve(heart, 4)], 0.004)
        r.line(line, 0.009, name="remove", strength=0.35)
        r.line(line, 0.009, RED, name="paint_soft", strength=0.6)


def carrot():
    a, b = (-0.47, -0.452, 0.36), (-0.14, -0.468, 0.47)
    body = [mix(a, b, k / 8) for k in range(9)]
    r.line(tapered(body, 1, 0.35, 0.75), 0.042, ORANGE, spacing=0.08)
    d = unit(sub(b, a))
    for k in range(10):
        t = 0.06 + 0.085 * k + rng.uniform(-0.02, 0.02)
        size = 0.042 * (1 - 0.6 * t)
        turned = rng.uniform(-60, 60)
        q = after(between((0, 1, 0), d), turn((0, 1, 0), turned))
        arc = [add(mix(a, b, t), rotate(q, (size * math.sin(u), 0, size * math.cos(u))))
               for u in (math.radians(v) for v in range(-50, 51, 20))]
        r.line(tapered(arc, 0.2, 0.2), 0.0105, name="remove", strength=0.3, pressure=["strength"])
    # A bite.
    for dx, dy, dz in ((0.02, 0.035, 0.01), (0.0, 0.03, 0.03), (0.035, 0.03, -0.012)):
        r.press(add(mix(a, b, 0.45), (dx, dy, dz)), 0.026, name="erase", strength=1)
    r.tool(0.035)
    r.action("smooth", 0.8)
    r.stroke([add(mix(a, b, 0.45), (0.01, 0.01, 0.01)), add(mix(a, b, 0.5), (0, 0.01, 0))], 0.08)
    for k in range(9):
        s = rng.uniform(-1, 1)
        leaf = curve([a, add(a, (-0.05, 0.02 + 0.02 * abs(s), 0.03 * s - 0.02)),
                      add(a, (-0.11 - 0.03 * rng.random(), 0.01 + 0.05 * rng.random(),
                              0.08 * s - 0.03))], 4)
        r.line(tapered(leaf, 0.7, 0.5), 0.011, GREEN, spacing=0.12)


def daisy():
    """Petals by radial symmetry about z, on the scarf's knot side of the chest."""
    p, n = scan.front(0.06, 0.06)
    p = add(p, n, 0.01)
    r.mirror_at = p
    q = between((0, 0, 1), n)
    r.line([add(p, (0, 0.016, 0.004)), add(p, (0, 0.045, 0))], 0.0125, CREAM, radial=("z", 8))
    r.blob(add(p, (0, 0, 0.008)), 0.018, GOLD)
    r.mirror_at = (0, 0, 0)


smooth_parts()
patches()
letters()
eyes()
hat()
scarf()
buttons()
daisy()
carrot()
r.write(sys.argv[1])
