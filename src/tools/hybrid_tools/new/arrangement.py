# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines that meet and end on each other, as points, edges and faces that share them: what gmsh meshes without gaps."""

import numpy as np
from shapely.geometry import LineString, Polygon
from shapely.ops import polygonize, unary_union

TINY = 0.25  # of the length that edges should have: shorter ones shrink wherever their lines go
MOVED = 0.125  # of this length: how far lines may move aside where edges shrink that are not tiny


class Arrangement:
    """points: n x 2 [m]; edges: {(a, b): label}, a < b; faces: lists of points, counter-clockwise.

    lines: [(label, points)], the first label counts where two coincide. short(x, y): edges below this length [m] are drawn together,
    where their lines move by little.
    An end that should lie on another line may stick out: dangling ends are left out.
    """

    def __init__(self, lines, short, fixed):
        noded = unary_union([LineString(points) for _, points in lines])
        polygons = list(polygonize(noded))
        self.number, self.points = {}, []
        self.edges = {}
        sources = Sources(lines)
        for polygon in polygons:
            for ring in [polygon.exterior] + list(polygon.interiors):
                nodes = [self.node(c) for c in ring.coords]
                for a, b in zip(nodes, nodes[1:]):
                    if a == b:
                        continue
                    self.edges.setdefault((min(a, b), max(a, b)), None)
        for a, b in self.edges:
            self.edges[a, b] = sources.label_at(0.5 * (self.points[a] + self.points[b]))
        self.draw_together(short, fixed)
        self.faces = self.find_faces()

    def node(self, c):
        key = (round(c[0], 7), round(c[1], 7))
        if key not in self.number:
            self.number[key] = len(self.points)
            self.points.append(np.array(c[:2]))
        return self.number[key]

    def draw_together(self, short, fixed):
        """Short edges shrink to one of their ends: a fixed one, else the one where more lines meet.

        An edge that is not tiny stays where no line may move so far: so corners are kept that are more than the wiggles of a survey."""
        beside = self.neighbours()
        held = {self.node(c) for c in fixed}
        target, members = list(range(len(self.points))), {k: [k] for k in range(len(self.points))}

        def root(k):
            while target[k] != k:
                k = target[k]
            return k

        for (a, b), _ in sorted(self.edges.items(), key=lambda e: self.length(e[0])):
            a, b = root(a), root(b)
            limit = short(*(0.5 * (self.points[a] + self.points[b])))
            if a == b or self.length((a, b)) >= limit or (a in held and b in held):
                continue
            ends = sorted(((a, b), (b, a)), key=lambda e: (e[0] in held, len(beside[e[0]]), -e[0]), reverse=True)
            fits = [(keep, gone) for keep, gone in ends if gone not in held and (
                self.length((a, b)) < TINY * limit or self.moved_by(members[gone], keep, beside) < MOVED * limit)]
            if fits:
                keep, gone = fits[0]
                target[gone] = keep
                members[keep] += members.pop(gone)
        edges = {}
        for (a, b), label in self.edges.items():
            a, b = root(a), root(b)
            if a != b:
                edges.setdefault((min(a, b), max(a, b)), label)
        self.edges = edges

    def neighbours(self):
        """Of each point: those at the other ends of its edges."""
        found = [[] for _ in self.points]
        for a, b in self.edges:
            found[a].append(b)
            found[b].append(a)
        return found

    def moved_by(self, points, place, beside):
        """How far lines through these points move aside, if they go to another point [m]."""
        largest = 0.0
        for k in points:
            way = self.points[place] - self.points[k]
            for other in beside[k]:
                along = self.points[other] - self.points[k]
                if other != place:
                    largest = max(largest, abs(way[0] * along[1] - way[1] * along[0]) / np.hypot(*along))
        return largest

    def divide(self, size):
        """Long edges fall into pieces along which the element size [m] varies by less than half; faces go along."""
        pieces = {}
        for edge in sorted(self.edges):
            a, b = (self.points[k] for k in edge)
            length, at, nodes = self.length(edge), 0.0, [edge[0]]
            while True:
                at += max(4.0 * size(*(a + (b - a) * at / length)), 0.02 * length)
                if at > length - 2.0 * size(*b):
                    break
                nodes.append(self.node(a + (b - a) * at / length))
            pieces[edge] = nodes + [edge[1]]
        self.edges = {(min(a, b), max(a, b)): self.edges[edge] for edge, nodes in pieces.items() for a, b in zip(nodes, nodes[1:])}

        def pieces_from(a, b):
            return pieces[a, b][:-1] if a < b else pieces[b, a][:0:-1]

        self.faces = [[k for a, b in zip(face, face[1:] + face[:1]) for k in pieces_from(a, b)] for face in self.faces]

    def length(self, edge):
        return float(np.hypot(*(self.points[edge[1]] - self.points[edge[0]])))

    def find_faces(self):
        lines = [LineString([self.points[a], self.points[b]]) for a, b in self.edges]
        faces = []
        for polygon in polygonize(lines):
            nodes = [self.node(c) for c in polygon.exterior.coords][:-1]
            faces.append(nodes if polygon.exterior.is_ccw else nodes[::-1])
        used = {edge for face in faces for edge in edges_of(face)}
        self.edges = {edge: label for edge, label in self.edges.items() if edge in used}
        return faces

    def polygon(self, face):
        return Polygon([self.points[k] for k in face])

    def place_in(self, face):
        return self.polygon(face).representative_point()


def edges_of(face):
    return [(min(a, b), max(a, b)) for a, b in zip(face, face[1:] + face[:1])]


class Sources:
    """Which of the given lines a point lies on."""

    def __init__(self, lines):
        pieces = [(label, a, b) for label, points in lines for a, b in zip(points, points[1:])]
        self.labels = [label for label, _, _ in pieces]
        self.start = np.array([a for _, a, _ in pieces], float)
        self.along = np.array([b for _, _, b in pieces], float) - self.start

    def label_at(self, point):
        """Of the nearest line; of the first of those that coincide there."""
        t = np.clip(((point - self.start) * self.along).sum(axis=1) / (self.along**2).sum(axis=1), 0, 1)
        distance = np.hypot(*(self.start + t[:, None] * self.along - point).T)
        return self.labels[int(np.flatnonzero(distance <= distance.min() + 1e-7)[0])]
