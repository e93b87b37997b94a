# SPDX-License-Identifier: GPL-3.0-or-later
"""A stiff slab of bonded triangles with a belt slides as Newmark's rigid block, if its blocks do not ring."""

from scene_numbers import Numbers
from shaken_base import newmark_slip

STEP = 0.00025  # of a variant [s]


def slips(run):
    """Mean slip on the belt and that of a rigid block [m], down the slope."""
    expected = newmark_slip(run.time, run.history("input/acceleration")[:, 0], Numbers(run), "Blocks/Belt material")
    return abs(run.file["slip/mean"][:]), expected


def check(case):
    case.found = {}
    for name, overrides in (("dt = 1 ms", ()), ("dt = %g ms" % (1e3 * STEP), ("Time/Time step=%g" % STEP,))):
        run = case.run(name.replace(" ", ""), *overrides)
        slip, expected = slips(run)
        case.found[name] = run.time, slip, expected
        case.near(name + ": slip in the end", slip[-1], expected[-1], 0.01, "m")
        case.below(name + ": residual of the energy audit", run.summary["energy_residual"], 1e-3)


def draw(case, figure):
    axes = figure.subplots()
    time, _, expected = case.found["dt = 1 ms"]
    axes.plot(time, expected, color="0.6", linewidth=4, label="rigid block (Newmark)")
    finer, undamped = {"Resolution/h": 1}, "Blocks/Damping ratio=0"
    rings = [(case.run("undamped", undamped, mesh=finer), "h = 1 m, undamped, dt = 1 ms"),
             (case.run("undamped_fine", undamped, "Time/Time step=%g" % STEP, mesh=finer), "h = 1 m, undamped, dt = %g ms" % (1e3 * STEP))]
    for name, (time, slip, _) in case.found.items():
        axes.plot(time, slip, "--", label="slab, " + name)
    for run, name in rings:
        axes.plot(run.time, slips(run)[0], ":", label="slab, " + name)
    axes.set(xlabel="time [s]", ylabel="slip [m]")
    axes.legend()
