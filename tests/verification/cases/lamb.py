# SPDX-License-Identifier: GPL-3.0-or-later
"""Lamb's problem: vertical displacement of the surface against Cagniard and de Hoop's solution."""

import numpy as np
from lamb_solution import LambSurface
from scene_numbers import Numbers

DISTANCES = (200, 400)  # [m]

shown = {}


def check(case, distances=DISTANCES):
    run = case.run()
    numbers = Numbers(run)
    rock, frequency = numbers.material("rock"), numbers.number("Point loads/Frequency")
    peak = -float(numbers.text("Point loads/Forces").split(",")[-1])  # downwards [N/m]
    half_space = LambSurface(rock.density, rock.young, rock.poisson)

    def force(t):
        s = (np.pi * (frequency * t - 1.5)) ** 2
        return peak * (1 - 2 * s) * np.exp(-s)

    for r in distances:
        found = -run.history("monitors/r%d/displacement" % r)[:, 1]
        expected = half_space.displacement(r, run.time, force)
        passed = run.time <= r * half_space.rayleigh + 2.8 / frequency  # the wavelet ends at 3 / f
        case.near("%d m: peak of |u_z|" % r, abs(found[passed]).max(), abs(expected[passed]).max(), 0.01, "m")
        error = np.linalg.norm((found - expected)[passed]) / np.linalg.norm(expected[passed])
        case.below("%d m: relative L2 norm of the difference" % r, error, 0.01)
        crests = [run.time[passed][u[passed].argmax()] for u in (found, expected)]
        case.near("%d m: time of the crest" % r, *crests, 0.005, "s")
        shown[r] = run.time, found, expected
    if rock.poisson == 0.25:
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
