# SPDX-License-Identifier: GPL-3.0-or-later
"""Failed joints against time."""

import numpy as np
from matplotlib.ticker import MaxNLocator

from hybrid_run import MissingData

from . import curves


def draw(comparison, directory):
    times = {}
    for i in range(len(comparison.runs)):
        try:
            times[i] = comparison.failed_joints(i)
        except MissingData:
            pass
    if not any(len(time) for time in times.values()):
        raise MissingData("no joint failed")
    figure, axes = curves.panels(1, 1, (8, 3.4))
    axis = axes[0, 0]
    for i, time in times.items():
        count = np.arange(len(time) + 1)
        axis.step(np.r_[0, time, comparison.end], np.r_[count, count[-1]], where="post", **curves.look(i))
    axis.set_xlim(0, comparison.end)
    axis.set_ylim(bottom=0)
    axis.yaxis.set_major_locator(MaxNLocator(integer=True))
    axis.set_xlabel("time [s]")
    axis.set_ylabel("failed joints since rest [-]")
    curves.finish(figure, comparison, "Failed joints", directory, "failures")
