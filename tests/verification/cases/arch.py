# SPDX-License-Identifier: GPL-3.0-or-later
"""Semicircular arch of voussoirs on level ground: the least thickness that bears its weight, by limit analysis of rigid blocks.

An arch stands if a line of thrust fits into it (Heyman 1969). Joints bear no tension and mu = tan(phi) times what presses them
(rigid_blocks.py).
"""

import numpy as np
from rigid_blocks import Assembly
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


def assembly(polygons):
    joints = [(k, k - 1 if k > 0 else None, polygon[:2]) for k, polygon in enumerate(polygons)]
    return Assembly(polygons, joints + [(len(polygons) - 1, None, polygons[-1][2:])])


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
    thin = case.thin = least(lambda ratio: assembly(arch.polygons(ratio)).bears(arch.mu), 0.05, 0.2)
    case.near("least thickness over radius by limit analysis, and of a continuous arch", thin, CONTINUOUS, 0.03)
    bracket(case, "thickness over radius", thin, lambda ratio: arch.stands(ratio, arch.mu))
    smooth = least(lambda mu: assembly(arch.polygons(THICK)).bears(mu), 0.1, 1.0)
    bracket(case, "thickness 0.2 R: tan(phi)", smooth, lambda mu: arch.stands(THICK, mu))
    push = assembly(arch.polygons(THICK)).largest_push(arch.mu)
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
