"""The starter tools: python3 tools.py ../../tools

Contact is -z: a tool stands on z = 0 and its handle points up.
"""
import json
import math
import sys

UP = [0.7071067811865476, 0.7071067811865476, 0, 0]  # turns y to z


def scene(spacing):
    return [{"bozzetto": "recording", "version": 1}, {"op": "scene", "spacing": spacing}]


def rounded(points):
    return [[round(number, 4) + 0.0 for number in point] for point in points]


def fill(shape, center, radii, colour, rotation=None):
    line = {"op": "fill", "shape": shape, "center": rounded([center])[0], "radii": radii}
    if rotation:
        line["rotation"] = rounded([rotation])[0]
    return line | {"colour": colour}


def tool(shape, radii, rotation=None, profile=None):
    line = {"op": "tool", "shape": shape, "radii": radii}
    if profile:
        line["profile"] = profile
    if rotation:
        line["rotation"] = rounded([rotation])[0]
    return line


def action(name, strength, colour=None):
    line = {"op": "action", "name": name, "strength": strength}
    return line | {"colour": colour} if colour else line


def stroke(points, **settings):
    return {"op": "stroke", "points": rounded(points)} | settings


def about_z(degrees):
    half = math.radians(degrees) / 2
    return [math.cos(half), 0, 0, math.sin(half)]


def about_x(degrees):
    half = math.radians(degrees) / 2
    return [math.cos(half), math.sin(half), 0, 0]


def smoothed(radii, strength, points, times=1):
    """Edges that cells cannot show become round."""
    return [tool("ellipsoid", radii, profile="box"), action("smooth", strength)] + \
        [stroke(points, spacing=0.4) for _ in range(times)]


def finger():
    """It points down, its pad toward -y, its nail toward +y."""
    w, length, skin, nail = 3.7, 17, "#c79a7b", "#e9c7b8"
    lines = scene(0.3)
    girths = [(0, 0.84), (0.3, 0.88), (0.5, 0.98), (0.7, 0.93), (1, 1)]
    lines.append(tool("ellipsoid", [1.6 * w, 1.6 * w, 1.6 * w]))
    lines.append(action("add", 0.5, skin))
    path = [[0, 0.12 * w * math.sin(2.4 * along), 0.95 * w + along * length, size]
            for along, size in girths]
    lines.append(stroke(path, spacing=0.08, pressure=["size"]))
    # the pad is fuller than the back
    lines.append(tool("ellipsoid", [1.25 * w, 1.1 * w, 1.5 * w]))
    lines.append(action("add", 0.35, skin))
    lines.append(stroke([[0, -0.3 * w, 1.2 * w], [0, -0.25 * w, 1.7 * w]], spacing=0.2))
    # creases where it bends: three at the back, one in front
    lines.append(tool("ellipsoid", [1.0 * w, 0.42 * w, 0.3 * w]))
    lines.append(action("remove", 0.2))
    joint = 0.95 * w + 0.47 * length
    for up in (-0.45, 0, 0.45):
        lines.append(stroke([[0, 1.16 * w, joint + up * w]]))
    lines.append(stroke([[0, -1.05 * w, joint]]))
    # a nail in its bed
    lines.append(tool("ellipsoid", [0.95 * w, 0.5 * w, 1.15 * w]))
    lines.append(action("remove", 0.5))
    lines.append(stroke([[0, 1.12 * w, 1.05 * w]]))
    lines += smoothed([3 * w, 3 * w, 3 * w], 0.8, [[0, 0, w], [0, 0, w + length]])
    lines.append(fill("ellipsoid", [0, 0.7 * w, 1.0 * w], [0.66 * w, 0.3 * w, 0.95 * w], nail,
                      about_x(-6)))
    lines += smoothed([1.6 * w, 1.2 * w, 1.8 * w], 0.35, [[0, w, w]])
    return lines


def thumb():
    """Broad and flat, bent back at its only joint, with the ball that it stands on."""
    skin, nail = "#c79a7b", "#e9c7b8"
    lines = scene(0.3)
    lines.append(tool("ellipsoid", [9.2, 7, 8]))
    lines.append(action("add", 0.5, skin))
    bent = [[0, 0, 5, 0.92], [0, -0.4, 9, 1], [0, -1.6, 13, 0.86], [0, -1.2, 17, 0.92],
            [0, 1, 22, 1]]
    lines.append(stroke(bent, spacing=0.06, pressure=["size"]))
    lines.append(tool("ellipsoid", [15, 13, 13]))
    lines.append(action("add", 0.5, skin))
    lines.append(stroke([[0, 1.5, 25], [0, 3, 29]], spacing=0.1))
    # creases over the joint, the nail's bed
    lines.append(tool("ellipsoid", [4.4, 1.7, 1.2]))
    lines.append(action("remove", 0.2))
    for up in (12, 14, 16):
        lines.append(stroke([[0, 3, up]]))
    lines.append(tool("ellipsoid", [5.2, 2.2, 5.4]))
    lines.append(action("remove", 0.5))
    lines.append(stroke([[0, 4, 5.2]]))
    lines += smoothed([13, 13, 13], 0.8, [[0, 0, 4], [0, 0, 32]])
    lines.append(fill("ellipsoid", [0, 2.2, 5], [3.9, 1.2, 4.4], nail, about_x(-8)))
    lines += smoothed([8, 6, 9], 0.35, [[0, 3, 5]])
    return lines


def loop():
    steel, wood = "#b9b4a8", "#c9a46a"
    lines = scene(0.3)
    lines.append(tool("ellipsoid", [2.2, 2.2, 2.2]))
    lines.append(action("add", 0.5, steel))
    # A drop of wire, broad where it carves, its ends together in the ferrule.
    drop = [[6.4 * math.sin(math.tau * n / 96) * (1 - 0.45 * (1 - math.cos(math.tau * n / 96)) / 2),
             0, 8 - 7 * math.cos(math.tau * n / 96)] for n in range(97)]
    lines.append(stroke(drop, spacing=0.1))
    lines.append(stroke([[0, 0, 15], [0, 0, 18]], spacing=0.1))
    lines.append(fill("capsule", [0, 0, 27], [2.4, 10, 2.4], wood, UP))
    lines.append(fill("capsule", [0, 0, 18.6], [2.1, 2.6, 2.1], "#d9b26a", UP))
    lines += smoothed([4, 4, 4], 0.7, [[0, 0, 14], [0, 0, 21]])
    return lines


def rake():
    steel, wood = "#8f9498", "#3f3a36"
    lines = scene(0.3)
    for x in (-8, -4, 0, 4, 8):
        lines.append(fill("capsule", [x, 0, 5.5], [1, 5.5, 1], steel, UP))
    lines.append(fill("capsule", [0, 0, 10.8], [9.4, 1.4, 1.4], steel, about_z(0))
                 | {"radii": [1.4, 9.6, 1.4], "rotation": rounded([about_z(90)])[0]})
    lines.append(fill("capsule", [0, 0, 14], [1.3, 4, 1.3], steel, UP))
    lines.append(fill("capsule", [0, 0, 26], [2.2, 10, 2.2], wood, UP))
    lines.append(fill("capsule", [0, 0, 17.4], [1.9, 2.4, 1.9], "#d9b26a", UP))
    lines += smoothed([4, 4, 4], 0.7, [[-9, 0, 10.6], [9, 0, 10.6]])
    lines += smoothed([4, 4, 4], 0.5, [[0, 0, 14], [0, 0, 20]])
    return lines


def knife():
    steel, wood = "#c2c6c9", "#7a4a2c"
    lines = scene(0.25)
    # A wedge of bars along y, their lower ends round towards -y: a slit with upright walls would
    # have an edge that waves with the cells.
    for n in range(52):
        z = 0.7 + n / 3
        thick = min(0.6 + 0.32 * z, 2.2)
        front = 3.6 - (6 - math.sqrt(36 - (6 - z) ** 2) if z < 6 else 0)
        lines.append(fill("capsule", [0, (3.6 - front) / 2, z], [thick, (3.6 + front) / 2, thick],
                          steel))
    lines += smoothed([6, 6, 6], 0.9, [[0, 0, 0], [0, 0, 18]], 2)
    lines.append(fill("capsule", [0, 1, 19.4], [1.7, 2.2, 2.2], "#d9b26a", UP))
    lines.append(fill("capsule", [0, 1, 28], [1.9, 9, 2.5], wood, UP))
    lines += smoothed([4, 5, 4], 0.6, [[0, 0.5, 16.5], [0, 1, 22]])
    return lines


def star_tip():
    plaster = "#d8d2c4"
    lines = scene(0.25)
    # Six arms, each a row of upright capsules that grow thinner outward.
    lines.append(fill("capsule", [0, 0, 7], [2.8, 7, 2.8], plaster, UP))
    for arm in range(6):
        way = math.radians(60 * arm)
        for n in range(8):
            out, thick = 1.5 + 0.62 * n, 1.75 - 0.075 * n
            lines.append(fill("capsule", [out * math.cos(way), out * math.sin(way), 7],
                              [thick, 7, thick], plaster, UP))
    lines.append(fill("cylinder", [0, 0, 17], [6, 4.5, 6], plaster, UP))
    lines += smoothed([10, 10, 6], 0.9, [[0, 0, 1], [0, 0, 21]], 2)
    return lines


def screw():
    metal = "#a9a59a"
    lines = scene(0.3)
    lines.append(fill("capsule", [0, 0, 21], [2.8, 19.5, 2.8], metal, UP))
    lines.append(tool("ellipsoid", [2.2, 2.2, 1.7]))
    lines.append(action("add", 0.5, metal))
    thread, turns, rise = [], 7.5, 4.4
    for n in range(int(turns * 32) + 1):
        turn = n / 32
        # It grows out of the tip and runs out under the head.
        size = min(1, 0.3 + 0.7 * turn / 1.2, 0.35 + 0.65 * (turns - turn) / 0.8)
        out = 3.1 * min(1, 0.15 + 0.85 * turn / 1.2)
        way = math.tau * turn
        thread.append([out * math.cos(way), out * math.sin(way), 2.6 + rise * turn, size])
    lines.append(stroke(thread, spacing=0.1, pressure=["size"]))
    lines += smoothed([6, 6, 5], 0.8, [[0, 0, 3], [0, 0, 37]], 2)
    lines.append(fill("cylinder", [0, 0, 42], [7, 2.6, 7], metal, UP))
    lines += smoothed([9, 9, 5], 0.9, [[0, 0, 40], [0, 0, 44]], 3)
    lines.append(tool("capsule", [1.5, 12, 2.4], [0.7071067811865476, 0, 0, 0.7071067811865476],
                      "box"))
    lines.append(action("remove", 1))
    lines.append(stroke([[0, 0, 45]]))
    lines += smoothed([9, 9, 4], 0.6, [[0, 0, 44.5]])
    return lines


def scale():
    green = "#6f8f86"
    lines = scene(0.25)
    lines.append(fill("ellipsoid", [0, 0, 0], [8, 9.5, 2.6], green))
    lines.append(tool("box", [14, 14, 3]))
    lines.append(action("erase", 0.5))
    lines.append(stroke([[0, 0, -3.4]]))
    # Ridges fan out from where it is hidden by the next scale.
    lines.append(tool("ellipsoid", [1.1, 1.1, 1.1]))
    lines.append(action("remove", 0.22))
    def on_surface(x, y):
        return 2.6 * math.sqrt(max(0, 1 - (x / 8) ** 2 - (y / 9.5) ** 2))
    for angle in (0, 14, 28, 42):
        way = math.radians(angle)
        line = []
        for n in range(13):
            r = 3.5 + n * 0.85
            x, y = r * math.sin(way), 6.5 - r * math.cos(way)
            if (x / 8) ** 2 + (y / 9.5) ** 2 < 0.86:
                line.append([x, y, on_surface(x, y) + 0.15])
        lines.append(stroke(line, spacing=0.2) | ({"mirror": "x"} if angle else {}))
    lines += smoothed([12, 13, 5], 0.9, [[0, 0, 0]], 2)
    return lines


def brick():
    red = "#a5482f"
    lines = scene(0.3)
    lines.append(fill("box", [0, 0, 3.5], [10, 4.6, 3.5], red))
    lines += smoothed([22, 12, 11], 0.95, [[0, 0, 3.5]], 8)
    # The hollow that takes the mortar.
    lines.append(tool("box", [7, 2.6, 1.6], profile="box"))
    lines.append(action("remove", 1))
    lines.append(stroke([[0, 0, 7.2]]))
    lines.append(tool("ellipsoid", [3, 3, 3]))
    lines.append(action("paint_soft", 0.25, "#8d3b27"))
    lines.append(stroke([[-7, 2, 7], [-3, -2, 7], [2, 2, 7], [6, -2, 7]], spacing=0.9))
    lines += smoothed([22, 12, 11], 0.8, [[0, 0, 3.5]], 2)
    return lines


def eye():
    skin = "#c79a7b"
    lines = scene(0.16)
    lines.append(fill("ellipsoid", [0, 0, 0], [8, 8, 8], skin))
    for radius, colour in ((6.6, "#f4efe6"), (3.3, "#27455e"), (3.0, "#3f6f8f"),
                           (1.5, "#15130f")):
        lines.append(tool("cylinder", [radius, 4.4, radius], UP))
        lines.append(action("paint", 1, colour))
        lines.append(stroke([[0, 0, 8]]))
    lines += smoothed([4.4, 4.4, 3], 0.9, [[0, 0, 8]], 2)
    lines.append(fill("ellipsoid", [1, 1, 7.7], [0.8, 0.8, 0.4], "#ffffff"))
    # Lids: over the ball, thick at their edges, meeting in the corners.
    for side, thick, opening in ((1, 1.15, 3.4), (-1, 1.0, 2.9)):
        for layer in range(7):
            t = layer / 6
            path = []
            for n in range(25):
                x = -7.6 + 15.2 * n / 24
                arch = 1 - (x / 7.6) ** 2
                y = side * (opening * arch + t * (0.7 + 2.4 * arch))
                z = math.sqrt(max(0.5, 8.7 ** 2 - 0.82 * x * x - y * y)) - 0.4 * t
                path.append([x, y, z])
            lines.append(tool("ellipsoid", [2 * thick] * 3))
            lines.append(action("add", 0.6, skin))
            lines.append(stroke(path, spacing=0.15))
    lines.append(tool("ellipsoid", [3, 3, 3]))
    lines.append(action("smooth", 0.6))
    for side, opening in ((1, 3.4), (-1, 2.9)):
        lid = []
        for n in range(13):
            x = -8 + 16 * n / 12
            y = side * (opening + 2.2) * (1 - (x / 8.4) ** 2)
            lid.append([x, y, math.sqrt(max(0.5, 8.9 ** 2 - 0.82 * x * x - y * y))])
        lines.append(stroke(lid, spacing=0.2))
    return lines



def write(name, lines):
    with open(f"{sys.argv[1]}/{name}.jsonl", "w") as out:
        for line in lines:
            out.write(json.dumps(line, separators=(",", ":"), ensure_ascii=False) + "\n")


for made in (finger, thumb, loop, rake, knife, star_tip, screw, scale, brick, eye):
    write(made.__name__, made())
