# SPDX-License-Identifier: GPL-3.0-or-later
"""What the runs cost: wall time against simulated time, and per step."""

import numpy as np

from hybrid_run import MissingData

from . import curves
from .quantities import wall_times


def draw(comparison, directory):
    walls = {i: wall_times(run, comparison.end) for i, run in enumerate(comparison.runs)}
    walls = {i: wall for i, wall in walls.items() if wall is not None}
    if not walls:
        raise MissingData("no wall times")
    figure, axes = curves.panels(1, 2, (5.2, 3.4))
    for i, wall in walls.items():
        time = comparison.runs[i].time[: len(wall)]
        axes[0, 0].plot(time, np.cumsum(wall), **curves.look(i))
    axes[0, 0].set_xlim(0, comparison.end)
    axes[0, 0].set_ylim(bottom=0)
    axes[0, 0].set_xlabel("simulated time [s]")
    axes[0, 0].set_ylabel("wall time of all steps [s]")
    draw_bars(comparison, walls, axes[0, 1])
    curves.finish(figure, comparison, "Cost (wall time: other work on the machine counts)", directory, "cost")


def draw_bars(comparison, walls, axis):
    """Mean and median wall time of a step."""
    for row, (i, wall) in enumerate(walls.items()):
        mean, median = 1e3 * wall.mean(), 1e3 * np.median(wall)
        axis.barh(row, mean, color=curves.look(i)["color"], height=0.6)
        axis.plot([median] * 2, [row - 0.4, row + 0.4], color="#262626", lw=1.4)
        axis.annotate("%.3g" % mean, (max(mean, median), row), (5, 0), textcoords="offset points", va="center", fontsize=8)
    axis.set_yticks(range(len(walls)), [comparison.labels[i] for i in walls])
    axis.invert_yaxis()
    axis.margins(x=0.15)
    axis.grid(axis="y", visible=False)
    axis.set_xlabel("ms per step: mean (black line: median)")
