# SPDX-License-Identifier: GPL-3.0-or-later
"""Figure: error against the size of the levels of each ladder, with observed orders and slopes 1 and 2."""

import matplotlib.pyplot as plt
import numpy as np

from hybrid_tools import style
from hybrid_tools.study import tables
from hybrid_tools.study.error_over_time import FLOOR, MARKS, logarithmic

MOST = 6  # quantities in a panel
COLOURS = ("#1f5a94", "#d98b2b", "#3c8d5a", "#8a5fa8", "#c8202f", "#6f6a60")


def chosen(ladder):
    """Of each kind of quantity the one with the largest error, as many as a panel takes; two known errors make a line."""
    worst = {}
    for row in ladder.rows.values():
        kind = row.quantity.split("/")[1]
        if len(points(ladder, row)[0]) > 1 and (kind not in worst or row.errors[0] > worst[kind].errors[0]):
            worst[kind] = row
    return list(worst.values())[:MOST]


def points(ladder, row):
    """Sizes and errors; without those of the reference itself."""
    sizes = [ladder.axis.sizes[result.setting.levels[ladder.index]] for result in ladder.results]
    pairs = [(size, error) for size, error in zip(sizes, row.errors) if error > 0 and np.isfinite(error)]
    return [size for size, _ in pairs], [max(error, FLOOR) for _, error in pairs]


def slope(axes, order, sizes, top):
    """A guide of this order that ends at the largest size."""
    x = np.array([min(sizes), max(sizes)])
    y = top * (x / x[1]) ** order
    axes.plot(x, y, color="#9a9a9a", lw=0.8, ls=":" if order == 1 else "-.", label="slope %d" % order, zorder=1)


def words(row):
    if row.convergence.verdict == "does not converge":
        return "does not converge"
    return "order %.2f" % row.order if np.isfinite(row.order) else tables.NO_ORDER.get(row.convergence.verdict, "no order")


def draw_panel(axes, analysis, ladder):
    rows = [(row, *points(ladder, row)) for row in chosen(ladder)]
    for (row, x, y), mark, colour in zip(rows, MARKS, COLOURS):
        axes.plot(x, y, mark + ("--" if row.convergence.verdict == "does not converge" else "-"), color=colour, ms=5, lw=1.1,
                  label="%s, %s (%s)" % (tables.in_words(row.quantity), words(row), row.kind))
    sizes, errors = [s for _, x, _ in rows for s in x], [e for _, _, y in rows for e in y]
    if max(sizes) > min(sizes) and any(row.convergence.verdict != "does not converge" for row, _, _ in rows):
        for order in (1, 2):
            slope(axes, order, sizes, 1.5 * max(errors))
    logarithmic(axes, sizes, errors + [1.5 * max(errors)])
    axes.set_xlabel(ladder.axis.title)
    axes.set_ylabel("error [%]")
    axes.set_title(tables.ladder_title(analysis, ladder))
    axes.legend(loc="center left", bbox_to_anchor=(1.0, 0.5))


def draw(analysis, directory):
    """orders.png; nothing if no ladder has sizes."""
    ladders = [ladder for ladder in tables.ladders(analysis) if ladder.axis.sizes and chosen(ladder)]
    if not ladders:
        return
    figure, axes = plt.subplots(len(ladders), 1, figsize=(9.5, 3.6 * len(ladders) + 0.4), squeeze=False, constrained_layout=True)
    for panel, ladder in zip(axes[:, 0], ladders):
        draw_panel(panel, analysis, ladder)
    style.title(figure, "Orders of convergence: " + (analysis.study.base.get("Title") or "study"))
    style.save(figure, directory, "orders")
