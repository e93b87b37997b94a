# SPDX-License-Identifier: GPL-3.0-or-later
"""Unit squares on a slope of 20 degrees, 15 degrees of friction: columns that lean on nothing slide as one rigid body.

One block and 10 x 2 blocks: s = g/2 (sin a - cos a tan phi) t^2. With 21 degrees they rest. A column of five is taller
than its foot is wide / tan a, so 10 x 5 topple: there the answer at three steps is compared with itself.
"""

import numpy as np
from slope import down, slide

ANGLE, FRICTION, SQUARES = 20.0, 15.0, "Mesh/Numbers=Angle = 20; Columns = %d; Rows = %d; Base above = 20"


def check(case):
    case.pair = case.run()
    expected = slide(case.pair.time[-1], ANGLE, FRICTION)
    case.near("slide of 10 x 2 blocks, mean", mean(case.pair), expected, 0.003, "m")
    case.near("slide of 10 x 2 blocks, one of the lower row", down(case.pair, "block", ANGLE)[-1], expected, 0.003, "m")
    one = [SQUARES % (1, 1), "Monitors/Points=block: 0.299, 0.641"]
    case.near("slide of one block", mean(case.run("one", *one)), expected, 0.003, "m")
    case.near("slide of one block at dt = 0.2 ms", mean(case.run("one_fine", "Time/Time step=0.0002", *one)), expected, 0.001, "m")
    for name, overrides in (("one", one), ("ten", [])):
        run = case.run(name + "_rest", "Materials/rock/Friction angle=21", "Gravity/Static stage=equilibrium", *overrides)
        case.below("movement with 21 deg of friction, " + name, run.get("section/blocks_peak_displacement").max(), 1e-6, "m")
    topple(case)


def mean(run):
    """Mean distance of the blocks down the slope [m]."""
    a = np.radians(ANGLE)
    return -(run.get("section/blocks_displacement") @ np.array([np.cos(a), np.sin(a)])).mean()


def topple(case):
    """10 x 5 blocks at three steps: the mean, and all blocks (root mean square of what lies apart), the same within 5 %.

    Not each block alone: the one at the lower front corner is squeezed out or not by round-off.
    """
    overrides = [SQUARES % (10, 5), "Gravity/Static stage=none", "Monitors/Points=block: 3.160, 5.940"]
    steps = (2e-4, 1e-3, 2e-3)
    runs = [case.run("tall_%g" % step, "Time/Time step=%g" % step, *overrides) for step in steps]
    moved = [run.get("section/blocks_displacement") for run in runs]
    for step, run, found in zip(steps[1:], runs[1:], moved[1:]):
        case.near("10 x 5 blocks, mean at dt = %g against %g s" % (step, steps[0]), mean(run), mean(runs[0]), 0.05, "m")
        apart = np.sqrt(((found - moved[0]) ** 2).sum(axis=1).mean()) / mean(runs[0])
        case.below("10 x 5 blocks, root mean square of what lies apart, over the mean", apart, 0.05)
    case.tall = dict(zip(steps, runs))


def draw(case, figure):
    path, tall = figure.subplots(1, 2)
    time = case.pair.time
    path.plot(time, slide(time, ANGLE, FRICTION), color="0.6", linewidth=4, label="closed form")
    path.plot(time, down(case.pair, "block", ANGLE), label="hybrid, 10 x 2 blocks")
    path.set(xlabel="time [s]", ylabel="distance down the slope [m]")
    path.legend()
    for step, run in case.tall.items():
        tall.plot(run.time, down(run, "block", ANGLE), label="dt = %g s" % step)
    tall.plot(time, slide(time, ANGLE, FRICTION), color="0.6", linestyle=":", label="rigid slide")
    tall.set(xlabel="time [s]", ylabel="top block of 10 x 5, down the slope [m]", title="topples: no closed form")
    tall.legend()
