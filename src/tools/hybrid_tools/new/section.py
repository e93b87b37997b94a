# SPDX-License-Identifier: GPL-3.0-or-later
"""The section: ground with level ends, mass, bedrock between base and sides, cut into layers by the bedding planes."""

import numpy as np
from shapely.geometry import LineString, Point, Polygon

from hybrid_run import UserError
from . import sizes
from .arrangement import Arrangement, edges_of
from .mass import below_of, find_mass
from .materials import Slices, belt, body, rock
from .monitors import point_at, slope_ends
from .planes import Continuations, as_lines, cut_planes, look_at_layers, spacing

STRIP = 0.3  # of a free-field column that is level ground beside the side; a quarter is asked for
GROWTH = 0.15  # of element sizes with distance
SHORTEST = 0.8  # edge of the section over the element size there; shorter ones are drawn together where their lines move by little


class Section:
    """All that a geometry file and a scene need of a slope. notes: sentences on what was changed or chosen.

    h: edge length [m], None: by wavelength, of blocks and bedrock times `finer`. far, ground_size, plane_size: of bedrock elements far
    from all, at the slope and along the planes; they grow with the distance from there.
    """

    def __init__(self, profile, slip, planes, record, h, notes, finer=(1.0, 1.0)):
        self.record, self.notes = record, notes
        self.rock = rock()
        self.mass = self.body = self.belt = self.h = None
        if slip is not None:
            self.mass = find_mass(slip, profile, notes)
            self.body = body(self.mass)
            self.belt = belt(self.mass, self.body)
            self.h = sizes.block_edge(self.body, self.mass, record, h, notes, finer[0])
        self.set_extent(profile, planes)
        self.far = sizes.far_edge(self.rock, record, self.h, finer[1])
        if self.mass is None and h:
            if h > self.far:
                notes.append("size: %g m instead of %g m, as longer edges do not resolve the motion" % (self.far, h))
            self.far = min(h, self.far)
        self.ground_size = sizes.ground_edge(profile, self.far, self.h)
        self.h = self.h or self.ground_size
        self.ground = self.simplified(self.extended(profile), "ground")
        self.slip = self.slip_line = None
        if self.mass is not None:
            self.mass = find_mass(self.simplified(self.mass.slip, "slip line"), self.ground, [])
            self.slip, self.slip_line = self.mass.slip, LineString(self.mass.slip)
        self.cut(planes, (profile[0, 0], profile[-1, 0]))

    @property
    def left(self):
        return float(self.ground[0, 0])

    @property
    def right(self):
        return float(self.ground[-1, 0])

    def set_extent(self, profile, planes):
        """Height of the slope, base and margins."""
        low = profile[:, 1].min()
        if self.mass is not None:
            low = min(low, self.mass.slip[:, 1].min())
        self.height = max(profile[:, 1].max() - low, 0.02 * np.ptp(profile[:, 0]))
        self.margin, below = sizes.margins(profile, self.mass, self.rock, self.record, self.height)
        deepest = min([low] + [points[np.abs(points[:, 0] - np.clip(points[:, 0], profile[0, 0], profile[-1, 0])) == 0, 1].min(initial=low)
                               for _, points in planes])
        self.base = float(np.floor(deepest - below))
        self.depth_below = deepest - self.base

    def extended(self, profile):
        """The ground with level ends: rock beside the mass, and level ground as free-field columns ask for."""
        inner = (profile[0, 0], profile[-1, 0]) if self.mass is None else tuple(self.mass.slip[[0, -1], 0])
        ends = []
        for end, edge, direction in ((0, inner[0], -1), (-1, inner[1], 1)):
            x, y = profile[end]
            level = level_length(profile if end == 0 else profile[::-1], 0.02 * (y - self.base))
            missing = max(self.margin - abs(x - edge), STRIP * (y - self.base) - level, 0.0)
            if missing > 0:
                missing = sizes.rounded_up(missing)
                self.notes.append("ground: %g m of level ground were added at the %s, at y = %g m" % (missing, "left" if end == 0 else "right", y))
                ends.append((end, (x + direction * missing, y)))
        for end, point in ends:
            profile = np.vstack([[point], profile]) if end == 0 else np.vstack([profile, [point]])
        return profile

    def simplified(self, line, name):
        """Without points that change it by less than a twentieth of an element."""
        allowed = 0.05 * self.h
        found = np.array(LineString(line).simplify(allowed).coords)
        if len(found) < len(line) - 2:
            self.notes.append("%s: %d of %d points were left out, it moves by less than %.2g m" % (name, len(line) - len(found), len(line), allowed))
        return found

    def cut(self, planes, limits):
        rock_area = below_of(self.ground).intersection(Polygon([(self.left, self.base), (self.right, self.base), (self.right, 1e9), (self.left, 1e9)]))
        if self.mass is not None:
            rock_area = rock_area.difference(self.mass.polygon)
        self.planes = cut_planes(planes, rock_area, self.slip, limits, self.notes)
        sides = [("the %s side" % name, LineString([(end[0], self.base), end])) for name, end in (("left", self.ground[0]), ("right", self.ground[-1]))]
        look_at_layers(self.planes, obstacles_of(self.slip, self.ground) + sides, self.h, self.notes)
        self.plane_size = float(np.clip(spacing(self.planes, self.slip, self.ground), 0.5 * self.h, self.far))
        obstacles = [line for _, line in obstacles_of(self.slip, self.ground)]
        tops = (self.ground[0, 1], self.ground[-1, 1])
        more = Continuations(self.planes, obstacles, (self.left, self.right), self.base, tops, self.h)
        reach = 1e-3 * self.h
        corners = [(self.left, self.base), (self.right, self.base), tuple(self.ground[-1]), tuple(self.ground[0])]
        lines = [("base", corners[:2]), ("right", [corners[1], corners[2]]), ("left", [corners[3], corners[0]]),
                 ("ground", list(map(tuple, self.ground)))]
        if self.slip is not None:
            lines.append(("sliding_surface", stuck_out(self.slip, reach, True, True)))
        exact = {tuple(tip) for tip, _, _ in more.tips}.union(() if self.slip is None else map(tuple, self.slip))
        for name, number, points in self.planes:
            lines.append(("bedding_%d" % number, stuck_out(points, reach, tuple(points[0]) not in exact, tuple(points[-1]) not in exact)))
        lines += [("inner", stuck_out(points, reach, False, True)) for points in more.lines]
        ends = [] if self.slip is None else [tuple(self.slip[0]), tuple(self.slip[-1])]
        self.plane_lines = as_lines([points for _, _, points in self.planes]) if self.planes else None
        self.slope_line = self.slope_of_ground() if self.ground_size < self.far else None
        detail = max(0.2 * self.height, self.h)  # of the section that is kept however large the elements are
        self.mesh = Arrangement(lines, lambda x, y: SHORTEST * min(self.size_at(x, y), detail), corners + ends)
        self.mesh.divide(self.size_at)
        self.sort_faces()
        self.redraw()

    def redraw(self):
        """Ground, slip line and mass as they are in the mesh."""
        ground, slip = self.chain({"ground", "mass_surface"}), None if self.slip is None else self.chain({"sliding_surface"})
        for name, line, now in (("ground", self.ground, ground), ("slip line", self.slip, slip)):
            moved = 0.0 if line is None else LineString(line).hausdorff_distance(LineString(now))
            if moved > 0.05 * self.h:
                self.notes.append("%s: it moves by up to %.2g m, as points are drawn together that are closer than the elements; a smaller --size keeps them" % (
                    name, moved))
        self.ground, self.slip = ground, slip
        if self.mass is not None:
            self.mass = find_mass(slip, ground, [])
            self.belt.safety = Slices(self.mass, self.body.density).safety(self.belt.friction_angle, self.belt.cohesion)

    def chain(self, labels):
        """The lines of these groups as they are in the mesh, from left to right."""
        ahead = {}
        for edge, label in self.mesh.edges.items():
            if label in labels:
                for a, b in (edge, edge[::-1]):
                    ahead.setdefault(a, []).append(b)
        first = min((k for k, others in ahead.items() if len(others) == 1), key=lambda k: self.mesh.points[k][0])
        nodes, last = [first], None
        while True:
            more = [k for k in ahead[nodes[-1]] if k != last]
            if not more:
                return np.array([self.mesh.points[k] for k in nodes])
            last = nodes[-1]
            nodes.append(more[0])

    def slope_of_ground(self):
        """The ground without its level ends."""
        left, right = slope_ends(self.ground)
        inner = [tuple(p) for p in self.ground if left < p[0] < right]
        return LineString([point_at(self.ground, left)] + inner + [point_at(self.ground, right)])

    def distances(self, x, y):
        """(from the sliding surface, from the planes, from the slope of the ground) [m]; infinite where there are none."""
        place = Point(x, y)
        return tuple(np.inf if line is None else line.distance(place) for line in (self.slip_line, self.plane_lines, self.slope_line))

    def size_at(self, x, y):
        """Of elements there [m]."""
        from_slip, from_planes, from_slope = self.distances(x, y)
        return min(self.far, self.h + GROWTH * from_slip, self.plane_size + GROWTH * from_planes, self.ground_size + GROWTH * from_slope)

    def sort_faces(self):
        """Mass and bedrock; curves of the ground on the mass are its own."""
        self.bedrock, self.body_faces = [], []
        for face in self.mesh.faces:
            is_mass = self.mass is not None and self.mass.polygon.contains(self.mesh.place_in(face))
            (self.body_faces if is_mass else self.bedrock).append(face)
        if self.mass is not None and not self.body_faces:
            raise UserError("the mass between slip line and ground is thinner than an element of %g m everywhere; give a smaller --size" % self.h)
        rock_edges = {edge for face in self.bedrock for edge in edges_of(face)}
        for edge, label in self.mesh.edges.items():
            if label == "ground" and edge not in rock_edges:
                self.mesh.edges[edge] = "mass_surface"


def obstacles_of(slip, ground):
    """[(name, line)]"""
    return [(name, LineString(line)) for name, line in (("the slip line", slip), ("the ground", ground)) if line is not None]


def level_length(profile, allowed):
    """How far the ground is level from its first point on [m]."""
    off = np.flatnonzero(np.abs(profile[:, 1] - profile[0, 1]) > allowed)
    return abs(profile[off[0] - 1, 0] - profile[0, 0]) if len(off) else abs(profile[-1, 0] - profile[0, 0])


def stuck_out(points, reach, at_start, at_end):
    """A line whose ends lie on others: with a piece more beyond them, so that it meets them for sure.

    The ends stay points of the line: one on a corner of another line would pass it by round-off."""
    points = [np.array(p, float) for p in points]
    before = [points[0] + reach * (points[0] - points[1]) / np.hypot(*(points[0] - points[1]))] if at_start else []
    beyond = [points[-1] + reach * (points[-1] - points[-2]) / np.hypot(*(points[-1] - points[-2]))] if at_end else []
    return [tuple(p) for p in before + points + beyond]
