# SPDX-License-Identifier: GPL-3.0-or-later
"""Plane S pulse through bonded blocks: v(y, t) = v_base(t - y / c), c = sqrt(G / rho), G = E / 2 for nu = 0.

The first trough is judged: it is through before the waves from the sides and the reflection from the top arrive.
"""

from bonded_bar import draw_pulse, histories, peak
from scene_numbers import Numbers


def check(case):
    run = case.run()
    case.speed, case.station = Numbers(run).material("rock").speed("S"), Numbers(run).point("station")[1]
    travel = case.station / case.speed
    case.histories = time, base, station = histories(run, 0)
    t0, v0 = peak(time, -base)
    direct = time < t0 + 1.5 * travel
    t1, v1 = peak(time[direct], -station[direct])
    case.near("travel time, S pulse", t1 - t0, travel, 0.01, "s")
    case.near("amplitude, S pulse", v1, v0, 0.02, "m/s")


def draw(case, figure):
    draw_pulse(case, figure)
