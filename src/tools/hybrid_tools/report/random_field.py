# SPDX-License-Identifier: GPL-3.0-or-later
"""What a random (heterogeneous) field of modulus and strength was: where it is weak, and how its values are spread."""

import matplotlib.pyplot as plt
import numpy as np

from hybrid_run import NotInScene
from hybrid_tools.plot import heterogeneity, section_view

from .panels import WIDTH, give_room

OF = {"modulus": "Young's modulus of the blocks", "strength": "Cohesion and tensile strength of the joints"}


def panel_of(run, name):
    """The section over the histogram with Weibull's density."""
    path = "heterogeneity/%s_factor" % name
    if not run.has(path):
        raise NotInScene("the scene has no random %s" % name)
    values, section = run.get(path), section_view.Section(run)
    shape = float(np.ravel(run.attribute("heterogeneity", name + "_shape"))[0])
    size = section.high - section.low
    height = np.clip(3.9 * size[1] / size[0], 1.4, 4.0)
    figure, axes = plt.subplots(2, 1, figsize=(WIDTH, height + 3.2), gridspec_kw={"height_ratios": [height, 2.1]}, constrained_layout=True)
    heterogeneity.draw_section(section, axes[0], heterogeneity.marks_of(run, section, name), name + " / mean")
    give_room(axes[0])
    axes[0].set_xlabel("x [m]")
    heterogeneity.draw_histogram(axes[1], values, shape, name + " / mean")
    seed = run.parameters.get("Heterogeneity/Seed", "?")
    weak = np.mean(values < 0.5)
    about = "%s over the mean that the material says: Weibull's distribution of shape %g, seed %s; " % (OF[name], shape, seed)
    return figure, about + "%d values from %.2g to %.2g, %.0f %% of them below one half." % (len(values), values.min(), values.max(), 100 * weak)


def modulus(run):
    return panel_of(run, "modulus")


def strength(run):
    return panel_of(run, "strength")
