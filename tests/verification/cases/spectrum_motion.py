# SPDX-License-Identifier: GPL-3.0-or-later
"""The motion of the base has the response spectrum that was asked for."""

import numpy as np
from hybrid_run import pseudo_acceleration
from scene_numbers import Numbers

GROUND = 0.1 * 9.80665  # a_g of eurocode8_type1_b.csv [m/s2]

shown = {}


def target(period):
    """EN 1998-1, equations 3.2-3.5 with S = 1.2, T_B = 0.15, T_C = 0.5, T_D = 2 s [m/s2]."""
    t, s = np.asarray(period), 1.2
    return GROUND * s * np.select([t < 0.15, t < 0.5, t < 2.0], [1 + 1.5 * t / 0.15, 2.5, 2.5 * 0.5 / t], 2.5 / t**2)


def check(case):
    run = case.run()
    time, a = run.time, run.history("monitors/base/acceleration")[:, 0]
    numbers = Numbers(run)
    lowest, highest, damping, duration = (
        numbers.number("Motion/" + name) for name in ("Lowest frequency", "Highest frequency", "Spectrum damping", "Duration"))
    frequency, over = np.geomspace(lowest, highest, 60), time > duration + 0.01
    reached = pseudo_acceleration(a, time[1] - time[0], frequency, damping)
    misfit = np.abs(reached / target(1 / frequency) - 1)
    case.below("mean misfit of the base's response spectrum", misfit.mean(), 0.05)
    case.below("largest misfit", misfit.max(), 0.15)
    u, v = run.history("input/displacement")[:, 0], run.history("input/velocity")[:, 0]
    case.below("velocity after the motion over its peak", np.abs(v[over]).max() / np.abs(v).max(), 1e-9)
    case.below("displacement after the motion over its peak", np.abs(u[over]).max() / np.abs(u).max(), 1e-9)
    case.near("spectrum recorded in the run", run.get("spectrum/reached").mean(),
              pseudo_acceleration(run.history("input/acceleration")[:, 0], time[1] - time[0],
                                  run.get("spectrum/frequency"), damping).mean(), 0.01, "m/s2")
    shown.update(time=time, a=a, period=1 / frequency, reached=reached)


def draw(case, figure):
    history, spectrum = figure.subplots(1, 2, width_ratios=[1.4, 1])
    history.plot(shown["time"], shown["a"], lw=0.6)
    history.set_xlabel("time [s]")
    history.set_ylabel("acceleration of the base [m/s²]")
    spectrum.loglog(shown["period"], shown["reached"], label="program")
    spectrum.loglog(shown["period"], target(shown["period"]), "k--", label="Eurocode 8")
    spectrum.set_xlabel("period [s]")
    spectrum.set_ylabel("pseudo-acceleration, 5 % damping [m/s²]")
    spectrum.legend()
