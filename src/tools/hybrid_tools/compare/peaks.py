# SPDX-License-Identifier: GPL-3.0-or-later
"""Peaks of every monitor in all runs: displacement, velocity, and acceleration over that of the outcrop motion; horizontal."""

import numpy as np
from matplotlib.lines import Line2D
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

from hybrid_run import MissingData
from hybrid_tools import style
from hybrid_tools.plot.monitor_choice import along_slope

from . import curves
from .quantities import G

WIDE = 20.0  # largest over smallest: beyond it the axis is logarithmic
LITTLE = 1e-4  # of the largest: smaller values are nothing, hollow at the lower edge of a logarithmic axis
MARKS = ("o", "s", "^", "D", "v", "P", "X")
BESIDE = 0.2, 0.7  # a run from the next, and all runs of a monitor at most; monitors are 1 apart


def peaks(comparison, names, history):
    """A row per run, a column per monitor: the largest horizontal value of history(i, name)."""
    return np.array([[np.abs(history(i, name)[:, 0]).max() for name in names] for i in range(len(comparison.runs))])


def outcrops(comparison):
    """Horizontal peak of each run's outcrop motion [m/s2]. @raises MissingData where it has none"""
    found = np.array([np.abs(comparison.outcrop(i)).max(axis=0) for i in range(len(comparison.runs))])
    if not (found[:, 0] > LITTLE * found.max(axis=1)).all():
        raise MissingData("no horizontal outcrop motion")
    return found[:, 0]


def quantities(comparison, names):
    """[(values, words on the axis, level to compare with or None)]."""
    moved = peaks(comparison, names, comparison.displacement)
    factor, unit = style.length_unit(np.nanmax(moved, initial=0))
    found = [(factor * moved, "displacement\n[%s]" % unit, None), (peaks(comparison, names, comparison.velocity), "velocity\n[m/s]", None)]
    shaken = peaks(comparison, names, comparison.acceleration)
    try:
        found.append((shaken / outcrops(comparison)[:, None], "acceleration /\noutcrop peak [-]", 1.0))
    except MissingData:
        found.append((shaken / G, "acceleration\n[g]", None))
    return found


def set_scale(axis, values):
    """Logarithmic where values are far apart; plain numbers all the same."""
    good = values[np.isfinite(values) & (values > LITTLE * np.nanmax(values, initial=0))]
    if not len(good) or good.max() < WIDE * good.min():
        axis.set_ylim(0, 1.1 * max(good.max() if len(good) else 0, 1e-12))
        return values
    axis.set_yscale("log")
    spread = good.max() / good.min()
    axis.yaxis.set_major_locator(LogLocator(subs=(1, 2, 5) if spread < 200 else (1,)))
    axis.yaxis.set_major_formatter(FuncFormatter(lambda value, _: "%g" % value))
    axis.yaxis.set_minor_formatter(NullFormatter())
    axis.set_ylim(good.min() / 1.5, good.max() * 1.5)
    return np.maximum(values, good.min() / 1.5)


def draw_quantity(axis, values, level):
    drawn = set_scale(axis, values)
    n = len(values)
    beside = min(BESIDE[0], BESIDE[1] / n)
    size = float(np.clip(9 - 0.5 * n, 3.5, 7))
    for i, row in enumerate(drawn):
        x = np.arange(len(row)) + beside * (i - 0.5 * (n - 1))
        colour, is_nothing = curves.look(i)["color"], row > values[i]  # raised to the edge of a logarithmic axis
        mark = {"ls": "none", "marker": MARKS[i % len(MARKS)], "ms": size, "zorder": 3, "clip_on": False}
        axis.plot(x, np.where(is_nothing, np.nan, row), color=colour, mec="white", mew=0.5, **mark)
        if is_nothing.any():
            axis.plot(x[is_nothing], row[is_nothing], mfc="white", mec=colour, **mark)
        axis.vlines(x, axis.get_ylim()[0], row, color=curves.look(i)["color"], lw=1.1, alpha=0.45, zorder=2)
    if level is not None:
        axis.axhline(level, color="#8a8a8a", lw=0.8, ls="--", zorder=1)
    axis.grid(axis="x", visible=False)


def draw(comparison, directory):
    kinds = comparison.reference.monitor_groups().values()
    names = [name for kind in kinds for name in along_slope(comparison.reference, kind) if name in comparison.monitors and name != comparison.base]
    if not names:
        raise MissingData("no monitors but the base")
    rows = quantities(comparison, names)
    width = float(np.clip(0.5 * len(names) * (0.6 + 0.2 * len(comparison.runs)), 7, 16))
    figure, axes = curves.panels(len(rows), 1, (width, 1.9), sharex=True)
    for axis, (values, words, level) in zip(axes[:, 0], rows):
        draw_quantity(axis, values, level)
        axis.set_ylabel(words)
    last = axes[-1, 0]
    last.set_xlim(-0.6, len(names) - 0.4)
    last.set_xticks(range(len(names)), names, rotation=0 if sum(map(len, names)) < 12 * width else 90)
    last.tick_params(axis="x", length=0, labelsize=9)
    figure.align_ylabels()
    handles = [Line2D([], [], label=label, ls="none", marker=MARKS[i % len(MARKS)], ms=6, color=curves.look(i)["color"])
               for i, label in enumerate(comparison.labels)]
    relative = "; displacement relative to %s" % comparison.base if comparison.base else ""
    low_pass = "; others below %g Hz" % comparison.corner if comparison.corner else ""
    curves.finish(figure, comparison, "Horizontal peaks up to %.4g s%s%s" % (comparison.end, relative, low_pass), directory, "peaks", handles)
