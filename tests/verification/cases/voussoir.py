# SPDX-License-Identifier: GPL-3.0-or-later
"""Voussoir beam of two halves: finite elements of one half with unilateral contact at midspan and at the wall.

By symmetry midspan is a smooth wall: u_x >= 0, no tension. At the abutment u_x <= 0, no tension, and what touches sticks. Small
displacements: contact areas do not depend on the load. Beside it the arch of Diederichs & Kaiser (1999): a rectangular beam whose compression
acts, as a triangle of depth n T at midspan and at the walls, n chosen so that the largest stress is least.
"""

import numpy as np
import scipy.sparse.linalg
from rectangle_elements import Rectangle
from scene_numbers import Numbers

SPANS = (5.0, 15.0)  # of variants [m]
COARSE = (0.25, 0.125)  # blocks of variants [m]
ROWS = 24  # elements through the thickness


class Beam:
    def __init__(self, run):
        numbers = Numbers(run)
        rock = numbers.material("rock")
        self.span, self.thickness = numbers.mesh("Span"), numbers.mesh("Thickness")
        self.young, self.poisson, self.weight = rock.young, rock.poisson, rock.density * numbers.gravity()  # N/m3

    def contact_elements(self):
        """Deflection at midspan [m], thrust [N/m], its height at midspan and at the wall [m]; touching parts of both."""
        half, t = self.span / 2, self.thickness
        grid = Rectangle((half, t), (int(round(half / t * 8)), ROWS), self.young, self.poisson)
        n, load = grid.nodes, np.concatenate([np.zeros(grid.nodes), -self.weight * grid.weights])
        middle, wall = grid.node(0, slice(None)), grid.node(-1, slice(None))
        touches = [grid.y > t / 2, grid.y < t / 2]
        for _ in range(60):
            fixed = np.concatenate([middle[touches[0]], wall[touches[1]], n + wall[touches[1]]])
            free = np.setdiff1d(np.arange(2 * n), fixed)
            u = np.zeros(2 * n)
            u[free] = scipy.sparse.linalg.spsolve(grid.stiffness[free][:, free], load[free])
            r = grid.stiffness @ u - load
            new = [np.where(touches[0], r[middle] > 0, u[middle] < 0), np.where(touches[1], r[wall] < 0, u[wall] > 0)]
            if all(np.array_equal(a, b) for a, b in zip(new, touches)):
                break
            touches = new
        heights = [np.sum(grid.y * r[side] * c) / np.sum(r[side] * c) for side, c in zip((middle, wall), touches)]
        return -u[n + middle[0]], r[middle[touches[0]]].sum(), heights, [c.mean() for c in touches]

    def arch(self):
        """n, deflection [m] and thrust [N/m] of Diederichs & Kaiser (1999)."""
        s, t, modulus = self.span, self.thickness, self.young / (1 - self.poisson**2)
        best = None
        for n in np.arange(0.02, 1, 0.01):
            first = arm = t * (1 - 2 * n / 3)
            for _ in range(100):
                stress = self.weight * s**2 / (4 * n * arm)
                shortening = (s + 8 * first**2 / (3 * s)) * stress / 3 * (2 / 3 + n) / modulus
                left = 8 * first**2 / (3 * s) - shortening
                arm = np.sqrt(3 * s / 8 * left) if left > 0 else np.nan
            if np.isfinite(arm) and (best is None or stress < best[0]):
                best = stress, n, first - arm, self.weight * t * s**2 / (8 * arm)
        return best[1:]


def found(run):
    """Deflection of the lower corners at midspan [m], thrust [N/m], weight on both walls [N/m], height of the thrust at the wall [m]."""
    start, end = run.get("section/blocks_points"), run.get("section/blocks_points_final")
    corner = np.hypot(*start.T) < 1e-6
    force, places = run.get("interface/force")[0].reshape(-1, 2), run.get("interface/position")
    right = places[:, 0] > 0
    thrust = force[right, 0].sum()
    return (start - end)[corner, 1].mean(), thrust, -force[:, 1].sum(), np.sum(force[right, 0] * places[right, 1]) / thrust


def compare(case, name, run, allowed=0.05):
    beam = Beam(run)
    deflection, thrust, weight, height = found(run)
    expected = beam.contact_elements()
    case.near(name + ": deflection at midspan", deflection, expected[0], allowed, "m")
    case.near(name + ": thrust", thrust, expected[1], allowed, "N/m")
    case.below(name + ": height of the thrust at the wall, difference over the thickness",
               (height - expected[2][1]) / beam.thickness, 0.02)
    case.near(name + ": weight on the walls", weight, beam.weight * beam.span * beam.thickness, 1e-5, "N/m")
    print("      contact over %.2f and %.2f of midspan and wall; arch: n %.2f, deflection %.4g m, thrust %.6g N/m"
          % (*expected[3], *beam.arch()))
    return deflection / expected[0], thrust / expected[1]


def check(case):
    first = case.first = case.run()
    numbers = Numbers(first)
    case.ratios = {numbers.mesh("Resolution/h"): compare(case, "span %g m" % numbers.mesh("Span"), first)}
    for span in SPANS:
        compare(case, "span %g m" % span, case.run("span_%g" % span, mesh={"Span": span}))
    for h in COARSE:
        beam, run = Beam(first), case.run("h_%g" % h, mesh={"Resolution/h": h})
        expected = beam.contact_elements()
        case.ratios[h] = found(run)[0] / expected[0], found(run)[1] / expected[1]
    errors = [abs(case.ratios[h][0] - 1) for h in sorted(case.ratios, reverse=True)]
    case.true("the error of the deflection falls with the size of the blocks: %.3g, %.3g, %.3g" % tuple(errors),
              errors[0] > 2 * errors[1] > 4 * errors[2])


def draw(case, figure):
    from matplotlib.collections import PolyCollection

    left, right = figure.subplots(2, 1, height_ratios=(1.3, 1))
    blocks = case.first.blocks
    scaled = [a + 200 * (b - a) for a, b in zip(blocks.polygons, blocks.final_polygons)]
    left.add_collection(PolyCollection(scaled, facecolors="0.85", edgecolors="0.5", linewidths=0.2))
    left.set(aspect="equal", xlabel="x [m]", ylabel="y [m]", title="displacements 200 times as large")
    left.autoscale()
    sizes = sorted(case.ratios)
    for k, name in ((0, "deflection"), (1, "thrust")):
        right.loglog(sizes, [abs(1 - case.ratios[h][k]) for h in sizes], "o-", label=name)
    right.set(xlabel="size of the blocks [m]", ylabel="error [-]")
    right.legend()
