"""Writes the recordings of deformable solids: what McDonnell and Qin's figures show, and a clay
figure that is posed. Python 3, nothing else: python3 solids.py ../solids"""
import itertools
import json
import math
import os
import sys


class Session:
    """A recording of a solid, with cells of `edge` world units."""

    def __init__(self, edge, spacing=1.0):
        self.edge = edge
        self.lines = [{"bozzetto": "recording", "version": 1},
                      {"op": "scene", "spacing": spacing}]

    def add(self, op, **keys):
        self.lines.append({"op": op, **keys})

    def block(self, cells, removed=()):
        self.cells = cells
        self.add("solid", cells=list(cells), edge=self.edge, center=[0, 0, 0],
                 removed=[list(r) for r in removed])

    def cell(self, i, j, k):
        """Middle of a cell of the block; halves are its faces."""
        return [round((n + 0.5 - c / 2) * self.edge, 6)
                for n, c in zip((i, j, k), self.cells)]

    def grow(self, *at, times=1, axis=1, sign=1, length=0):
        """Extrudes the face at this place, again and again along an axis."""
        at = list(at)
        for _ in range(times):
            self.add("solid_extrude", at=list(at), length=length)
            at[axis] += sign * (length or self.edge)

    def dent(self):
        """Presses corners and edges of the block inwards, point by point, towards a ball."""
        half = [c / 2 for c in self.cells]
        for point in itertools.product(*(range(c + 1) for c in self.cells)):
            at = [n - h for n, h in zip(point, half)]
            far = math.dist(at, (0, 0, 0)) / max(half)
            if far > 1.15:
                by = [round(x * self.edge * 0.75 * (1.15 / far - 1), 6) for x in at]
                self.add("solid_move", point=list(point), by=by)

    def write(self, folder, name):
        with open(os.path.join(folder, name + ".jsonl"), "w") as out:
            for line in self.lines:
                out.write(json.dumps(line, separators=(",", ":")) + "\n")


def head():
    """The cartoon head of §7.1: 5 x 5 x 5 cells, carved, extruded, subdivided, roped, inflated."""
    s = Session(12)
    s.block((5, 5, 5))
    s.dent()
    under = [(i, 0, k) for i in range(5) for k in range(5) if i in (0, 4) or k in (0, 1)]
    back = [(i, 4, 0) for i in range(5)]
    for i, j, k in under + back:
        s.add("solid_carve", at=s.cell(i, j, k))
    for i in (1, 3):  # eye sockets, and an eye in each
        s.add("solid_carve", at=s.cell(i, 3, 4))
        s.add("solid_extrude", at=s.cell(i, 3, 3.5), length=9)
    s.add("solid_extrude", at=s.cell(2, 2, 4.5), length=12)  # the nose
    s.add("solid_extrude", at=s.cell(2, 2, 5.5), length=8)
    for i in (1.5, 2.5):  # the moustache grows from it, and droops
        s.add("solid_extrude", at=s.cell(i, 2, 5), length=12)
    s.add("solid_carve", at=s.cell(2, 1, 4))  # the mouth
    s.add("solid_subdivide", at=s.cell(2, 0, 4))  # the lower jaw
    for side in (-1, 1):  # ears
        s.add("solid_extrude", at=s.cell(2 + 2.5 * side, 2, 2), length=7)
        s.add("solid_extrude", at=[side * 37, 0, 0], length=6)
    s.add("solid_settings", solver="standard", time_step=0.5, damping=1, rope_strength=20)
    s.add("solid_window", min=[-60, -30, 5], max=[60, 10, 90])
    s.add("solid_pull", steps=25, ropes=[
        {"at": [-18, 0, 36], "to": [-20, -9, 33]}, {"at": [18, 0, 36], "to": [20, -9, 33]}])
    s.add("solid_pull", steps=20, ropes=[{"at": [0, 0, 50], "to": [0, 4, 56]}])
    s.add("solid_pull", steps=20, ropes=[{"at": [0, -27, 30], "to": [0, -30, 37]}])
    s.add("solid_window")
    s.add("solid_rest")
    s.add("solid_inflate", at=[0, 28, 0], radius=40, amount=0.3, steps=40)
    s.add("solid_inflate", at=[0, -8, -24], radius=22, amount=-0.15, steps=30)
    s.add("bake", levels=3, colour="#d9a06c")
    return s


def chair(holes):
    """A block of 7 x 8 x 6 cells with the rest taken away, its top rail bent as a B-spline."""
    s = Session(8)
    feet, seat, size = (0, 1, 2), 3, (7, 8, 6)
    gaps = [(i, j) for i in (1, 3, 5) for j in (4, 5, 6)] if holes else []

    def stays(i, j, k):
        if j in feet:
            return i in (0, 6) and k in (0, 5)
        return j == seat or (k == 0 and (i, j) not in gaps)

    s.block(size, [(i, j, k) for i in range(7) for j in range(8) for k in range(6)
                   if not stays(i, j, k)])
    s.add("solid_settings", damping=1, rope_strength=10, time_step=0.5)
    s.add("solid_window", min=[-40, 2, -40], max=[40, 60, 0])
    s.add("solid_spline", points=[s.cell(i, 7.5, 0) for i in (0, 1.5, 3, 4.5, 6)],
          drag=[{"control": n, "by": [0, up, -9]} for n, up in enumerate((-3, 3, 9, 3, -3))],
          steps=40)
    s.add("solid_window")
    s.add("bake", levels=3, colour="#8a5a34")
    return s


def mug():
    """A hollow block, made round point by point; the handle is extruded and joined."""
    s = Session(8)
    inside = [(i, j, k) for i in range(1, 4) for k in range(1, 4) for j in range(1, 5)]
    s.block((5, 5, 5), inside)
    for j in (1, 4):
        s.grow(*s.cell(4.5, j, 2), times=2, axis=0)
    s.add("solid_join", at=s.cell(6, 3.5, 2), to=s.cell(6, 1.5, 2))
    for j in range(6):
        for i in range(6):
            for k in range(6):
                x, z = (i - 2.5) * 8, (k - 2.5) * 8
                square, round_ = max(abs(x), abs(z)), math.hypot(x, z)
                if square < 8:
                    continue
                belly = 1 + 0.05 * math.sin(math.pi * j / 5)
                want = square * (1.12 if square > 16 else 1.3) * belly / round_
                s.add("solid_move", point=[i, j, k],
                      by=[round(x * (want - 1), 6), 0, round(z * (want - 1), 6)])
    s.add("solid_sharp", what="face", at=s.cell(2, -0.5, 2))
    s.add("bake", levels=3, colour="#4a7fb0")
    return s


def soccer():
    """24 control cells, refined twice (table 1)."""
    s = Session(10)
    s.block((3, 2, 1))  # the trunk: 6
    s.grow(*s.cell(1, 1.5, 0), axis=1, length=5)  # neck and head: 2
    s.grow(*s.cell(1, 2, 0), axis=1, length=14)
    for side, i in ((-1, -0.5), (1, 2.5)):  # arms: 3 each
        s.grow(*s.cell(i, 1, 0), times=3, axis=0, sign=side)
    for i in (0, 2):  # legs: 4 each, and feet: 1 each
        s.grow(*s.cell(i, -0.5, 0), times=4, axis=1, sign=-1)
        s.add("solid_extrude", at=s.cell(i, -4, 0.5), length=9)
    s.add("solid_settings", levels=2, damping=1, rope_strength=20, time_step=0.5, creep=0.3)
    s.add("solid_inflate", at=s.cell(1, 2.9, 0), radius=13, amount=0.9, steps=40)
    s.add("solid_pull", steps=60, ropes=[
        {"at": s.cell(2, -2, 0), "to": [11, -29, 13]},  # the knee
        {"at": s.cell(2, -4, 0.9), "to": [12, -43, 21]},  # the foot at the ball
        {"at": s.cell(0, -4, 0), "to": [-11, -47, -4]},
        {"at": s.cell(-3, 1, 0), "to": [-36, 18, 12]},
        {"at": s.cell(5, 1, 0), "to": [38, 14, -14]},
        {"at": s.cell(1, 3.4, 0), "to": [0, 28, 2]}])
    s.add("bake", levels=3, colour="#c0392b")
    s.add("fill", shape="ellipsoid", center=[13, -45, 36], radii=[9, 9, 9], colour="#f0f0f0")
    return s


def ring():
    """A bar, bent round and twisted, its ends joined: a Möbius ring of 180 degrees."""
    s = Session(10)
    n = 14
    s.block((n, 1, 1))
    radius, turn = 38.0, math.pi
    for i in range(n + 1):
        a = 2 * math.pi * i / (n + 1)
        t = turn * i / (n + 1)
        for j in (0, 1):
            for k in (0, 1):
                u, v = (j - 0.5) * 14, (k - 0.5) * 9
                r = radius + u * math.cos(t) - v * math.sin(t)
                h = u * math.sin(t) + v * math.cos(t)
                want = (r * math.cos(a), h, -r * math.sin(a))
                at = ((i - n / 2) * s.edge, (j - 0.5) * s.edge, (k - 0.5) * s.edge)
                s.add("solid_move", point=[i, j, k],
                      by=[round(w - p, 6) for w, p in zip(want, at)])

    def end(i):
        a = 2 * math.pi * i / (n + 1)
        return [round(radius * math.cos(a), 6), 0, round(-radius * math.sin(a), 6)]

    s.add("solid_join", at=end(0), to=end(n))
    s.add("bake", levels=3, colour="#b08d2e")
    return s


def posed():
    """A clay figure, its trunk twisted and an arm raised through a wrap; mass stays."""
    s = Session(1)
    skin, cloth = "#d8a27a", "#3f6f8f"
    s.add("fill", shape="ellipsoid", center=[0, 0, 0], radii=[12, 20, 8], colour=cloth)
    s.add("fill", shape="ellipsoid", center=[0, 29, 0], radii=[8, 10, 8], colour=skin)
    for x in (-1, 1):
        s.add("fill", shape="capsule", center=[x * 24, 12, 0], radii=[4.5, 16, 4.5],
              rotation=[0.70710678, 0, 0, 0.70710678], colour=skin)
        s.add("fill", shape="capsule", center=[x * 7, -32, 0], radii=[5.5, 20, 5.5], colour=cloth)
        s.add("fill", shape="ellipsoid", center=[x * 7, -51, 4], radii=[5, 3.5, 9], colour=skin)
    cells = (8, 9, 2)
    s.add("wrap", cells=list(cells), min=[-42, -56, -10], max=[42, 41, 14])
    low, high = (-42, -56, -10), (42, 41, 14)
    edge = [(h - l) / c for l, h, c in zip(low, high, cells)]
    for i in range(cells[0] + 3):
        for j in range(cells[1] + 3):
            for k in range(cells[2] + 3):
                p = [l + (n - 1) * e for l, n, e in zip(low, (i, j, k), edge)]
                x, y, z = p
                if x > 11:  # the arm rises round the shoulder
                    a = 1.05 * min(1.0, (x - 11) / 14) * max(0.0, min(1.0, (y + 20) / 26))
                    dx, dy = x - 11, y - 12
                    x = 11 + dx * math.cos(a) - dy * math.sin(a)
                    y = 12 + dx * math.sin(a) + dy * math.cos(a)
                t = 0.012 * max(0.0, p[1] + 10)  # the trunk turns
                x, z = x * math.cos(t) + z * math.sin(t), -x * math.sin(t) + z * math.cos(t)
                by = [round(a - b, 6) for a, b in zip((x, y, z), p)]
                if any(by):
                    s.add("solid_move", point=[i, j, k], by=by)
    s.add("wrap_apply", keep_mass=True)
    s.add("solid_drop")
    return s


def main():
    folder = sys.argv[1]
    os.makedirs(folder, exist_ok=True)
    for name, made in (("head", head()), ("chair", chair(False)), ("chair_with_holes", chair(True)),
                       ("mug", mug()), ("soccer_player", soccer()), ("twisted_ring", ring()),
                       ("posed_figure", posed())):
        made.write(folder, name)


main()
