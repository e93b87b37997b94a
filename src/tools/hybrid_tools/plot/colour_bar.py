# SPDX-License-Identifier: GPL-3.0-or-later
"""A colour bar beside axes of equal scales, as wide on narrow sections as on long ones."""

import numpy as np
from matplotlib.transforms import Bbox

GAP, WIDTH = 0.14, 0.16  # [in]


def draw_beside(axes, collection, label):
    """@return the bar, as high as the axes."""
    beside = axes.inset_axes([1.0, 0.0, 0.1, 1.0])  # until it is drawn

    def place(_, renderer):
        box, paper = axes.get_position(), axes.figure.transSubfigure  # not the figure's bbox, which saving may cut to what is drawn
        whole = np.ptp(paper.transform([(0, 0), (1, 0)])[:, 0]) / axes.figure.dpi
        return Bbox.from_bounds(box.x1 + GAP / whole, box.y0, WIDTH / whole, box.height)

    beside.set_axes_locator(place)
    bar = axes.figure.colorbar(collection, cax=beside)
    bar.set_label(label)
    bar.outline.set_linewidth(0.5)
    return bar
