# SPDX-License-Identifier: GPL-3.0-or-later
"""The sliding mass between ground and slip line."""

import numpy as np
from shapely.geometry import LineString, Point, Polygon

from hybrid_run import UserError

THINNEST = 0.2  # mass that blocks can fill, thickest place [m]


class Mass:
    """slip: where it lies below the ground, from left to right, ends on the ground [m]; polygon: of the mass."""

    def __init__(self, slip, polygon):
        self.slip, self.polygon = slip, polygon

    @property
    def thickest(self):
        """Greatest vertical thickness [m] and where, (thickness, x)."""
        left, low, right, high = self.polygon.bounds
        found = []
        for x in np.linspace(left, right, 201)[1:-1]:
            cut = self.polygon.intersection(LineString([(x, low - 1), (x, high + 1)]))
            found.append((cut.length, x))
        return max(found)

    @property
    def steepest(self):
        """Angle of its ground over a fifth of its height [deg]."""
        outline = np.array(self.polygon.exterior.coords)
        top = outline[len(self.slip) - 1:]  # from the right end of the slip line back to the left one
        line = LineString(top)
        count = max(int(5 * line.length / max(np.ptp(outline[:, 1]), 1e-9)), 2)
        points = np.array([line.interpolate(s, normalized=True).coords[0] for s in np.linspace(0, 1, count + 1)])
        run, rise = np.abs(np.diff(points, axis=0)).T
        return float(np.degrees(np.arctan2(rise, run)).max())

    @property
    def falls_left(self):
        return self.slip[0, 1] < self.slip[-1, 1]


def find_mass(slip, ground, notes):
    """Cut or extend the slip line to the ground. @raises UserError where it leaves it or bounds no mass."""
    line, surface = LineString(slip), LineString(ground)
    if not line.is_simple:
        raise UserError("the slip line crosses itself; its points must be in the order along the line")
    below = below_of(ground)
    slip = np.array(line.coords)
    reach = np.ptp(ground[:, 0])
    pieces = pieces_below(slip, below, 1e-9 * reach)
    if not pieces:
        x, y = max(slip, key=lambda p: p[1])
        raise UserError("the slip line lies above the ground or beside it: its highest point is (%g, %g) m, the ground there %s" % (
            x, y, height_in_words(ground, x)))
    if len(pieces) > 1:
        (x, y), (x2, y2) = pieces[0][-1], pieces[1][0]
        raise UserError("the slip line is above the ground between (%g, %g) and (%g, %g) m; it may leave the ground only at its ends" % (
            x, y, x2, y2))
    slip = pieces[0]
    slip = extended(slip[::-1], surface, reach, line.coords[0], "left", notes)[::-1]
    slip = extended(slip, surface, reach, line.coords[-1], "right", notes)
    along = [surface.project(Point(p)) for p in (slip[0], slip[-1])]
    top = [tuple(slip[-1])] + [p for p in ground[::-1] if min(along) < surface.project(Point(p)) < max(along)]
    polygon = Polygon(list(map(tuple, slip)) + list(map(tuple, top[1:])))
    if not polygon.is_valid or polygon.area <= 0:
        raise UserError("the slip line from (%g, %g) to (%g, %g) m bounds no mass with the ground above it" % (*slip[0], *slip[-1]))
    mass = Mass(slip, polygon)
    thickest, x = mass.thickest
    if thickest < THINNEST:
        raise UserError("the mass is %.2g m thick at most (at x = %g m); at least %g m are needed for blocks: look at the slip line or at its unit" % (
            thickest, x, THINNEST))
    return mass


def below_of(ground):
    """The half plane below the ground, as deep as it is wide."""
    depth = ground[:, 1].min() - 2 * np.ptp(ground[:, 0])
    return Polygon(list(map(tuple, ground)) + [(ground[-1, 0], depth), (ground[0, 0], depth)])


def pieces_below(slip, below, tolerance):
    """Parts of the line below the ground, in its order; parts that only graze it by less than the tolerance are none."""
    found = LineString(slip).intersection(below)
    lines = [part for part in getattr(found, "geoms", [found]) if part.geom_type == "LineString" and part.length > 0]
    lines = [part for part in lines if max(below.boundary.distance(Point(p)) for p in with_middles(part)) > max(tolerance, 1e-6 * part.length)]
    along = LineString(slip)
    parts = sorted((oriented(np.array(part.coords), along) for part in lines), key=lambda p: along.project(Point(p[0])))
    joined = []
    for part in parts:
        if joined and np.hypot(*(joined[-1][-1] - part[0])) <= 1e-6 * along.length:
            joined[-1] = np.vstack([joined[-1], part[1:]])
        else:
            joined.append(part)
    return joined


def with_middles(line):
    points = np.array(line.coords)
    return np.vstack([points, 0.5 * (points[1:] + points[:-1])])


def oriented(points, along):
    return points if along.project(Point(points[0])) <= along.project(Point(points[-1])) else points[::-1]


def extended(slip, surface, reach, given, side, notes):
    """The line, with its last point on the ground: cut there already, or straight on until it gets there."""
    end = slip[-1]
    if surface.distance(Point(end)) <= 1e-7 * reach:
        if np.hypot(*(end - given)) > 1e-6 * reach:
            notes.append("slip line: its %s end at (%g, %g) m was cut at the ground, at (%.6g, %.6g) m" % (side, *given, *end))
        return np.vstack([slip[:-1], on_line(surface, end)])
    ahead = (end - slip[-2]) / np.hypot(*(end - slip[-2]))
    hits = LineString([end, end + reach * ahead]).intersection(surface)
    points = [np.array(p.coords[0]) for p in getattr(hits, "geoms", [hits]) if not p.is_empty]
    if not points:
        raise UserError("the slip line ends inside the ground at (%g, %g) m and does not reach it straight on; give its %s end on the ground" % (
            *end, side))
    hit = min(points, key=lambda p: np.hypot(*(p - end)))
    missing = np.hypot(*(hit - end))
    if missing > 0.5 * LineString(slip).length:
        raise UserError("the slip line ends inside the ground at (%g, %g) m, %.3g m away from it straight on, more than half of its length; "
                        "give its %s end on the ground" % (*end, missing, side))
    notes.append("slip line: its %s end at (%g, %g) m was extended by %.3g m to the ground, to (%.6g, %.6g) m" % (side, *end, missing, *hit))
    return np.vstack([slip, hit])


def on_line(surface, point):
    return np.array(surface.interpolate(surface.project(Point(point))).coords[0])


def height_in_words(ground, x):
    if ground[0, 0] <= x <= ground[-1, 0]:
        return "at y = %.6g m" % np.interp(x, ground[:, 0], ground[:, 1])
    return "is not given: the profile runs from x = %g to %g m" % (ground[0, 0], ground[-1, 0])
