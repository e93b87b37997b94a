# SPDX-License-Identifier: GPL-3.0-or-later
"""Slip on the sliding surface: mean and largest over time, and along the surface at the times of the pictures."""

import matplotlib.pyplot as plt
import numpy as np

from hybrid_run import MissingData
from hybrid_tools import style

MOST_PROFILES = 6  # besides the last one


def draw_history(run, axes, factor, unit):
    mean, largest = run.history("slip/mean"), run.history("slip/largest")
    axes.plot(run.time, factor * largest, color=style.SHEAR, lw=0.9, label="largest")
    axes.plot(run.time, factor * mean, color=style.TEXT, lw=1.3, label="mean")
    axes.axhline(0, color="#8a8a8a", lw=0.7)
    axes.text(0.995, 0.04, "left at the end: mean %.3g %s, largest %.3g %s" % (factor * mean[-1], unit, factor * largest[-1], unit),
              transform=axes.transAxes, ha="right", va="bottom", fontsize=8,
              bbox={"fc": "white", "ec": "none", "alpha": 0.8, "pad": 1})
    axes.set_xlim(run.time[0], run.time[-1])
    axes.margins(y=0.15)
    axes.set_xlabel("time [s]")
    axes.set_ylabel("slip %s[%s]" % ("" if run.is_level else "downhill ", unit))
    axes.legend(loc="upper left", ncol=2)


def draw_profiles(run, axes, factor, unit):
    time, profile, position = run.get("slip/time"), run.get("slip/profile"), run.get("slip/position")
    n = min(len(time), len(profile))
    profile = profile.reshape(len(profile), -1)  # one sole alone has no second axis
    order = np.argsort(position[:, 0])
    x = position[order, 0]
    rows = sorted({int(round(row)) for row in np.linspace(0, n - 1, MOST_PROFILES + 1)} - {0, n - 1})
    colours = plt.get_cmap("viridis")(np.linspace(0.1, 0.9, max(len(rows), 1)))
    for row, colour in zip(rows, colours):
        axes.plot(x, factor * profile[row][order], color=colour, lw=0.9, label="%.3g s" % time[row])
    axes.plot(x, factor * profile[n - 1][order], color=style.TEXT, lw=1.6, marker=".", ms=3, label="%.3g s" % time[n - 1])
    axes.axhline(0, color="#8a8a8a", lw=0.7)
    axes.set_xlabel("x of the block's sole at rest [m]")
    axes.set_ylabel("slip %s[%s]" % ("" if run.is_level else "downhill ", unit))
    axes.legend(loc="center left", bbox_to_anchor=(1.0, 0.5), handlelength=1.2)


def draw(run, directory):
    if not run.has("slip/mean") or run.n < 2:
        raise MissingData("no slip in run.h5")
    factor, unit = style.length_unit(np.abs(run.history("slip/largest")).max())
    figure, axes = plt.subplots(2, 1, figsize=(9, 6.5), constrained_layout=True)
    draw_history(run, axes[0], factor, unit)
    draw_profiles(run, axes[1], factor, unit)
    style.title(figure, "Slip on the sliding surface: " + run.title())
    style.save(figure, directory, "slip")
