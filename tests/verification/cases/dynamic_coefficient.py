# SPDX-License-Identifier: GPL-3.0-or-later
"""Free fall with k01: v_n = -g dt (1 - k01^n) / (1 - k01)."""

import os

import numpy as np

GRAVITY, STEP = 9.81, 1e-3

shown = {}


def velocity(steps, k01):
    """After each of the first steps [m/s]."""
    n = np.arange(1, steps + 1)
    return -GRAVITY * STEP * (n if k01 == 1 else (1 - k01 ** n) / (1 - k01))


def check(case):
    for k01 in (0.98, 0.9, 1.0):
        run = case.run("k01_%g" % k01, "Time/Dynamic coefficient=%g" % k01)
        v = run.history("monitors/block/velocity")[:, 1]
        expected = velocity(len(v), k01)
        case.below("k01 = %g: velocity against the recurrence" % k01, np.abs(v - expected).max(),
                   1e-9 * np.abs(expected).max(), "m/s")
        case.below("k01 = %g: energy residual" % k01, run.summary["energy_residual"], 1e-9)
        shown[k01] = run.time, v, expected
    case.near("terminal velocity", -shown[0.98][1][-1], GRAVITY * STEP / (1 - 0.98), 1e-4, "m/s")
    said = open(os.path.join(case.work, "k01_0.98", "log.txt"), encoding="utf-8").read()
    case.true("the log says rate and terminal velocity", "damping rate 20 1/s" in said and "0.4905 m/s" in said)


def draw(case, figure):
    axes = figure.subplots()
    for k01, (time, v, expected) in shown.items():
        axes.plot(time, -v, lw=2.4, alpha=0.5, label="program, k01 = %g" % k01)
        axes.plot(time, -expected, "k--", lw=1)
    axes.set_ylim(0, 1)
    axes.set_xlabel("time [s]")
    axes.set_ylabel("velocity of fall [m/s]")
    axes.legend()
