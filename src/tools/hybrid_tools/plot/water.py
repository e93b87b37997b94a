# SPDX-License-Identifier: GPL-3.0-or-later
"""The water of a section: a level, which may move, and a phreatic line."""

import numpy as np
from matplotlib.lines import Line2D

from hybrid_tools import style

DASHES = (0, (7, 3))


class Water:
    """line: points of the phreatic line [m], or None. moves: the level changes in time."""

    def __init__(self, run):
        level = run.attribute("section", "water_level")
        self.at_start = None if level is None else float(np.ravel(level)[0])
        self.levels = run.get("section/water_levels") if run.has("section/water_levels") else None
        self.line = run.get("section/water_line") if run.has("section/water_line") else None
        self.moves = self.levels is not None and np.ptp(self.levels[:, 1]) > 0
        self.end = run.time[-1] if run.n else 0.0

    def level(self, time=0.0):
        """[m], or None without one; linear between the rows of its table and constant beyond them, as in the run."""
        return self.at_start if self.levels is None else float(np.interp(time, *self.levels.T))

    def label(self, time):
        text = "%.4g m" % self.level(time)
        return text + " at %.3g s" % time if self.moves else text


def draw_phreatic_line(points, axes):
    """Constant beyond its ends. @return what was drawn."""
    x = np.unique(np.concatenate([axes.get_xlim(), points[:, 0]]))
    return axes.plot(x, np.interp(x, *points.T), color=style.WATER, lw=1.1, zorder=3, scalex=False, scaley=False)


def draw_level(water, axes, time=0.0):
    """A line where the level stands. @return what was drawn: nothing without one, or beyond the view."""
    low, high = axes.get_ylim()
    level = water.level(time)
    if level is None or not low < level < high:
        return []
    return [axes.axhline(level, color=style.WATER, lw=1.1, ls=DASHES, zorder=3)]


def draw_water(water, axes, time=0.0, keep_off=()):
    """Level, with the usual triangle and its height, and phreatic line. keep_off: points that have names. @return what was drawn."""
    drawn = draw_phreatic_line(water.line, axes) if water.line is not None else []
    line = draw_level(water, axes, time)
    if not line:
        return drawn
    level, (left, right), (bottom, top) = water.level(time), axes.get_xlim(), axes.get_ylim()
    near = [x for x, y in keep_off if abs(y - level) < 0.15 * (top - bottom) and left < x < right]
    is_right = len(near) > 0 and np.mean(near) < 0.5 * (left + right)
    x = right - 0.02 * (right - left) if is_right else left + 0.02 * (right - left)
    mark = axes.plot(x, level, marker=7, ms=8, color=style.WATER, zorder=6, clip_on=False)
    text = axes.annotate(water.label(time), (x, level), (-9 if is_right else 9, 3), textcoords="offset points",
                         ha="right" if is_right else "left", color=style.WATER, fontsize=8, path_effects=style.HALO, zorder=7)
    return drawn + line + mark + [text]


def entries(water, has_level):
    """For a legend of a section at the start. has_level: its level is in the view."""
    result = []
    if has_level:
        way = " (%.4g to %.4g m)" % (water.levels[:, 1].min(), water.levels[:, 1].max()) if water.moves else ""
        result.append(Line2D([], [], color=style.WATER, lw=1.1, ls=DASHES, label="water " + water.label(0.0) + way))
    if water.line is not None:
        result.append(Line2D([], [], color=style.WATER, lw=1.1, label="phreatic line"))
    return result
