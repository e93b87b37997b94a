# SPDX-License-Identifier: GPL-3.0-or-later
"""Bedding planes: cut to the bedrock, and continued from their tips until they divide it."""

import numpy as np
from shapely.geometry import LineString, MultiLineString, Point, box

from hybrid_run import UserError

THIN, TOO_THIN = 0.25, 0.1  # layers of rock over the edge length h
STEEPEST = np.tan(np.radians(50))  # of a continuation [-]


def cut_planes(planes, rock, slip, limits, notes):
    """[(name, number, points)] within the bedrock `rock` (a polygon), between the x of limits; a plane may fall into several.

    What lies on the slip line is left out: the sliding surface is there.

    @raises UserError where planes cross or lie nowhere in the bedrock.
    """
    found = []
    for number, (name, points) in enumerate(planes, 1):
        line = LineString(points)
        if not line.is_simple:
            raise UserError("bedding plane %s crosses itself" % name)
        line, shared = without(line, slip)
        if shared > 0 and line.is_empty:
            raise UserError("bedding plane %s coincides with the slip line: leave it out, the sliding surface is there already" % name)
        if shared > 0:
            notes.append("bedding_%d (%s): %.3g m of it on the slip line were left out, the sliding surface is there" % (number, name, shared))
        parts = inside(line, rock, limits)
        if not parts:
            raise UserError("bedding plane %s from (%g, %g) to (%g, %g) m lies nowhere in the bedrock: x = %.6g to %.6g m, below the ground and the slip line" % (
                name, *points[0], *points[-1], *limits))
        lost = line.length - sum(LineString(p).length for p in parts)
        if lost > 1e-3 * line.length:
            notes.append("bedding_%d (%s): %.3g m of it outside the bedrock were left out (above the ground, in the mass, or beyond the profile)" % (
                number, name, lost))
        found += [(name, number, part) for part in parts]
    refuse_crossings(found)
    return found


def without(line, slip):
    """(parts of a line that do not lie on the slip line, length of those that do [m])."""
    if slip is None:
        return line, 0.0
    near = 1e-6 * line.length
    on_slip = line.intersection(LineString(slip).buffer(near))
    longest = max((part.length for part in getattr(on_slip, "geoms", [on_slip])), default=0.0)
    if longest < 1e-3 * line.length:  # it crosses or meets the slip line
        return line, 0.0
    rest = line.difference(LineString(slip).buffer(near))
    parts = [LineString(to_corner(np.array(part.coords), slip, 1e-4 * line.length))
             for part in getattr(rest, "geoms", [rest]) if part.length > 1e-3 * line.length]
    return MultiLineString(parts), on_slip.length


def to_corner(points, slip, near):
    """Ends that lie at a corner of the slip line, on it."""
    for end in (0, -1):
        apart = np.hypot(*(slip - points[end]).T)
        if apart.min() < near:
            points[end] = slip[apart.argmin()]
    return points


def inside(line, rock, limits):
    left, right = limits
    low, high = rock.bounds[1] - 1, rock.bounds[3] + 1
    found = line.intersection(rock).intersection(box(left, low, right, high))
    parts = [part for part in getattr(found, "geoms", [found]) if part.geom_type == "LineString" and part.length > 1e-3 * line.length]
    points = [np.array(part.coords) for part in parts]
    return [p if tuple(p[-1]) > tuple(p[0]) else p[::-1] for p in points]


def refuse_crossings(planes):
    for k, (name, _, points) in enumerate(planes):
        for other, _, more in planes[:k]:
            a, b = LineString(points), LineString(more)
            shared = a.intersection(b)
            for part in getattr(shared, "geoms", [shared]):
                if part.is_empty:
                    continue
                place = Point(part.coords[0])
                is_end = [min(place.distance(Point(line.coords[e])) for e in (0, -1)) < 1e-6 * line.length for line in (a, b)]
                if not any(is_end) or part.length > 1e-6 * a.length:
                    raise UserError("bedding planes %s and %s %s at (%.6g, %.6g) m; a plane may end on another but not go through it" % (
                        other, name, "coincide" if part.length > 0 else "cross", place.x, place.y))


def look_at_layers(planes, obstacles, h, notes):
    """Layers of rock between a plane and another line that are much thinner than an element: told or refused. Where lines meet they count for nothing."""
    for k, (name, _, points) in enumerate(planes):
        line = LineString(points)
        others = obstacles + [("bedding plane " + other, LineString(more)) for other, _, more in planes[:k]]
        for what, other in others:
            ends = [Point(c) for own in (line, other) for c in (own.coords[0], own.coords[-1])]
            places = [line.interpolate(s) for s in np.arange(0, line.length, 0.5 * h)]
            found = [(other.distance(p), p) for p in places if min(p.distance(end) for end in ends) > 2 * h]
            thinnest, place = min(found, key=lambda item: item[0], default=(np.inf, None))
            if thinnest >= THIN * h:
                continue
            words = "bedding plane %s runs %.2g m beside %s at (%.6g, %.6g) m, blocks have edges of %g m" % (name, thinnest, what, place.x, place.y, h)
            if thinnest < TOO_THIN * h:
                raise UserError(words + "; at least %.2g m are needed: move it, leave it out, or give a smaller --size" % (TOO_THIN * h))
            notes.append(words + ": elements between them are distorted")


class Continuations:
    """Unnamed lines from the tips of planes on to the sides, so that every plane lies between two surfaces.

    Each goes straight on past the other tips, and from the outermost one to the side, where all are spread: lines that do not cross
    still do not. One that meets another line ends there.
    """

    def __init__(self, planes, obstacles, sides, base, tops, near):
        self.left, self.right = sides
        self.base, self.near = base, near
        self.obstacles = list(obstacles) + [LineString(points) for _, _, points in planes]
        self.tips = [tip for _, _, points in planes for tip in self.free_ends(points)]
        self.lines = []
        if self.tips:
            self.set_heights(tops)
            for k in sorted(range(len(self.tips)), key=lambda k: tuple(self.tips[k][0][::-1])):
                self.add(k)

    def free_ends(self, points):
        """(tip, slope, direction along x) of ends that lie on nothing else, nor at a side of the section."""
        line = LineString(points)
        for end, before in ((points[0], points[1]), (points[-1], points[-2])):
            if min(abs(end[0] - self.left), abs(end[0] - self.right)) <= 1e-6 * self.near:
                continue
            others = [o for o in self.obstacles if not o.equals(line)]
            if min((o.distance(Point(end)) for o in others), default=np.inf) <= 1e-6 * self.near:
                continue
            run, rise = end - before
            direction = np.sign(run) if abs(run) > 1e-9 * line.length else (-1.0 if end[0] < 0.5 * (self.left + self.right) else 1.0)
            slope = np.clip(rise / abs(run), -STEEPEST, STEEPEST) if abs(run) > 1e-9 * line.length else np.sign(rise) * STEEPEST
            yield end, slope, direction

    def set_heights(self, tops):
        """Heights at the sides, in the order in which the planes would get there: apart from each other, and from ground and base.

        Tips that are close to their side go straight on.
        """
        self.low = min(tip[1] for tip, _, _ in self.tips)
        self.goals, self.shrink = {}, 1.0
        for direction, top in zip((-1.0, 1.0), tops):
            tips = sorted((k for k, t in enumerate(self.tips) if t[2] == direction), key=lambda k: self.straight_on(*self.tips[k], self.side(direction)))
            if not tips:
                continue
            ahead = np.array([self.straight_on(*self.tips[k], self.side(direction)) for k in tips])
            height = top - self.base
            apart = min(0.6 * height / len(tips), max(4 * self.near, np.ptp(ahead) / max(len(tips) - 1, 1)))
            half = 0.5 * apart * (len(tips) - 1)
            middle = np.clip(ahead.mean(), self.base + 0.2 * height + half, top - 0.2 * height - half)
            self.goals.update({k: middle - half + apart * rank for rank, k in enumerate(tips)})
            self.goals.update({k: y for k, y in zip(tips, ahead) if abs(self.tips[k][0][0] - self.side(direction)) < 4 * self.near})
            last = max((self.tips[k][0][0] for k in tips), key=lambda x: x * direction)
            deepest = min(self.straight_on(*self.tips[k], last) for k in tips)
            if deepest < self.low:
                self.shrink = min(self.shrink, 0.5 * (self.low - self.base) / (self.low - deepest))

    @staticmethod
    def straight_on(tip, slope, _, x):
        return tip[1] + slope * abs(x - tip[0])

    def side(self, direction):
        return self.left if direction < 0 else self.right

    def height(self, y):
        """Flatter below the lowest tip, so that nothing reaches the base."""
        return np.where(y < self.low, self.low + self.shrink * (y - self.low), y)

    def add(self, k):
        tip, slope, direction = self.tips[k]
        places = [t[0] for t, _, d in self.tips if d == direction and (t[0] - tip[0]) * direction > 0] + [self.side(direction)]
        x = np.array(sorted(set([tip[0]] + places), key=lambda v: v * direction))
        points = np.column_stack([x, self.height(tip[1] + slope * np.abs(x - tip[0]))])
        points[-1, 1] = self.goals[k]
        line = LineString(points)
        hits = []
        for other in self.obstacles:
            shared = line.intersection(other)
            hits += [line.project(Point(c)) for part in getattr(shared, "geoms", [shared]) if not part.is_empty for c in part.coords]
        hits = [h for h in hits if h > 1e-6 * self.near]
        end = min(hits, default=line.length)
        cut = [tuple(tip)] + [tuple(p) for p in points if 0 < line.project(Point(p)) < end] + [line.interpolate(end).coords[0]]
        self.obstacles.append(LineString(cut))
        self.lines.append(np.array(cut))


def spacing(planes, slip, ground):
    """Smallest distance between planes that do not meet, and of them to slip line and ground where they do not meet [m]."""
    lines = [LineString(points) for _, _, points in planes]
    others = [LineString(line) for line in (slip, ground) if line is not None]
    found = [a.distance(b) for k, a in enumerate(lines) for b in lines[:k] + others]
    return min((d for d in found if d > 1e-6), default=np.inf)


def as_lines(parts):
    return MultiLineString([list(map(tuple, part)) for part in parts])
