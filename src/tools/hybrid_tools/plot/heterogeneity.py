# SPDX-License-Identifier: GPL-3.0-or-later
"""Heterogeneity: the section by modulus and joint strength, and the histograms over Weibull's density."""

import math

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection, PolyCollection

from hybrid_run import NotInScene
from hybrid_tools import style

from . import colour_bar
from .section_view import Section, draw_rock, margin_of, set_view


def density(x, shape):
    """Weibull's density of mean 1."""
    scale = 1 / math.gamma(1 + 1 / shape)
    return shape / scale * (x / scale) ** (shape - 1) * np.exp(-((x / scale) ** shape))


def draw_histogram(axes, values, shape, label):
    axes.hist(values, bins=min(50, max(10, len(values) // 20)), density=True, color="#e9b872", edgecolor="white", lw=0.4,
              label="%d values, mean %.3f" % (len(values), values.mean()))
    x = np.linspace(1e-3, max(values.max(), 2), 400)
    axes.plot(x, density(x, shape), color=style.HORIZONTAL, lw=1.4, label="Weibull, shape %g, mean 1" % shape)
    axes.set_xlabel(label)
    axes.set_ylabel("density")
    axes.set_ylim(0, 1.3 * axes.get_ylim()[1])
    axes.legend(loc="upper left")


def draw_section(section, axes, collection, label):
    draw_rock(section, axes)
    axes.add_collection(collection)
    colour_bar.draw_beside(axes, collection, label)
    set_view(axes, section.low, section.high, margin_of(section))


def marks_of(run, section, name):
    """Blocks by their modulus, or joints by their strength."""
    values = run.get("heterogeneity/%s_factor" % name)
    if name == "modulus":
        return PolyCollection(section.blocks, array=values, cmap="viridis", edgecolors="none", zorder=3)
    return LineCollection(run.get("heterogeneity/joint_ends").reshape(-1, 2, 2), array=values, cmap="viridis", lw=1.2, zorder=5)


def draw(run, directory):
    rows = []
    section = None
    for name, label in (("modulus", "modulus / mean"), ("strength", "strength / mean")):
        if not run.has("heterogeneity/" + name + "_factor"):
            continue
        section = section or Section(run)
        values = run.get("heterogeneity/" + name + "_factor")
        shape = float(np.ravel(run.attribute("heterogeneity", name + "_shape"))[0])
        rows.append((values, shape, label, marks_of(run, section, name)))
    if not rows:
        raise NotInScene("the scene is not heterogeneous")
    figure, axes = plt.subplots(len(rows), 2, figsize=(12, 3.4 * len(rows) + 0.4), squeeze=False,
                                gridspec_kw={"width_ratios": [2.2, 1]}, constrained_layout=True)
    for (left, right), (values, shape, label, marks) in zip(axes, rows):
        draw_section(section, left, marks, label)
        draw_histogram(right, values, shape, label)
    axes[-1, 0].set_xlabel("x [m]")
    style.title(figure, "Heterogeneity: " + run.title())
    style.save(figure, directory, "heterogeneity")
