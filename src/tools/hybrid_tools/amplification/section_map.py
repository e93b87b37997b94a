# SPDX-License-Identifier: GPL-3.0-or-later
"""The section with its lines coloured by amplification."""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colors import Normalize
from matplotlib.ticker import MaxNLocator

from hybrid_tools import style
from hybrid_tools.amplification.quantities import GAP

AMPLIFICATION = "plasma"
OFFSET = 2.6  # points that the two sides of a plane are drawn apart
SLENDER = 5  # times as high as wide: a column is drawn wider than it is
PIECES = 100  # of a line at least, in each of which the colour is one


def outline(run, axes):
    """Bedrock and blocks, faint."""
    if run.has("section/cells"):
        cells = run.get("section/cells").reshape(-1, 4, 2)
        axes.add_collection(PolyCollection(cells, facecolors="#eeece8", edgecolors="#eeece8", lw=0.2, zorder=0))
    if run.has("section/blocks_points"):
        axes.add_collection(PolyCollection(run.blocks.polygons, facecolors="#f3dfb5", edgecolors="#c9b58a", lw=0.2, zorder=1))
    if run.has("section/outline"):
        axes.add_collection(LineCollection(run.get("section/outline").reshape(-1, 2, 2), colors=style.ROCK_EDGE, lw=0.9, zorder=2))


def limits(run, studied):
    points = [side.position for side in studied]
    for path in ("section/outline", "section/cells", "section/blocks_points"):
        if run.has(path):
            points.append(run.get(path).reshape(-1, 2))
    points = np.vstack(points)
    return points.min(axis=0), points.max(axis=0)


def frame(run, studied, axes):
    low, high = limits(run, studied)
    margin = 0.02 * (high - low).max()
    axes.set_xlim(low[0] - margin, high[0] + margin)
    axes.set_ylim(low[1] - margin, high[1] + 3 * margin)
    width, height = high - low
    if width < height / SLENDER:
        axes.set_aspect("auto")
        axes.set_xlim(low[0] - 0.1 * width, high[0] + 0.1 * width)
        axes.xaxis.set_major_locator(MaxNLocator(4))
        axes.set_title("width not to scale", fontweight="normal", fontsize=8)
    else:
        axes.set_aspect("equal")
    axes.grid(False)
    axes.set_xlabel("x [m]")
    axes.set_ylabel("elevation [m]")


def figure_size(low, high, width=9.0):
    if high[0] - low[0] < (high[1] - low[1]) / SLENDER:
        return 3.6, 5.0
    aspect = np.clip((high[1] - low[1]) / max(high[0] - low[0], 1e-9), 0.12, 1.3)
    return (width, width * aspect * 0.9 + 1.0) if aspect < 0.7 else (4.0 / aspect + 2.5, 5.0)


def runs_of(points, gap):
    """Slices of consecutive points that are not farther apart than a gap."""
    cuts = np.flatnonzero(np.hypot(*np.diff(points, axis=0).T) > gap) + 1
    return [slice(a, b) for a, b in zip([0, *cuts], [*cuts, len(points)]) if b - a > 1]


def in_pieces(points, values):
    """A line of few points with more of them between, as the lines of other figures run."""
    distance = np.r_[0, np.cumsum(np.hypot(*np.diff(points, axis=0).T))]
    if len(points) >= PIECES or distance[-1] <= 0:
        return points, values
    fine = np.union1d(distance, np.linspace(0, distance[-1], PIECES))
    return np.column_stack([np.interp(fine, distance, c) for c in points.T]), np.interp(fine, distance, values)


def coloured(axes, points, values, norm, shift):
    """@param shift of the line to its left [points]"""
    steps = np.hypot(*np.diff(points, axis=0).T)
    for part in runs_of(points, GAP * np.median(steps)):
        p, v = in_pieces(points[part], values[part])
        normal = np.array([-(p[-1] - p[0])[1], (p[-1] - p[0])[0]])
        normal = shift * normal / max(np.hypot(*normal), 1e-30)
        moved = axes.transData + plt.matplotlib.transforms.ScaledTranslation(*(normal / 72), axes.figure.dpi_scale_trans)
        segments = np.stack([p[:-1], p[1:]], axis=1)
        axes.add_collection(LineCollection(segments, array=0.5 * (v[1:] + v[:-1]), cmap=AMPLIFICATION, norm=norm, lw=4.0, zorder=4,
                                           transform=moved, capstyle="butt"), autolim=False)


def draw(study, directory):
    low, high = limits(study.run, study.sides)
    figure, axes = plt.subplots(figsize=figure_size(low, high), constrained_layout=True)
    outline(study.run, axes)
    frame(study.run, study.sides, axes)
    values = np.concatenate([side.ratio for side in study.sides])
    norm = Normalize(values.min(), max(values.max(), values.min() + 1e-3))
    for side in study.sides:
        coloured(axes, side.position, side.ratio, norm, {"above": OFFSET, "below": -OFFSET, "on": 0.0}[side.name])
    top = max(study.sides, key=lambda side: side.ratio.max())
    k = top.largest()
    axes.plot(*top.position[k], "v", ms=7, mfc="none", mec=style.TEXT, mew=1.1, zorder=6)
    axes.annotate("%.2f" % top.ratio[k], top.position[k], (0, 8), textcoords="offset points", ha="center", fontsize=8, zorder=7)
    bar = figure.colorbar(plt.cm.ScalarMappable(norm, AMPLIFICATION), ax=axes, shrink=0.8, pad=0.02)
    bar.set_label("peak a$_%s$ / outcrop [-]" % study.letter)
    style.title(figure, "Section: " + study.run.title())
    style.save(figure, directory, "section")
    return ["section"]
