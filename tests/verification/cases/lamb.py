# SPDX-License-Identifier: GPL-3.0-or-later
"""Lamb's problem: vertical displacement of the surface against Cagniard and de Hoop's solution."""

import numpy as np
from lamb_solution import LambSurface

FORCE, FREQUENCY = 1e10, 10.0  # [N/m], [Hz]
DISTANCES = (200, 400)  # [m]

shown = {}


def force(t):
    s = (np.pi * (FREQUENCY * t - 1.5)) ** 2
    return FORCE * (1 - 2 * s) * np.exp(-s)


def check(case, distances=DISTANCES):
    half_space = LambSurface(2700.0, 20.25e9, 0.25)
    run = case.run()
    for r in distances:
        found = -run.history("monitors/r%d/displacement" % r)[:, 1]
        expected = half_space.displacement(r, run.time, force)
        passed = run.time <= r * half_space.rayleigh + 2.8 / FREQUENCY  # the wavelet ends at 3 / f
        case.near("%d m: peak of |u_z|" % r, abs(found[passed]).max(), abs(expected[passed]).max(), 0.01, "m")
        error = np.linalg.norm((found - expected)[passed]) / np.linalg.norm(expected[passed])
        case.below("%d m: relative L2 norm of the difference" % r, error, 0.01)
        crests = [run.time[passed][u[passed].argmax()] for u in (found, expected)]
        case.near("%d m: time of the crest" % r, *crests, 0.005, "s")
        shown[r] = run.time, found, expected
    case.near("Rayleigh speed", 1 / half_space.rayleigh, 0.91940 * half_space.c_s, 1e-4, "m/s")
    case.below("energy residual", run.summary["energy_residual"], 1e-3)


def draw(case, figure):
    axes = figure.subplots(len(shown), 1, sharex=True, squeeze=False)[:, 0]
    for row, (r, (time, found, expected)) in zip(axes, shown.items()):
        row.plot(time, found, color="#1f5a94", lw=1.2, label="program")
        row.plot(time, expected, "k--", lw=0.9, label="closed form")
        row.set_ylabel("%d m" % r)
    axes[0].set_title("vertical displacement [m] (downwards) at distance r from the force")
    axes[0].legend(fontsize=8, loc="upper left")
    axes[-1].set_xlabel("time [s]")
