# SPDX-License-Identifier: GPL-3.0-or-later
"""Unit squares on a slope of 20 degrees, 15 degrees of friction: columns that lean on nothing slide as one rigid body.

One block and 10 x 2 blocks: s = g/2 (sin a - cos a tan phi) t^2. With 21 degrees they rest.
"""

import numpy as np
from slope import down, slide

ANGLE, FRICTION, SQUARES = 20.0, 15.0, "Mesh/Numbers=Angle = 20; Columns = %d; Rows = %d; Base above = 20"


def check(case):
    case.pair = case.run()
    expected = slide(case.pair.time[-1], ANGLE, FRICTION)
    case.near("slide of 10 x 2 blocks, mean", mean(case.pair), expected, 0.003, "m")
    stiff = case.run("stiff", "Materials/rock/Young modulus=100e9")
    for place, slid in (("lowest", columns(stiff)[0]), ("highest", columns(stiff)[-1])):
        case.near("slide of 10 x 2 blocks of 100 GPa, %s column" % place, slid, expected, 0.003, "m")
    one = [SQUARES % (1, 1), "Monitors/Points=block: 0.299, 0.641"]
    case.near("slide of one block", mean(case.run("one", *one)), expected, 0.003, "m")
    case.near("slide of one block at dt = 0.2 ms", mean(case.run("one_fine", "Time/Time step=0.0002", *one)), expected, 0.001, "m")
    for name, overrides in (("one", one), ("ten", [])):
        run = case.run(name + "_rest", "Materials/rock/Friction angle=21", "Gravity/Static stage=equilibrium", *overrides)
        case.below("movement with 21 deg of friction, " + name, run.get("section/blocks_peak_displacement").max(), 1e-6, "m")


def slid(run):
    """Distance of each block down the slope [m]."""
    a = np.radians(ANGLE)
    return -run.get("section/blocks_displacement") @ np.array([np.cos(a), np.sin(a)])


def mean(run):
    """Mean distance of the blocks down the slope [m]."""
    return slid(run).mean()


def columns(run):
    """Mean distance of the two blocks of each column [m], from the lowest column up."""
    first = run.get("section/blocks_offsets").astype(int)[:20]
    points = run.get("section/blocks_points").reshape(-1, 2)
    place = [points[k : k + 4].mean(axis=0)[0] for k in first]
    return slid(run)[np.argsort(place)].reshape(10, 2).mean(axis=1)


def draw(case, figure):
    axes = figure.subplots()
    time = case.pair.time
    axes.plot(time, slide(time, ANGLE, FRICTION), color="0.6", linewidth=4, label="closed form")
    axes.plot(time, down(case.pair, "block", ANGLE), label="hybrid, 10 x 2 blocks, one in the middle")
    axes.set(xlabel="time [s]", ylabel="distance down the slope [m]")
    axes.legend()
