# SPDX-License-Identifier: GPL-3.0-or-later
"""Slip on the sliding surface: mean and largest over time, how much strength is mobilised, and slip along the surface."""

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
    axes.set_ylabel("slip %s[%s]" % ("downhill " if run.slips_downhill else "", unit))
    axes.legend(loc="upper left", ncol=2)


def draw_shares(run, axes):
    """Base shear over shear strength, and the part of the surface that has slipped."""
    axes.plot(run.time, 100 * run.mobilised(), color=style.HORIZONTAL, lw=0.9, label="base shear / shear strength")
    if run.has("slip/part"):
        threshold = style.length_unit(0)[0] * float(np.ravel(run.attribute("slip", "threshold"))[0])
        axes.plot(run.time, 100 * run.history("slip/part"), color=style.VERTICAL, lw=1.3,
                  label="part of the length that has slid by more than %.3g mm" % threshold)
    axes.axhline(0, color="#8a8a8a", lw=0.7)
    axes.axhline(100, color="#8a8a8a", lw=0.7, ls="--")
    axes.set_xlim(run.time[0], run.time[-1])
    axes.margins(y=0.1)
    axes.set_xlabel("time [s]")
    axes.set_ylabel("share [%]")
    axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncol=2)


def mark_slipped(run, axes, order):
    """A bar along the lower edge under the soles that have slid beyond the threshold."""
    if not run.has("slip/farthest"):
        return
    threshold = float(np.ravel(run.attribute("slip", "threshold"))[0])
    slipped = run.get("slip/farthest")[order] > threshold
    position, length = run.get("slip/position")[order], run.get("slip/length")[order]
    bars = [(x - w / 2, w) for (x, _), w, slid in zip(position, length, slipped) if slid]
    if bars:
        low, high = axes.get_ylim()
        axes.broken_barh(bars, (low, 0.02 * (high - low)), color=style.VERTICAL, lw=0, label="slipped\n(> %.3g mm)" % (1e3 * threshold))
        axes.set_ylim(low, high)


def slide_breaks(run, order):
    """Numbers of the soles, taken in this order, with which another slide begins: no line goes there through the air."""
    return np.flatnonzero(np.diff(np.ravel(run.get("slip/slide"))[order])) + 1 if run.has("slip/slide") else []


def broken(x, values, breaks):
    """The line x, values with gaps before these numbers."""
    return np.insert(x, breaks, np.nan), np.insert(values, breaks, np.nan)


def draw_profiles(run, axes, factor, unit):
    time, profile, position = run.get("slip/time"), run.get("slip/profile"), run.get("slip/position")
    n = min(len(time), len(profile))
    profile = profile.reshape(len(profile), -1)  # one sole alone has no second axis
    order = np.argsort(position[:, 0])
    x, breaks = position[order, 0], slide_breaks(run, order)
    marker = "." if len(breaks) else ""  # a slide of one sole has no line
    rows = sorted({int(round(row)) for row in np.linspace(0, n - 1, MOST_PROFILES + 1)} - {0, n - 1})
    colours = plt.get_cmap("viridis")(np.linspace(0.1, 0.9, max(len(rows), 1)))
    for row, colour in zip(rows, colours):
        axes.plot(*broken(x, factor * profile[row][order], breaks), color=colour, lw=0.9, marker=marker, ms=3, label="%.3g s" % time[row])
    axes.plot(*broken(x, factor * profile[n - 1][order], breaks), color=style.TEXT, lw=1.6, marker=".", ms=3, label="%.3g s" % time[n - 1])
    axes.axhline(0, color="#8a8a8a", lw=0.7)
    mark_slipped(run, axes, order)
    axes.set_xlabel("x of the block's sole at rest [m]")
    axes.set_ylabel("slip %s[%s]" % ("downhill " if run.slips_downhill else "", unit))
    axes.legend(loc="center left", bbox_to_anchor=(1.0, 0.5), handlelength=1.2)


def draw(run, directory):
    if not run.has("slip/mean") or run.n < 2:
        raise MissingData("no slip in run.h5")
    factor, unit = style.length_unit(np.abs(run.history("slip/largest")).max())
    has_shares = run.has("base_shear/shear")
    rows = 3 if has_shares else 2
    figure, axes = plt.subplots(rows, 1, figsize=(9, 3 * rows + 0.5), constrained_layout=True)
    draw_history(run, axes[0], factor, unit)
    if has_shares:
        draw_shares(run, axes[1])
        axes[0].set_xlabel("")
    draw_profiles(run, axes[-1], factor, unit)
    style.title(figure, "Slip on the sliding surface: " + run.title())
    style.save(figure, directory, "slip")
