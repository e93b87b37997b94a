# SPDX-License-Identifier: GPL-3.0-or-later
"""Small scenes of loose blocks, for the errors that runs say they have: on finite elements and on rigid ground, in bins, on slopes, in towers."""

import math

import numpy as np
from scenes import Scene, nested  # tests/invariants
from shapely.geometry import MultiPoint, Point, Polygon
from shapely.ops import voronoi_diagram

GAP = 1e-3  # between blocks that are cut from one area [m]
NET = {"bedrock": "continuum", "blocks": "loose", "strength": "strong", "belt": "none", "bedding": "off", "static": "equilibrium", "water": "none",
       "scheme": "automatic", "base": "compliant", "sides": "viscous", "kind": "quads", "mass": "small", "nodes": "shared", "ratio": 1.0,
       "angle": 20.0, "surface": "plane", "degree": 2, "rock": "stiff", "friction": "holds", "motion": "outcrop", "springs": False,
       "damping": "none", "belt rate": 0.0, "threads": 1, "rock solver": "factor"}
RIGID = {"bedrock": "rigid", "base": "rigid"}
SLIDES = {"friction": "slides", "static": "held"}
BIN = [(-4, 5), (-2, 0), (2, 0), (4, 5)]

# name: options of the net that differ, peak [m/s2] and frequency [Hz] of the motion
ON_BEDROCK = {
    "squares that hold": ({}, 5, 3),
    "squares that slide": (SLIDES, 5, 3),
    "triangles": ({"kind": "triangles"}, 5, 3),
    "triangles, soft rock": ({"kind": "triangles", "rock": "soft"}, 5, 3),
    "triangles, mud, 10 degrees": ({"kind": "triangles", "rock": "mud", "angle": 10.0}, 6, 3),
    "triangles, 10 degrees, strong": ({"kind": "triangles", "angle": 10.0}, 9, 4),
    "triangles in a valley": (dict(SLIDES, kind="triangles", surface="valley"), 4, 3),
    "columns, mud": ({"kind": "columns", "nodes": "own", "rock": "mud"}, 3, 2),
    "squares on a ridge": (dict(SLIDES, surface="ridge", ratio=3.0, nodes="own"), 4, 3),
    "triangles, rigid": (dict(RIGID, kind="triangles"), 5, 3),
    "columns, rigid": (dict(RIGID, **SLIDES, kind="columns"), 3, 2),
    "squares on a ridge, rigid": (dict(RIGID, **SLIDES, surface="ridge"), 3, 3)}


def shaking(peak, frequency):
    return {"Motion/Type": "sine", "Motion/Peak": peak, "Motion/Frequency": frequency, "Motion/Angle": 0, "Motion/Meaning": "outcrop",
            "Motion/Cycles": 4, "Motion/Taper": 1}


def monitors(blocks):
    """The centres of four of them."""
    picked = sorted({0, len(blocks) // 3, len(blocks) // 2, len(blocks) - 1})
    return {"Monitors/Points": "; ".join("b%d: %.6g, %.6g" % (k, *np.mean(blocks[k], axis=0)) for k in picked)}


def pieces(area, count, seed):
    """A polygon cut into about so many cells of Voronoi, which are evened out three times."""
    area, random, points = Polygon(area), np.random.default_rng(seed), []
    low, high = np.array(area.bounds[:2]), np.array(area.bounds[2:])
    while len(points) < count:
        point = random.uniform(low, high)
        if area.contains(Point(point)):
            points.append(point)
    for _ in range(3):
        cells = [cell.intersection(area) for cell in voronoi_diagram(MultiPoint(points), envelope=area).geoms]
        points = [np.array(cell.centroid.coords[0]) for cell in cells]
    return [outline(cell.buffer(-GAP, join_style=2)) for cell in cells]


def outline(cell):
    """Its corners, counter-clockwise, without edges below 3 cm."""
    corners = np.array(cell.exterior.coords)[:-1]
    corners = corners if cell.exterior.is_ccw else corners[::-1]
    return np.array([x for x, before in zip(corners, np.roll(corners, 1, axis=0)) if np.linalg.norm(x - before) > 0.03])


def rectangle(x, y, width, height, turn=0.0):
    c, s = math.cos(turn), math.sin(turn)
    return np.array([(x + c * u - s * v, y + s * u + c * v) for u, v in ((0, 0), (width, 0), (width, height), (0, height))])


def turned(points, degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return np.array([(c * x - s * y, s * x + c * y) for x, y in points])


def on_slope(degrees, count, seed, ends=((-20, 0), (12, 0))):
    """Blocks cut from a heap on a slope, and the slope."""
    blocks = pieces([(0, 0.005), (6, 0.005), (5, 1.5), (1, 1.5)], count, seed)
    return [turned(b, degrees) for b in blocks], turned(ends, degrees)


def in_bin(count, seed):
    return pieces([(-1.98, 0.01), (1.98, 0.01), (2.78, 2), (-2.78, 2)], count, seed), BIN


def wall():
    return [rectangle(k + 0.5 * (row % 2), 0.6 * row, 1 - GAP, 0.6) for row in range(4) for k in range(5 - row % 2)], [(-10, 0), (15, 0)]


def tower():
    return [rectangle(0, 0.5005 * k, 1, 0.5) for k in range(6)] + [rectangle(1.6, 0, 0.4, 2.2), rectangle(2.2, 0, 0.4, 1.8)], [(-10, 0), (10, 0)]


def three_that_drop():
    return [rectangle(0, 0.3, 1, 1, 0.2), rectangle(1.2, 0.3, 1, 1, -0.1), rectangle(0.5, 1.8, 1.1, 0.7, 0.3)], [(-10, 0), (10, 0)]


# name: blocks and ground, friction [deg], end [s], peak and frequency of the motion (0: none), static stage
ON_GROUND = {
    "14 in a bin": (lambda: in_bin(14, 1), 25, 1.2, 4, 3, "none"),
    "36 in a bin": (lambda: in_bin(36, 2), 15, 1.2, 6, 3, "none"),
    "20 at rest in a bin": (lambda: in_bin(20, 3), 30, 1.2, 3, 4, "equilibrium"),
    "16 on a slope of 25 degrees": (lambda: on_slope(25, 16, 4), 20, 1, 0, 0, "none"),
    "10 on a slope, shaken": (lambda: on_slope(25, 10, 5), 32, 1.2, 5, 3, "none"),
    "brick wall": (wall, 28, 1.5, 6, 2.5, "equilibrium"),
    "tower": (tower, 30, 1.5, 4, 2, "equilibrium"),
    "three that drop": (three_that_drop, 30, 1, 0, 0, "none")}


def write_on_bedrock(name, directory):
    options, peak, frequency = ON_BEDROCK[name]
    scene = Scene(dict(NET, **options), end_time=1.2)
    corners = [[scene.section.nodes[n] for n in block] for block in scene.section.blocks] + scene.section.free_blocks
    scene.further = dict(shaking(peak, frequency), **monitors(corners))
    return scene.write(directory)


def write_on_ground(name, directory):
    make, friction, end, peak, frequency, static = ON_GROUND[name]
    blocks, ground = make()
    directory.mkdir(parents=True, exist_ok=True)
    rows = ["%d,%.9g,%.9g\n" % (k + 1, *x) for k, block in enumerate(blocks) for x in block]
    (directory / "blocks.csv").write_text("block,x,y\n" + "".join(rows), encoding="utf-8")
    (directory / "ground.csv").write_text("x,y\n" + "".join("%.9g,%.9g\n" % tuple(x) for x in ground), encoding="utf-8")
    values = {"Time/End time": end, "Mesh/Polygons file": "blocks.csv", "Mesh/Surface file": "ground.csv", "Model/Bedrock": "rigid",
              "Model/Blocks": "loose", "Materials/Names": "rock", "Materials/rock/Density": 2300, "Materials/rock/Young modulus": 1e9,
              "Materials/rock/Poisson ratio": 0.25, "Materials/rock/Friction angle": friction, "Blocks/Material": "rock",
              "Gravity/Static stage": static, **(shaking(peak, frequency) if peak else {}), **monitors(blocks)}
    file = directory / "scene.prm"
    file.write_text("# %s\n" % name + "".join(nested(values)), encoding="utf-8")
    return file


def write_scene(name, directory):
    """The parameter file of a scene, with its mesh or blocks beside it."""
    return (write_on_bedrock if name in ON_BEDROCK else write_on_ground)(name, directory)
