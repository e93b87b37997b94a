# SPDX-License-Identifier: GPL-3.0-or-later
"""What each event adds, what is left after each, and how the first and the last one moved a monitor."""

import os

import matplotlib.pyplot as plt
import numpy as np

from hybrid_tools import style

MOST_LINES = 6


def draw(events, done, part, directory):
    figure, panels = plt.subplots(1, 3, figsize=(12, 3.6), constrained_layout=True, width_ratios=(1, 1.1, 1.5))
    order = sorted(done[0].points, key=lambda name: -np.linalg.norm(done[0].points[name].left))
    _added(panels[0], done, part)
    _left(panels[1], events, done, order[:MOST_LINES])
    if order:
        _first_and_last(panels[2], events, order[0], done[-1].number)
    path = os.path.join(directory, "condition.png")
    figure.savefig(path)
    plt.close(figure)
    return path


def _added(axes, done, part):
    numbers = np.array([event.number for event in done])
    sizes = 1e3 * np.array([event.sizes() for event in done])
    axes.bar(numbers - 0.2, sizes[:, 0], 0.4, color=style.HORIZONTAL, label="largest displacement of a monitor")
    if done[0].slip is not None:
        axes.bar(numbers + 0.2, sizes[:, 1], 0.4, color=style.SLIP, label="mean slip")
    axes.axhline(part * sizes[0, 0], color=style.TEXT, linewidth=0.8, linestyle="--", label="%g %% of the first" % (100 * part))
    axes.set(xlabel="event", ylabel="added [mm]", title="What each event adds", xticks=numbers)
    axes.set_ylim(top=1.45 * max(sizes.max(), 1e-9))
    axes.legend(loc="upper right")


def _left(axes, events, done, names):
    """Sums over the events, from zero."""
    for name, colour in zip(names, style.CURVES):
        left = np.cumsum([0.0] + [events.run.downhill * event.points[name].left[0] for event in done])
        axes.plot(range(len(left)), 1e3 * left, color=colour, marker="o", markersize=3.5, linewidth=1.2, label=name)
    axes.set(xlabel="after event", ylabel="left, %s [mm]" % events.run.along(), title="What is left after each event", xticks=range(len(done) + 1))
    axes.legend(loc="best", ncols=2)


def _first_and_last(axes, events, name, last):
    """Displacement of a monitor in both events, each from zero at its beginning."""
    history = events.run.downhill * events.histories[name]
    for number, colour in sorted({1: style.SLIP, last: style.HORIZONTAL}.items()):
        rows = events.span(number)
        moved = history[rows][:, 0] - events.end_of(number - 1, history)[0]
        axes.plot(events.run.time[rows] - (number - 1) * events.period, 1e3 * moved, color=colour, linewidth=0.9, label="event %d" % number)
    axes.axhline(0.0, color=style.TEXT, linewidth=0.5)
    axes.set(xlabel="time in the event [s]", ylabel="%s [mm]" % events.run.along(), title="%s in the first and the last event" % name)
    axes.legend(loc="best")
