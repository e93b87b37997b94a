# SPDX-License-Identifier: GPL-3.0-or-later
"""Plane S pulse through bonded blocks: v(y, t) = v_base(t - y / c), c = sqrt(G / rho), G = E / 2 for nu = 0.

The first trough is judged: it is through before the waves from the sides and the reflection from the top arrive.
"""

import numpy as np
from bonded_bar import histories, peak

DENSITY, E, STATION = 2000.0, 160e6, 14.0  # kg/m3, Pa, m


def check(case):
    run = case.run()
    case.speed = np.sqrt(0.5 * E / DENSITY)
    travel = STATION / case.speed
    case.histories = time, base, station = histories(run, 0)
    t0, v0 = peak(time, -base)
    direct = time < t0 + 1.5 * travel
    t1, v1 = peak(time[direct], -station[direct])
    case.near("travel time, S pulse", t1 - t0, travel, 0.01, "s")
    case.near("amplitude, S pulse", v1, v0, 0.02, "m/s")


def draw(case, figure):
    axes = figure.subplots()
    time, base, station = case.histories
    axes.plot(time, 1e3 * base, color="C1", label="base (input)")
    axes.plot(time + STATION / case.speed, 1e3 * base, color="0.6", linewidth=4, label="closed form at 14 m")
    axes.plot(time, 1e3 * station, color="C0", label="hybrid at 14 m (then the reflection from the top)")
    axes.set(xlabel="time [s]", ylabel="velocity [mm/s]", xlim=(0, time[-1]))
    axes.legend()
