# SPDX-License-Identifier: GPL-3.0-or-later
"""Block sliding down a plane: s = g/2 (sin a - cos a tan phi) t^2 (Newton's second law with Coulomb friction)."""

import numpy as np
from scene_numbers import Numbers
from slope import down, slide


def check(case):
    for step, allowed in ((1e-3, 0.003), (2e-4, 0.001)):
        run = case.run("step_%g" % step, "Time/Time step=%g" % step) if step != 1e-3 else case.run()
        if step == 1e-3:
            case.data = run
        case.near("slide at dt = %g s" % step, down(run, "block")[-1], slide(run)[-1], allowed, "m")
    for angle in [a for a in (20.0, 40.0) if a >= np.degrees(Numbers(run).material("rock").friction) + 1]:
        run = case.run("angle_%g" % angle, mesh={"Angle": angle, "Base below": 20})
        case.near("slide on %g deg" % angle, down(run, "block")[-1], slide(run)[-1], 0.003, "m")
    # A degree of slope to spare and large blocks: these would flutter, were their shape not damped (flutter.py).
    angle, side = Numbers(case.data).mesh("Angle"), 5.0
    a = np.radians(angle)
    centre = 0.5 * side * np.array([np.cos(a) - np.sin(a), np.sin(a) + np.cos(a)])
    large = case.run("large", "Materials/rock/Friction angle=%.10g" % (angle - 1), "Monitors/Points=block: %.9g, %.9g" % tuple(centre),
                     mesh={"Block width": side, "Block height": side, "Angle": angle})
    case.near("slide of 5 x 5 m with 1 deg less friction than slope", down(large, "block")[-1], slide(large)[-1], 0.003, "m")


def draw(case, figure):
    axes, difference = figure.subplots(1, 2)
    time, found, expected = case.data.time, down(case.data, "block"), slide(case.data)
    axes.plot(time, expected, color="0.6", linewidth=4, label="closed form")
    axes.plot(time, found, color="C0", label="hybrid, dt = 1 ms")
    axes.set(xlabel="time [s]", ylabel="distance down the slope [m]")
    axes.legend()
    difference.plot(time[1:], 1e6 * (found - expected)[1:], color="C0")
    difference.set(xlabel="time [s]", ylabel="hybrid less closed form [micrometre]")
