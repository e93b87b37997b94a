# SPDX-License-Identifier: GPL-3.0-or-later
"""Heave of a floating block: w^2 = rho_w g / (rho h)."""

import numpy as np

GRAVITY, DENSITY, WATER, HEIGHT, DEEP = 9.81, 500.0, 1000.0, 1.0, 0.1
OMEGA = np.sqrt(WATER * GRAVITY / (DENSITY * HEIGHT))

shown = {}


def crossings(time, y):
    k = np.flatnonzero(np.diff(np.sign(y)) != 0)
    return time[k] - y[k] * (time[k + 1] - time[k]) / (y[k + 1] - y[k])


def check(case):
    heave = {}
    for method in ("submerged", "pressures"):
        run = case.run(method, "Water/Method=" + method)
        y = run.history("monitors/block/displacement")[:, 1] - DEEP
        heave[method] = y
        zeros = crossings(run.time, y)
        case.near(method + ": period", 2 * np.diff(zeros).mean(), 2 * np.pi / OMEGA, 0.001, "s")
        case.near(method + ": amplitude of the last period", np.abs(y[run.time > 5 - 2 * np.pi / OMEGA]).max(), DEEP,
                  0.005, "m")
        case.below(method + ": energy residual", run.summary["energy_residual"], 1e-4)
        shown[method] = run.time, y
    case.below("submerged less pressures", np.abs(heave["submerged"] - heave["pressures"]).max(), 1e-9, "m")
    for scheme in ("trapezoidal", "dissipative"):
        run = case.run("dropped_" + scheme, "Water/Level=-1.6", "Time/Scheme=" + scheme)
        y = run.history("monitors/block/displacement")[:, 1]
        case.true("dropped, %s: falls into the water (to %.3f m)" % (scheme, y.min()), y.min() < -1.5)
        case.below("dropped, %s: energy residual" % scheme, run.summary["energy_residual"], 1e-4)


def draw(case, figure):
    axes = figure.subplots()
    time = shown["submerged"][0]
    for method, (t, y) in shown.items():
        axes.plot(t, y, lw=3 if method == "submerged" else 1.2, alpha=0.7, label="program, " + method)
    axes.plot(time, -DEEP * np.cos(OMEGA * time), "k--", lw=0.9, label="closed form")
    axes.set_xlabel("time [s]")
    axes.set_ylabel("heave [m]")
    axes.legend(loc="upper right")
