# SPDX-License-Identifier: GPL-3.0-or-later
"""Figure: values of what does not converge, at each level and over the copies of the finest run."""

import matplotlib.pyplot as plt
import numpy as np

from hybrid_tools import style
from hybrid_tools.study import quantities, tables
from hybrid_tools.study.quantities import Number

MOST = 6


def draw(analysis, directory):
    """scatter.png; nothing if all numbers converge."""
    found = [(ladder, row) for ladder, row in tables.scattered(analysis) if isinstance(row.values[0], Number)]
    found = sorted(found, key=lambda entry: -entry[1].convergence.fine)[:MOST]
    if not found:
        return
    figure, axes = plt.subplots((len(found) + 1) // 2, min(len(found), 2), figsize=(9.5, 2.7 * ((len(found) + 1) // 2) + 0.5), squeeze=False,
                                constrained_layout=True)
    for panel, (ladder, row) in zip(axes.flat, found):
        labels = [ladder.axis.labels[result.setting.levels[ladder.index]] for result in ladder.results]
        copies = [copy.values[row.quantity].value for copy in analysis.copies(ladder.results[-1].setting.levels)[1:]
                  if row.quantity in copy.values]
        panel.plot(range(len(labels)), [value.value for value in row.values], "o--", lw=0.8, color=style.HORIZONTAL)
        if copies:
            labels.append("seeds")
            panel.plot(np.full(len(copies), len(labels) - 1), copies, "D", color=style.VERTICAL, mec="white", ms=6)
        panel.set_xticks(range(len(labels)), labels)
        panel.set_xlim(-0.4, len(labels) - 0.6)
        panel.margins(y=0.15)
        panel.set_xlabel(ladder.axis.title)
        unit = quantities.unit(row.quantity)
        panel.set_ylabel("" if unit == "-" else "[%s]" % unit)
        panel.set_title(row.quantity.replace("/", ": "))
    for panel in axes.flat[len(found) :]:
        panel.set_visible(False)
    style.title(figure, "What does not converge: " + (analysis.study.base.get("Title") or "study"))
    style.save(figure, directory, "scatter")
