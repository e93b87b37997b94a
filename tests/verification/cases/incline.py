# SPDX-License-Identifier: GPL-3.0-or-later
"""Block sliding down a plane: s = g/2 (sin a - cos a tan phi) t^2 (Newton's second law with Coulomb friction)."""

from slope import down, slide

ANGLE, FRICTION = 30.0, 15.0  # deg


def check(case):
    for step, allowed in ((1e-3, 0.003), (2e-4, 0.001)):
        run = case.run("step_%g" % step, "Time/Time step=%g" % step) if step != 1e-3 else case.run()
        if step == 1e-3:
            case.data = run
        found = down(run, "block", ANGLE)[-1]
        case.near("slide at dt = %g s" % step, found, slide(run.time[-1], ANGLE, FRICTION), allowed, "m")
    for angle in (20.0, 40.0):
        run = case.run("angle_%g" % angle, "Mesh/Numbers=Angle = %g; Base below = 20" % angle)
        case.near("slide on %g deg" % angle, down(run, "block", angle)[-1], slide(run.time[-1], angle, FRICTION), 0.003, "m")


def draw(case, figure):
    axes, difference = figure.subplots(1, 2)
    time, found = case.data.time, down(case.data, "block", ANGLE)
    expected = slide(time, ANGLE, FRICTION)
    axes.plot(time, expected, color="0.6", linewidth=4, label="closed form")
    axes.plot(time, found, color="C0", label="hybrid, dt = 1 ms")
    axes.set(xlabel="time [s]", ylabel="distance down the slope [m]")
    axes.legend()
    difference.plot(time[1:], 1e6 * (found - expected)[1:], color="C0")
    difference.set(xlabel="time [s]", ylabel="hybrid less closed form [micrometre]")
