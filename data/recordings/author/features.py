"""Small recordings, one a feature: features.py FOLDER"""
import sys
from sculpt import Recording, ring, spiral, turn

CLAY, BLUE, RED = "#ac7052", "#2b62b8", "#c8201c"


def sample(name):
    def wrap(make):
        r = Recording()
        make(r)
        r.write(f"{sys.argv[1]}/{name}.jsonl")
    return wrap


def lump(r):
    r.press((0, 0, 0), 32, CLAY, 2)


@sample("add")
def _(r):
    lump(r)
    r.line([(-16, 20, 0), (0, 26, 0), (16, 20, 0)], 6, CLAY)


@sample("remove")
def _(r):
    lump(r)
    r.line([(-16, 8, 20), (16, -8, 20)], 5, name="remove", strength=0.5)


@sample("erase")
def _(r):
    lump(r)
    r.press((0, 0, 24), 14, name="erase")


@sample("paint")
def _(r):
    lump(r)
    r.press((0, 0, 20), 12, BLUE, name="paint")


@sample("paint_soft")
def _(r):
    lump(r)
    r.line([(-14, 0, 20), (14, 0, 20)], 6, RED, name="paint_soft", strength=0.4)


@sample("smooth")
def _(r):
    lump(r)
    for k in range(5):
        r.press((-12 + 6 * k, 4 * (-1) ** k, 22), 6, CLAY)
    r.tool(16)
    r.action("smooth", 0.8)
    r.stroke([(-14, 0, 22), (14, 0, 22)], 0.1)


@sample("mirror")
def _(r):
    lump(r)
    r.line([(10, 14, 10), (18, 30, 4), (12, 40, -6)], 5, CLAY, mirror="x")
    r.line([(6, 6, 22), (12, 8, 20)], 4, BLUE, mirror="xy")
    r.mirror_at = (0, 0, 8)
    r.press((20, 0, 14), 8, RED, mirror="z")


@sample("radial")
def _(r):
    lump(r)
    r.line([(0, 8, 22), (0, 20, 30)], 4, RED, radial=("y", 7))
    r.line([(26, 0, 0), (30, 6, 0)], 4, BLUE, mirror="x", radial=("z", 3))


@sample("pressure")
def _(r):
    lump(r)
    r.line([(-24, 24, 0, 0.1), (0, 30, 0, 1), (24, 24, 0, 0.1)], 9, CLAY)
    r.line([(-20, 0, 22, 0), (20, 0, 22, 1)], 5, name="remove", strength=0.6,
           pressure=["strength"])
    r.line([(-20, -10, 20, 0.2), (20, -10, 20, 1)], 5, RED, name="paint_soft", strength=0.6,
           pressure=["strength", "size"])


@sample("shapes")
def _(r):
    kinds = ["ellipsoid", "box", "cylinder", "capsule"]
    for i, shape in enumerate(kinds):
        for j, profile in enumerate(["wyvill", "box"]):
            q = turn((1, 2, 3), 40 * j + 15 * i)
            r.press((36 * i, 40 * j, 0), (14, 20, 11), CLAY, 2, shape=shape, profile=profile,
                    rotation=q)
    for i, shape in enumerate(kinds):
        r.op(op="fill", shape=shape, center=(36 * i, 80, 0), radii=(12, 16, 10),
             rotation=turn((0, 0, 1), 30.0 * i), colour=BLUE)


@sample("push")
def _(r):
    r.op(op="fill", shape="box", center=(0, 0, 0), radii=(16, 6, 10), colour=CLAY)
    r.op(op="hold", box={"min": [-20, -10, -12], "max": [-10, 10, 12]}, amount=1)
    r.op(op="support", shape="cylinder", center=(-4, -11, 0), radii=(5, 12, 5),
         rotation=turn((1, 0, 0), 90))
    r.op(op="clay", layers=["displacement", "conservation", "tension"], stiffness=0.9)
    r.op(op="tool", shape="ellipsoid", radii=(5, 5, 5))
    r.op(op="action", name="push")
    r.op(op="stroke", points=[(13, 13, 0), (13, 8, 0)],
         rotations=[(1, 0, 0, 0), (0.9, 0, 0, -0.3)])
    r.op(op="action", name="grip")
    r.op(op="stroke", points=[(14, -2, 0), (15, -5, 0)])
    r.op(op="release", supports=True, hold=True)
    r.op(op="clay", layers=["diffusion"], viscosity=3, profile="gaussian")
    r.op(op="action", name="push")
    r.op(op="stroke", points=[(0, 13, 4), (0, 9, 4)])
    r.op(op="clay", layers=["automaton"], sharing="literal", sweeps=20)
    r.op(op="stroke", points=[(-8, 13, -4), (-8, 9, -4)])
    r.op(op="action", name="swell", strength=0.5)
    r.op(op="stroke", points=[(-12, 6, 0), (-8, 6, 0)])
    r.op(op="clay", scheme="paper")
    r.op(op="relax", steps=3)


@sample("resample")
def _(r):
    lump(r)
    r.op(op="resample", spacing=0.5)
    r.line(ring(21, 4, 24), 3, RED)
    r.op(op="resample", spacing=1.5)
    r.line([(0, 16, 0), (0, 30, 0)], 6, BLUE)


@sample("undo_redo")
def _(r):
    lump(r)
    r.line(spiral((0, 16, 0), (0, 1, 0), 14, 4, 22, 2), 4, CLAY)
    r.line([(-16, 0, 20), (16, 0, 20)], 5, name="remove", strength=0.5)
    r.op(op="undo", count=2)
    r.op(op="redo", count=1)
    r.press((0, 0, 20), 12, RED, name="paint")
    r.op(op="undo", count=1)
    r.op(op="redo", count=9)
