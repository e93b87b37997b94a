# SPDX-License-Identifier: GPL-3.0-or-later
"""Cantilever under its own weight in plane strain (Timoshenko): w(x) from the wall, E' = E / (1 - nu^2), I = d^3 / 12,

    w = q / (24 E' I) (x^4 - 4 L x^3 + 6 L^2 x^2) + q / (kappa G A) (L x - x^2 / 2),   kappa = 10 (1 + nu) / (12 + 11 nu)
"""

import numpy as np
from scene_numbers import Numbers


class Beam:
    def __init__(self, run):
        numbers = Numbers(run)
        rock = numbers.material("rock")
        self.length, self.depth = numbers.mesh("Height"), numbers.mesh("Width")  # the mesh is drawn upright [m]
        self.load = rock.density * numbers.gravity() * self.depth  # [N/m]
        nu = rock.poisson
        self.bending = rock.young / (1 - nu**2) * self.depth**3 / 12
        self.shear = 10 * (1 + nu) / (12 + 11 * nu) * rock.shear_modulus * self.depth

    def deflection(self, x):
        length = self.length
        bent = self.load / (24 * self.bending) * (x**4 - 4 * length * x**3 + 6 * length**2 * x**2)
        return bent + self.load / self.shear * (length * x - x**2 / 2)


def axis(run):
    """Distance from the wall [m] and deflection [m] of the vertices at half depth, in order."""
    half = Beam(run).depth / 2
    start, end = run.get("section/blocks_points"), run.get("section/blocks_points_final")
    middle = np.abs(start[:, 1] - half) < 1e-6
    x, w = -start[middle, 0], (start - end)[middle, 1]
    places = np.unique(x.round(6))
    return places, np.array([w[np.abs(x - place) < 1e-5].mean() for place in places])


def check(case):
    run = case.run()
    beam = case.beam = Beam(run)
    case.curves = {n: axis(run if n == 16 else case.run("through_%d" % n, mesh={"Resolution/h": beam.depth / n}))
                   for n in (4, 8, 16)}
    expected = beam.deflection(beam.length)
    case.near("deflection of the tip, 16 through the depth", case.curves[16][1][-1], expected, 0.03, "m")
    errors = [abs(case.curves[n][1][-1] / expected - 1) for n in (4, 8, 16)]
    case.true("the error falls with the mesh size: %.3g, %.3g, %.3g" % tuple(errors), errors[0] > 2 * errors[1] > 4 * errors[2])


def draw(case, figure):
    axes = figure.subplots()
    x = np.linspace(0, case.beam.length, 200)
    axes.plot(x, 1e3 * case.beam.deflection(x), color="0.6", linewidth=4, label="Timoshenko")
    for n, (place, w) in case.curves.items():
        axes.plot(place, 1e3 * w, label="hybrid, %d through the depth" % n)
    axes.set(xlabel="distance from the wall [m]", ylabel="deflection [mm]")
    axes.invert_yaxis()
    axes.legend()
