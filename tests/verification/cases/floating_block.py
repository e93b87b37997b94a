# SPDX-License-Identifier: GPL-3.0-or-later
"""Heave of a floating block: w^2 = rho_w g / (rho h)."""

import numpy as np
import water_methods_figure
from scene_numbers import Numbers

HEIGHT, BOTTOM = 1.0, -0.6  # of floating_block.csv [m]

shown = {}


class Floating:
    def __init__(self, run):
        n = Numbers(run)
        draught = n.material(n.text("Blocks/Material")).density / n.number("Water/Density") * HEIGHT  # at rest [m]
        self.rise = n.number("Water/Level") - draught - BOTTOM  # from the start to rest [m]
        self.omega = np.sqrt(n.gravity() / draught)

    def heave(self, time):
        """From rest's place [m]."""
        return -self.rise * np.cos(self.omega * time)


def crossings(time, y):
    k = np.flatnonzero(np.diff(np.sign(y)) != 0)
    return time[k] - y[k] * (time[k + 1] - time[k]) / (y[k + 1] - y[k])


def check(case):
    heave = {}
    for method in ("submerged", "pressures"):
        run = case.run(method, "Water/Method=" + method)
        floating = Floating(run)
        y = run.history("monitors/block/displacement")[:, 1] - floating.rise
        heave[method] = y
        zeros = crossings(run.time, y)
        case.near(method + ": period", 2 * np.diff(zeros).mean(), 2 * np.pi / floating.omega, 0.001, "s")
        case.near(method + ": amplitude of the last period", np.abs(y[run.time > run.time[-1] - 2 * np.pi / floating.omega]).max(),
                  abs(floating.rise), 0.005, "m")
        case.below(method + ": energy residual", run.summary["energy_residual"], 1e-4)
        shown[method] = run.time, y, floating.heave(run.time)
    case.below("submerged less pressures", np.abs(heave["submerged"] - heave["pressures"]).max(), 1e-9, "m")
    for scheme in ("trapezoidal", "filtered", "dissipative"):
        run = case.run("dropped_" + scheme, "Water/Level=-1.6", "Time/Scheme=" + scheme)
        y = run.history("monitors/block/displacement")[:, 1]
        case.true("dropped, %s: falls into the water (to %.3f m)" % (scheme, y.min()), y.min() < -1.5)
        case.below("dropped, %s: energy residual" % scheme, run.summary["energy_residual"], 1e-4)


def draw(case, figure):
    water_methods_figure.draw(figure, shown, "heave [m]")
