# SPDX-License-Identifier: GPL-3.0-or-later
"""Free vibration of bonded blocks: zeta_1 = zeta f1 / f."""

import numpy as np
from free_decay import Decay, draw_decay
from scene_numbers import Numbers

BEGIN = 2.2  # the Ricker pulse of 1.5 Hz lasts 2 s

shown = {}


def top(run):
    return run.time, run.history("monitors/top/displacement")[:, 0]


def check(case):
    time, u = top(case.run("undamped", "Blocks/Damping ratio=0"))
    crossings = np.flatnonzero(np.diff(np.sign(u[time >= BEGIN])))
    period = 2 * np.diff(crossings).mean() * (time[1] - time[0])
    free = Decay(time, u, BEGIN, period)
    case.below("damping ratio of the undamped column", free.ratio, 1e-5)
    for ratio, overrides in ((0.05, ()), (0.02, ("Blocks/Damping ratio=0.02",))):
        run = case.run("ratio_%g" % ratio, *overrides)
        time, u = top(run)
        decay = Decay(time, u, BEGIN, period)
        damping_frequency = Numbers(run).number("Blocks/Damping frequency")
        expected = ratio * free.frequency / damping_frequency
        case.near("damping ratio of the mode at %.4g Hz with %g at %g Hz" % (free.frequency, ratio, damping_frequency),
                  decay.ratio, expected, 0.01)
        case.near("logarithmic decrement", decay.decrement, 2 * np.pi * expected / np.sqrt(1 - expected ** 2), 0.01)
        case.below("energy residual", run.summary["energy_residual"], 1e-3)
        if ratio == 0.05:
            shown.update(time=time, u=u, omega=free.omega, ratio=expected)


def draw(case, figure):
    axes = figure.subplots()
    draw_decay(axes, shown["time"], shown["u"], BEGIN, shown["omega"], shown["ratio"], "closed form")
    axes.set_xlabel("time [s]")
    axes.set_title("bonded blocks, 5 % at 4 Hz")
