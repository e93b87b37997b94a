# SPDX-License-Identifier: GPL-3.0-or-later
"""Plane pulse through bonded blocks: v(y, t) = v_base(t - y / c), c = sqrt(E / rho) for nu = 0."""

import numpy as np

DENSITY, E, STATION = 2000.0, 200e6, 40.0  # kg/m3, Pa, m


def check(case):
    case.speed = np.sqrt(E / DENSITY)
    case.run_data = case.run()
    time, base, station = histories(case.run_data, 1)
    case.histories = time, base, station
    judge(case, "blocks of 1 m", time, base, station, STATION / case.speed)
    fine = case.run("fine", "Mesh/Numbers=Width = 1; Height = 80; Resolution/h = 0.5", "Monitors/Points=station: 0.5, 40")
    judge(case, "blocks of 0.5 m", *histories(fine, 1), STATION / case.speed)


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
    draw_pulse(case, figure, STATION)


def draw_pulse(case, figure, station_height):
    """case.histories over the input, delayed by the travel time to station_height [m] at case.speed [m/s]."""
    axes = figure.subplots()
    time, base, station = case.histories
    axes.plot(time, 1e3 * base, color="C1", label="base (input)")
    axes.plot(time + station_height / case.speed, 1e3 * base, color="0.6", linewidth=4,
              label="closed form at %g m" % station_height)
    axes.plot(time, 1e3 * station, color="C0", label="hybrid at %g m (then the reflection from the top)" % station_height)
    axes.set(xlabel="time [s]", ylabel="velocity [mm/s]", xlim=(0, time[-1]))
    axes.legend()
