# SPDX-License-Identifier: GPL-3.0-or-later
"""Where a new scene records: along the ground, below the sliding surface, at the base, along boreholes."""

import numpy as np
from shapely.geometry import LineString, Point

COUNT = 7  # along the ground


def place_monitors(section):
    """({name: (x, y)}, {borehole: (x, top, bottom)}): S along the ground from left to right, D in the rock under some of them, B at the base."""
    ground = LineString(section.ground)
    if section.slip is None:
        ends = slope_ends(section.ground)
    else:
        ends = section.slip[0, 0], section.slip[-1, 0]
    first, last = (ground.project(Point(point_at(section.ground, x))) for x in ends)
    beside = 0.15 * (last - first)
    inner = np.linspace(first, last, COUNT)[1:-1]
    along = np.r_[max(first - beside, 0.02 * ground.length), inner, min(last + beside, 0.98 * ground.length)]
    points = {"S%d" % k: ground.interpolate(s).coords[0] for k, s in enumerate(along, 1)}
    boreholes = {}
    for k, name in enumerate(("S2", "S4", "S6"), 1):
        x, y = points[name]
        deep = depth_of_slip(section, x, y)
        if deep is None:
            below = 0.25 * (y - section.base)
            points["D%d" % k] = (x, y - below)
        else:
            below = deep + max(2 * section.h, 0.15 * deep)
            points["D%d" % k] = (x, y - deep - max(section.h, 0.08 * deep))
        boreholes["BH%d" % k] = (x, y, y - below)
    points["B1"] = (0.5 * (section.left + section.right), section.base)
    return points, boreholes


def depth_of_slip(section, x, y):
    """Of the sliding surface's deepest point below the ground at x [m]; None without a mass there."""
    if section.slip is None:
        return None
    cut = LineString(section.slip).intersection(LineString([(x, y), (x, section.base)]))
    heights = [c[1] for part in getattr(cut, "geoms", [cut]) if not part.is_empty for c in part.coords]
    return y - min(heights) if heights else None


def slope_ends(ground):
    """x between which the ground has 5 to 95 % of its height; the middle half of level ground."""
    x = np.linspace(ground[0, 0], ground[-1, 0], 2001)
    y = np.interp(x, ground[:, 0], ground[:, 1])
    low, high = y.min(), y.max()
    between = x[(y > low + 0.05 * (high - low)) & (y < high - 0.05 * (high - low))]
    return (between[0], between[-1]) if len(between) else tuple(np.quantile(x, (0.25, 0.75)))


def point_at(ground, x):
    return x, float(np.interp(x, ground[:, 0], ground[:, 1]))
