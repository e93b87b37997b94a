# SPDX-License-Identifier: GPL-3.0-or-later
"""The frames of a film: section with blocks where they are, and below it the motion of the ground with a mark at the time."""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colors import Normalize
from matplotlib.lines import Line2D
from scipy.spatial import cKDTree

from hybrid_tools import style
from hybrid_tools.plot.section_view import Section, draw_rock
from hybrid_tools.plot.water import draw_water

from .motion import DISPLACEMENT, SHEAR, TENSILE

WIDTH = 8.0  # [inches]
DPI = 100
STRIP = 1.1  # height of the strip [inches]
KINDS = ((TENSILE, style.TENSILE, "tensile"), (SHEAR, style.SHEAR, "shear"))
FARTHEST = 10.0  # blocks that flew farther than so many sizes of the section are out of the picture


def view(extent, section, whole):
    """Lower left and upper right corner of what is shown [m]: all places that blocks reach, with a margin."""
    low, high = extent.low.copy(), extent.high.copy()
    size = extent.first[1] - extent.first[0]
    far = FARTHEST * max(size)
    low, high = np.maximum(low, extent.first[0] - far), np.minimum(high, extent.first[1] + far)
    if whole and section.outline is not None:
        ends = section.outline.reshape(-1, 2)
        low, high = np.minimum(low, ends.min(axis=0)), np.maximum(high, ends.max(axis=0))
    margin = 0.06 * max(high - low) + 0.04 * max(size)
    return low - margin, high + margin


def page(low, high):
    """Figure, axes of section, colour bar and strip: the section as high as its shape wants, within 2 to 7 inches."""
    room = WIDTH - 1.75
    height = np.clip(room * (high[1] - low[1]) / (high[0] - low[0]), 2.0, 6.6)
    total = height + STRIP + 1.62
    total = 2 * np.round(total * DPI / 2) / DPI  # mp4 wants even numbers of pixels
    figure = plt.figure(figsize=(WIDTH, total), dpi=DPI)
    main = figure.add_axes([0.8 / WIDTH, (STRIP + 0.98) / total, room / WIDTH, height / total])
    bar = figure.add_axes([(0.8 + room + 0.12) / WIDTH, (STRIP + 0.98) / total, 0.13 / WIDTH, height / total])
    strip = figure.add_axes([0.8 / WIDTH, 0.5 / total, room / WIDTH, (STRIP - 0.25) / total])
    return figure, main, bar, strip


class Film:
    """Draws picture number k of a run by draw(k)."""

    def __init__(self, motion, extent, quantity, whole):
        self.motion, self.quantity = motion, quantity
        run = motion.run
        section = Section(run)
        low, high = view(extent, section, whole)
        self.figure, self.axes, bar, strip = page(low, high)
        self.factor, self.unit = style.length_unit(extent.top)
        self.unit += "/s" if quantity == "velocity" else ""
        self.draw_ground(section)
        self.add_blocks(bar, extent)
        self.set_view(low, high)
        self.section, self.water = section, []
        self.draw_water(self.motion.times[0])
        self.marker = self.draw_strip(strip, extent)
        height = self.figure.get_size_inches()[1]
        self.figure.text(0.02, 1 - 0.09 / height, run.title(), fontsize=11, fontweight="bold", va="top")
        self.clock = self.figure.text(0.02, 1 - 0.32 / height, "", fontsize=10, va="top", color=style.TEXT)
        self.add_legend()

    def draw_ground(self, section):
        if self.motion.bedrock is None:
            draw_rock(section, self.axes)
            self.cells = None
            return
        self.cells = PolyCollection([], facecolors="#eceae5", edgecolors="#d6d3cb", lw=0.2, zorder=1)
        self.axes.add_collection(self.cells)
        self.planes = LineCollection([], colors=style.BEDDING, lw=0.9, linestyles="--", zorder=2)
        self.axes.add_collection(self.planes)
        ends = np.concatenate([edges.reshape(-1, 2) for edges in section.bedding.values()] or [np.zeros((0, 2))])
        bedrock = self.motion.bedrock[0]
        self.plane_nodes = cKDTree(bedrock.points - bedrock.fields[DISPLACEMENT]).query(ends)[1] if len(ends) else np.zeros(0, int)

    def add_blocks(self, bar, extent):
        n = len(self.motion.blocks[0].starts)
        self.blocks = PolyCollection([], cmap=style.DISPLACEMENT_MAP, norm=Normalize(0, self.factor * extent.top), edgecolors="#5b4a3a",
                                     lw=0.15 if n > 300 else 0.5, zorder=3)
        self.axes.add_collection(self.blocks)
        self.lines = {}
        for kind, colour, _ in KINDS:
            self.lines[kind] = LineCollection([], colors=colour, lw=1.4, zorder=5, capstyle="round")
            self.axes.add_collection(self.lines[kind])
        self.figure.colorbar(self.blocks, cax=bar, extend="max" if n > 200 else "neither")
        bar.set_ylabel("%s [%s]" % ("speed" if self.quantity == "velocity" else "displacement", self.unit))

    def add_legend(self):
        """What the colours of joints mean, where any fail in the run."""
        failed = self.motion.failed(len(self.motion.times) - 1)
        kinds = {kind for kind, ends in failed if len(ends)}
        entries = [Line2D([], [], color=colour, lw=1.6, label=label) for kind, colour, label in KINDS if kind in kinds]
        if entries:
            height = self.figure.get_size_inches()[1]
            self.figure.legend(handles=entries, title="failed joints:", ncol=3, loc="upper right",
                               bbox_to_anchor=(0.995, 1 - 0.22 / height), alignment="left", borderaxespad=0, title_fontsize=8)

    def set_view(self, low, high):
        self.axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), xlabel="x [m]", ylabel="elevation [m]")
        self.axes.set_aspect("equal", adjustable="datalim")  # the box stays, beside its colour bar
        self.axes.grid(False)

    def draw_strip(self, axes, extent):
        """The motion that comes in, or, where there is none, the mean of what the blocks show. @return the mark of the time."""
        run, times = self.motion.run, self.motion.times
        acceleration = run.history("input/acceleration") if run.has("input/acceleration") else np.zeros((run.n, 2))
        if acceleration.any():
            component = np.abs(acceleration).max(axis=0).argmax()
            axes.plot(run.time, acceleration[:, component], color=(style.HORIZONTAL, style.VERTICAL)[component], lw=0.8)
            label, unit = "outcrop motion, " + ("horizontal", "vertical")[component], "m/s²"
        else:
            axes.plot(np.linspace(times[0], times[-1], len(extent.means)), self.factor * extent.means, color=style.HORIZONTAL, lw=1.2)
            label, unit = "mean over the blocks", self.unit
        axes.set_ylabel("[%s]" % unit)
        axes.set_title(label, fontsize=8, fontweight="normal", pad=2)
        axes.set(xlim=(times[0], times[-1]), xlabel="time [s]")
        axes.margins(y=0.1)
        return axes.axvline(times[0], color=style.TENSILE, lw=1.4)

    def draw_water(self, time):
        """Again where the level moves."""
        if self.water and not self.section.water.moves:
            return
        for artist in self.water:
            artist.remove()
        self.water = draw_water(self.section.water, self.axes, time, self.section.names())

    def draw(self, k):
        motion, time = self.motion, self.motion.times[k]
        picture = motion.blocks[k]
        self.blocks.set_verts(motion.polygons(picture, motion.drawn(picture, time)))
        self.blocks.set_array(self.factor * motion.values(picture, time, self.quantity))
        for kind, ends in motion.failed(k):
            self.lines[kind].set_segments(ends)
        if self.cells is not None and k < len(motion.bedrock):
            bedrock = motion.bedrock[k]
            points = motion.drawn(bedrock, time)
            self.cells.set_verts(motion.polygons(bedrock, points))
            self.planes.set_segments(points[self.plane_nodes].reshape(-1, 2, 2))
        self.draw_water(time)
        self.marker.set_xdata([time, time])
        scaled = "" if motion.scale == 1 else "    displacements drawn %g times as large" % motion.scale
        self.clock.set_text("t = %.*f s%s" % (self.digits(), time, scaled))
        return self.blocks,

    def digits(self):
        step = np.diff(self.motion.times).mean()
        return 1 if step >= 0.1 else 2 if step >= 0.01 else 3
