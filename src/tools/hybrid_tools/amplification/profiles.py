# SPDX-License-Identifier: GPL-3.0-or-later
"""Amplification along each line, with what lies above, and against altitude."""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.patches import Patch

from hybrid_tools import style
from hybrid_tools.amplification.quantities import GAP

SIDES = {"above": ("#0072b2", "-", "above"), "below": ("#d55e00", "--", "below"), "on": ("#0072b2", "-", None)}

FEW = 20  # points of a line that are marked one by one


def mass_range(run):
    """x of the sliding mass, or None."""
    if not run.has("slip/position"):
        return None
    x = run.get("slip/position")[:, 0]
    return x.min(), x.max()


def broken(distance, values):
    """With a gap where the line has one."""
    steps = np.diff(distance)
    cuts = np.flatnonzero(steps > GAP * np.median(steps)) + 1
    return np.insert(np.asarray(distance, float), cuts, np.nan), np.insert(np.asarray(values, float), cuts, np.nan)


def draw_line(study, line, directory):
    sides = [side for side in study.sides if side.line is line]
    figure = plt.figure(figsize=(9, 4.8), constrained_layout=True)
    grid = figure.add_gridspec(2, 2, height_ratios=(2.2, 1), width_ratios=(2.6, 1))
    along, profile, altitude = figure.add_subplot(grid[0, 0]), figure.add_subplot(grid[1, 0]), figure.add_subplot(grid[:, 1])
    for side in sides:
        colour, dashes, label = SIDES[side.name]
        marks = {"marker": "o", "ms": 4} if len(side.distance) <= FEW else {}
        along.plot(*broken(side.distance, side.ratio), color=colour, ls=dashes, label=label, **marks)
        ratio, elevation = (broken(side.distance, values)[1] for values in (side.ratio, side.position[:, 1]))
        altitude.plot(ratio, elevation, color=colour, ls=dashes, marker=".", ms=3, lw=0.8)
    profile.plot(*broken(sides[0].distance, sides[0].position[:, 1]), color=style.TEXT)
    handles, _ = along.get_legend_handles_labels()
    span = mass_range(study.run)
    if span is not None and line.name != "sliding_surface":
        under = (sides[0].position[:, 0] >= span[0]) & (sides[0].position[:, 0] <= span[1])
        for axis in (along, profile):
            axis.fill_between(sides[0].distance, 0, 1, where=under, transform=axis.get_xaxis_transform(), color="#f3dfb5", lw=0, zorder=0)
        if under.any():
            handles.append(Patch(color="#f3dfb5", label="sliding mass above"))
    along.axhline(1, color="#8a8a8a", lw=0.7)
    altitude.axvline(1, color="#8a8a8a", lw=0.7)
    if handles:
        along.legend(handles=handles, loc="lower center", bbox_to_anchor=(0.5, 1.0), ncol=3)
    for axis in (along, profile):
        axis.set_xlim(sides[0].distance[0], sides[0].distance[-1])
        axis.margins(y=0.1)
    along.tick_params(labelbottom=False)
    along.set_ylim(0, max(1.1 * max(side.ratio.max() for side in sides), 1.05))
    altitude.set_xlim(left=0)
    label = "peak a$_%s$ / outcrop [-]" % study.letter
    along.set_ylabel(label)
    profile.set_xlabel("distance along %s [m]" % line.name)
    profile.set_ylabel("elevation [m]")
    altitude.set_xlabel(label)
    altitude.set_ylabel("elevation [m]")
    style.title(figure, "Amplification along %s: %s" % (line.name, study.run.title()))
    name = "profile_" + line.name
    style.save(figure, directory, name)
    return name


def draw(study, directory):
    return [draw_line(study, line, directory) for line in study.lines]
