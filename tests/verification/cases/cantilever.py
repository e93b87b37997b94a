# SPDX-License-Identifier: GPL-3.0-or-later
"""Cantilever under its own weight in plane strain (Timoshenko): w(x) from the wall, E' = E / (1 - nu^2), I = d^3 / 12,

    w = q / (24 E' I) (x^4 - 4 L x^3 + 6 L^2 x^2) + q / (kappa G A) (L x - x^2 / 2),   kappa = 10 (1 + nu) / (12 + 11 nu)
"""

import numpy as np

GRAVITY, DENSITY, E, NU, LENGTH, DEPTH = 9.81, 2500.0, 10e9, 0.25, 8.0, 1.0  # SI


def deflection(x):
    q = DENSITY * GRAVITY * DEPTH  # N/m per metre of thickness
    bending = E / (1 - NU**2) * DEPTH**3 / 12
    shear = 10 * (1 + NU) / (12 + 11 * NU) * E / (2 * (1 + NU)) * DEPTH
    return q / (24 * bending) * (x**4 - 4 * LENGTH * x**3 + 6 * LENGTH**2 * x**2) + q / shear * (LENGTH * x - x**2 / 2)


def axis(run):
    """Distance from the wall [m] and deflection [m] of the vertices at half depth, in order."""
    start, end = run.get("section/blocks_points"), run.get("section/blocks_points_final")
    middle = np.abs(start[:, 1] - DEPTH / 2) < 1e-6
    x, w = -start[middle, 0], (start - end)[middle, 1]
    places = np.unique(x.round(6))
    return places, np.array([w[np.abs(x - place) < 1e-5].mean() for place in places])


def check(case):
    case.curves = {}
    for n in (4, 8, 16):
        size = "Mesh/Numbers=Angle = 90; Width = 1; Height = 8; Resolution/h = %g" % (DEPTH / n)
        run = case.run() if n == 16 else case.run("through_%d" % n, size)
        case.curves[n] = axis(run)
    expected = deflection(LENGTH)
    case.near("deflection of the tip, 16 through the depth", case.curves[16][1][-1], expected, 0.03, "m")
    errors = [abs(case.curves[n][1][-1] / expected - 1) for n in (4, 8, 16)]
    case.true("the error falls with the mesh size: %.3g, %.3g, %.3g" % tuple(errors), errors[0] > 2 * errors[1] > 4 * errors[2])


def draw(case, figure):
    axes = figure.subplots()
    x = np.linspace(0, LENGTH, 200)
    axes.plot(x, 1e3 * deflection(x), color="0.6", linewidth=4, label="Timoshenko")
    for n, (place, w) in case.curves.items():
        axes.plot(place, 1e3 * w, label="hybrid, %d through the depth" % n)
    axes.set(xlabel="distance from the wall [m]", ylabel="deflection [mm]")
    axes.invert_yaxis()
    axes.legend()
