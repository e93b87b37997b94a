# SPDX-License-Identifier: GPL-3.0-or-later
"""Figure: largest error of each setting against its processor time, with the Pareto front."""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.ticker import FuncFormatter, NullFormatter
from matplotlib.transforms import Bbox

from hybrid_tools import style
from hybrid_tools.study import tables

MARKS = "osD^vP*X"
MOST_LABELS = 12
FLOOR = 1e-9  # smaller errors, which are round-off, are drawn here


def plain(value, _=None):
    return "%g" % value


def percent(value, _=None):
    return "%g" % (100 * value)


def logarithmic(axes, x, y):
    """Axes with plain numbers that leave room about the points; times within a factor of three are on a plain axis."""
    for axis, values, words, name in ((axes.xaxis, x, plain, "x"), (axes.yaxis, y, percent, "y")):
        low, high = min(values), max(values)
        if name == "x" and high < 3 * low:
            width = max(high - low, 0.1 * high)
            axes.set_xlim(low - 0.1 * width, high + 0.25 * width)
            continue
        getattr(axes, "set_%sscale" % name)("log")
        room = max((high / low) ** 0.12, 1.4)
        getattr(axes, "set_%slim" % name)(low / room, high * room)
        steps = range(1, 10) if high / low < 3 else (1, 2, 5) if high / low < 300 else (1,)
        axis.set_ticks([m * 10.0**k for k in range(-9, 9) for m in steps if low / room <= m * 10.0**k <= high * room])
        axis.set_major_formatter(FuncFormatter(words))
        axis.set_minor_formatter(NullFormatter())


def along(corners):
    """Boxes along a line [pixels]."""
    fractions = np.linspace(0, 1, 60)
    points = [a + fraction * (b - a) for a, b in zip(corners, corners[1:]) for fraction in fractions]
    return [Bbox.from_bounds(x - 1, y - 1, 2, 2) for x, y in points]


def write_labels(figure, axes, entries, lines):
    """Words beside points [(x, y, words)], where they cover neither points, the lines nor each other; those without a place are left out."""
    figure.canvas.draw()
    points = [axes.transData.transform((x, y)) for x, y, _ in entries]
    taken = [Bbox.from_bounds(x - 6, y - 6, 12, 12) for x, y in points]
    taken += [box for line in lines for box in along(axes.transData.transform(line))]
    for (x, y, words), place in zip(entries, points):
        for dx, dy, side in ((7, 5, "left"), (7, -12, "left"), (-7, 5, "right"), (-7, -12, "right"), (7, 16, "left"), (-7, 16, "right")):
            label = axes.annotate(words, (x, y), xytext=(dx, dy), textcoords="offset points", ha=side, fontsize=7.5, color=style.TEXT)
            box = label.get_window_extent()
            if axes.bbox.x0 <= box.x0 and box.x1 <= axes.bbox.x1 and not any(box.overlaps(other) for other in taken):
                taken.append(box)
                break
            label.remove()


def label_of(study, setting, axes):
    return ", ".join(study.axes[k].labels[setting.levels[k]] for k in axes)


def draw(analysis, directory):
    """error_over_time.png; nothing if fewer than two settings have an error and a time."""
    study, found = analysis.study, tables.judged(analysis)
    if len(found) < 2:
        return
    fronts = [tables.front_of(entries) for entries in tables.problems(analysis).values()]
    front = [entry for entries in fronts for entry in entries]
    figure, axes = plt.subplots(figsize=(8.5, 5.2), constrained_layout=True)
    groups, own = {}, study.axes_of("options", "models")
    for entry in found:
        key = ", ".join(tables.level_columns(study, entry.setting.levels)[k] for k in own) or "setting"
        groups.setdefault(key, []).append((entry.cost, max(entry.error, FLOOR)))
    corners = [[(entry.cost, max(entry.error, FLOOR)) for entry in entries] for entries in fronts]
    for k, line in enumerate(corners):
        words = "Pareto front" if len(corners) == 1 else "Pareto front of each problem"
        axes.plot(*zip(*line), color=style.TEXT, lw=1.2, label=words if k == 0 else None, zorder=2)
    colours = plt.get_cmap("viridis")(np.linspace(0.1, 0.8, len(groups)))
    for (name, points), mark, colour in zip(groups.items(), MARKS * len(groups), colours):
        axes.plot(*zip(*points), mark, color=colour, ms=6, mec="white", mew=0.6, label=name, zorder=3)
    tolerances = [study.tolerance] if study.tolerance else []
    logarithmic(axes, [entry.cost for entry in found], [max(entry.error, FLOOR) for entry in found] + tolerances)
    if study.tolerance:
        axes.axhline(study.tolerance, color=style.TENSILE, lw=1.0, ls="--", label="tolerance %.3g %%" % (100 * study.tolerance))
    first = {entry.setting.levels for entry in front}
    labelled = front if len(found) > MOST_LABELS else front + [entry for entry in found if entry.setting.levels not in first]
    axes.set_xlabel("processor time [s]")
    axes.set_ylabel("largest error [%]")
    ladders = study.axes_of("ladder") or own
    names = "labels: " + ", ".join(study.axes[k].title for k in ladders)
    axes.legend(loc="center left", bbox_to_anchor=(1.0, 0.5), title=names, title_fontsize=8)
    style.title(figure, "What accuracy costs: " + (study.base.get("Title") or "study"))
    lines = corners + [[(x, study.tolerance) for x in axes.get_xlim()]] * bool(study.tolerance)
    write_labels(figure, axes, [(e.cost, max(e.error, FLOOR), label_of(study, e.setting, ladders)) for e in labelled], lines)
    style.save(figure, directory, "error_over_time")
