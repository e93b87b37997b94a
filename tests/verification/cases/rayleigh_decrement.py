# SPDX-License-Identifier: GPL-3.0-or-later
"""Free vibration of a continuum column: zeta = alpha_M / (2 w) + beta_K w / 2, f1 = c_p / (4 H)."""

import numpy as np
from free_decay import Decay, draw_decay
from scene_numbers import Numbers

BEGIN = 2.0  # the Ricker pulse of 1.7 Hz lasts 1.8 s

shown = {}


def check(case):
    for name, alpha, beta in (("default", 0.4, 0.003), ("mass", 0.4, 0.0), ("stiffness", 0.0, 0.003), ("none", 0.0, 0.0)):
        run = case.run(name, "Continuum/Rayleigh mass=%g" % alpha, "Continuum/Rayleigh stiffness=%g" % beta)
        numbers = Numbers(run)
        omega = np.pi / 2 * numbers.material("rock").speed("P") / numbers.mesh("Height")
        u = run.history("monitors/top/displacement")[:, 1]
        decay = Decay(run.time, u, BEGIN, 2 * np.pi / omega)
        expected = alpha / (2 * omega) + beta * omega / 2
        case.near(name + ": frequency", decay.frequency, omega / (2 * np.pi), 0.001, "Hz")
        if expected == 0:
            case.below("none: damping ratio", decay.ratio, 1e-5)
        else:
            case.near(name + ": damping ratio", decay.ratio, expected, 0.01)
        case.below("energy residual", run.summary["energy_residual"], 1e-3)
        if name == "default":
            shown.update(time=run.time, u=u, ratio=expected, omega=omega)


def draw(case, figure):
    axes = figure.subplots()
    draw_decay(axes, shown["time"], shown["u"], BEGIN, shown["omega"], shown["ratio"], "closed form")
    axes.set_xlabel("time [s]")
    axes.set_title("Rayleigh damping, alpha_M = 0.4 1/s, beta_K = 3 ms")
