# SPDX-License-Identifier: GPL-3.0-or-later
"""Columns of some 200 grains, poured anew from three seeds, beside the laws of grain_column.py."""

import grain_column
import grain_packing
import numpy as np
from grain_column import discs, growth, heights, rods, sand
from run_hybrid import Started

SEEDS = (1, 2, 3)
RATIO = {16.0: 0.5, 12.0: 1.0, 8.0: 2.0, 7.0: 3.0, 5.0: 6.0}  # a of the columns, by the width between the walls [m]
ROWS = {16.0: 15, 12.0: 22, 8.0: 29, 7.0: 39, 5.0: 56}  # of grains that are drawn, a little more than the columns need
BELOW_SAND = 0.5, 0.8  # lowest run-out allowed over that of sand: of each packing (some 120 to 240 grains scatter), of their mean
SMALLEST = 1.0  # a from which that is asked of the mean: lower columns are less than ten grains high


def poured(case, seed, width):
    """Grains of a seed, settled between wall and gate."""
    name, rows = "poured_%g_%d" % (width, seed), ROWS[width]
    drawn, ground = case.work / (name + ".csv"), case.work / (name + "_ground.csv")
    case.work.mkdir(parents=True, exist_ok=True)
    grain_packing.write_grains(drawn, grain_packing.drawn(seed, int(width), rows))
    grain_packing.write_ground(ground, width, rows + 2, has_gate=True)
    run = case.run(name, "Mesh/Polygons file=%s" % drawn, "Mesh/Surface file=%s" % ground, *grain_packing.SETTLING)
    return grain_packing.parted(run.blocks.final_polygons)


def check(case):
    case.scene = case.scene.with_name("grain_column.prm")
    case.program = Started(case.binary)  # a summary has the processor time of its process
    case.all = {a: [] for a in RATIO.values()}
    for seed in SEEDS:
        for width, a in RATIO.items():
            found = grain_column.collapse(case, "a_%g_%d" % (a, seed), poured(case, seed, width), width, a)
            grain_column.judge(case, "a = %g, packing %d" % (a, seed), found, BELOW_SAND[0])
            case.all[a].append(found)
    judge_means(case)


def judge_means(case):
    """What is asked of the means over all packings."""
    mean = {a: np.mean([found.run_out for found in columns]) for a, columns in case.all.items()}
    for a in (a for a in mean if a >= SMALLEST):
        most = max(discs(a), rods(a))
        case.true("a = %g: mean run-out %.2f, sand %.2f, highest published %.2f" % (a, mean[a], sand(a), most),
                  BELOW_SAND[1] * sand(a) <= mean[a] <= most)
    flat, tall = growth(mean, 1.0, 2.0), growth(mean, 2.0, 6.0)
    case.within("power of a from 1 to 2", flat, 1.0, 0.25)
    case.true("power of a from 2 to 6: %.2f, less than 1 and than from 1 to 2" % tall, tall < min(flat, 1.0))


def draw(case, figure):
    left, right = figure.subplots(1, 2, width_ratios=(1.4, 1))
    a = np.geomspace(0.4, 8, 200)
    left.fill_between(a, sand(a), np.maximum(discs(a), rods(a)), color="0.9")
    for law, label, style in ((sand, "sand, Lube et al. 2005", "k-"), (discs, "discs, Staron & Hinch 2005", "k--"),
                              (rods, "rods, Nguyen et al. 2015", "k:")):
        left.loglog(a, law(a), style, linewidth=1, label=label)
    low, high = heights(a)
    right.fill_between(a, low, high, color="0.9", label="published")
    for axes, value in ((left, "run_out"), (right, "top")):
        for ratio, columns in case.all.items():
            found = [getattr(column, value) for column in columns]
            axes.plot([ratio] * len(found), found, "C0_", markersize=9)
            axes.plot(ratio, np.mean(found), "C3o", markersize=5, label="hybrid, mean" if ratio == 1.0 else None)
    left.set(xlabel="a = H0/L0 [-]", ylabel="run-out (L - L0)/L0 [-]")
    right.set(xscale="log", yscale="log", xlabel="a = H0/L0 [-]", ylabel="height of the heap H/L0 [-]")
    for axes in (left, right):
        axes.legend(fontsize=8)
