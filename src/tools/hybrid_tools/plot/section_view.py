# SPDX-License-Identifier: GPL-3.0-or-later
"""The section at its true aspect ratio: blocks by displacement, bedrock, water, monitors, failed joints."""

import matplotlib.patheffects as effects
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colors import Normalize
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from shapely.geometry import MultiLineString, box

from hybrid_run.geometry import chains
from hybrid_tools import style

from . import colour_bar
from .water import Water, draw_water

ROOM_FOR_BAR = 0.6  # [in], with its numbers and its name

OUTLINE = [effects.withStroke(linewidth=2.6, foreground="#ffffffb0")]


class Section:
    """What run.h5 says about the section, read once."""

    def __init__(self, run):
        offsets = run.get("section/blocks_offsets").astype(int)
        points = run.get("section/blocks_points")
        self.blocks = np.split(points, offsets[1:-1])
        self.final_blocks = None
        if run.has("section/blocks_points_final"):
            self.final_blocks = np.split(run.get("section/blocks_points_final"), offsets[1:-1])
        self.final = self.magnitude(run, "section/blocks_displacement")
        self.peak = self.magnitude(run, "section/blocks_peak_displacement")
        self.reference = " relative to the base" if run.base else ""
        self.outline = run.get("section/outline") if run.has("section/outline") else None
        self.surface = run.surface if run.has("section/surface") else None
        self.water = Water(run)
        self.read_materials(run)
        self.low, self.high = points.min(axis=0), points.max(axis=0)
        self.show_ground_between()
        self.monitors = [(n, run.attribute("monitors/" + n, "position")) for n in run.names("monitors")]
        self.monitors = [(n, p) for n, p in self.monitors if p is not None]
        self.boreholes = [(n, run.attribute("profiles/" + n, "position")) for n in run.names("profiles")]
        self.boreholes = [(n, np.reshape(p, (2, 2))) for n, p in self.boreholes if p is not None]
        self.joints = None
        if run.has("joints/position") and run.file["joints/position"].shape[0] > 0:
            ends = run.get("joints/ends") if run.has("joints/ends") else None
            self.joints = run.get("joints/position"), run.get("joints/failure_time"), run.get("joints/failure_kind"), ends

    def show_ground_between(self):
        """The view reaches down to the ground between two masses, as the floor of a valley: to the rock that is uppermost there."""
        edges = [np.hstack([line[:-1], line[1:]]) for line in self.surface or []]
        if self.outline is not None:
            edges.append(self.outline.reshape(-1, 4))
        x, y, x_end, y_end = np.vstack(edges + [np.zeros((0, 4))]).T
        for at in np.unique([x, x_end]):
            if self.low[0] < at < self.high[0]:
                passes = (x != x_end) & (np.minimum(x, x_end) <= at) & (at <= np.maximum(x, x_end))
                part = (at - x[passes]) / (x_end - x)[passes]
                if passes.any():
                    self.low[1] = min(self.low[1], ((1 - part) * y[passes] + part * y_end[passes]).max())

    def names(self):
        """Where names of monitors stand."""
        return [position for _, position in self.monitors]

    def read_materials(self, run):
        """What the section is made of; empty where an older run does not say."""
        def numbers(path):
            return run.get(path).astype(int) if run.has(path) else np.zeros(0, int)

        self.materials = run.text(run.attribute("section", "materials", "")).split(", ")
        self.block_material = numbers("section/blocks_material")
        self.cell_material = numbers("section/cells_material")
        self.belt_material = numbers("section/belt_material")
        self.cells = run.get("section/cells").reshape(-1, 4, 2) if len(self.cell_material) else np.zeros((0, 4, 2))
        self.belt = run.get("section/belt").reshape(-1, 2, 2) if len(self.belt_material) else np.zeros((0, 2, 2))
        self.bedding = {n: run.get("section/bedding/" + n).reshape(-1, 2, 2) for n in run.names("section/bedding")}

    @staticmethod
    def magnitude(run, path):
        if not run.has(path):
            return None
        values = run.get(path)
        return np.hypot(values[:, 0], values[:, 1]) if values.ndim == 2 else np.abs(values)


def draw_rock(section, axes):
    if section.outline is not None:
        axes.add_collection(LineCollection(section.outline.reshape(-1, 2, 2), colors=style.ROCK_EDGE, lw=1.1, zorder=2))
    for segments in section.bedding.values():
        axes.add_collection(LineCollection(chains(segments), colors=style.BEDDING, lw=0.9, linestyles="--", zorder=2))
    if section.surface is not None:
        axes.add_collection(LineCollection(section.surface, colors=style.SLIP, lw=1.8, zorder=4))


def draw_materials(section, axes):
    """Areas and lines in the colour of their material, and what the colours mean."""
    entries = []
    used = np.unique(np.concatenate([section.block_material, section.cell_material]))
    for k, number in enumerate(used):
        colour = style.MATERIALS[k % len(style.MATERIALS)]
        for areas, material in ((section.cells, section.cell_material), (section.blocks, section.block_material)):
            chosen = [area for area, m in zip(areas, material) if m == number]
            axes.add_collection(PolyCollection(chosen, facecolors=colour, edgecolors=colour, lw=0.3, zorder=1))
        entries.append(Patch(facecolor=colour, edgecolor="#8a8a8a", lw=0.4, label=section.materials[number]))
    for k, number in enumerate(np.unique(section.belt_material)):
        colour = style.BELTS[k % len(style.BELTS)]
        axes.add_collection(LineCollection(section.belt[section.belt_material == number], colors=colour, lw=2.4, zorder=5))
        entries.append(Line2D([], [], color=colour, lw=2.4, label="belt: " + section.materials[number]))
    if section.bedding:
        entries.append(Line2D([], [], color=style.BEDDING, lw=0.9, ls="--", label="bedding planes"))
    if not len(section.belt) and section.surface is not None:
        entries.append(Line2D([], [], color=style.SLIP, lw=1.8, label="sliding surface"))
    axes.legend(handles=entries, loc="center left", bbox_to_anchor=(1.0, 0.5), borderaxespad=0.5)


def draw_blocks(axes, blocks, values, title, scale):
    factor, unit, norm = scale
    width = np.ptp(np.vstack(blocks), axis=0)[0]
    edge = 0.12 if len(blocks) > 300 or width > 200 else 0.4
    collection = PolyCollection(blocks, array=factor * values, cmap=style.DISPLACEMENT_MAP, norm=norm, edgecolors="#5b4a3a", lw=edge, zorder=3)
    axes.add_collection(collection)
    colour_bar.draw_beside(axes, collection, "displacement [%s]" % unit)
    axes.set_title(title)


def free_corner(section):
    """The lower corner that the mass leaves free: under its upper end."""
    middles = np.array([block.mean(axis=0) for block in section.blocks])
    left = middles[:, 0] < 0.5 * (section.low[0] + section.high[0])
    if not 0 < left.sum() < len(left):
        return "upper right"
    return "lower right" if middles[left, 1].mean() < middles[~left, 1].mean() else "lower left"


def draw_joints(section, axes):
    """Failed joints. @return what they are called: [(artist, words)]."""
    entries = []
    if section.joints is None:
        return entries
    position, time, kind, ends = section.joints
    sets = ((2, True, style.SHEAR_PALE, "shear, static stage"), (1, True, style.TENSILE_PALE, "tensile, static stage"),
            (2, False, style.SHEAR, "shear"), (1, False, style.TENSILE, "tensile"))
    for wanted, is_static, colour, label in sets:
        chosen = (kind == wanted) & ((time < 0) == is_static)
        if not chosen.any():
            continue
        if ends is not None:
            lines = LineCollection(ends[chosen].reshape(-1, 2, 2), colors=colour, lw=1.7, zorder=5, capstyle="round", path_effects=OUTLINE)
            artist = axes.add_collection(lines)
        else:
            artist, = axes.plot(position[chosen, 0], position[chosen, 1], ".", color=colour, ms=3.5, zorder=5, mew=0)
        entries.append((artist, "%s: %d" % (label, chosen.sum())))
    return entries


def planes_in_view(section, axes):
    """How many bedding planes have a part within the axes."""
    (left, right), (bottom, top) = axes.get_xlim(), axes.get_ylim()
    view = box(left, bottom, right, top)
    return sum(MultiLineString(list(segments)).intersects(view) for segments in section.bedding.values())


def explain(section, axes, joints):
    """The legend of failed joints and bedding planes, where the mass leaves room."""
    entries, title = list(joints), "failed joints"
    if number := planes_in_view(section, axes):
        plane = Line2D([], [], color=style.BEDDING, lw=0.9, ls="--")
        entries = [(artist, "failed joints, " + words) for artist, words in joints] + [(plane, "bedding plane" + "s" * (number > 1))]
        title = None
    if not entries:
        return
    legend = axes.legend(*zip(*entries), loc=free_corner(section), title=title, markerscale=2.0, frameon=True, framealpha=0.9,
                         edgecolor="#cccccc", fontsize=8, title_fontsize=8)
    legend.set_zorder(9)


def draw_labels(section, axes):
    """Monitors as dots, boreholes as lines, named where they lie in view."""
    left, right = axes.get_xlim()
    bottom, top = axes.get_ylim()
    for name, (head, foot) in section.boreholes:
        axes.plot([head[0], foot[0]], [head[1], foot[1]], color=style.TEXT, lw=1.3, zorder=6)
        if left < head[0] < right and bottom < head[1] < top:
            axes.annotate(name, head, (0, 24), textcoords="offset points", ha="center", fontsize=8, fontweight="bold", zorder=8,
                          path_effects=style.HALO, arrowprops={"arrowstyle": "-", "lw": 0.6, "color": style.TEXT, "shrinkA": 0, "shrinkB": 0})
    for name, p in section.monitors:
        if not (left < p[0] < right and bottom < p[1] < top):
            continue
        below = name.startswith("D")
        axes.plot(*p, "o", ms=4, color="white", mec=style.TEXT, mew=0.9, zorder=7)
        axes.annotate(name, p, (3, -10) if below else (-3, 5), textcoords="offset points", ha="left" if below else "right",
                      fontsize=8, color=style.TEXT, path_effects=style.HALO, zorder=8)


def set_view(axes, low, high, margin):
    size = high - low
    axes.set_xlim(low[0] - margin * size[0], high[0] + margin * size[0])
    room = max(margin * size[1], 0.007 * size[0])  # for markers on flat sections
    axes.set_ylim(low[1] - 2.0 * room, high[1] + 2.2 * room)
    axes.set_aspect("equal")
    axes.grid(False)
    axes.set_ylabel("elevation [m]")


def make_room_for_names(section, axes):
    """Names of boreholes stand below the title: about 45 points above their heads."""
    width = 0.8 * 72 * axes.figure.get_size_inches()[0] if hasattr(axes.figure, "get_size_inches") else 700
    room = 45 * np.ptp(axes.get_xlim()) / width
    heads = [head[1] for _, (head, foot) in section.boreholes]
    bottom, top = axes.get_ylim()
    axes.set_ylim(bottom, max([top] + [head + room for head in heads if head < top]))


def margin_of(section):
    """Few blocks are shown with what they stand on."""
    return 0.05 if len(section.blocks) > 20 else 0.4


def is_high(section):
    size = section.high - section.low
    return size[1] > size[0]


def line_end(section):
    """Within a title: panels of few blocks and of high sections are narrow."""
    return "\n" if len(section.blocks) <= 20 or is_high(section) else " "


def draw_whole(section, axes):
    """The whole model, small: where the sliding mass lies in it."""
    draw_rock(section, axes)
    if len(section.block_material):
        draw_materials(section, axes)
    else:
        axes.add_collection(PolyCollection(section.blocks, facecolors="#e9b872", edgecolors="none", zorder=1))
    ends = np.vstack([section.low, section.high] if section.outline is None else [section.outline.reshape(-1, 2), section.low, section.high])
    set_view(axes, ends.min(axis=0), ends.max(axis=0), 0.02)
    draw_water(section.water, axes, 0.0, section.names())
    for name, p in section.monitors:
        if not name.startswith(("S", "D")):
            axes.plot(*p, "o", ms=4, color="white", mec=style.TEXT, mew=0.9, zorder=7)
            axes.annotate(name, p, (5, 4), textcoords="offset points", fontsize=8, path_effects=style.HALO)
    axes.set_title("model")


def draw_main(section, axes):
    """Blocks at their first place, coloured by the largest displacement, with all marks."""
    values = section.peak if section.peak is not None else section.final
    draw_rock(section, axes)
    if values is None:  # a run that goes on or was killed
        axes.add_collection(PolyCollection(section.blocks, facecolors="#f3dfb5", edgecolors="#5b4a3a", lw=0.12, zorder=3))
        axes.set_title("blocks at their initial place (displacements are written at the end of a run)")
    else:
        label = "largest displacement" if section.peak is not None else "displacement at the end"
        title = label + section.reference + line_end(section) + "(blocks at their initial place)"
        draw_blocks(axes, section.blocks, values, title, scale_of(values))
    set_view(axes, section.low, section.high, margin_of(section))
    make_room_for_names(section, axes)
    draw_water(section.water, axes, 0.0, section.names())
    explain(section, axes, draw_joints(section, axes))
    draw_labels(section, axes)


def draw_final(section, axes):
    """Blocks where they lie at the end, drawn to scale."""
    draw_rock(section, axes)
    title = "displacement at the end" + line_end(section) + "(blocks where they lie then)"
    draw_blocks(axes, section.final_blocks, section.final, title, scale_of(section.final))
    points = np.vstack(section.final_blocks)
    inside = (np.abs(points - 0.5 * (section.low + section.high)) < 1.5 * (section.high - section.low)).all(axis=1)
    if inside.mean() > 0.5:  # the few that flew away are not shown
        points = points[inside]
    set_view(axes, np.minimum(section.low, points.min(axis=0)), np.maximum(section.high, points.max(axis=0)), margin_of(section))
    draw_water(section.water, axes, section.water.end, section.names())


def scale_of(values):
    """One block that flies away must not take the colours from all others: 99.5 % of them fit."""
    top = np.quantile(values, 0.995) if len(values) > 200 else values.max()
    factor, unit = style.length_unit(top)
    return factor, unit, Normalize(0, max(factor * top, 1e-9))


def panels_of(section):
    """Functions that draw, row by row; high sections stand side by side."""
    size = section.high - section.low
    is_wide = section.outline is not None and np.ptp(section.outline[:, 0::2]) > 1.4 * size[0]
    rows = [[draw_whole]] if is_wide or len(section.block_material) else []
    rows.append([draw_main])
    if section.final_blocks is not None and section.final is not None and section.final.max() > 0.01 * size.max():
        if is_high(section):
            rows[-1].append(draw_final)
        else:
            rows.append([draw_final])
    return rows


def height_of(axes, width):
    """What axes of equal scales need in a column of @p width [in]."""
    return np.clip(width * np.ptp(axes.get_ylim()) / np.ptp(axes.get_xlim()), 0.6, 5.0)


def draw(run, directory):
    section = Section(run)
    rows = panels_of(section)
    size = section.high - section.low
    width = 12 if 1.25 * size[1] < 0.6 * size[0] else 8
    figure = plt.figure(figsize=(width, 4 * len(rows)), constrained_layout=True)
    grid = figure.add_gridspec(len(rows), 1)
    heights = []
    for row, functions in enumerate(rows):
        part = grid[row].subgridspec(1, len(functions), wspace=ROOM_FOR_BAR * len(functions) / width)
        axes = [figure.add_subplot(part[k]) for k in range(len(functions))]
        for axis, function in zip(axes, functions):
            function(section, axis)
        heights.append(max(height_of(axis, 0.8 * width / len(axes)) for axis in axes))
    for axis in axes:
        axis.set_xlabel("x [m]")
    grid.set_height_ratios(heights)
    lines = 2 if line_end(section) == "\n" else 1
    figure.set_size_inches(width, sum(heights) + (0.4 + 0.2 * lines) * len(rows) + 0.5)
    style.title(figure, "Section: " + run.title())
    style.save(figure, directory, "section")
