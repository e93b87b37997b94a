# SPDX-License-Identifier: GPL-3.0-or-later
"""Peak acceleration at every node and block over that of the outcrop motion."""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colors import Normalize

from hybrid_run import MissingData
from hybrid_tools import style
from hybrid_tools.amplification import section_map


def draw(study, directory):
    run = study.run
    if not run.has("fields"):
        raise MissingData("the run has no peak fields (Monitors/Peak fields, written at the end of a run)")
    parts = {name: run.get("fields/%s/peak_acceleration" % name)[:, study.component] / study.outcrop_peak
             for name in ("nodes", "blocks") if run.has("fields/%s/peak_acceleration" % name)}
    values = np.concatenate(list(parts.values()))
    norm = Normalize(0, np.quantile(values, 0.995))
    low, high = section_map.limits(run, study.sides)
    figure, axes = plt.subplots(figsize=section_map.figure_size(low, high), constrained_layout=True)
    if "nodes" in parts:
        position, cells = run.get("fields/nodes/position"), run.get("fields/nodes/cells").astype(int)
        triangles = np.vstack([cells[:, [0, 1, 2]], cells[:, [0, 2, 3]]])
        axes.tripcolor(*position.T, triangles, parts["nodes"], cmap="viridis", norm=norm, shading="gouraud", rasterized=True)
    if "blocks" in parts:
        axes.add_collection(PolyCollection(run.blocks.polygons, array=parts["blocks"], cmap="viridis", norm=norm, edgecolors="none", zorder=2))
    if run.has("section/outline"):
        axes.add_collection(LineCollection(run.get("section/outline").reshape(-1, 2, 2), colors=style.TEXT, lw=0.7, zorder=3))
    for name in run.names("section/bedding"):
        axes.add_collection(LineCollection(run.get("section/bedding/" + name).reshape(-1, 2, 2), colors="white", lw=0.8, zorder=3))
    section_map.frame(run, study.sides, axes)
    bar = figure.colorbar(plt.cm.ScalarMappable(norm, "viridis"), ax=axes, shrink=0.8, pad=0.02, extend="max")
    bar.set_label("peak a$_%s$ / outcrop [-]" % study.letter)
    style.title(figure, "Peak acceleration: " + study.run.title())
    style.save(figure, directory, "peak_acceleration")
    return ["peak_acceleration"]
