# SPDX-License-Identifier: GPL-3.0-or-later
"""Spectral ratios at points of the lines beside the transfer function of the layered column under each."""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.lines import Line2D
from matplotlib.ticker import NullFormatter, ScalarFormatter

from hybrid_run import MissingData, konno_ohmachi, motion_in_column
from hybrid_run.spectra import FAINT
from hybrid_tools import style

COLOURS = ("#0072b2", "#d55e00", "#009e73")


def points_of(side):
    """Upper tip, largest, lower tip, each once."""
    upper, lower = side.tips()
    return list(dict.fromkeys((upper, side.largest(), lower)))


def column_ratio(study, side, k):
    """Smoothed as the run's ratio is: both spectra, and not their ratio."""
    fine = np.linspace(0, 1.3 * study.frequency[-1], 4001)[1:]
    ratio = motion_in_column(study.run, side.position[k], fine, side.name, is_pressure=study.component == 1)
    outcrop = np.interp(fine, *study.outcrop_amplitude())
    smooth = konno_ohmachi(fine, np.column_stack([ratio * outcrop, outcrop]), study.frequency, study.bandwidth)
    return np.where(study.is_clear, smooth[:, 0] / smooth[:, 1], np.nan)


def draw(study, directory):
    at_rest = study.at_rest()
    sides = [side for side in study.sides if side.name != "below" and side.line.name not in at_rest]
    if not sides:
        raise MissingData("nothing moves along the lines")
    if not study.is_clear.any():
        raise MissingData("the outcrop motion has next to no energy at the frequencies of the ratios")
    columns = min(len(sides), 3)
    rows = -(-len(sides) // columns)
    figure, grid = plt.subplots(rows, columns, figsize=(3.6 * columns + 0.8, 3.1 * rows + 0.4), squeeze=False, constrained_layout=True)
    has_column = False
    clear = study.frequency[study.is_clear]
    limits = clear[0], clear[-1]
    for axis, side in zip(grid.flat, sides):
        for k, colour in zip(points_of(side), COLOURS):
            axis.plot(study.frequency, side.spectral[:, k], color=colour, label="s = %.4g m, y = %.4g m" % (side.distance[k], side.position[k, 1]))
            try:
                axis.plot(study.frequency, column_ratio(study, side, k), color=colour, ls="--", lw=0.9)
                has_column = True
            except MissingData:
                pass
        axis.set_xscale("log")
        axis.xaxis.set_major_formatter(ScalarFormatter())
        axis.xaxis.set_minor_formatter(NullFormatter())
        axis.set_xticks(style.frequency_ticks(*limits))
        axis.set_xlim(*limits)
        axis.axhline(1, color="#8a8a8a", lw=0.7)
        if study.resolved < limits[1]:
            axis.axvspan(study.resolved, limits[1], color="#eeeeee", lw=0, zorder=0)
        top = np.nanmax(axis.dataLim.intervaly[1:] if np.isfinite(axis.dataLim.y1) else [1.0])
        axis.set_ylim(0, 1.35 * top)
        axis.legend(loc="upper left", fontsize=7, handlelength=1.2)
        axis.set_title(side.label)
    for axis in grid.flat[len(sides):]:
        axis.axis("off")
    for axis in grid[:, 0]:
        axis.set_ylabel("spectral ratio to outcrop [-]")
    for axis in grid.flat[max(0, len(sides) - columns) : len(sides)]:
        axis.set_xlabel("frequency [Hz]\n(outcrop over %g %% of its largest amplitude)" % (100 * FAINT))
    handles = [Line2D([], [], color=style.TEXT, label="run")]
    if has_column:
        handles.append(Line2D([], [], color=style.TEXT, ls="--", lw=0.9, label="1D column under the point (planes taken as level)"))
    if study.resolved < limits[1]:
        handles.append(plt.matplotlib.patches.Patch(color="#e4e4e4", label="not resolved"))
    figure.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, 0.0), ncol=3)
    style.title(figure, "Spectral ratios at points: " + study.run.title())
    style.save(figure, directory, "points")
    return ["points"]
