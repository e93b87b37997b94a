# SPDX-License-Identifier: GPL-3.0-or-later
"""Block on a plane of 30 degrees: rests for a friction angle above the slope (Coulomb), slides for one below."""

import numpy as np
from scene_numbers import Numbers
from slope import down, slide


def check(case):
    case.data = case.run()
    case.below("movement in %.3g s, friction angle above the slope's" % case.data.time[-1], largest(case.data), 1e-6, "m")
    for step in (1e-4, 2e-3):
        run = case.run("step_%g" % step, "Time/Time step=%g" % step, "Time/End time=1")
        case.below("movement in 1 s at dt = %g s" % step, largest(run), 1e-6, "m")
    for scheme in ("dissipative", "filtered", "trapezoidal", "shi"):
        run = case.run("damped_" + scheme, "Time/Scheme=" + scheme, "Time/Time step=2e-3", "Time/End time=2",
                       "Blocks/Damping ratio=0.02", "Blocks/Damping frequency=50")
        case.below("movement in 2 s of a damped block, " + scheme, largest(run), 1e-6, "m")
    less = Numbers(case.data).mesh("Angle") - 1
    case.sliding = case.run("sliding", "Materials/rock/Friction angle=%.10g" % less, "Gravity/Static stage=held",
                            "Time/End time=1")
    case.near("slide in 1 s with 1 deg less than the slope", down(case.sliding, "block")[-1], slide(case.sliding)[-1],
              0.003, "m")


def largest(run):
    return np.abs(run.history("monitors/block/displacement")).max()


def draw(case, figure):
    rests, slides = figure.subplots(1, 2)
    rests.plot(case.data.time, 1e9 * down(case.data, "block"), color="C0")
    rests.set(xlabel="time [s]", ylabel="displacement down the slope [nm]", title="friction 31 deg: rests")
    time = case.sliding.time
    slides.plot(time, slide(case.sliding), color="0.6", linewidth=4, label="closed form")
    slides.plot(time, down(case.sliding, "block"), color="C0", label="hybrid")
    slides.set(xlabel="time [s]", ylabel="displacement down the slope [m]", title="friction 29 deg: slides")
    slides.legend()
