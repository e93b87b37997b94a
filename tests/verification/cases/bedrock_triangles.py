# SPDX-License-Identifier: GPL-3.0-or-later
"""Column of bonded triangles on a compliant base: one-dimensional waves in a uniform half space."""

import numpy as np
from scene_numbers import Numbers

shown = {}


def wave(time, outcrop, speed, paths):
    """Velocity: half the outcrop motion going up and half of it coming down, after the paths [m]."""
    return sum(0.5 * np.interp(time - path / speed, time, outcrop, left=0.0) for path in paths)


def peak_time(time, v):
    """Time of the largest positive value, by the parabola through it and its neighbours."""
    k = v.argmax()
    a, b, c = v[k - 1 : k + 2]
    return time[k] + 0.5 * (a - c) / (a - 2 * b + c) * (time[1] - time[0])


def check_wave(case, run, name, component):
    numbers = Numbers(run)
    speed, height = numbers.material("rock").speed(name[0]), numbers.mesh("Height")
    pulse = 3 / numbers.number("Motion/Frequency")
    time, outcrop = run.time, run.history("input/velocity")[:, component]
    largest = np.abs(outcrop).max()
    top = run.history("monitors/top/velocity")[:, component]
    middle = run.history("monitors/middle/velocity")[:, component]
    forms = []
    for point in ("top", "middle"):
        y = numbers.point(point)[1]
        forms.append(wave(time, outcrop, speed, (y, 2 * height - y)))
    case.near(name + ": peak velocity at the surface over the outcrop's", np.abs(top).max() / largest, 1.0, 0.02)
    case.below(name + ": largest error of the surface's history over its peak",
               np.abs(top - forms[0]).max() / largest, 0.02)
    case.below(name + ": the same half way up", np.abs(middle - forms[1]).max() / largest, 0.02)
    case.near(name + ": arrival after", peak_time(time, top) - peak_time(time, outcrop), height / speed, 0.01, "s")
    # What the base sends back is at the surface from 3 H / c on, when the pulse itself has gone; there it is
    # doubled like the incident wave.
    late = time > max(3 * height / speed, pulse + 1.05 * height / speed)
    case.below(name + ": reflection at the base over the incident wave", np.abs(top[late]).max() / largest, 0.02)
    case.below(name + ": energy residual", run.summary["energy_residual"], 1e-3)
    shown[name] = (time, top, middle, *forms)


def check(case):
    shear = case.run()
    check_wave(case, shear, "S wave", 0)
    numbers = Numbers(shear)
    rock = numbers.material("rock")
    faster = rock.speed("P") / rock.speed("S")
    run = case.run("p_wave", "Motion/Angle=90", "Motion/Frequency=%.10g" % (faster * numbers.number("Motion/Frequency")),
                   "Time/End time=%.6g" % (numbers.number("Time/End time") / faster))
    check_wave(case, run, "P wave", 1)


def draw(case, figure):
    for axes, name in zip(figure.subplots(1, 2, sharey=True), ("S wave", "P wave")):
        time, top, middle, top_form, middle_form = shown[name]
        for label, found, form in (("surface", top, top_form), ("half way up", middle, middle_form)):
            line = axes.plot(time, 1000 * form, linewidth=4, alpha=0.4, label=label + ", closed form")
            axes.plot(time, 1000 * found, color=line[0].get_color(), label=label + ", program")
        axes.set_title(name)
        axes.set_xlabel("time [s]")
    figure.axes[0].set_ylabel("velocity [mm/s]")
    figure.axes[0].legend(fontsize=8)
