# SPDX-License-Identifier: GPL-3.0-or-later
"""Figure: what is left along each borehole, as a band over the samples (seeds, records) of each setting, beside what was measured."""

import os

import matplotlib.pyplot as plt
import numpy as np

from hybrid_run import Run
from hybrid_tools import style
from hybrid_tools.compare.curves import COLOURS
from hybrid_tools.plot.boreholes import depth_of_slip, draw_measured, left_at_end, with_jump
from hybrid_tools.study import tables

POINTS = 200  # of a profile


def groups(analysis):
    """{words for a setting: its runs, one for each sample}, without effects and seeds."""
    study, found = analysis.study, {}
    own = study.axes_of("ladder", "options", "models")
    for result in analysis.done:
        if not result.setting.effect and not result.setting.seed:
            labels = tables.level_columns(study, result.setting.levels)
            words = ", ".join("%s %s" % (study.axes[k].short, labels[k]) for k in own) or "all"
            found.setdefault(words, []).append(result.run.path)
    return found


def profile(run, name):
    """(depths, what is left, depth of the sliding surface) of a borehole [m]."""
    path = "profiles/" + name
    depth, x = run.get(path + "/depth"), run.downhill * run.get(path + "/displacement")[:, 0::2]
    order, slip_depth = np.argsort(depth), depth_of_slip(run, path)
    return *with_jump(depth[order], left_at_end(run, x[:, order])[0], slip_depth), slip_depth


def resampled(depth, x, slip_depth):
    """At POINTS depths on each side of the sliding surface, so that profiles of other meshes have the same ones."""
    jump = np.flatnonzero(depth == slip_depth) if slip_depth is not None else []
    if len(jump) != 2:
        wanted = np.linspace(depth[0], depth[-1], 2 * POINTS)
        return wanted, np.interp(wanted, depth, x)
    sides = slice(0, jump[1]), slice(jump[1], None)
    wanted = [np.linspace(depth[side][0], depth[side][-1], POINTS) for side in sides]
    return np.concatenate(wanted), np.concatenate([np.interp(w, depth[side], x[side]) for w, side in zip(wanted, sides)])


def draw(analysis, directory):
    """profile_bands.png; nothing without boreholes or samples."""
    if not analysis.study.axes_of("samples") or not analysis.done:
        return
    found = groups(analysis)
    run = Run(analysis.done[0].run.path)
    names = [n for n in run.names("profiles") if run.has("profiles/%s/displacement" % n)]
    if not names:
        return
    figure, axes = plt.subplots(1, len(names), figsize=(max(4.2 * len(names), 5), 6), squeeze=False)
    figure.subplots_adjust(wspace=0.3)
    for axis, name in zip(axes[0], names):
        draw_borehole(axis, found, name)
    axes[0, 0].set_ylabel("depth [m]")
    axes[0, 0].legend(loc="upper left", bbox_to_anchor=(0.0, -0.1), ncol=2)
    style.title(figure, "What is left: " + (analysis.study.base.get("Title") or os.path.basename(analysis.study.directory)))
    style.save(figure, directory, "profile_bands")


def draw_borehole(axis, found, name):
    for k, (words, paths) in enumerate(found.items()):
        colour, runs = COLOURS[k % len(COLOURS)], [Run(path) for path in paths]
        profiles = [resampled(*profile(run, name)) for run in runs]
        depth, left = profiles[0][0], 1e3 * np.array([x for _, x in profiles])
        axis.fill_betweenx(depth, left.min(axis=0), left.max(axis=0), color=colour, alpha=0.18, lw=0)
        axis.plot(left.mean(axis=0), depth, color=colour, lw=1.8, label="%s: mean and limits of %d" % (words, len(paths)))
    draw_measured(runs[0], axis, name, 1.0)
    slip_depth = depth_of_slip(runs[0], "profiles/" + name)
    if slip_depth is not None:
        axis.axhline(slip_depth, color=style.SLIP, lw=1.0)
    axis.axvline(0, color="#8a8a8a", lw=0.7)
    axis.set_ylim(depth[-1], 0)
    axis.margins(x=0.08)
    axis.set_xlabel("displacement downhill [mm]")
    axis.set_title(name)
