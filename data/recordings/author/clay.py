"""The experiments of the clay papers, and a figure posed by pushes. Writes FOLDER/*.jsonl."""
import json
import math
import sys

CLAY = "#b06a4a"
DOWN = [math.sqrt(0.5), -math.sqrt(0.5), 0, 0]
ALONG_Z = [math.sqrt(0.5), math.sqrt(0.5), 0, 0]


def quarter(axis, degrees):
    s, c = math.sin(math.radians(degrees) / 2), math.cos(math.radians(degrees) / 2)
    return [c, s * axis[0], s * axis[1], s * axis[2]]


def turned(p, hinge, degrees):
    """p turned about z through hinge."""
    a = math.radians(degrees)
    x, y = p[0] - hinge[0], p[1] - hinge[1]
    return [hinge[0] + math.cos(a) * x - math.sin(a) * y,
            hinge[1] + math.sin(a) * x + math.cos(a) * y, p[2]]


class Session:
    def __init__(self):
        self.lines = [{"bozzetto": "recording", "version": 1}]

    def add(self, op, **keys):
        self.lines.append({"op": op, **keys})

    def solid(self, shape, center, radii, colour=CLAY, **keys):
        self.add("fill", shape=shape, center=center, radii=radii, colour=colour, **keys)

    def hold(self, low, high):
        self.add("hold", box={"min": low, "max": high})

    def clay(self, **keys):
        self.add("clay", **keys)

    def move(self, name, shape, radii, points, rotations=None, rotation=None, **keys):
        tool = {"shape": shape, "radii": radii}
        if rotation:
            tool["rotation"] = rotation
        self.add("tool", **tool)
        self.add("action", name=name)
        if rotations:
            keys["rotations"] = rotations
        self.add("stroke", points=points, **keys)

    def write(self, path):
        def rounded(value):
            if isinstance(value, float):
                return round(value, 5)
            if isinstance(value, list):
                return [rounded(v) for v in value]
            if isinstance(value, dict):
                return {k: rounded(v) for k, v in value.items()}
            return value
        with open(path, "w") as f:
            for line in self.lines:
                f.write(json.dumps(rounded(line)) + "\n")


def bend():
    s = Session()
    s.solid("box", [0, 0, 0], [40, 6, 6])
    s.hold([-60, -20, -20], [-22, 20, 20])
    s.add("support", shape="cylinder", center=[-6, -14, 0], radii=[8, 14, 8], rotation=ALONG_Z)
    s.clay(stiffness=1)
    hinge, start = (-6, -14), [32, 0, 0]
    steps = [(-90 * n / 60) for n in range(61)]
    s.move("grip", "box", [7, 9, 9], [turned(start, hinge, a) for a in steps],
           [quarter((0, 0, 1), a) for a in steps])
    return s


def bend_push():
    s = Session()
    s.solid("box", [0, 0, 0], [40, 6, 6])
    s.hold([-60, -20, -20], [-22, 20, 20])
    s.add("support", shape="cylinder", center=[-6, -14, 0], radii=[8, 14, 8], rotation=ALONG_Z)
    s.clay(stiffness=1)
    hinge, start = (-6, -14), [34, 14.5, 0]
    steps = [(-80 * n / 60) for n in range(61)]
    s.move("push", "cylinder", [8, 14, 8], [turned(start, hinge, a) for a in steps],
           [quarter((0, 0, 1), a) for a in steps], rotation=ALONG_Z)
    return s


def twist():
    s = Session()
    s.solid("box", [0, 0, 0], [10, 42, 10])
    s.solid("box", [0, -50, 0], [22, 10, 22], "#7a6a5a")
    s.solid("box", [10.5, 0, 0], [1.5, 42, 4], "#d8c8a8")
    s.solid("box", [-10.5, 0, 0], [1.5, 42, 4], "#d8c8a8")
    s.hold([-40, -80, -40], [40, -38, 40])
    s.clay(stiffness=1)
    steps = [180 * n / 90 for n in range(91)]
    s.move("grip", "box", [15, 6, 15], [[0, 38, 0]] * 91, [quarter((0, 1, 0), a) for a in steps])
    return s


def hole_thin():
    s = Session()
    s.solid("box", [0, 0, 0], [32, 3, 32])
    for x in (-32, 20):
        for z in (-32, 20):
            s.hold([x, -9, z], [x + 12, 9, z + 12])
    s.clay(stiffness=0.35)
    s.move("push", "ellipsoid", [8, 8, 8], [[0, 14, 0], [0, -18, 0]])
    return s


def hole_thick():
    s = Session()
    s.solid("box", [0, 0, 0], [34, 13, 34])
    for x in (-34, 22):
        for z in (-34, 22):
            s.hold([x, -20, z], [x + 12, 20, z + 12])
    s.clay(stiffness=0.1)
    s.move("push", "capsule", [7, 20, 7], [[0, 36, 0], [0, -1, 0]])
    return s


def folds():
    s = Session()
    s.solid("ellipsoid", [0, 0, 0], [32, 32, 32])
    s.hold([-8, -8, -8], [8, 8, 8])
    s.clay(stiffness=0.45)
    for turn in (0, 72, 144, 216, 288):
        a = math.radians(turn)
        x, z = math.sin(a), math.cos(a)
        s.move("push", "capsule", [6, 26, 6], [[x * 42, 0, z * 42], [x * 24, 0, z * 24]])
    return s


def neck():
    """A dumbbell pulled until it necks and parts."""
    s = Session()
    s.solid("capsule", [0, 0, 0], [3, 24, 3], rotation=quarter((0, 0, 1), 90))
    for x in (-22, 22):
        s.solid("ellipsoid", [x, 0, 0], [13, 13, 13])
    s.hold([-60, -20, -20], [-11, 20, 20])
    s.clay(stiffness=1, parting=4)
    s.move("grip", "ellipsoid", [20, 20, 20], [[22, 0, 0], [130, 0, 0]])
    return s


def plough():
    s = Session()
    s.solid("box", [0, 0, 0], [64, 14, 32])
    s.hold([-70, -20, -40], [70, -9, 40])
    s.clay(stiffness=0)
    s.move("push", "ellipsoid", [9, 9, 9], [[-50, 26, 0], [-50, 18, 0], [46, 18, 0], [46, 26, 0]])
    return s


def raffin(profile=None):
    s = Session()
    s.solid("box", [0, 0, 0], [25, 25, 25])
    keys = {"viscosity": 7, "profile": profile} if profile else {}
    s.clay(layers=["diffusion"], walk=10, **keys)
    s.move("push", "box", [10, 10, 10], [[0, 36, 0], [0, 27, 0]])
    return s


def raffin_ball():
    s = Session()
    s.solid("box", [0, 0, 0], [25, 25, 25])
    s.clay(layers=["diffusion"], walk=10)
    s.move("push", "ellipsoid", [12, 12, 12], [[0, 38, 0], [0, 25, 0]])
    return s


def raffin_star(viscosity=0):
    """Figure 7: a cube pushed into by a star-shaped tip, without viscosity and with."""
    s = Session()
    s.solid("box", [0, 0, 0], [25, 25, 25])
    s.clay(layers=["diffusion"], walk=10, viscosity=viscosity, profile="linear")
    s.add("tool", shape="freeform", scale=[2.4, 2.4, 2.4], rotation=DOWN,
          **{"from": "shelf:star tip", "pivot": [0, 0, 0]})
    s.add("action", name="push")
    s.add("stroke", points=[[0, 27, 0], [0, 12, 0]])
    return s


def prints():
    """Sculpted tools pressed into fluid clay: letters and a leaf."""
    s = Session()
    s.solid("box", [0, 0, 0], [62, 10, 30])
    s.hold([-70, -20, -40], [70, -7, 40])
    s.clay(stiffness=0)
    for name, x, size in (("letter B", -40, 1.8), ("leaf", -4, 1.2), ("star tip", 38, 2.2)):
        s.add("tool", shape="freeform", scale=[size] * 3, rotation=DOWN,
              **{"from": "shelf:" + name, "pivot": [0, 0, 0]})
        s.add("action", name="push")
        s.add("stroke", points=[[x, 16, 0], [x, 6, 0]])
    return s


def column():
    s = Session()
    s.solid("cylinder", [0, 32, 0], [16, 32, 16])
    s.hold([-20, -4, -20], [20, 1, 20])
    s.clay(layers=["automaton"])
    s.move("push", "box", [60, 5, 60], [[0, 69.5, 0], [0, 40, 0]])
    return s


def cube():
    s = Session()
    s.solid("box", [0, 32, 0], [32, 32, 32])
    s.add("support", shape="box", center=[0, -8, 0], radii=[80, 8, 80])
    s.clay(layers=["automaton"])
    s.move("push", "box", [12, 10, 12], [[0, 75, 0], [0, 48, 0]])
    return s


def board():
    s = Session()
    s.solid("box", [0, 9, 0], [40, 9, 40])
    s.add("support", shape="box", center=[0, -8, 0], radii=[80, 8, 80])
    s.clay(layers=["automaton"])
    s.move("push", "box", [2.5, 20, 60], [[0, 39, 0], [0, 22, 0]])
    return s


def chair():
    s = Session()
    s.solid("box", [0, 32, 0], [28, 32, 28])
    s.add("support", shape="box", center=[0, -8, 0], radii=[80, 8, 80])
    s.clay(layers=["automaton"])
    s.move("push", "box", [40, 20, 26], [[0, 88, 14], [0, 58, 14]])
    s.add("support", shape="box", center=[0, 58, 14], radii=[40, 20, 26])
    s.move("push", "box", [12, 12, 60], [[0, -14, 0], [0, 6, 0]])
    s.move("push", "box", [60, 12, 12], [[0, -14, 0], [0, 6, 0]])
    return s


def cup():
    s = Session()
    s.solid("cylinder", [0, 26, 0], [24, 26, 24], "#9aa88a")
    s.add("support", shape="box", center=[0, -8, 0], radii=[80, 8, 80])
    s.clay(layers=["automaton"])
    s.move("push", "cylinder", [17, 24, 17], [[0, 80, 0], [0, 36, 0]])
    s.add("action", name="swell", strength=1)
    s.add("tool", shape="ellipsoid", radii=[4, 4, 8])
    for depth in (24.5, 25.5):
        for points in ([[-11, 28], [11, 28]], [[0, 43], [0, 13]]):
            s.add("stroke", points=[[x, y, depth] for x, y in points])
    return s


def figure():
    """A mannequin of plain limbs, then posed by hands that hold and turn."""
    s = Session()
    for shape, center, radii in (
            ("ellipsoid", [0, 46, 0], [13, 24, 9]), ("ellipsoid", [0, 24, 0], [13, 10, 9]),
            ("capsule", [0, 70, 0], [4, 8, 4]), ("ellipsoid", [0, 84, 0], [9, 11, 9]),
            ("capsule", [-7, -2, 0], [5.5, 32, 5.5]), ("capsule", [7, -2, 0], [5.5, 32, 5.5]),
            ("ellipsoid", [-7, -32, 3], [5.5, 3.5, 10]), ("ellipsoid", [7, -32, 3], [5.5, 3.5, 10])):
        s.solid(shape, center, radii)
    lying = quarter((0, 0, 1), 90)
    s.solid("capsule", [-28, 60, 0], [4.5, 26, 4.5], rotation=lying)
    s.solid("capsule", [28, 60, 0], [4.5, 26, 4.5], rotation=lying)
    s.hold([-12, 20, -12], [12, 72, 12])
    s.clay(stiffness=1)

    def swing(start, hinge, degrees, radii):
        steps = [degrees * n / 40 for n in range(41)]
        s.move("grip", "ellipsoid", radii, [turned(start, hinge, a) for a in steps],
               [quarter((0, 0, 1), a) for a in steps])

    swing([-50, 60, 0], (-16, 60), 55, [8, 7, 7])
    swing([50, 60, 0], (16, 60), 60, [8, 7, 7])
    swing([-7, -30, 2], (-7, 20), -24, [9, 7, 14])
    swing([7, -30, 2], (7, 20), 16, [9, 7, 14])
    return s


ALL = {"bend": bend, "bend_push": bend_push, "twist": twist, "hole_thin": hole_thin,
       "hole_thick": hole_thick, "folds": folds, "neck": neck, "plough": plough,
       "raffin": raffin, "raffin_linear": lambda: raffin("linear"),
       "raffin_gaussian": lambda: raffin("gaussian"), "raffin_ball": raffin_ball,
       "raffin_star": raffin_star, "raffin_star_viscous": lambda: raffin_star(7),
       "prints": prints, "column": column, "cube": cube,
       "board": board, "chair": chair, "cup": cup, "figure": figure}

if __name__ == "__main__":
    for name, make in ALL.items():
        make().write(f"{sys.argv[1]}/{name}.jsonl")
