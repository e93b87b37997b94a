# SPDX-License-Identifier: GPL-3.0-or-later
"""Block sliding over a base of many collinear edges: the same as over one edge, s = g/2 (sin a - cos a tan phi) t^2."""

import numpy as np
from slope import down, slide


def check(case):
    case.whole = case.run("one_edge", mesh={"Base pieces": 1})
    expected = down(case.whole, "block")
    case.seams = {}
    for pieces in (47, 15, 150):
        run = case.run() if pieces == 47 else case.run("pieces_%d" % pieces, mesh={"Base pieces": pieces})
        case.seams[pieces] = down(run, "block")
        difference = np.abs(case.seams[pieces] - expected).max() / expected[-1]
        case.below("largest difference from one edge, %d edges" % pieces, difference, 1e-6)
        case.near("slide over %d edges" % pieces, case.seams[pieces][-1], slide(run)[-1], 0.003, "m")


def draw(case, figure):
    path, difference = figure.subplots(1, 2)
    time, whole = case.whole.time, down(case.whole, "block")
    path.plot(time, slide(case.whole), color="0.6", linewidth=4, label="closed form")
    for pieces, found in sorted(case.seams.items()):
        path.plot(time, found, label="%d edges" % pieces)
        difference.plot(time, np.abs(found - whole) / whole[-1], label="%d edges" % pieces)
    path.set(xlabel="time [s]", ylabel="distance down the slope [m]")
    difference.set(xlabel="time [s]", ylabel="difference from one edge / distance [-]")
    path.legend()
    difference.legend()
