"""A clown's head, after figure 16 of Ferley, Cani and Gascuel: ellipsoids only."""
import math
import random
import sys
from sculpt import *

rng = random.Random(16)
r = Recording()
SKIN, WHITE, RED, DARK = "#dd9c74", "#f4ead8", "#c8201c", "#5a1012"
HAIR, HAIR2, BLUE, FELT, BAND = "#e0641a", "#f0862a", "#2b62b8", "#2c5a54", "#f0b83a"
UP = (0, 1, 0)


def plinth():
    for y, rad in ((-158, 60), (-148, 58), (-138, 56)):
        r.blob((0, y, -4), (rad, 11, rad), "#4a3a34")
    for y, rad in ((-157, 54), (-148, 57)):
        r.line(ring(rad, y, 48, (0, 0, -4)), 9, "#4a3a34")
    r.line(ring(63, -138, 48, (0, 0, -4)), 6, "#4a3a34")
    r.line(ring(66, -158, 48, (0, 0, -4)), 7, "#4a3a34")


def head():
    r.mirror = "x"
    r.blob((0, 26, -8), (60, 62, 62), SKIN)
    r.blob((0, -14, 4), (53, 54, 54), SKIN)
    r.blob((0, -54, 26), (27, 20, 24), SKIN)
    r.blob((34, -12, 36), (24, 22, 20), SKIN)
    r.line([(0, -50, -8), (0, -120, -10)], 31, SKIN)
    # Fuse: rolls along the seams, then a broad smoothing.
    r.line([(36, -40, 24), (18, -58, 34)], 13, SKIN, strength=0.3)
    r.line([(52, 10, 8), (48, -20, 10), (34, -48, 10)], 16, SKIN, strength=0.3)
    r.line([(0, 44, 50), (22, 44, 46), (40, 36, 36)], 13, SKIN, strength=0.35)
    r.line([(0, -44, 46), (12, -46, 44)], 11, SKIN, strength=0.35)
    for points in ([(0, 60, 40), (40, 40, 34), (54, 0, 20), (40, -44, 26), (0, -66, 36)],
                   [(0, 20, 56), (30, 10, 50), (20, -20, 52), (0, -40, 54)]):
        r.tool(26)
        r.action("smooth", 0.9)
        r.stroke(curve(points, 4), 0.06)


def sockets():
    r.press((23, 22, 62), (24, 20, 20), name="remove", strength=0.55)
    r.press((9, 22, 60), (12, 14, 14), name="remove", strength=0.3)


def eyes():
    r.blob((22, 21, 44), 17, WHITE)
    lid = [(22 + 19.0 * math.cos(a), 21 + 14.5 * math.sin(a)) for a in
           (math.radians(d) for d in range(10, 176, 15))]
    upper = [(x, y, 44 + math.sqrt(max(20.5 ** 2 - (x - 22) ** 2 - (y - 21) ** 2, 0)) - 2)
             for x, y in lid]
    r.line(curve(tapered(upper, 0.6, 0.6), 2), 4.6, SKIN)
    lower = [(22 + 18 * math.cos(a), 20 + 13.0 * math.sin(a)) for a in
             (math.radians(d) for d in range(190, 351, 16))]
    lower = [(x, y, 44 + math.sqrt(max(20 ** 2 - (x - 22) ** 2 - (y - 21) ** 2, 0)) - 2.5)
             for x, y in lower]
    r.line(curve(tapered(lower, 0.6, 0.6), 2), 3.8, SKIN)


def nose():
    r.line([(0, 30, 52), (0, 12, 62), (0, 2, 70)], 9, SKIN, strength=0.5)
    r.blob((0, -2, 82), (21, 20, 20), RED)
    r.mirror = ""
    r.press((-6, 8, 98), (5, 4, 5), "#ff9a8a", name="paint_soft", strength=0.5)


def mouth():
    r.mirror = "x"
    # A broad muzzle for the paint to sit on.
    r.line(r.front_line(curve([(0, -38), (18, -36), (34, -26), (43, -14)], 4), -4), 11, SKIN,
           strength=0.4)
    smile = curve([(0, -37.5), (14, -35.5), (28, -29), (41, -15)], 4)
    r.line(r.front_line(smile, 1), 6.5, DARK, name="remove", strength=0.5)
    r.line(r.front_line(smile, -2), 7, DARK, name="paint_soft", strength=0.7)
    teeth = r.front_line(curve([(0, -34.5), (14, -32.5), (25, -28)], 4), -3)
    r.line(teeth, 4, "#f6eeda", strength=0.5)
    upper = curve([(0, -31.5), (13, -29), (27, -23), (39, -12), (42, -10)], 4)
    lower = curve([(0, -48), (14, -45.5), (29, -37), (41, -22), (44, -12)], 4)
    r.line(tapered(r.front_line(upper, 0.5), 1, 0.5), 5, RED)
    r.line(tapered(r.front_line(lower, 1), 1.1, 0.5), 6, RED)


def ears():
    r.mirror = "x"
    rim = [(60, 24, -4), (70, 34, -9), (80, 31, -15), (83, 17, -17), (77, 3, -13), (66, -10, -5)]
    r.blob((69, 12, -9), (11, 21, 12), SKIN, rotation=turn((0, 1, 0), 30))
    r.line(curve(tapered(rim, 0.85, 1.15), 5), 5.6, SKIN)
    r.press((78, 14, -1), (11, 16, 12), name="remove", strength=0.8)
    r.line([(66, 0, 4), (68, 10, 3), (66, 18, 1)], 4, SKIN)
    r.press((76, 14, -4), (11, 16, 12), "#b9603f", 1, "paint_soft", 0.9)


def brows():
    r.mirror = ""
    for side, lift in ((1, 4), (-1, 0)):
        def arch(t, dy=0.0):
            return (side * (8 + 31 * t), 62 + lift + 12 * math.sin(math.pi * (0.08 + 0.8 * t)) + dy)
        roll = r.front_line([arch(k / 10) for k in range(11)], 1)
        tufts = []
        for i in range(12):  # lying along it
            t = i / 11 * 0.84
            tufts.append(r.front_line([arch(t, rng.uniform(-4, 1)),
                                       arch(t + 0.1, rng.uniform(-1, 3)),
                                       arch(t + 0.2, rng.uniform(0, 4))], 5))
        r.line(tapered(roll, 0.8, 0.45), 6.5, HAIR)
        for tuft in tufts:
            r.line(tapered(tuft, 0.9, 0.35), 2.6,
                   rng.choice(["#b8430f", HAIR, HAIR2]), spacing=0.12)


def hair():
    """Curls: helices in two heaps at the sides and round the back, all rooted in the head."""
    r.mirror = ""
    roots = []
    for side in (1, -1):
        for _ in range(420):
            u, v = rng.random(), rng.random()
            a = math.radians(66 + 112 * u) * side
            e = math.radians(-20 + 62 * v * (1 - 0.2 * u))
            if 80 < abs(math.degrees(a)) < 118 and -18 < math.degrees(e) < 19:
                continue  # the ear
            d = (math.cos(e) * math.sin(a), math.sin(e), math.cos(e) * math.cos(a))
            p = r.toward((0, 16, -8), d, 120)
            if all(length(sub(p, q)) > 10.5 for q, _, _ in roots):
                roots.append((p, d, side))
    for p, d, side in roots:
        r.soft(add(p, d, 2), 8, HAIR)
    tiers = [root + ((3, 11),) for root in roots]
    tiers += [root + ((13, 21),) for root in roots
              if abs(root[1][0]) > 0.6 and length(sub(root[0], (78 * root[2], 14, -12))) > 20]
    for p, d, side, heights in tiers:
        n = unit(mix(d, (0.3 * side, rng.uniform(-0.5, 0.6), rng.uniform(-0.4, 0.4)), 0.4))
        radius = rng.uniform(7.5, 10.5)
        points = spiral(add(p, d, rng.uniform(*heights)), n, radius, radius * 0.25,
                        rng.uniform(9, 16), rng.uniform(1.6, 2.4), rng.uniform(0, 360), 10)
        r.line(tapered(points, 0.9, 0.55), 3.7, rng.choice([HAIR, HAIR, HAIR2, "#c9500f"]),
               spacing=0.25, strength=0.6)


def ruff():
    r.mirror = ""
    pleats = 14
    for layer, (y, inner, outer, amp) in enumerate([(-104, 30, 92, 12), (-86, 26, 78, 10)]):
        n = 10
        for i in range(n):
            phase = 360 / pleats * i / n
            points = []
            for k in range(8):
                t = k / 7
                a = math.radians(phase)
                rad = inner + (outer - inner) * t
                h = amp * t ** 0.8 * math.cos(a * pleats) - 8 * t * t
                points.append((rad * math.sin(a), y + h, rad * math.cos(a) - 6))
            r.mirror_at = (0, 0, -6)
            r.line(points, 4.2, WHITE, strength=0.5, radial=("y", pleats))
        # The coloured hem.
        hem = []
        for i in range(pleats * 12 + 1):
            a = 2 * math.pi * i / (pleats * 12)
            hem.append((outer * math.sin(a), y + amp * math.cos(a * pleats) - 8,
                        outer * math.cos(a) - 6))
        r.line(hem, 4.6, [BLUE, RED][layer], strength=0.5)
        r.line(hem, 4.4, [BLUE, RED][layer], name="paint_soft", strength=0.6)
    r.mirror_at = (0, 0, 0)


def hat():
    tilt = after(turn((0, 0, 1), 20), turn((1, 0, 0), -8))
    c = (-20, 84, -6)
    def at(x, y, z):
        return add(c, rotate(tilt, (x, y, z)))
    r.blob(at(0, 0, 0), (46, 5, 46), FELT, rotation=tilt)
    r.blob(at(0, 22, 0), (30, 28, 30), FELT, rotation=tilt)
    r.line([at(0, 4, 0), at(0, 18, 0)], 31, FELT)
    r.line([at(*p) for p in ring(45, 2, 40)], 5, FELT)
    for y in (8, 13):
        r.line([at(*p) for p in ring(32.5, y, 40)], 4.6, BAND)
    # A daisy in the band.
    heart = at(10, 22, 31)
    stem = add(heart, rotate(tilt, (2, 16, 8)))
    r.line(tapered([at(8, 8, 33), heart, stem], 1, 0.8), 2.6, "#3f7d32")
    face = unit(add(rotate(tilt, (0.2, 0.2, 1)), (0.5, 0, 0.3)))
    q = between((0, 0, 1), face)
    for i in range(9):
        a = 2 * math.pi * i / 9
        petal = rotate(q, (9.5 * math.cos(a), 9.5 * math.sin(a), 0))
        r.blob(add(stem, petal), (7, 3.6, 2.6), WHITE,
               rotation=after(q, turn((0, 0, 1), math.degrees(a))))
    r.blob(add(stem, face, 2), 6, BAND)


def wrinkles():
    r.mirror = "x"
    for y, bend in ((70, 2), (62, 3)):
        pts = r.front_line(curve([(0, y), (14, y + bend), (28, y - 3)], 3), 2)
        r.line(tapered(pts, 1, 0.3), 3, name="remove", strength=0.2, pressure=["strength"])
    fold = r.front_line(curve([(19, 2), (32, -6), (46, -16), (48, -26)], 4), 2)
    r.line(tapered(fold, 0.3, 0.3), 4.5, name="remove", strength=0.22, pressure=["strength"])
    for dy in (-4, 2, 8):
        foot = r.front_line(curve([(44, 22 + dy), (50, 23 + dy * 1.6)], 3), 1.5)
        r.line(foot, 2.4, name="remove", strength=0.12)
    r.line(r.front_line([(0, -54), (8, -55)], 1.5), 4, name="remove", strength=0.15)


def paint():
    def soft(points, radius, colour, strength=0.6, lift=0.0, profile="wyvill", spacing=0.25):
        r.tool(radius, profile=profile)
        r.action("paint_soft", strength, colour)
        r.stroke([add(p, (0, 0, lift)) for p in points], spacing)
    r.mirror = "x"
    # White round the eyes, up to the brows, and a red cheek.
    for x, y, size in ((22, 40, 13), (22, 33, 14), (22, 50, 10), (22, 6, 9)):
        p = r.front(x, y)
        r.press(p, (size * 1.3, size * 1.4, 16), WHITE, 2, "paint_soft", 0.7, profile="box")
    muzzle = r.front_line(curve([(0, -56), (20, -52), (36, -40), (46, -28)], 4))
    r.tool(11, profile="box")
    r.action("paint_soft", 0.5, WHITE)
    r.stroke(muzzle, 0.3)
    for line in (curve([(0, -23), (18, -20), (30, -14)], 4),):
        r.tool(7, profile="box")
        r.stroke(r.front_line(line), 0.3)
    r.press(r.front(43, -6), (17, 16, 20), "#d8452f", 2, "paint_soft", 0.4)
    # Eye shadow on the lids, a star's rays above and below.
    lid = r.front_line([(22 + 20.5 * math.cos(a), 22 + 15 * math.sin(a)) for a in
                        (math.radians(d) for d in range(22, 149, 9))])
    r.tool(6, profile="box")
    r.action("paint_soft", 0.6, "#5fa3c4")
    r.stroke(lid, 0.25)
    for line in ([(22, 47), (22, 58)], [(23, 0), (24, -9)]):
        pts = r.front_line([mix(line[0], line[1], k / 5) for k in range(6)])
        r.line([p + (1 - 0.5 * k / 5,) for k, p in enumerate(pts)], 3.4, "#1d2a52",
               name="paint_soft", strength=0.8)
    # The eyes again, since paint spilt on them is white, and the irises.
    gaze = unit((0.05, -0.03, 1))
    p = add((22, 21, 44), gaze, 17)
    r.press(p, (11, 11, 10), "#1c3f78", 2, "paint_soft", 1, profile="box")
    r.press(p, (9.4, 9.4, 10), "#3f8fd0", 2, "paint_soft", 0.9, profile="box")
    r.press(p, (5.6, 5.6, 7), "#0c0a10", 2, "paint_soft", 1, profile="box")
    r.mirror = ""
    for s in (1, -1):
        g = add(p if s == 1 else (-p[0], p[1], p[2]), (3.4, 3.6, 0))
        r.press(g, (3, 3, 4), "#ffffff", 3, "paint_soft", 1, profile="box")


plinth()
head()
sockets()
eyes()
mouth()
nose()
ears()
wrinkles()
hair()
paint()
brows()
ruff()
hat()
r.write(sys.argv[1])
