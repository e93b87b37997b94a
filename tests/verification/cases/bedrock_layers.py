# SPDX-License-Identifier: GPL-3.0-or-later
"""Layers on elastic bedding planes: two masses between springs, with the dashpots of their sides."""

import numpy as np
from matrix_exponential import exponential
from scene_numbers import Numbers

shown = {}


def closed_form(numbers, time, base):
    """Displacement of middle and top layer [m] for the base's, linear between the samples: exact by the matrix exponential.

    Both layers are equally high.
    """
    rock, height, width = numbers.material("rock"), numbers.mesh("Top height"), numbers.mesh("Width")
    mass = rock.density * height * width
    dashpots = 2 * height * rock.density * rock.speed("P")
    spring = numbers.number("Bedding planes/Shear stiffness") * width
    stiffness = spring * np.array([[2.0, -1.0], [-1.0, 1.0]])
    dt = time[1] - time[0]
    # x = (u_1, u_2, u_1', u_2'), x' = A x + b u_b; b, its slope: appended states, so one exponential is exact
    a = np.zeros((6, 6))
    a[0, 2] = a[1, 3] = 1
    a[2:4, :2] = -stiffness / mass
    a[2, 2] = a[3, 3] = -dashpots / mass
    a[2, 4] = spring / mass
    a[4, 5] = 1
    step = exponential(a * dt)
    x, result = np.zeros(6), []
    for u0, u1 in zip(np.concatenate([[0.0], base[:-1]]), base):
        x[4:] = u0, (u1 - u0) / dt
        x = step @ x
        result.append(x[:2].copy())
    return np.array(result)


def check(case):
    run = case.run()
    base = run.history("input/displacement")[:, 0]
    expected = closed_form(Numbers(run), run.time, base)
    shown.update(time=run.time, curves={})
    for k, name in enumerate(("middle", "top")):
        found = run.history("monitors/%s/displacement" % name)[:, 0] - base
        form = expected[:, k] - base
        peak = np.abs(form).max()
        case.near("peak displacement of the %s layer relative to the base" % name, np.abs(found).max(), peak, 0.02, "m")
        case.below("largest error of the %s layer's history over its peak" % name, np.abs(found - form).max() / peak, 0.02)
        shown["curves"][name] = (found, form)
    case.below("energy residual", run.summary["energy_residual"], 1e-3)


def draw(case, figure):
    axes = figure.subplots()
    for name, (found, form) in shown["curves"].items():
        line = axes.plot(shown["time"], 1000 * form, linewidth=4, alpha=0.4, label=name + ", closed form")
        axes.plot(shown["time"], 1000 * found, color=line[0].get_color(), label=name + ", program")
    axes.set_xlabel("time [s]")
    axes.set_ylabel("displacement relative to the base [mm]")
    axes.legend()
