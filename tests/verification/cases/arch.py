# SPDX-License-Identifier: GPL-3.0-or-later
"""Semicircular arch of voussoirs on level ground: the least thickness that bears its weight, by limit analysis of rigid blocks.

An arch stands if a line of thrust fits into it (Heyman 1969). Joints bear no tension and mu = tan(phi) times what presses them: two forces at
the ends of each joint, in equilibrium with the weights of the voussoirs. Whether there are such forces is a linear programme.
"""

import numpy as np
import scipy.optimize
from scene_numbers import Numbers

CONTINUOUS = 0.1075  # least thickness over radius without end of voussoirs (Milankovitch 1907)
MARGIN = 0.02  # on either side of a limit
CUTS = 5  # bisections of the bracket, for the page
THICK = 0.2  # over the radius: thick enough, so that friction decides, or what pushes it
FALLS = 0.9  # of the least thickness: moves for a second


def voussoirs(ratio, count, radius):
    """Corners of each voussoir, from the right springing to the left one: inner and outer of one joint, outer and inner of the next [m]."""
    angle = np.linspace(0, np.pi, count + 1)
    ray = np.column_stack([np.cos(angle), np.sin(angle)])
    ray[-1, 1] = 0.0
    inner, outer = (1 - ratio / 2) * radius * ray, (1 + ratio / 2) * radius * ray
    return np.stack([inner[:-1], outer[:-1], outer[1:], inner[1:]], axis=1)


def bears(polygons, mu, push=0.0):
    """Whether forces at the ends of the joints can balance the weights (of density and gravity 1) and a part of them to the right."""
    n = len(polygons)
    unknown = lambda joint, end, part: 4 * joint + 2 * end + part  # part 0: pressure, 1: shear along the joint, outwards
    equations, weights = np.zeros((3 * n, 4 * (n + 1))), np.zeros(3 * n)
    for k, polygon in enumerate(polygons):
        x, y = polygon.T
        cross = x * np.roll(y, -1) - np.roll(x, -1) * y
        area = cross.sum() / 2
        centre = np.array([((x + np.roll(x, -1)) * cross).sum(), ((y + np.roll(y, -1)) * cross).sum()]) / (6 * area)
        weights[3 * k : 3 * k + 3] = -push * area, area, area * (centre[0] + push * centre[1])
        for joint, places, sign in ((k, polygon[:2], 1), (k + 1, polygon[[3, 2]], -1)):
            along = (places[1] - places[0]) / np.linalg.norm(places[1] - places[0])
            across = np.array([-along[1], along[0]])  # into the voussoir above the joint
            for end, place in enumerate(places):
                for part, direction in enumerate((sign * across, sign * along)):
                    column = unknown(joint, end, part)
                    equations[3 * k : 3 * k + 2, column] = direction
                    equations[3 * k + 2, column] = place[0] * direction[1] - place[1] * direction[0]
    friction = np.zeros((4 * (n + 1), 4 * (n + 1)))  # +-T - mu N <= 0
    for row, (joint, end, sign) in enumerate((j, e, s) for j in range(n + 1) for e in (0, 1) for s in (1, -1)):
        friction[row, unknown(joint, end, 1)] = sign
        friction[row, unknown(joint, end, 0)] = -mu
    bounds = [(0, None), (None, None)] * (2 * (n + 1))
    found = scipy.optimize.linprog(np.zeros(4 * (n + 1)), friction, np.zeros(len(friction)), equations, weights, bounds, method="highs")
    return found.status == 0


def least(holds, low, high):
    """Where holds() begins, between low, where it is false, and high."""
    for _ in range(40):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if holds(middle) else (middle, high)
    return high


class Arch:
    """The arch of a run, in other thicknesses."""

    def __init__(self, case, run):
        numbers = Numbers(run)
        polygons = run.blocks.polygons
        self.case, self.count = case, len(polygons)
        self.radius = 0.5 * np.linalg.norm(polygons[0], axis=1)[:2].sum()
        self.ratio = (np.linalg.norm(polygons[0][1]) - np.linalg.norm(polygons[0][0])) / self.radius
        self.mu = np.tan(np.radians(numbers.number("Materials/rock/Friction angle")))

    def polygons(self, ratio):
        return voussoirs(ratio, self.count, self.radius)

    def run(self, name, ratio, mu, *overrides):
        file = self.case.work / (name + ".csv")
        rows = ["%d,%.17g,%.17g" % (k + 1, *corner) for k, polygon in enumerate(self.polygons(ratio)) for corner in polygon]
        file.write_text("\n".join(["block,x,y"] + rows) + "\n")
        return self.case.run(name, "Mesh/Polygons file=%s" % file.resolve(),
                             "Materials/rock/Friction angle=%.12g" % np.degrees(np.arctan(mu)), *overrides)

    def stands(self, ratio, mu, push=0.0):
        run = self.run("t_%.6f_mu_%.6f_k_%.6f" % (ratio, mu, push), ratio, mu, "Gravity/Horizontal coefficient=%.12g" % push,
                       "Gravity/Static stage=equilibrium or move")
        return run.summary["static_stage"]["equilibrium"]


def bracket(case, what, limit, stands, sign=1):
    """The limit as hybrid has it, by bisection from 2 % on either side of that of limit analysis. sign: -1 where less stands."""
    falls, bears_it = (1 - sign * MARGIN) * limit, (1 + sign * MARGIN) * limit
    case.true("%s = %.4f, %g %% on the safe side of limit analysis: it stands" % (what, bears_it, 100 * MARGIN), stands(bears_it))
    case.true("%s = %.4f, %g %% on the other: it does not" % (what, falls, 100 * MARGIN), not stands(falls))
    for _ in range(CUTS):
        middle = 0.5 * (falls + bears_it)
        falls, bears_it = (falls, middle) if stands(middle) else (middle, bears_it)
    case.near("%s at the limit, within %.2g" % (what, abs(bears_it - falls)), 0.5 * (falls + bears_it), limit, MARGIN)


def check(case):
    arch = case.arch = Arch(case, case.run())
    case.true("the scene's arch is the one that is analysed",
              np.allclose(case.run("again").blocks.polygons, arch.polygons(arch.ratio), atol=1e-6))
    thin = case.thin = least(lambda ratio: bears(arch.polygons(ratio), arch.mu), 0.05, 0.2)
    case.near("least thickness over radius by limit analysis, and of a continuous arch", thin, CONTINUOUS, 0.03)
    bracket(case, "thickness over radius", thin, lambda ratio: arch.stands(ratio, arch.mu))
    smooth = least(lambda mu: bears(arch.polygons(THICK), mu), 0.1, 1.0)
    bracket(case, "thickness 0.2 R: tan(phi)", smooth, lambda mu: arch.stands(THICK, mu))
    push = least(lambda k: not bears(arch.polygons(THICK), arch.mu, k), 0.0, 1.0)
    bracket(case, "thickness 0.2 R: horizontal coefficient", push, lambda k: arch.stands(THICK, arch.mu, k), sign=-1)
    case.moved = arch.run("moves", FALLS * thin, arch.mu, "Gravity/Static stage=none", "Time/End time=1")
    case.true("an arch of %g of the least thickness falls" % FALLS, case.moved.blocks.displacement.min() < -0.1 * arch.radius)


def draw(case, figure):
    from matplotlib.collections import PolyCollection

    left, right = figure.subplots(1, 2)
    for axes, polygons, title in ((left, case.moved.blocks.polygons, "%.3f R thick" % (FALLS * case.thin)),
                                  (right, case.moved.blocks.final_polygons, "after 1 s")):
        axes.add_collection(PolyCollection(polygons, facecolors="0.8", edgecolors="k", linewidths=0.6))
        axes.axhline(0, color="k", linewidth=1)
        axes.set(aspect="equal", xlabel="x [m]", ylabel="y [m]", title=title, xlim=(-6.5, 6.5), ylim=(-0.5, 6))
