# SPDX-License-Identifier: GPL-3.0-or-later
"""Horizontal velocities of the monitors, those that move alike in one panel (or as --groups says).

Velocities are absolute and below the run's low-pass, as its peaks are.
"""

import matplotlib.pyplot as plt
import numpy as np

from hybrid_run import MissingData
from hybrid_tools import style

from .monitor_choice import alike, name_of, read_groups

WIDTH = 11.0  # [inches]


def velocity(run, name):
    """(time [s], horizontal velocity [m/s], downhill or +x positive)."""
    time, values = run.filtered("monitors/%s/velocity" % name)
    return time, run.downhill * values[:, 0]


def chosen(run, text, histories):
    """(groups of names, words on them)."""
    if text is not None:
        return read_groups(text, run.names("monitors")), ""
    groups, ratio = alike(run, {name: float(np.abs(values).max()) for name, (_, values) in histories.items()})
    return groups, "" if len(groups) == 1 else "neighbours together whose peaks differ by a factor of %.2g at most" % ratio


def draw_group(run, axes, names, histories):
    for k, name in enumerate(names):
        time, values = histories[name]
        top = np.abs(values).argmax()
        axes.plot(time, values, color=style.CURVES[k % len(style.CURVES)], lw=0.8, ls="-" if k < len(style.CURVES) else "--", zorder=3 - 0.01 * k,
                  label="%s: peak %.3g m/s, %.1f s" % (name, np.abs(values[top]), time[top]))
    axes.axhline(0, color="#8a8a8a", lw=0.7, zorder=1)
    axes.set_title(name_of(names, run.names("monitors")), fontsize=9)
    axes.set_ylabel("velocity [m/s]")
    legend = axes.legend(loc="center left", bbox_to_anchor=(1.0, 0.5), handlelength=1.2)
    for line in legend.get_lines():
        line.set_linewidth(1.8)


def draw(run, directory, groups=None):
    """groups: text of --groups, None to find them."""
    names = [name for name in run.names("monitors") if run.has("monitors/%s/velocity" % name)]
    if not names or run.n < 2:
        raise MissingData("no velocities of monitors in run.h5")
    histories = {name: velocity(run, name) for name in names}
    parts, words = chosen(run, groups, histories)
    if not parts:
        raise MissingData("no monitors but the base in run.h5")
    heights = [max(1.7, 0.4 + 0.18 * len(part)) for part in parts]
    figure, axes = plt.subplots(len(parts), 1, figsize=(WIDTH, sum(heights) + 0.9), sharex=True, squeeze=False, constrained_layout=True,
                                gridspec_kw={"height_ratios": heights})
    for axis, part in zip(axes[:, 0], parts):
        draw_group(run, axis, part, histories)
    axes[-1, 0].set_xlabel("time [s]")
    axes[-1, 0].set_xlim(run.time[0], run.time[-1])
    low_pass = ", below %g Hz" % run.corner if run.corner > 0 else ""
    style.title(figure, "Velocities, horizontal (%s positive)%s: %s" % (run.along(), low_pass, run.title()))
    if words:
        figure.text(0.995, 0.002, words, ha="right", va="bottom", fontsize=7, color="#555555")
    style.save(figure, directory, "velocities")
