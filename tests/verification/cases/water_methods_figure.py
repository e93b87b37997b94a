# SPDX-License-Identifier: GPL-3.0-or-later
"""Figure of a block in water: histories of both methods over each other, and the closed form."""


def draw(figure, shown, ordinate):
    """shown: {method: (times [s], values of the program, those of the closed form)}; ordinate: words for the values with their unit."""
    axes = figure.subplots()
    for method, (time, values, closed) in shown.items():
        axes.plot(time, values, lw=3 if method == "submerged" else 1.2, alpha=0.6, label="program, " + method)
    axes.plot(time, closed, "k--", lw=0.9, label="closed form")
    axes.set_xlabel("time [s]")
    axes.set_ylabel(ordinate)
    axes.legend()
