# SPDX-License-Identifier: GPL-3.0-or-later
"""Spectral ratio to the outcrop motion over distance along a line and frequency."""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.ticker import NullFormatter, ScalarFormatter

from hybrid_run.spectra import FAINT
from hybrid_tools import style
from hybrid_tools.amplification.quantities import GAP


def with_gaps(distance, values):
    """Columns of NaN beside the gaps of the line."""
    steps = np.diff(distance)
    usual = np.median(steps)
    for cut in np.flatnonzero(steps > GAP * usual)[::-1] + 1:
        distance = np.insert(distance, cut, [distance[cut - 1] + usual, distance[cut] - usual])
        values = np.insert(values, [cut, cut], np.nan, axis=1)
    return distance, values


def draw_line(study, line, directory):
    sides = [side for side in study.sides if side.line is line and np.isfinite(side.spectral).any() and len(side.distance) > 1]
    if not sides:
        return []
    figure, axes = plt.subplots(1, len(sides), figsize=(4.4 * len(sides) + 1.2, 3.9), sharey=True, squeeze=False, constrained_layout=True)
    clear = study.frequency[np.isfinite(sides[0].spectral).any(axis=1)]
    shown = (study.frequency >= clear[0]) & (study.frequency <= clear[-1])
    top = max(np.nanmax(side.spectral[shown]) for side in sides)
    for axis, side in zip(axes[0], sides):
        distance, values = with_gaps(side.distance, side.spectral[shown])
        image = axis.pcolormesh(distance, study.frequency[shown], values, cmap="viridis", vmin=0, vmax=top,
                                shading="nearest", rasterized=True)
        axis.set_yscale("log")
        axis.yaxis.set_major_formatter(ScalarFormatter())
        axis.yaxis.set_minor_formatter(NullFormatter())
        axis.set_facecolor("#e4e4e4")
        axis.grid(False)
        axis.set_xlim(side.distance[0], side.distance[-1])
        axis.set_xlabel("distance along %s [m]" % line.name)
        if side.name != "on":
            axis.set_title(side.name)
        if study.resolved < study.frequency[shown][-1]:
            axis.axhline(study.resolved, color="white", lw=1.4, ls="--")
            axis.annotate("resolved below", (0.99, study.resolved), (0, -3), xycoords=("axes fraction", "data"), textcoords="offset points",
                          ha="right", va="top", color="white", fontsize=8)
    ticks = style.frequency_ticks(study.frequency[shown][0], study.frequency[shown][-1])
    axes[0, 0].set_yticks(ticks)
    axes[0, 0].set_ylabel("frequency [Hz]\n(outcrop over %g %% of its largest amplitude)" % (100 * FAINT))
    figure.colorbar(image, ax=axes[0, -1], pad=0.02).set_label("spectral ratio to outcrop [-]")
    style.title(figure, "Spectral ratios along %s: %s" % (line.name, study.run.title()))
    name = "ratios_" + line.name
    style.save(figure, directory, name)
    return [name]


def draw(study, directory):
    at_rest = study.at_rest()
    return [name for line in study.lines if line.name not in at_rest for name in draw_line(study, line, directory)]
