# SPDX-License-Identifier: GPL-3.0-or-later
"""Walls of dry bricks in running bond that a part of their weight pushes sideways (Ferris & Tin-Loi 2001, first and second example).

Beside limit analysis with friction that dilates, which overestimates what a wall bears, the one without dilation (rigid_blocks.py).
"""

import numpy as np
from rigid_blocks import Assembly
from scene_numbers import Numbers

COLUMNS, WIDTH, HEIGHT = 5, 0.4, 0.175  # bricks of a course [m]
WALLS = {6: (0.64286, 0.63982), 10: (0.58000, 0.56262)}  # courses: published limits with and without dilation
MARGIN = 0.02  # on either side of the limit
CUTS = 5  # bisections of the bracket, for the page
DIGITS = 1e-4  # of the published numbers, relative
FALLS = 1.1  # of the limit of the higher wall: moves for half a second


def bricks(courses):
    """Left, right, bottom, top of each brick; the first course begins and ends with half bricks."""
    whole = [k * WIDTH for k in range(COLUMNS + 1)]
    half = [0.0] + [(k + 0.5) * WIDTH for k in range(COLUMNS)] + [COLUMNS * WIDTH]
    return [(a, b, j * HEIGHT, (j + 1) * HEIGHT)
            for j in range(courses) for ends in [whole if j % 2 else half] for a, b in zip(ends[:-1], ends[1:])]


def polygons(wall):
    return [np.array([(a, c), (b, c), (b, d), (a, d)]) for a, b, c, d in wall]


def joints(wall):
    found = []
    for i, (a, b, bottom, top) in enumerate(wall):
        if bottom == 0:
            found.append((i, None, np.array([(a, 0.0), (b, 0.0)])))
        for j, (left, right, low, high) in enumerate(wall):
            first, last = max(a, left), min(b, right)
            if np.isclose(high, bottom) and last - first > 1e-9:
                found.append((i, j, np.array([(first, bottom), (last, bottom)])))
            if np.isclose(right, a) and np.isclose(low, bottom):
                found.append((i, j, np.array([(a, top), (a, bottom)])))
    return found


def run_wall(case, name, courses, *overrides):
    file = case.work / ("courses_%d.csv" % courses)
    rows = ["%d,%.12g,%.12g" % (k + 1, *corner) for k, brick in enumerate(polygons(bricks(courses))) for corner in brick]
    file.write_text("\n".join(["block,x,y"] + rows) + "\n")
    return case.run(name, "Mesh/Polygons file=%s" % file.resolve(), *overrides)


def stands(case, courses, push):
    run = run_wall(case, "courses_%d_push_%.6f" % (courses, push), courses, "Gravity/Horizontal coefficient=%.12g" % push,
                   "Gravity/Static stage=equilibrium or move")
    return run.summary["static_stage"]["equilibrium"]


def check(case):
    mu = np.tan(np.radians(Numbers(case.run()).number("Materials/rock/Friction angle")))
    case.limits = {}
    for courses, (dilating, published) in WALLS.items():
        wall, name = bricks(courses), "%d courses: " % courses
        assembly = Assembly(polygons(wall), joints(wall))
        case.near(name + "limit analysis with dilation as published", assembly.largest_push(mu), dilating, DIGITS)
        limit = case.limits[courses] = assembly.largest_push_without_dilation(mu)
        case.near(name + "without dilation as published", limit, published, DIGITS)
        low, high = (1 - MARGIN) * limit, (1 + MARGIN) * limit
        case.true("%s%.4f of the weight, %g %% below the limit: it stands" % (name, low, 100 * MARGIN), stands(case, courses, low))
        case.true("%s%.4f, %g %% above: it does not" % (name, high, 100 * MARGIN), not stands(case, courses, high))
        for _ in range(CUTS):
            middle = 0.5 * (low + high)
            low, high = (middle, high) if stands(case, courses, middle) else (low, middle)
        case.near("%slimit, within %.2g" % (name, high - low), 0.5 * (low + high), limit, MARGIN)
    case.moved = run_wall(case, "moves", max(WALLS), "Gravity/Horizontal coefficient=%.12g" % (FALLS * case.limits[max(WALLS)]),
                          "Gravity/Static stage=none", "Time/End time=0.5")
    moved = case.moved.blocks.displacement[:, 0]
    case.true("10 % more than the limit: bricks move to the right", moved.max() > 0.1 * WIDTH and moved.min() > -1e-3)


def draw(case, figure):
    from matplotlib.collections import PolyCollection

    axes = figure.subplots()
    axes.add_collection(PolyCollection(case.moved.blocks.final_polygons, facecolors="0.8", edgecolors="k", linewidths=0.6))
    axes.axhline(0, color="k", linewidth=1)
    axes.set(aspect="equal", xlabel="x [m]", ylabel="y [m]", title="pushed by 10 % more than the limit, after 0.5 s", xlim=(-0.5, 3), ylim=(-0.1, 1.9))
