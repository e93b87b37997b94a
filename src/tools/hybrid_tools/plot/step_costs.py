# SPDX-License-Identifier: GPL-3.0-or-later
"""What each step cost: step size (cuts), iterations, wall time; and where the wall time of all went."""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.ticker import FormatStrFormatter, LogLocator, NullFormatter

from hybrid_run import MissingData, timings
from hybrid_tools import style


def log_axis(axis, values):
    """Plain numbers on a logarithmic axis: the values themselves if they are few, else 1, 2, 5."""
    axis.set_yscale("log")
    few = np.unique(np.round(values, 9))
    if len(few) <= 9:
        axis.set_yticks(few)
    else:
        axis.yaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
    axis.yaxis.set_major_formatter(FormatStrFormatter("%g"))
    axis.yaxis.set_minor_formatter(NullFormatter())
    low, high = values.min(), values.max()
    axis.set_ylim(low / 1.3, high * max(1.3, (high / low) ** 0.25))


def draw_parts(axis, parts):
    """One bar of parts of the wall time."""
    total, begin = sum(parts.values()), 0.0
    colours = plt.get_cmap("tab20").colors
    for k, (label, seconds) in enumerate(parts.items()):
        share = 100 * seconds / total
        axis.barh(0, share, left=begin, color=colours[k % len(colours)], height=0.6, label="%s %.0f %%" % (label, share))
        begin += share
    axis.set_xlim(0, 100)
    axis.set_yticks([])
    axis.set_xlabel("wall time of the time loop [%]")
    axis.legend(loc="upper center", bbox_to_anchor=(0.5, -1.1), ncol=4, fontsize=8, frameon=False)


def draw(run, directory):
    dt = run.get("steps/dt")
    panels = [(dt * 1e3, "step size [ms]", "log")]
    for path, label in (("iterations", "open-close\niterations [-]"), ("solver_iterations", "iterations of the\nblock solver [-]")):
        if run.has("steps/" + path) and run.get("steps/" + path).any():
            panels.append((run.get("steps/" + path), label, "linear"))
    if run.has("steps/wall_time"):
        panels.append((run.get("steps/wall_time") * 1e3, "wall time\nper step [ms]", "log"))
    time = run.get("time")
    n = min([len(time)] + [len(p[0]) for p in panels])
    if n < 2:
        raise MissingData("fewer than two steps in run.h5")
    parts = timings.parts(run.summary, minimum=0.005)
    heights = [1.7] * len(panels) + ([1.0] if parts else [])
    figure, axes = plt.subplots(len(heights), 1, figsize=(9, sum(heights) + 0.6), squeeze=False, constrained_layout=True,
                                gridspec_kw={"height_ratios": [1.0] * len(panels) + ([0.25] if parts else [])})
    if parts:
        draw_parts(axes[-1, 0], parts)
        axes = axes[:-1]
    for axis, (values, label, scale) in zip(axes[:, 0], panels):
        axis.sharex(axes[-1, 0])
        axis.tick_params(labelbottom=axis is axes[-1, 0])
        values = values[:n]
        axis.plot(time[:n], values, ".", ms=1.5, color=style.HORIZONTAL, alpha=0.35, rasterized=True)
        window = max(n // 200, 1)
        mean = np.convolve(values, np.ones(window) / window, mode="valid")
        axis.plot(time[window - 1 : n], mean, color=style.TEXT, lw=1.0, label="mean of %d steps" % window if window > 1 else "each step")
        if scale == "log" and values.min() > 0:
            log_axis(axis, values)
        elif scale == "linear":
            axis.set_ylim(bottom=0)
        axis.set_ylabel(label)
        axis.text(0.995, 0.95, "mean %.3g, largest %.3g" % (values.mean(), values.max()), transform=axis.transAxes, fontsize=8,
                  ha="right", va="top", bbox={"fc": "white", "ec": "none", "alpha": 0.8, "pad": 1})
    axes[0, 0].legend(loc="lower left")
    axes[-1, 0].set_xlabel("time [s]")
    axes[-1, 0].set_xlim(time[0], time[n - 1])
    style.title(figure, "Steps: " + run.title())
    style.save(figure, directory, "steps")
