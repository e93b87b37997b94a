# SPDX-License-Identifier: GPL-3.0-or-later
"""Accelerations along a line as traces side by side: a section in distance and time."""

import matplotlib.pyplot as plt
import numpy as np

from hybrid_run import MissingData
from hybrid_tools import style

MOST_TRACES = 40


def window(time, values):
    """Times between which 98 % of the energy is, with a tenth more on each side."""
    energy = np.cumsum((values**2).sum(axis=1))
    if energy[-1] <= 0:
        raise MissingData("nothing moves along the lines")
    first, last = time[np.searchsorted(energy, [0.01 * energy[-1], 0.99 * energy[-1]])]
    margin = 0.1 * (last - first)
    return max(first - margin, time[0]), min(last + margin, time[-1])


def draw_line(study, line, directory):
    side = line.sides[0]
    spacing, _ = line.equal_steps(line.outcrop())
    values = line.low_passed(line.acceleration(side)[:, :, study.component])
    time = line.time[0] + spacing * np.arange(len(values))
    start, end = window(time, values)
    usual = np.median(np.diff(line.distance))  # every k-th point of an even line
    even = np.arange(line.distance[0], line.distance[-1] + 1e-6 * usual, usual * np.ceil(line.distance[-1] / usual / MOST_TRACES))
    chosen = np.unique(np.abs(line.distance[:, None] - even).argmin(axis=0))
    seen = (time >= start) & (time <= end)
    distance = line.distance[chosen]
    apart = np.median(np.diff(distance)) if len(chosen) > 1 else 1.0
    scale = 0.95 * apart / np.abs(values[:, chosen]).max()
    figure, axes = plt.subplots(figsize=(9, 5), constrained_layout=True)
    for s, trace in zip(distance, values[seen][:, chosen].T):
        axes.plot(s + scale * trace, time[seen], color=style.TEXT, lw=0.5)
        axes.fill_betweenx(time[seen], s, s + scale * trace, where=trace > 0, color="#0072b2", lw=0, interpolate=True)
    axes.set_ylim(end, start)
    axes.set_xlim(distance[0] - 2 * apart, distance[-1] + 2 * apart)
    axes.grid(False)
    axes.set_xlabel("distance along %s%s [m]" % (line.name, "" if side == "on" else ", side " + side))
    axes.set_ylabel("time [s]")
    largest = np.abs(values[:, chosen]).max()
    axes.set_title("a$_%s$, largest %.3g m/s$^2$; +%s to the right, filled" % (study.letter, largest, study.letter), fontweight="normal")
    style.title(figure, "Accelerations along %s: %s" % (line.name, study.run.title()))
    name = "wiggles_" + line.name
    style.save(figure, directory, name)
    return name


def draw(study, directory):
    at_rest = study.at_rest()
    return [draw_line(study, line, directory) for line in study.lines if len(line.distance) > 1 and line.name not in at_rest]
