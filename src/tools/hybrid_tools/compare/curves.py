# SPDX-License-Identifier: GPL-3.0-or-later
"""How the figures of a comparison look: a colour and a dash for each run, one legend above all panels."""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.lines import Line2D

from hybrid_tools import style

# Okabe and Ito (2008): told apart by the colour-blind, too
COLOURS = ("#0072b2", "#e69f00", "#009e73", "#cc3311", "#8c5fa8", "#56b4e9", "#000000")
DASHES = ("-", (0, (5, 2)), (0, (1.2, 1.2)), (0, (6, 1.5, 1.2, 1.5)), (0, (3, 1)), (0, (8, 2)), (0, (1, 2)))
FEW = 6  # monitors in a figure


def look(i):
    """Keywords of the curve of run i, others for each of 49 runs: the reference lies wide below the others, which are dashed."""
    dashes = DASHES[(i + i // len(COLOURS)) % len(DASHES)]  # other dashes once the colours are used up
    return {"color": COLOURS[i % len(COLOURS)], "ls": dashes, "lw": 1.2 if i else 2.0, "zorder": 3 if i else 2.5}


def monitors_to_show(comparison):
    """The first few that differ most in their histories, in their order; the base last."""
    names = [name for name in comparison.monitors if name != comparison.base]
    if len(names) > FEW:
        def spread(name):
            first = comparison.displacement(0, name)
            return max(np.abs(comparison.displacement(i, name) - first).max() for i, _ in comparison.others)

        chosen = sorted(names, key=lambda name: -np.nan_to_num(spread(name), nan=np.inf))[:FEW]
        names = [name for name in names if name in chosen]
    return names or list(comparison.monitors)


def component(comparison, name):
    """0 (horizontal) or 1 (vertical): which moves more in the reference."""
    u, a = np.abs(comparison.displacement(0, name)).max(axis=0), np.abs(comparison.acceleration(0, name)).max(axis=0)
    return int(u[1] > u[0] and a[1] > a[0])


def along(comparison, c=0):
    """What a component is called."""
    return "up" if c else comparison.reference.along()


def panels(rows, columns, size, **options):
    """(figure, axes with rows and columns) of this size of a panel [inch]."""
    return plt.subplots(rows, columns, figsize=(columns * size[0], rows * size[1] + 0.7), squeeze=False, constrained_layout=True, **options)


def finish(figure, comparison, text, directory, name, handles=None):
    """Title, and below it one legend for all panels; saved."""
    handles = handles or [Line2D([], [], label=label, **look(i)) for i, label in enumerate(comparison.labels)]
    width, height = figure.get_size_inches()
    wide = [0.75 + 0.075 * len(handle.get_label()) for handle in handles]  # inches of each entry, about
    per_row = len(handles) if sum(wide) < width else max(1, int(width / max(wide)))
    rows = -(-len(handles) // per_row)
    below = 0.26 + 0.18 * style.title(figure, text)
    figure.get_layout_engine().set(rect=(0, 0, 1, 1 - (below + 0.1 + 0.2 * rows) / height))
    figure.legend(handles=handles, loc="upper left", bbox_to_anchor=(0.005, 1 - below / height), ncol=per_row, handlelength=3.2)
    style.save(figure, directory, name)
