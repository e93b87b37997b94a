# SPDX-License-Identifier: GPL-3.0-or-later
"""10 x 5 unit squares on a slope: a column of five is taller than its foot is wide / tan a, so they topple.

No closed form: runs at 0.2 ms and at the scene's 1 ms are compared, the mean and all blocks (root mean square of what
lies apart). Not each block alone: the one at the lower front corner is squeezed out or not by round-off.
"""

import numpy as np
from slope import down, slide
from unit_squares import mean

FINE = 2e-4  # s


def compare(case, run, step):
    """Asks for a run that lies within 5 % of one at 0.2 ms, which it returns."""
    fine = case.run("fine", "Time/Time step=%g" % FINE)
    found, expected = (r.get("section/blocks_displacement") for r in (run, fine))
    case.near("10 x 5 blocks, mean at dt = %g against %g s" % (step, FINE), mean(run), mean(fine), 0.05, "m")
    apart = np.sqrt(((found - expected) ** 2).sum(axis=1).mean()) / mean(fine)
    case.below("10 x 5 blocks, root mean square of what lies apart, over the mean", apart, 0.05)
    return fine


def check(case):
    run = case.run()
    case.curves = {1e-3: run, FINE: compare(case, run, 1e-3)}


def draw(case, figure):
    axes = figure.subplots()
    for step, run in case.curves.items():
        axes.plot(run.time, down(run, "block"), label="dt = %g s" % step)
    axes.plot(run.time, slide(run), color="0.6", linestyle=":", label="rigid slide")
    axes.set(xlabel="time [s]", ylabel="top block of 10 x 5, down the slope [m]", title="topples: no closed form")
    axes.legend()
