# SPDX-License-Identifier: GPL-3.0-or-later
"""Free fall with k01: v_n = -g dt (1 - k01^n) / (1 - k01)."""

import os

import numpy as np
from scene_numbers import Numbers

shown = {}


def gain(run):
    """Of velocity in a step without the coefficient [m/s]."""
    numbers = Numbers(run)
    return numbers.gravity() * numbers.number("Time/Time step")


def velocity(run, k01):
    """After each step [m/s]."""
    n = np.arange(1, len(run.time) + 1)
    return -gain(run) * (n if k01 == 1 else (1 - k01 ** n) / (1 - k01))


def check(case):
    for k01 in (0.98, 0.9, 1.0):
        run = case.run("k01_%g" % k01, "Time/Dynamic coefficient=%g" % k01)
        v = run.history("monitors/block/velocity")[:, 1]
        expected = velocity(run, k01)
        case.below("k01 = %g: velocity against the recurrence" % k01, np.abs(v - expected).max(),
                   1e-9 * np.abs(expected).max(), "m/s")
        case.below("k01 = %g: energy residual" % k01, run.summary["energy_residual"], 1e-9)
        shown[k01] = run.time, v, expected
        if k01 == 0.98:
            terminal = gain(run) / (1 - k01)
    case.near("terminal velocity", -shown[0.98][1][-1], terminal, 1e-4, "m/s")
    said = open(os.path.join(case.work, "k01_0.98", "log.txt"), encoding="utf-8").read()
    case.true("the log says rate and terminal velocity", "terminal velocity of a free fall %.4g m/s" % terminal in said and "damping rate" in said)


def draw(case, figure):
    axes = figure.subplots()
    for k01, (time, v, expected) in shown.items():
        axes.plot(time, -v, lw=2.4, alpha=0.5, label="program, k01 = %g" % k01)
        axes.plot(time, -expected, "k--", lw=1, label="recurrence" if k01 == 1 else None)
    axes.set_ylim(0, 1)
    axes.set_xlabel("time [s]")
    axes.set_ylabel("velocity of fall [m/s]")
    axes.legend()
