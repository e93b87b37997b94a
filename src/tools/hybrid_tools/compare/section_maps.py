# SPDX-License-Identifier: GPL-3.0-or-later
"""The blocks of each run at their first place, coloured by how far they moved at most, with one colour bar."""

import numpy as np
from matplotlib.collections import PolyCollection
from matplotlib.colors import Normalize

from hybrid_run import MissingData
from hybrid_tools import style
from hybrid_tools.plot.section_view import Section, draw_rock

from . import curves
from .result_table import number


def draw(comparison, directory):
    needed = ("section/blocks_points", "section/blocks_peak_displacement")
    chosen = [i for i, run in enumerate(comparison.runs) if all(run.has(path) for path in needed)]
    if not chosen:
        raise MissingData("no displacements of blocks, which are written at the end of a run")
    sections = {i: Section(comparison.runs[i]) for i in chosen}
    low, high = view(comparison, sections)
    size = high - low
    columns = 1 if len(chosen) == 1 or size[0] > 3 * size[1] else 2
    rows = -(-len(chosen) // columns)
    width = 10.0 / columns
    figure, axes = curves.panels(rows, columns, (width, np.clip(0.85 * width * size[1] / size[0], 1.3, 5.0) + 0.5))
    top = max(np.quantile(section.peak, 0.995) if len(section.peak) > 200 else section.peak.max() for section in sections.values())
    factor, unit = style.length_unit(top)
    norm = Normalize(0, max(factor * top, 1e-9))
    for axis in axes.flat[len(chosen):]:
        axis.set_axis_off()
    for axis, (i, section) in zip(axes.flat, sections.items()):
        collection = draw_map(axis, section, factor, norm)
        axis.set_xlim(low[0], high[0])
        axis.set_ylim(low[1], high[1])
        axis.set_title("%s: at most %s %s%s" % (comparison.labels[i], number(factor * section.peak.max()), unit, during(comparison, i)))
    for axis in axes[-1]:
        axis.set_xlabel("x [m]")
    for row in axes:
        row[0].set_ylabel("elevation [m]")
    bar = figure.colorbar(collection, ax=axes, shrink=0.7, aspect=30, pad=0.015)
    bar.set_label("displacement [%s]" % unit)
    bar.outline.set_linewidth(0.5)
    style.title(figure, "Largest displacement%s (blocks at their initial place)" % next(iter(sections.values())).reference)
    style.save(figure, directory, "section_maps")


def draw_map(axis, section, factor, norm):
    edge = 0.12 if len(section.blocks) > 300 else 0.4
    collection = PolyCollection(section.blocks, array=factor * section.peak, cmap=style.DISPLACEMENT_MAP, norm=norm, edgecolors="#5b4a3a",
                                lw=edge, zorder=3)
    draw_rock(section, axis)
    axis.add_collection(collection)
    axis.set_aspect("equal")
    axis.grid(False)
    return collection


def view(comparison, sections):
    """Corners of the smallest mass of all runs (bedrock of blocks is not what one looks for), with a margin [m]."""
    section = min(sections.values(), key=lambda section: np.prod(section.high - section.low))
    margin = 0.08 * (section.high - section.low).max()
    return section.low - margin, section.high + margin


def during(comparison, i):
    """The whole run counts, not only what all have in common."""
    return "" if comparison.ends_with(i) else " in %.4g s" % comparison.runs[i].time[-1]
