# SPDX-License-Identifier: GPL-3.0-or-later
"""Small scenes for the errors that runs say of their meshes: ridges, valleys, steps, canyons, layers, pits of blocks, bonded masses and slopes.
Each is a scene of the repository with numbers of its mesh and settings that differ."""

import math
import re
import subprocess

TERRAIN = "Mesh/File={source}/tests/verification/terrain.geo"
STEP = "behind: -150, {0}; crest: {1}, {0}; toe: 0, 0; before: 150, 0; under: 0, -100"
AROUND = "left: -150, 0; rim: -95, 0; mid: 0, 0; quarter: 50, 0; far: 200, 0"
OF_PIT = "below: {0}, -{1}; surface: {2}, -0.5; side: {3}, -0.5; ground: {4}, 0"
STRONG = ["Materials/soil/Friction angle=35", "Materials/soil/Cohesion=1e9", "Materials/soil/Tensile strength=1e9", "Blocks/Material=soil",
          "Blocks/Belt material=soil"]
SLIDES = ["Materials/Names=rock, belt", "Materials/belt/Friction angle=15", "Materials/belt/Cohesion=0", "Materials/belt/Tensile strength=0",
          "Blocks/Belt material=belt", "Gravity/Acceleration=9.81", "Blocks/Damping ratio=0.05", "Blocks/Damping frequency=5", "Motion/Frequency=3",
          "Motion/Peak=4", "Time/End time=0.9"]
BONDED = ["Motion/Peak=0.05 g", "Blocks/Belt material=body", "Materials/body/Cohesion=1e9", "Materials/body/Tensile strength=1e9"]
ELASTIC = ["Bedding planes/Strength=elastic", "Motion/Type=ricker", "Motion/Frequency=8", "Motion/Peak=1"]


def rock_and_soil(wave, ratio, nu=1 / 3):
    """Shear waves of both [m/s, and of the soil over it]."""
    return ["Materials/Names=rock, soil"] + ["Materials/%s/%s=%.10g" % (name, what, value) for name, c in (("rock", wave), ("soil", wave * ratio))
                                             for what, value in (("Density", 2000), ("Young modulus", 4000 * c**2 * (1 + nu)), ("Poisson ratio", nu))]


def run(frequency, end, step=None):
    return ["Motion/Frequency=%g" % frequency, "Time/End time=%g" % end] + (["Time/Time step=%g" % step] if step else [])


def terrain(trapezoid, bedrock, cells, wave, ratio, degree, times, points):
    """Trapezoid: level, half widths; bedrock: half width, depth; cells: sizes [m]."""
    names = ("Level", "Wide", "Narrow", "Half width", "Depth", "Resolution/h", "Resolution/fill")
    numbers = "; ".join("%s = %g" % pair for pair in zip(names, (*trapezoid, *bedrock, *cells)))
    return "step", numbers, [TERRAIN, *rock_and_soil(wave, ratio), "Continuum/Materials=bedrock: rock; bedrock_soft: soil",
                             "Continuum/Degree=%d" % degree, *run(*times), "Monitors/Points=" + points]


def layers(width, height, soft, cells, times, points, *settings):
    return "soft_layer", "Width = %g; Height = %g; Layer height = %g; Resolution/h = %g" % (width, height, soft, cells), [
        *run(*times), "Monitors/Points=" + points, *settings]


def pit(width, depth, margin, below, cells, wave, ratio, times, ground=15, angle=0):
    middle = margin + width / 2
    return "continuum_into_blocks", "Pit width = %g; Pit depth = %g; Margin = %g; Rock below = %g; Resolution/h = %g; Resolution/far = %g" % (
        width, depth, margin, below, *cells), [*rock_and_soil(wave, ratio, 0.25), *STRONG, *run(*times), "Motion/Angle=%g" % angle,
                                              "Monitors/Points=" + OF_PIT.format(middle, below, middle + 1, margin + 1, ground)]


def planes(cells, end, *settings):
    return "bedding_slip_blocks", "Width = 120; Base height = 20; Middle height = 15; Top height = 10; Resolution/h = %g" % cells, [
        *settings, "Time/End time=%g" % end, "Monitors/Points=ground: 60.2, 44.8; deep: 60.2, 10.2"]


def mass(mesh, numbers, points, *settings):
    return "bonded_mass", numbers, ["Mesh/File={source}/meshes/%s.geo" % mesh, "Monitors/Points=" + points, *settings]


def one_cell_step(height, angle, cells, degree, times):
    """A slope of one cell in all meshes."""
    crest = -height / math.tan(math.radians(angle)) if angle < 90 else 0
    return "step", "Height = %g; Angle = %g; Half width = 400; Depth = 300; Resolution/h = %g; Resolution/step = %g" % (
        height, angle, cells, height), ["Continuum/Degree=%d" % degree, *run(*times), "Monitors/Points=" + STEP.format(height, "%.9g" % crest)]


# What the reference has besides: where a slope is one cell long a third of the size is not enough.
REFERENCE = {name: ["Mesh/Corner levels=4"] for name in (
    "step of one cell", "vertical step of one cell", "low step of one cell, degree 2", "step of one cell, degree 1", "ridge of one cell",
    "step of 60 degrees, degree 4", "ridge, degree 4")}

# A slope without a mass, by hybrid new: ground and bedding planes of some dip, one above the other [m].
PLANES = {"four close planes slip": ([(0, 0), (100, 0), (150, 60), (300, 60)], 22, [(80, 220, y) for y in (-5, -20, -35, -50)]),
          "two planes slip": ([(0, 10), (60, 12), (100, 20), (180, 58), (230, 70), (330, 72)], 14, [(60, 300, y) for y in (-8, -23)]),
          "a plane below flat ground slips": ([(0, 50), (300, 50)], 14, [(60, 240, -8)])}


def slipping(cells, *settings):
    return "new planes", "Resolution/h = %g; Resolution/planes = %g" % cells, [
        "Bedding planes/Strength=Mohr-Coulomb", "Bedding planes/Friction angle=12", "Bedding planes/Cohesion=20e3", "Bedding planes/Tensile strength=0",
        "Bedding planes/Initial normal stress=2e5", "Monitors/Lines=", "Motion/Frequency=4", "Motion/Peak=0.3 g", *settings]


# name: scene that it varies, numbers of the mesh, settings
SCENES = {
    "ridge, degree 2": terrain((50, 100, 20), (400, 200), (30, 15), 500, 1, 2, (3, 1.6, 0.004), "left: -150, 0; foot: 100, 0; top: 0, 50; far: 200, 0"),
    "ridge, degree 3": terrain((40, 50, 25), (250, 120), (25, 12), 500, 1, 3, (4, 1.3, 0.004), "left: -100, 0; top: 0, 40; side: 37, 20; far: 150, 0"),
    "ridge, degree 4": terrain((40, 100, 60), (400, 200), (60, 40), 500, 1, 4, (4, 1.5, 0.004), "left: -150, 0; foot: 100, 0; top: 0, 40; far: 200, 0"),
    "valley of soft ground": terrain((-40, 100, 50), (400, 200), (30, 10), 800, 0.3, 2, (2.5, 2.5, 0.004), AROUND),
    "the same, long waves": terrain((-40, 100, 50), (400, 200), (20, 10), 800, 0.6, 2, (1.5, 3, 0.008), AROUND),
    "small valley": terrain((-25, 60, 30), (240, 120), (15, 6), 600, 0.5, 2, (4, 1.5, 0.004), "left: -100, 0; mid: 0, 0; quarter: 30, 0; far: 150, 0"),
    "steep valley, degree 3": terrain((-30, 100, 90), (400, 150), (40, 15), 600, 0.5, 3, (3, 2, 0.004), AROUND),
    "flat valley, degree 4": terrain((-60, 120, 20), (400, 200), (60, 30), 800, 0.4, 4, (3, 2, 0.004), AROUND),
    "stiff rock in soft ground": terrain((-30, 60, 59.9), (240, 120), (20, 10), 400, 2.5, 2, (3, 1.5, 0.004),
                                         "left: -100, 0; mid: 0, 0; edge: 55, 0; far: 150, 0"),
    "step of 30 degrees": ("step", "Height = 40; Angle = 30; Half width = 400; Depth = 200; Resolution/h = 20; Resolution/step = 10",
                           ["Continuum/Degree=2", *run(2, 2.2),
                            "Monitors/Points=behind: -120, 40; crest: -69.282, 40; toe: 0, 0; slope: -34.641, 20; before: 100, 0"]),
    "step of 60 degrees, degree 4": ("step", "Height = 30; Angle = 60; Half width = 300; Depth = 200; Resolution/h = 50; Resolution/step = 30",
                                     [*run(3, 1.8, 0.004), "Monitors/Points=behind: -100, 30; crest: -17.3205, 30; before: 50, 0"]),
    "small canyon, degree 2": ("canyon", "Radius = 60; Half width = 300; Depth = 200; Resolution/h = 20; Resolution/canyon = 10",
                               ["Continuum/Degree=2", *run(4, 1.2), "Monitors/Points=a: -100, 0; b: -60, 0; c: 0, -60; d: 42.426407, -42.426407; e: 150, 0"]),
    "layers, long waves": layers(10, 60, 25, 5, (2, 6, 0.002), "surface: 5, 60; deep: 5, 30"),
    "layers, short waves": layers(10, 60, 25, 5, (6, 4, 0.002), "surface: 5, 60; deep: 5, 30"),
    "layers, short steps": layers(8, 47, 13, 4, (1.5, 4, 0.001), "surface: 4, 47; deep: 4, 20"),
    "layers, P waves": layers(16, 96, 32, 8, (2.5, 4, 0.002), "surface: 8, 96; deep: 8, 40", "Motion/Angle=90"),
    "layers, degree 3": layers(10, 90, 50, 10, (2, 6, 0.002), "surface: 5, 90; deep: 5, 30", "Continuum/Degree=3"),
    "layers, degree 1": layers(10, 90, 50, 2.5, (2, 5, 0.004), "surface: 5, 90; deep: 5, 30", "Continuum/Degree=1"),
    "pit, soft": pit(40, 20, 40, 60, (4, 15), 400, 0.5, (3, 1.5)),
    "pit, flat, oblique motion": pit(60, 12, 40, 40, (3, 10), 500, 0.4, (5, 1), angle=60),
    "pit, stiff": pit(30, 15, 30, 45, (2.5, 7.5), 300, 1.5, (3, 1.2), ground=10),
    "column": ("time_order", "Width = 10; Height = 30; Block height = 15; Resolution/h = 2.5",
               ["Motion/Frequency=4", "Monitors/Points=top: 5, 30; interface: 5, 15; rock: 5, 5"]),
    "bar": ("bonded_bar", "Width = 4; Height = 60; Resolution/h = 2", [*run(5, 0.6), "Monitors/Points=station: 2, 40; foot: 2, 10"]),
    "bedrock of triangles": planes(2.5, 0.6, *ELASTIC),
    "the same, a plane slips": planes(5, 0.5),
    "mass on a rigid base": mass("bonded_blocks", "Width = 40; Height = 10; Resolution/h = 1", "mid: 20.1, 5.1; top: 20.1, 9.8; edge: 1.1, 9.8", *run(6, 0.5)),
    "mass of scattered corners": mass("random_blocks", "Width = 20; Height = 8; Scatter = 0.5; Resolution/h = 1",
                                      "mid: 10.1, 4.1; top: 10.1, 7.8; edge: 1.1, 7.8", *run(6, 0.5)),
    "slope": mass("slope", "Height = 10; Slope = 1.5; Depth = 5; Front = 10; Behind = 15; Resolution/h = 1.5",
                  "crest: 16, 9.8; toe: -0.5, -0.5; back: 25, 9.8; face: 7.5, 4.5", *run(5, 0.6)),
    "slab that slides": mass("bonded_blocks", "Width = 20; Height = 4; Base beyond = 5; Resolution/h = 1", "mid: 10.1, 2.1; top: 10.1, 3.8", *SLIDES),
    "landslide": ("new", "Resolution/h = 6.3; Resolution/far = 50; Resolution/ground = 12", [*BONDED, *run(1.5, 2.2)]),
    "landslide, shorter waves": ("new", "Resolution/h = 6.3; Resolution/far = 50; Resolution/ground = 12", [*BONDED, *run(3, 2)]),
    "step of one cell": one_cell_step(40, 40, 50, 4, (2, 2.6)),
    "vertical step of one cell": one_cell_step(40, 90, 50, 4, (1.5, 3)),
    "low step of one cell, degree 2": one_cell_step(20, 60, 25, 2, (1.5, 3)),
    "step of one cell, degree 1": one_cell_step(20, 90, 12.5, 1, (1, 3.5)),
    "ridge of one cell": terrain((30, 80, 40), (400, 200), (40, 30), 500, 1, 3, (1.5, 2.5, 0.004), "left: -150, 0; foot: 80, 0; top: 0, 30; far: 200, 0"),
    "four close planes slip": slipping((12, 11)),
    "two planes slip": slipping((12, 14.5)),
    "a plane below flat ground slips": slipping((12, 14.5))}


def scene_file(binary, source, work, name):
    """That it varies; "new": the slope of the third example, made by hybrid new."""
    base = SCENES[name][0]
    if base == "new planes":
        return scene_of_planes(binary, work, name)
    if base != "new":
        return source / "parameters/verification" / (base + ".prm")
    made, tables = work / "landslide_scene", source / "parameters/examples/03_own_slope"
    if not (made / "scene.prm").exists():
        subprocess.run([binary, "new", "--profile", tables / "ground.csv", "--slip", tables / "slip.csv", made], check=True, stdout=subprocess.DEVNULL)
    return made / "scene.prm"


def scene_of_planes(binary, work, name):
    ground, dip, planes = PLANES[name]
    made, tables = work / re.sub(r"\W+", "_", name + " scene"), [work / ("%s.csv" % table) for table in ("ground", "planes")]
    if not (made / "scene.prm").exists():
        tables[0].write_text("".join("%g,%g\n" % point for point in ground))
        slope = math.tan(math.radians(dip))
        tables[1].write_text("plane,x,z\n" + "".join("plane %d,%g,%.6g\n" % (number, x, y + slope * (x - left))
                                                    for number, (left, right, y) in enumerate(planes) for x in (left, right)))
        subprocess.run([binary, "new", "--profile", tables[0], "--planes", tables[1], "--frequency", "4", made], check=True, stdout=subprocess.DEVNULL)
    return made / "scene.prm"


def settings(source, name):
    return [setting.replace("{source}", str(source)) for setting in SCENES[name][2]]
