# SPDX-License-Identifier: GPL-3.0-or-later
"""Plane pulse through bonded blocks: v(y, t) = v_base(t - y / c), c = sqrt(E / rho) for nu = 0."""

import numpy as np
from scene_numbers import Numbers


def check(case):
    run = case.run()
    numbers = Numbers(run)
    case.speed, case.station = numbers.material("rock").speed("P"), numbers.point("station")[1]
    case.histories = histories(run, 1)
    travel = case.station / case.speed
    judge(case, "blocks of the scene", *case.histories, travel)
    width, size = numbers.mesh("Width"), numbers.mesh("Resolution/h")
    fine = case.run("fine", "Monitors/Points=station: %.10g, %.10g" % (width / 4, case.station),
                    mesh={"Width": width / 2, "Resolution/h": size / 2})
    judge(case, "blocks of half the size", *histories(fine, 1), travel)


def histories(run, component):
    """Time, velocity of the base and at the station [m/s]."""
    return run.time, run.history("input/velocity")[:, component], run.history("monitors/station/velocity")[:, component]


def judge(case, what, time, base, station, travel):
    """Arrival and amplitude of the pulse before its reflection from the top."""
    direct = time < travel + pulse_end(time, base)
    (t0, v0), (t1, v1) = peak(time, base), peak(time[direct], station[direct])
    case.near("travel time, " + what, t1 - t0, travel, 0.01, "s")
    case.near("amplitude, " + what, v1, v0, 0.02, "m/s")


def pulse_end(time, v):
    return time[np.nonzero(np.abs(v) > 0.01 * np.abs(v).max())[0][-1]]


def peak(time, v):
    """Time and value of the highest sample, refined by a parabola."""
    k = int(np.argmax(v))
    left, middle, right = v[k - 1 : k + 2]
    part = 0.5 * (left - right) / (left - 2 * middle + right)
    return time[k] + part * (time[1] - time[0]), middle - 0.25 * (left - right) * part


def draw(case, figure):
    draw_pulse(case, figure)


def draw_pulse(case, figure):
    """case.histories over the input, delayed by the travel time to case.station [m] at case.speed [m/s]."""
    axes = figure.subplots()
    time, base, station = case.histories
    axes.plot(time, 1e3 * base, color="C1", label="base (input)")
    axes.plot(time + case.station / case.speed, 1e3 * base, color="0.6", linewidth=4,
              label="closed form at %g m" % case.station)
    axes.plot(time, 1e3 * station, color="C0", label="hybrid at %g m (then the reflection from the top)" % case.station)
    axes.set(xlabel="time [s]", ylabel="velocity [mm/s]", xlim=(0, time[-1]))
    axes.legend()
