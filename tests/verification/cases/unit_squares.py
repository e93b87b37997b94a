# SPDX-License-Identifier: GPL-3.0-or-later
"""Unit squares on a slope of 20 degrees, 15 degrees of friction: columns that lean on nothing slide as one rigid body.

One block and 10 x 2 blocks: s = g/2 (sin a - cos a tan phi) t^2. With 21 degrees they rest.
"""

import numpy as np
from scene_numbers import Numbers
from slope import down, slide, uphill


def check(case):
    case.pair = case.run()
    expected = slide(case.pair)[-1]
    case.near("slide of 10 x 2 blocks, mean", mean(case.pair), expected, 0.003, "m")
    stiff = case.run("stiff", "Materials/rock/Young modulus=100e9")
    for place, slid in (("lowest", columns(stiff)[0]), ("highest", columns(stiff)[-1])):
        case.near("slide of 10 x 2 blocks of 100 GPa, %s column" % place, slid, expected, 0.003, "m")
    middle = "Monitors/Points=block: %.4g, %.4g" % tuple(place_of_one(case.pair))
    single = {"Columns": 1, "Rows": 1}
    case.near("slide of one block", mean(case.run("one", middle, mesh=single)), expected, 0.003, "m")
    fine = case.run("one_fine", "Time/Time step=0.0002", middle, mesh=single)
    case.near("slide of one block at dt = 0.2 ms", mean(fine), expected, 0.001, "m")
    friction = "Materials/rock/Friction angle=%.10g" % (Numbers(case.pair).mesh("Angle") + 1)
    for name, overrides, mesh in (("one", [middle], single), ("ten", [], None)):
        run = case.run(name + "_rest", friction, "Gravity/Static stage=equilibrium", *overrides, mesh=mesh)
        case.below("movement with 1 deg of friction more than the slope, " + name, run.get("section/blocks_peak_displacement").max(), 1e-6, "m")


def place_of_one(run):
    """Middle of the block at the origin [m]."""
    along, size = uphill(run), Numbers(run).mesh("Block width")
    return 0.5 * size * (along + np.array([-along[1], along[0]]))


def slid(run):
    """Distance of each block down the slope [m]."""
    return -run.get("section/blocks_displacement") @ uphill(run)


def mean(run):
    """Mean distance of the blocks down the slope [m]."""
    return slid(run).mean()


def columns(run):
    """Mean distance of the blocks of each column [m], from the lowest column up."""
    count = int(Numbers(run).mesh("Columns"))
    first = run.get("section/blocks_offsets").astype(int)[: len(slid(run))]
    points = run.get("section/blocks_points").reshape(-1, 2)
    place = [points[k : k + 4].mean(axis=0) @ uphill(run) for k in first]
    return slid(run)[np.argsort(place)].reshape(count, -1).mean(axis=1)


def draw(case, figure):
    axes = figure.subplots()
    time = case.pair.time
    axes.plot(time, slide(case.pair), color="0.6", linewidth=4, label="closed form")
    axes.plot(time, down(case.pair, "block"), label="hybrid, 10 x 2 blocks, one in the middle")
    axes.set(xlabel="time [s]", ylabel="distance down the slope [m]")
    axes.legend()
