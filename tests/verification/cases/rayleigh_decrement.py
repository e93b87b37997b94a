# SPDX-License-Identifier: GPL-3.0-or-later
"""Free vibration of a continuum column: zeta = alpha_M / (2 w) + beta_K w / 2, f1 = c_p / (4 H)."""

import numpy as np
from free_decay import Decay, draw_decay

BEGIN = 2.0  # the Ricker pulse of 1.7 Hz lasts 1.8 s
DENSITY, YOUNG, POISSON, HEIGHT = 2000.0, 450e6, 0.25, 50.0
MODULUS = YOUNG * (1 - POISSON) / ((1 + POISSON) * (1 - 2 * POISSON))  # lambda + 2 G [Pa]
OMEGA = np.pi / 2 * np.sqrt(MODULUS / DENSITY) / HEIGHT

shown = {}


def check(case):
    for name, alpha, beta in (("default", 0.4, 0.003), ("mass", 0.4, 0.0), ("stiffness", 0.0, 0.003), ("none", 0.0, 0.0)):
        run = case.run(name, "Continuum/Rayleigh mass=%g" % alpha, "Continuum/Rayleigh stiffness=%g" % beta)
        u = run.history("monitors/top/displacement")[:, 1]
        decay = Decay(run.time, u, BEGIN, 2 * np.pi / OMEGA)
        expected = alpha / (2 * OMEGA) + beta * OMEGA / 2
        case.near(name + ": frequency", decay.frequency, OMEGA / (2 * np.pi), 0.001, "Hz")
        if expected == 0:
            case.below("none: damping ratio", decay.ratio, 1e-5)
        else:
            case.near(name + ": damping ratio", decay.ratio, expected, 0.01)
        case.below("energy residual", run.summary["energy_residual"], 1e-3)
        if name == "default":
            shown.update(time=run.time, u=u, ratio=expected)


def draw(case, figure):
    axes = figure.subplots()
    draw_decay(axes, shown["time"], shown["u"], BEGIN, OMEGA, shown["ratio"], "closed form")
    axes.set_xlabel("time [s]")
    axes.set_title("Rayleigh damping, alpha_M = 0.4 1/s, beta_K = 3 ms")
