# SPDX-License-Identifier: GPL-3.0-or-later
"""Displacement and acceleration of the monitors in all runs, one row per monitor."""

import numpy as np

from hybrid_run import MissingData
from hybrid_tools import style

from . import curves
from .quantities import G


def draw(comparison, directory):
    names = curves.monitors_to_show(comparison)
    if not names:
        raise MissingData("no monitors")
    figure, axes = curves.panels(len(names), 2, (5.2, 2.1), sharex=True)
    for row, name in zip(axes, names):
        c = curves.component(comparison, name)
        u = [comparison.displacement(i, name)[:, c] for i in range(len(comparison.runs))]
        factor, unit = style.length_unit(np.nanmax(np.abs(u), initial=0))
        for i, history in enumerate(u):
            row[0].plot(comparison.axis, factor * history, **curves.look(i))
            row[1].plot(comparison.axis, comparison.acceleration(i, name)[:, c] / G, **dict(curves.look(i), lw=1.4 if i == 0 else 0.9))
        row[0].set_ylabel("u %s [%s]" % (curves.along(comparison, c), unit))
        row[1].set_ylabel("a %s [g]" % curves.along(comparison, c))
        row[0].set_title(name + (", relative to " + comparison.base if comparison.base not in ("", name) else ", absolute"))
        row[1].set_title(name + ", absolute" + (", below %g Hz" % comparison.corner if comparison.corner else ""))
    for axis in axes[-1]:
        axis.set_xlabel("time [s]")
        axis.set_xlim(0, comparison.end)
    curves.finish(figure, comparison, "Histories", directory, "histories")
