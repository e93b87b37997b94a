# SPDX-License-Identifier: GPL-3.0-or-later
"""Displacement of each monitor less that of the reference."""

import numpy as np
from matplotlib.lines import Line2D

from hybrid_run import MissingData, misfit
from hybrid_tools import style
from hybrid_tools.table import percent

from . import curves

FEW = 3  # runs whose misfits stand in a title


def misfits(values):
    """In the order of the runs; of many the least and the largest."""
    if len(values) > FEW:
        values = [min(values), max(values)]
        return " to ".join(percent(value).lstrip("+") for value in values)
    return ", ".join(percent(value).lstrip("+") for value in values)


def draw(comparison, directory):
    names = curves.monitors_to_show(comparison)
    if not names:
        raise MissingData("no monitors")
    columns = 2 if len(names) > 1 else 1
    figure, axes = curves.panels(-(-len(names) // columns), columns, (5.2, 2.2), sharex=True)
    for axis in axes.flat[len(names):]:
        axis.set_axis_off()
    for axis, name in zip(axes.flat, names):
        c = curves.component(comparison, name)
        reference = comparison.displacement(0, name)
        differences = {i: comparison.displacement(i, name)[:, c] - reference[:, c] for i, _ in comparison.others}
        factor, unit = style.length_unit(max(np.nanmax(np.abs(d), initial=0) for d in differences.values()))
        for i, difference in differences.items():
            axis.plot(comparison.axis, factor * difference, **curves.look(i))
        found = [misfit.relative_l2(comparison.displacement(i, name), reference) for i in differences]
        axis.set_title("%s: L2 misfit %s" % (name, misfits(found)), fontsize=9)
        axis.axhline(0, color="#8a8a8a", lw=0.7)
        axis.set_ylabel("difference of u %s [%s]" % (curves.along(comparison, c), unit), fontsize=8)
        axis.set_xlim(0, comparison.end)
        axis.tick_params(labelbottom=True)
    for axis in axes.flat[max(0, len(names) - columns):len(names)]:
        axis.set_xlabel("time [s]")
    handles = [Line2D([], [], label=label, **curves.look(i)) for i, label in comparison.others]
    base = " relative to " + comparison.base if comparison.base else ""
    curves.finish(figure, comparison, "Displacement u%s less that of '%s': how far the runs are apart" % (base, comparison.labels[0]), directory, "differences", handles)
