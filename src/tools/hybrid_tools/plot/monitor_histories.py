# SPDX-License-Identifier: GPL-3.0-or-later
"""Histories of the monitors: one figure per group, one row per monitor, shared axes."""

import matplotlib.pyplot as plt
import numpy as np

from hybrid_run import MissingData
from hybrid_tools import style

GROUP_TITLES = {"S": "Monitors on the surface", "D": "Monitors at depth", "other": "Other monitors", "base": "Base monitor"}


def position_text(run, name):
    position = run.attribute("monitors/" + name, "position")
    return "" if position is None else "x = %.0f m, y = %.1f m" % tuple(position)


def displacement(run, name):
    """Relative to the base; that of the base monitor itself is absolute."""
    if name == run.base:
        return run.history("monitors/" + name + "/displacement")
    return run.relative_displacement(name)


def draw_group(run, group, names, directory):
    height = max(0.95 * len(names) + 1.1, 2.6)
    # Margins that are known: measuring every label of every panel, as constrained_layout and a tight box do, takes half of the time.
    figure, axes = plt.subplots(len(names), 3, figsize=(12, height), sharex=True, sharey="col", squeeze=False, gridspec_kw={
        "left": (0.65 + 0.12 * max(len(name) for name in names)) / 12, "right": 0.985, "bottom": 0.48 / height, "top": 1 - 0.62 / height, "wspace": 0.17, "hspace": 0.12})
    relative = [displacement(run, name) for name in names]
    factor, unit = style.length_unit(max(np.abs(u).max() for u in relative))
    for row, name in enumerate(names):
        time, velocity = run.filtered("monitors/" + name + "/velocity")
        acceleration = run.filtered("monitors/" + name + "/acceleration")[1]
        columns = ((run.time, factor * relative[row]), (time, velocity), (time, acceleration))
        for axis, (t, values) in zip(axes[row], columns):
            axis.plot(t, values[:, 1], color=style.VERTICAL, lw=0.7, label="vertical (up)")
            axis.plot(t, run.downhill * values[:, 0], color=style.HORIZONTAL, lw=0.8, label="horizontal (%s)" % run.along())
            largest = np.abs(values).max(axis=0)
            axis.text(0.995, 0.97, "peak |x| %.3g, |y| %.3g" % tuple(largest), transform=axis.transAxes, fontsize=7,
                      ha="right", va="top", color="#555555", bbox={"fc": "white", "ec": "none", "alpha": 0.75, "pad": 0.8})
        axes[row, 0].set_ylabel(name, rotation=0, ha="right", va="center", fontweight="bold", fontsize=11, labelpad=10)
        axes[row, 0].text(0.01, 0.97, position_text(run, name), transform=axes[row, 0].transAxes, fontsize=7,
                          va="top", color="#555555", bbox={"fc": "white", "ec": "none", "alpha": 0.75, "pad": 0.8})
    against = "" if not run.base else ", absolute" if group == "base" else " relative to " + run.base
    axes[0, 0].set_title("displacement%s [%s]" % (against, unit))
    low_pass = " below %g Hz" % run.corner if run.corner > 0 else ""
    axes[0, 1].set_title("velocity%s [m/s]" % low_pass)
    axes[0, 2].set_title("acceleration%s [m/s²]" % low_pass)
    for axis in axes[0]:  # room for the words in the upper corners
        low, high = axis.get_ylim()
        axis.set_ylim(low, high + 0.3 * (high - low))
    for axis in axes[-1]:
        axis.set_xlabel("time [s]")
        axis.set_xlim(run.time[0], run.time[-1])
    handles, labels = axes[0, 0].get_legend_handles_labels()
    style.title(figure, GROUP_TITLES[group] + ": " + run.title(), beside=2.2)
    figure.legend(handles[::-1], labels[::-1], loc="upper right", ncol=2)
    style.save(figure, directory, "monitors_" + group, is_measured=True)


def draw_overlay(run, axes, names):
    """Horizontal displacement of all monitors of a group in one picture, downhill (or +x) positive."""
    relative = [run.downhill * run.relative_displacement(name)[:, 0] for name in names]
    factor, unit = style.length_unit(max(np.abs(u).max() for u in relative))
    colours = plt.get_cmap("viridis")(np.linspace(0.0, 0.92, len(names)))
    for name, u, colour in zip(names, relative, colours):
        axes.plot(run.time, factor * u, color=colour, lw=0.9, label=name)
    axes.set_xlim(run.time[0], run.time[-1])
    axes.set_xlabel("time [s]")
    axes.set_ylabel("%s displacement [%s]" % (run.along("horizontal"), unit))
    axes.legend(ncol=1, loc="center left", bbox_to_anchor=(1.0, 0.5), handlelength=1.2)


def draw(run, directory):
    groups = run.monitor_groups()
    if not groups or run.n < 2:
        raise MissingData("no monitors in run.h5")
    for group, names in groups.items():
        draw_group(run, group, names, directory)
