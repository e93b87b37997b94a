# SPDX-License-Identifier: GPL-3.0-or-later
"""Figure: processor time of each option and effect against the finest run, and what it changes."""

import matplotlib.pyplot as plt

from hybrid_tools import style
from hybrid_tools.study import tables


def draw(analysis, directory):
    """costs.png; nothing without options and effects."""
    rows = [row for row in tables.options(analysis).rows if row[1] is not None]
    if len(rows) < 2:
        return
    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 1.2 + 0.42 * len(rows)), sharey=True, constrained_layout=True)
    places = range(len(rows))
    left.barh(places, [row[1] for row in rows], color=[style.ROCK_EDGE] + [style.HORIZONTAL] * (len(rows) - 1), height=0.6)
    for place, row in zip(places, rows):
        left.text(row[1], place, " %.3g s%s" % (row[1], " (%.2f)" % row[2] if place and row[2] else ""), va="center", fontsize=8)
    left.set_yticks(list(places), [row[0] for row in rows])
    left.invert_yaxis()
    left.set_xlim(0, 1.3 * max(row[1] for row in rows))
    left.set_xlabel("processor time [s] (times that of the finest run)")
    changes = [min(100 * (row[3] or 0.0), 1000.0) for row in rows]
    right.barh(places, changes, color=style.VERTICAL, height=0.6)
    for place, row, change in zip(places, rows, changes):
        if place:
            words = " %s%s" % (tables.part(row[3]), ", " + tables.in_words(row[4]) if row[4] else "")
            right.text(change, place, words, va="center", fontsize=8)
    right.set_xlim(0, 1.9 * max(max(changes), 1e-3))
    right.set_xlabel("largest change of a result [%]")
    for axes in (left, right):
        axes.grid(axis="y", visible=False)
    style.title(figure, "What options and effects cost: " + (analysis.study.base.get("Title") or "study"))
    style.save(figure, directory, "costs")
