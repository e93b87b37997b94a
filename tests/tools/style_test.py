# SPDX-License-Identifier: GPL-3.0-or-later
"""Titles of figures."""

import matplotlib.pyplot as plt

from hybrid_tools import style


def test_a_long_title_takes_more_lines_and_stays_clear_of_what_is_beside_it():
    for width, beside in ((7.0, 0.0), (7.0, 2.2), (11.0, 2.2)):
        figure, _ = plt.subplots(figsize=(width, 5.0), constrained_layout=True)
        assert style.title(figure, "Monitors: short") == 0
        words = "Monitors: " + " ".join(["a landslide with a long name on a slope of layered rock"] * 3)
        more = style.title(figure, words, beside)
        assert more > 0
        figure.canvas.draw()
        box = figure._suptitle.get_window_extent().transformed(figure.dpi_scale_trans.inverted())
        assert box.x1 < width - beside + 0.1
        assert figure._suptitle.get_text().replace("\n", " ") == words
        assert box.y0 > figure.axes[0].get_window_extent().transformed(figure.dpi_scale_trans.inverted()).y1  # above the axes
        plt.close(figure)
