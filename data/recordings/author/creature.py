"""A dragon's child looking out of its egg."""
import math
import random
import sys
from sculpt import *

rng = random.Random(7)
r = Recording()
SKIN, DARK, BELLY, HORN, SHELL, SPOT = ("#5f8f6a", "#33604f", "#d9c48c", "#e6d3a8", "#e9dfc9",
                                        "#a98a68")
EYE, PUPIL, FRILL, MOUTH = "#e9a51c", "#120c08", "#c4573a", "#6d2a2c"
EGG = (0, -92, -6)


def egg():
    """A bowl of clay: pressed out by hollowing, its rim broken away."""
    r.blob(EGG, (84, 76, 84), SHELL, times=3)
    r.blob(add(EGG, (0, -66, 0)), (40, 12, 40), SHELL)
    r.press(EGG, (82, 73, 82), name="remove", strength=1, times=3, profile="box")
    # Away with everything above the rim, in teeth.
    n = 13
    for k in range(n):
        a = 2 * math.pi * (k + rng.uniform(-0.2, 0.2)) / n
        top = EGG[1] + 22 + 9 * math.sin(a * 2 + 1) + rng.uniform(-5, 6)
        p = (EGG[0] + 76 * math.sin(a), top, EGG[2] + 76 * math.cos(a))
        q = after(turn((0, 1, 0), math.degrees(a)), turn((0, 0, 1), 45))
        size = rng.uniform(15, 21)
        r.press(add(p, (0, 20, 0)), (size, size, 40), name="remove", strength=1, times=3,
                rotation=q, shape="box", profile="box")
    r.press(add(EGG, (0, 86, 0)), (110, 50, 110), name="remove", strength=1, times=3,
            shape="cylinder", profile="box")


def shell_marks():
    r.mirror = ""
    rng = random.Random(11)
    for k in range(70):
        a, e = rng.uniform(0, 360), rng.uniform(-62, 18)
        d = (math.cos(math.radians(e)) * math.sin(math.radians(a)), math.sin(math.radians(e)),
             math.cos(math.radians(e)) * math.cos(math.radians(a)))
        p = add(EGG, (84 * d[0], 76 * d[1], 84 * d[2]))
        size = rng.choice([3, 4, 4, 5, 7, 9])
        q = after(between((0, 0, 1), d), turn((0, 0, 1), rng.uniform(0, 180)))
        r.press(p, (size * rng.uniform(1, 1.6), size, size), SPOT, 2, "paint_soft",
                rng.uniform(0.35, 0.8), rotation=q, profile="box")
    # Cracks running down from the rim.
    for a0 in (6, 62, 118, 170, 230, 300):
        a, e, points = a0, 24, []
        while e > rng.uniform(-34, -8):
            d = (math.cos(math.radians(e)) * math.sin(math.radians(a)), math.sin(math.radians(e)),
                 math.cos(math.radians(e)) * math.cos(math.radians(a)))
            points.append(add(EGG, (85 * d[0], 77 * d[1], 85 * d[2])))
            e -= rng.uniform(5, 9)
            a += rng.uniform(-9, 9)
        points = [mix(p, q, k / 3) for p, q in zip(points, points[1:]) for k in range(3)]
        r.line(tapered(points, 1, 0.3, 0.8), 2.1, name="remove", strength=0.3,
               pressure=["strength"])
        r.line(points, 2.2, "#6b5542", name="paint_soft", strength=0.3)


def body():
    r.blob((0, -96, -14), (52, 50, 50), SKIN)
    r.line([(0, -70, -16), (0, -20, -12), (0, 10, -6)], 30, SKIN)
    r.line([(0, -70, 4), (0, -30, 8), (0, 0, 8)], 20, SKIN)


def head():
    r.mirror = "x"
    r.blob((0, 44, -10), (52, 46, 52), SKIN)
    # Snout and jaw.
    r.line([(0, 30, 22), (0, 24, 52), (0, 22, 62)], 25, SKIN)
    r.blob((13, 26, 66), (17, 15, 17), SKIN)
    r.line([(0, 8, 10), (6, 4, 44), (0, 3, 58)], 17, SKIN)
    r.blob((33, 20, 6), (18, 18, 26), SKIN)
    # Brow ridges and the bridge of the snout.
    r.line(curve(tapered([(10, 56, 38), (24, 66, 36), (40, 66, 22), (50, 58, 2)], 0.6, 0.5), 5), 11,
           SKIN, strength=0.5)
    r.line(tapered([(0, 62, 30), (0, 46, 50), (0, 40, 66)], 1, 0.7), 10, SKIN, strength=0.4)
    for points in ([(0, 80, 20), (10, 50, 46), (14, 36, 60)], [(30, 26, 40), (44, 20, 24),
                                                             (50, 40, -10)],
                   [(0, -6, 40), (22, 0, 30), (36, 4, 6)]):
        r.tool(24)
        r.action("smooth", 0.9)
        r.stroke(curve(points, 4), 0.06)


def face():
    r.mirror = "x"
    # Sockets and eyes, set a little outward.
    r.press((32, 46, 38), (22, 20, 20), name="remove", strength=0.7)
    eye, radius = (28, 45, 25), 18
    r.blob(eye, radius, EYE)
    look = unit((0.5, 0.02, 1))
    q = between((0, 0, 1), look)
    for low, high, size, lift, out in ((8, 172, 5.6, 3, 1.0), (190, 350, 4.6, -2, 1.0)):
        lid = []
        for d in range(low, high + 1, 12):
            a = math.radians(d)
            x, y = 17.5 * math.cos(a), 13.0 * math.sin(a) + lift
            z = math.sqrt(max((radius + 1) ** 2 - x * x - y * y, 0)) * out
            lid.append(add(eye, rotate(q, (x, y, z))))
        r.line(curve(tapered(lid, 0.7, 0.7), 2), size, SKIN)
    # Iris: dark rim, a lighter ring below, slit pupil, light.
    p = add(eye, look, radius)
    def touch(x, y, radii, colour, times=4, strength=1.0):
        r.press(add(p, rotate(q, (x, y, 0))), radii, colour, times, "paint_soft", strength,
                rotation=q, profile="box")
    touch(0, 0, (13.5, 13.5, 12), "#a8480f", 3, 0.6)
    touch(0, -1, (11, 11, 12), EYE, 4)
    touch(0, -4, (8, 5.5, 12), "#ffd95e", 2, 0.5)
    touch(0, 0, (4.3, 12.5, 12), PUPIL, 3)
    r.mirror = ""
    for s in (1, -1):
        near = add((p[0] * s, p[1], p[2]), (4.6, 5.6, 0))
        heart = (eye[0] * s, eye[1], eye[2])
        light = add(heart, unit(sub(near, heart)), radius)
        r.press(light, (3.9, 3.9, 5), "#ffffff", 2, "paint_soft", 1, profile="box")
    r.mirror = "x"
    # Nostrils.
    r.press((16, 32, 81), (6.5, 5, 7), name="remove", strength=1)
    r.line(curve([(10, 35, 80), (15, 40, 78), (22, 36, 76), (22, 29, 77)], 4), 3.6, SKIN)
    # The mouth's line, turning up at the corner, and a lip over it.
    mouth = []
    for x, y in curve([(0, 12), (12, 10.5), (22, 12), (30, 12)], 4):
        p2 = r.front(x, y)
        mouth.append(add(p2, (0, 0, 1)))
    for z, y in ((50, 12.5), (44, 13), (38, 14.5), (34, 17)):
        mouth.append(add(r.cast((60, y, z + 14), (-1, 0, -0.5)), (0.5, 0, 0.5)))
    r.line(mouth, 4.2, MOUTH, name="remove", strength=0.5)
    r.line(mouth, 3.4, MOUTH, name="paint_soft", strength=0.6)
    lip = [add(add(m, (0, 5.5, 0)), unit((m[0], 0, m[2] - 10)), 1) for m in mouth]
    r.line(tapered(lip, 1, 0.5), 4.2, SKIN, strength=0.4)
    # The egg tooth and two fangs.
    for x, y, size in ((12, 9, 1.0), (20, 10.5, 0.7)):
        p2 = r.front(x, y - 1)
        r.line([p2 + (1.0,), add(p2, (0.5, -6, 1)) + (0.75,),
                add(p2, (0.5, -11 * size, 0)) + (0.4,)], 3.8 * size, HORN, spacing=0.1)


def creases():
    """Wrinkles on the muzzle and round the eyes; lighter freckles."""
    r.mirror = "x"
    for line in ([(9, 49), (17, 45), (24, 38)], [(8, 44), (16, 40), (23, 33)],
                 [(30, 26), (38, 25), (45, 29)], [(29, 22), (38, 20), (46, 24)]):
        points = r.front_line(curve(line, 5), 1)
        r.line(tapered(points, 0.2, 0.2), 2.6, name="remove", strength=0.2, pressure=["strength"])
    for _ in range(16):
        p = r.front(rng.uniform(26, 48), rng.uniform(6, 24))
        if p:
            r.press(p, rng.uniform(2.4, 3.6), "#a9c47c", 1, "paint_soft", 0.8)


def horns():
    r.mirror = "x"
    path = curve([(24, 82, -18), (32, 102, -30), (42, 116, -50), (46, 120, -72), (42, 114, -88)], 8)
    n = len(path)
    r.line([p + (1 - 0.85 * (i / (n - 1)) ** 1.3,) for i, p in enumerate(path)], 12, HORN,
           spacing=0.05)
    for i in range(3, n - 6, 3):
        d = unit(sub(path[i + 1], path[i - 1]))
        size = 12 * (1 - 0.85 * (i / (n - 1)) ** 1.3)
        q = between((0, 1, 0), d)
        loop = [add(path[i], rotate(q, p)) for p in ring(size * 1.04, 0, 14)]
        r.line(loop, 1 + 0.13 * size, name="remove", strength=0.015 + 0.011 * size)
        r.line(loop, 1.8, "#b08d58", name="paint_soft", strength=0.12)
    r.line([path[0], path[0]], 15, SKIN)
    base = [add(path[1], rotate(between((0, 1, 0), sub(path[3], path[0])), p))
            for p in ring(11, 0, 18)]
    r.line(base, 4.5, SKIN)
    # Little horns on the cheek and brow.
    for at, to, size in (((47, 20, 2), (71, 13, -12), 6), ((42, 6, 0), (60, -5, -10), 5),
                         ((50, 62, -2), (62, 72, -14), 5)):
        r.line([mix(at, to, k / 5) + (1 - 0.16 * k,) for k in range(6)], size, HORN, spacing=0.08)


def ears():
    """Fins: three spines with skin between."""
    r.mirror = "x"
    root = (50, 40, -24)
    tips = [(88, 76, -46), (100, 52, -54), (92, 26, -52)]
    for i in range(25):
        t = i / 12
        k = min(int(t), 1)
        tip = mix(tips[k], tips[k + 1], t - k)
        sag = 0.86 + 0.12 * abs(math.cos(math.pi * t))
        tip = mix(root, tip, sag)
        r.line([root, mix(root, tip, 0.5), tip], 3.0, FRILL, strength=0.5)
    for tip in tips:
        path = curve([root, add(mix(root, tip, 0.5), (0, 3, 3)), tip, mix(root, tip, 1.1)], 4)
        r.line(tapered(path, 1, 0.35, 0.8), 5, SKIN, spacing=0.08)


def crest():
    r.mirror = ""
    for k in range(9):
        t = k / 8
        a = math.radians(62 + 118 * t)
        d = (0, math.sin(a), math.cos(a))
        p = r.toward((0, 36, -10), d, 140) if k < 7 else r.cast((0, 26 - 26 * (k - 6), -140),
                                                                  (0, 0, 1))
        back = unit(add(d, (0, 0.35, -0.75)))
        size = 8.5 * (0.55 + 0.45 * math.sin(math.pi * min(1, 0.25 + 0.7 * t)))
        r.line([add(p, back, size * 0.55 * j - 3) + (1 - 0.15 * j,) for j in range(6)], size, FRILL,
               spacing=0.08)


def scales():
    """Pebbles over the head, larger towards the brow; plates down the throat."""
    r.mirror = "x"
    placed = []
    tries = 0
    while len(placed) < 150 and tries < 2500:
        tries += 1
        a, e = rng.uniform(0, 175), rng.uniform(-20, 80)
        d = (math.cos(math.radians(e)) * math.sin(math.radians(a)), math.sin(math.radians(e)),
             math.cos(math.radians(e)) * math.cos(math.radians(a)))
        p = r.toward((0, 40, -8), d, 140)
        if not p or p[0] < 2.5:
            continue
        size = rng.uniform(3.4, 6.5)
        if length(sub(p, (28, 45, 28))) < 27 or length(sub(p, (0, 40, -8))) > 62:
            continue
        if a < 40 and e < 25:
            continue
        if any(length(sub(p, o)) < 0.95 * (size + s) for o, s in placed):
            continue
        placed.append((p, size))
    for p, size in placed:
        n = r.normal(p, 4)
        r.press(add(p, n, -0.5), (size, size, size * 0.8), rng.choice([SKIN, DARK, "#6f9f72"]),
                name="add", strength=0.42, rotation=between((0, 0, 1), n))
    # Snout: small ones in rows.
    for row in range(5):
        for k in range(3 + row % 2):
            p = r.front(3.5 + 6 * k + 3 * (row % 2), 44 + 5 * row - 2 * k)
            if p:
                r.press(p, 4.2, "#4f8260", name="add", strength=0.3)


def throat():
    r.mirror = ""
    for k in range(6):
        y = 0 - 9.5 * k
        points = []
        for x in (-17, -12, -6, 0, 6, 12, 17):
            p = r.front(x, y + 0.012 * x * x)
            points.append(add(p, (0, 0, -1.5)))
        r.line(tapered(points, 0.5, 0.5), 5.6, BELLY, squash=(1, 0.8, 1), spacing=0.12)


def claws():
    r.mirror = ""
    for side, turned, down in ((1, 36, 0), (-1, -30, 2)):
        base = math.radians(turned)
        rim = EGG[1] + 34 - down
        wrist = (62 * math.sin(base), rim + 2, EGG[2] + 62 * math.cos(base))
        r.line([(22 * side, -60, 20), add(wrist, (0, -4, -8)), wrist], 10, SKIN)
        r.blob(add(wrist, (0, 4, 2)), (14, 9, 12), SKIN)
        for f in (-1, 0, 1):
            a = base + f * 0.17
            out = (math.sin(a), 0, math.cos(a))
            def on(rad, dy):
                return (rad * out[0], rim + dy, EGG[2] + rad * out[2])
            finger = curve([on(62, 4), on(78, 9), on(89, 2), on(91, -8)], 5)
            r.line(tapered(finger, 1, 0.85), 5.6, SKIN)
            r.line([on(80, 9), on(82, 9.2)], 6.4, SKIN)
            tip = curve([on(90.5, -7), on(92.5, -15), on(90, -22)], 4)
            r.line([p + (1 - 0.7 * i / (len(tip) - 1),) for i, p in enumerate(tip)], 4.2, HORN,
                   spacing=0.08)


def tint():
    """Washes of dark over the crown, light under the jaw, warm cheeks."""
    r.mirror = "x"
    for x, y, size, colour, s in ((0, 82, 30, DARK, 0.2), (22, 84, 22, DARK, 0.16),
                                  (38, 70, 14, DARK, 0.2), (42, 14, 16, "#b8c77a", 0.12),
                                  (20, -2, 14, "#c9cf8c", 0.2)):
        p = r.front(x, y)
        if p:
            r.press(p, size, colour, 2, "paint_soft", s)


def tail():
    """Over the rim behind, round to the side."""
    r.mirror = ""
    path = curve([(24, -100, -40), (52, -50, -46), (78, -34, -36), (98, -52, -14), (104, -86, 8),
                  (98, -112, 30), (92, -116, 52), (90, -100, 68)], 8)
    n = len(path)
    def size(i):
        return 14 * (1 - 0.78 * i / (n - 1))
    r.line([p + (size(i) / 14,) for i, p in enumerate(path)], 14, SKIN, spacing=0.07)
    out = lambda i: unit((path[i][0], 0.6 * (path[i][1] + 140), path[i][2]))
    for i in range(12, n - 6, 4):
        p = add(path[i], out(i), size(i) * 0.8)
        d = unit(add(out(i), unit(sub(path[i + 1], path[i]))))
        r.line([add(p, d, size(i) * 0.28 * j) + (1 - 0.17 * j,) for j in range(5)], size(i) * 0.55,
               FRILL, spacing=0.1)
    tip = path[-1]
    for k in range(9):
        a = math.radians(-64 + 16 * k)
        reach = 33 - 15 * abs(math.sin(a)) - (2.5 if k % 2 else 0)
        end = add(tip, (reach * math.sin(a) - 3, reach * math.cos(a), 4))
        r.line(tapered([add(tip, (0, -6, -2)), mix(tip, end, 0.55), end], 0.9, 0.55), 4.4, FRILL,
               spacing=0.1)
    r.line(tapered([add(tip, (0, -8, 2)), add(tip, (-1, 10, 5)), add(tip, (-3, 27, 6))], 1, 0.4), 4,
           SKIN, spacing=0.1)


def nest():
    """Straw and twigs, each a stroke."""
    r.mirror = ""
    colours = ["#c9a25a", "#a87f40", "#d9b978", "#8a6436", "#b8924e"]
    for k in range(110):
        t = k / 109
        ring_radius = rng.uniform(62, 88) + 10 * t
        y = -170 + 26 * t + rng.uniform(-4, 4)
        start, span = rng.uniform(0, 360), rng.uniform(45, 95)
        lean, flare = rng.uniform(-7, 7), rng.uniform(-6, 9)
        points = []
        for j in range(8):
            a = math.radians(start + span * j / 7)
            u = j / 7 - 0.5
            rad = ring_radius + flare * u * 2 + 10 * max(0, abs(u) - 0.3) * (1 if k % 3 else -1)
            points.append((rad * math.sin(a), y + lean * u * 2, rad * math.cos(a) - 6))
        r.line(tapered(points, 0.6, 0.5), rng.uniform(2.6, 4.4), colours[k % 5], spacing=0.2,
               strength=0.6)


def neck_marks():
    """Folds at the sides of the neck, dark stripes down its back."""
    r.mirror = "x"
    for k in range(5):
        y = -4 - 13 * k
        points = []
        for deg in range(58, 131, 12):
            a = math.radians(deg)
            p = r.cast((90 * math.sin(a), y - 4 + 6 * math.sin(math.radians((deg - 58) * 2.4)),
                        -14 + 90 * math.cos(a)), (-math.sin(a), 0, -math.cos(a)))
            if p and p[0] < 50:
                points.append(p)
        if len(points) > 2:
            r.line(tapered(points, 0.2, 0.2), 4, name="remove", strength=0.28,
                   pressure=["strength"])
    for k in range(7):
        y = 4 - 11 * k
        points = [r.cast((90 * math.sin(a), y, -14 + 90 * math.cos(a)),
                         (-math.sin(a), 0, -math.cos(a)))
                  for a in (math.radians(d) for d in (180, 160, 140, 120))]
        if all(points):
            r.line(tapered(points, 1, 0.4), 4.6, DARK, name="paint_soft", strength=0.4)


egg()
body()
head()
throat()
horns()
ears()
tint()
scales()
crest()
face()
creases()
neck_marks()
shell_marks()
claws()
tail()
nest()
r.write(sys.argv[1])
