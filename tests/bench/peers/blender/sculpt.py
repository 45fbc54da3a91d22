"""Blender's Draw brush, with and without dynamic topology, on a ball of radius 256.

Runs inside Blender: blender -P sculpt.py -- draw|dyntopo THREADS REPEATS FILE. Appends one JSON
object a line to FILE. A stroke is 50 dabs, a quarter of the radius apart, as in workload.hpp, but
on the great circle that the window shows; no redraw happens between dabs.
"""
import json
import math
import os
import statistics
import sys
import time
import traceback

import bpy
from bpy_extras.view3d_utils import location_3d_to_region_2d
from mathutils import Vector

BALL = 256
DABS = 50
KIND, THREADS, REPEATS, FILE = sys.argv[sys.argv.index("--") + 1:]
RADII = (8, 16, 32, 64, 128) if KIND == "draw" else (8, 16, 32, 64)


def make_ball():
    """A ball of squares one unit wide: 2.47 million triangles (dyntopo: of 1.57, a million)."""
    bpy.ops.mesh.primitive_ico_sphere_add(subdivisions=7, radius=BALL)
    ball = bpy.context.object
    ball.data.remesh_voxel_size = 1.0 if KIND == "draw" else 1.57
    bpy.ops.object.voxel_remesh()
    return ball


def look_from_front(area):
    view = area.spaces.active.region_3d
    area.spaces.active.clip_end = 5000
    bpy.ops.view3d.view_axis(type="FRONT")
    view.view_perspective = "ORTHO"
    view.view_distance = 700
    view.view_location = (0, 0, 0)
    view.update()


def start_sculpting():
    bpy.ops.object.mode_set(mode="SCULPT")
    sculpt = bpy.context.scene.tool_settings.sculpt
    if KIND == "dyntopo":
        bpy.ops.sculpt.dynamic_topology_toggle()
        sculpt.detail_type_method = "CONSTANT"
        sculpt.constant_detail_resolution = 1.0 / 1.57
        sculpt.detail_refine_method = "SUBDIVIDE_COLLAPSE"
    for axis in "xyz":
        setattr(sculpt, "use_symmetry_" + axis, False)


def set_brush(radius, strength):
    """Before every stroke: undo may replace the brush."""
    settings = bpy.context.scene.tool_settings
    brush = bpy.data.brushes["SculptDraw"]
    settings.sculpt.brush = brush
    brush.use_locked_size = "SCENE"
    brush.unprojected_radius = radius
    brush.strength = strength
    brush.use_pressure_strength = brush.use_pressure_size = False
    unified = settings.unified_paint_settings
    unified.use_unified_size = unified.use_unified_strength = False


def stroke(region, view, radius):
    span = min((DABS - 1) * (radius / 4) / BALL, 2.2)  # stays on the side that is seen
    points = []
    for n in range(DABS):
        angle = -span / 2 + span * n / (DABS - 1)
        place = Vector((BALL * math.sin(angle), -BALL * math.cos(angle), 20.0))
        place *= BALL / place.length
        mouse = location_3d_to_region_2d(region, view, place)
        points.append(dict(name="", location=place, mouse=(mouse.x, mouse.y),
                           mouse_event=(mouse.x, mouse.y), pressure=1.0, size=50.0,
                           pen_flip=False, x_tilt=0.0, y_tilt=0.0, time=n * 0.01,
                           is_start=n == 0))
    return points


def paint(points):
    bpy.ops.sculpt.brush_stroke("EXEC_DEFAULT", True, stroke=points, mode="NORMAL")


def height():
    """How far the farthest vertex lies outside the ball; dyntopo keeps its mesh elsewhere."""
    mesh = bpy.data.objects[0].data
    return max(vertex.co.length for vertex in mesh.vertices) - BALL


def measure(region, view, radius, triangles):
    points = stroke(region, view, radius)
    set_brush(radius, 0.0005)
    paint(points[:1])  # so that every timed undo is a step on top of a step
    times, undo = [], []
    for _ in range(int(REPEATS)):
        set_brush(radius, 0.5)
        start = time.perf_counter()
        paint(points)
        times.append((time.perf_counter() - start) * 1e3 / DABS)
        raised = height() if KIND == "draw" else 0
        start = time.perf_counter()
        bpy.ops.ed.undo()
        undo.append((time.perf_counter() - start) * 1e3)
    detail = dict(triangles=triangles, undo_stroke_ms=statistics.median(undo), raised=raised)
    row = dict(peer="blender", case=KIND, radius=radius, threads=int(THREADS),
               median_ms=statistics.median(times), min_ms=min(times), detail=detail)
    with open(FILE, "a") as lines:
        lines.write(json.dumps(row) + "\n")


def run():
    status = 1
    try:
        window = bpy.context.window_manager.windows[0]
        area = max((a for a in window.screen.areas if a.type == "VIEW_3D"),
                   key=lambda a: a.width * a.height)
        region = next(r for r in area.regions if r.type == "WINDOW")
        with bpy.context.temp_override(window=window, screen=window.screen, area=area,
                                       region=region):
            for thing in list(bpy.data.objects):
                bpy.data.objects.remove(thing)
            ball = make_ball()
            triangles = len(ball.data.loops) - 2 * len(ball.data.polygons)
            look_from_front(area)
            start_sculpting()
            bpy.ops.ed.undo_push(message="ball")
            for radius in RADII:
                measure(region, area.spaces.active.region_3d, radius, triangles)
        status = 0
    except Exception:
        traceback.print_exc()
    os._exit(status)


bpy.app.timers.register(run, first_interval=3.0)
