# SPDX-License-Identifier: GPL-3.0-or-later
"""The section of a random scene: a slope of bedrock in structured cells and a slab of blocks on it.

Everything is built in the frame of the slope, where u runs along the surface and v away from it, and written as a mesh
file of gmsh (version 2.2) that needs no mesher: nodes and elements have the numbers that are given to them here.
"""

import math

import numpy as np

BEND = 0.08  # change of the slope's tangent on both sides of a valley or a ridge
SLAB = 1.0 / 3.0  # where the plane bedding_1 cuts the bedrock: part of its height below the surface


class Section:
    """nodes (n x 2) [m]; cells, blocks: lists of node numbers; lines: {name: [(node, node)]}; free blocks (n x 2 arrays)."""

    def __init__(self):
        self.nodes, self.cells, self.layer_of, self.blocks = [], [], [], []
        self.lines, self.free_blocks = {}, []
        self._index = {}

    def node(self, x, y):
        key = (round(x, 9), round(y, 9))
        if key not in self._index:
            self._index[key] = len(self.nodes)
            self.nodes.append((x, y))
        return self._index[key]

    def points(self):
        return np.array(self.nodes)


def make_section(geometry):
    """geometry: angle [deg], surface, cell, margin, rock height [m], block width and height [m], columns, rows, kind, shared,
    phase [m]."""
    section = Section()
    slope = math.radians(geometry["angle"])
    length = geometry["columns"] * geometry["width"]
    cell = geometry["cell"]
    u = grid_along(length, geometry["margin"], cell)
    heights = grid_down(geometry["rock"], cell)
    bent = bend_of(geometry)
    add_bedrock(section, (u, heights), geometry["rock"], slope, length, bent)
    add_mass(section, geometry, slope, bent)
    return section


def bend_of(geometry):
    """What a valley or a ridge adds to the height of a point, a function of x [m]."""
    knee = math.cos(math.radians(geometry["angle"])) * geometry["width"] * (geometry["columns"] // 2)  # a corner of blocks
    bend = {"plane": 0.0, "valley": BEND, "ridge": -BEND}[geometry["surface"]]
    return lambda x: bend * abs(x - knee)


def grid_along(length, margin, cell):
    """Places of the bedrock's nodes along the surface; the slab begins at 0 and ends on the last one before its margin."""
    beside = max(1, round(margin / cell))
    under = max(1, math.ceil(length / cell - 1e-9))
    return cell * np.arange(-beside, under + beside + 1)


def grid_down(height, cell):
    """Depths [part of the height], 1 at the surface, 0 at the base, growing downwards; SLAB below the surface is one of them."""
    upper = graded(SLAB * height, cell)
    last = upper[-1] - upper[-2] if len(upper) > 1 else SLAB * height
    lower = graded((1 - SLAB) * height, 1.5 * max(last, cell)) + SLAB * height
    return 1 - np.concatenate([upper, lower[1:]]) / height


def graded(height, first):
    steps, size = [], first
    while sum(steps) < height - 1e-9 and len(steps) < 50:
        steps.append(size)
        size *= 1.7
    return np.concatenate([[0.0], np.cumsum(steps)]) * height / sum(steps)


def add_bedrock(section, grid, height, slope, length, bent):
    u, parts = grid
    base = min(k * math.sin(slope) + bent(k * math.cos(slope)) for k in u) - height

    def node(i, j):
        x = u[i] * math.cos(slope)
        top = u[i] * math.sin(slope) + bent(x)
        return section.node(x, base + parts[j] * (top - base))

    n, m = len(u), len(parts)
    for i in range(n - 1):
        for j in range(m - 1):
            section.cells.append((node(i, j + 1), node(i + 1, j + 1), node(i + 1, j), node(i, j)))
            section.layer_of.append(0 if parts[j] > 1 - SLAB + 1e-9 else 1)
    plane = int(np.argmin(np.abs(parts - (1 - SLAB))))
    lines = {name: [] for name in ("base", "left", "right", "ground", "sliding_surface", "bedding_1")}
    for i in range(n - 1):
        covered = u[i + 1] > 1e-9 and u[i] < length - 1e-9
        lines["sliding_surface" if covered else "ground"].append((node(i, 0), node(i + 1, 0)))
        lines["base"].append((node(i, m - 1), node(i + 1, m - 1)))
        lines["bedding_1"].append((node(i, plane), node(i + 1, plane)))
    for j in range(m - 1):
        lines["left"].append((node(0, j), node(0, j + 1)))
        lines["right"].append((node(n - 1, j), node(n - 1, j + 1)))
    section.lines = lines


def add_mass(section, geometry, slope, bent):
    width, height = geometry["width"], geometry["height"]
    shared = geometry["shared"]
    along, away = np.array([math.cos(slope), math.sin(slope)]), np.array([-math.sin(slope), math.cos(slope)])
    shift = 0.0 if shared else geometry["phase"]

    def corner(i, k):
        x, y = (shift + i * width) * along + k * height * away
        return x, y + bent(x)

    for i in range(geometry["columns"]):
        for k in range(geometry["rows"]):
            quad = [(i, k), (i + 1, k), (i + 1, k + 1), (i, k + 1)]
            if geometry["kind"] != "triangles":
                shapes = [quad]
            elif (i + k) % 2 == 0:
                shapes = [[quad[0], quad[1], quad[2]], [quad[0], quad[2], quad[3]]]
            else:
                shapes = [[quad[0], quad[1], quad[3]], [quad[1], quad[2], quad[3]]]
            for shape in shapes:
                corners = np.array([corner(*c) for c in shape])
                if shared:
                    section.blocks.append(tuple(section.node(*x) for x in corners))
                else:
                    section.free_blocks.append(corners)


def mirrored(section):
    """The same section seen from behind: x changes its sign."""
    other = Section()
    other.nodes = [(-x, y) for x, y in section.nodes]
    other.cells = [c[::-1] for c in section.cells]
    other.layer_of = list(section.layer_of)
    other.blocks = [b[::-1] for b in section.blocks]
    exchanged = {"left": "right", "right": "left"}
    other.lines = {exchanged.get(n, n): [e[::-1] for e in edges] for n, edges in section.lines.items()}
    other.free_blocks = [(b * [-1, 1])[::-1] for b in section.free_blocks]
    return other


def shifted(section, by):
    other = Section()
    other.__dict__.update(section.__dict__)
    other.nodes = [(x + by[0], y + by[1]) for x, y in section.nodes]
    other.free_blocks = [b + by for b in section.free_blocks]
    return other


def renumbered(section, seed):
    """Nodes, cells and blocks in another order, and every block begins at another corner."""
    random = np.random.default_rng(seed)
    other = Section()
    order = random.permutation(len(section.nodes))
    number = np.argsort(order)
    other.nodes = [section.nodes[k] for k in order]

    def turned(nodes):
        k = int(random.integers(len(nodes)))
        return tuple(number[n] for n in nodes[k:] + nodes[:k])

    cells = random.permutation(len(section.cells))
    other.cells = [turned(section.cells[c]) for c in cells]
    other.layer_of = [section.layer_of[c] for c in cells]
    other.blocks = [turned(section.blocks[b]) for b in random.permutation(len(section.blocks))] if section.blocks else []
    other.lines = {n: [(number[a], number[b]) for a, b in random.permutation(e)] for n, e in section.lines.items()}
    other.free_blocks = [np.roll(section.free_blocks[b], int(random.integers(3)), axis=0)
                         for b in (random.permutation(len(section.free_blocks)) if section.free_blocks else [])]
    return other


GROUPS = {"bedrock": (2, 1), "sliding_mass": (2, 2), "sliding_surface": (1, 3), "ground": (1, 4), "base": (1, 5),
          "left": (1, 6), "right": (1, 7), "bedding_1": (1, 8)}


def write_mesh(section, file):
    """Bedrock, lines and meshed blocks as a .msh file; the two layers of bedrock are two surfaces."""
    elements = [(1, GROUPS[name][1], GROUPS[name][1], edge) for name, edges in section.lines.items() for edge in edges]
    elements += [(3, 1, 101 + layer, cell) for cell, layer in zip(section.cells, section.layer_of)]
    elements += [(len(block) - 1, 2, 103, block) for block in section.blocks]
    used = [n for n in GROUPS if n != "sliding_mass" or section.blocks]
    with open(file, "w", encoding="utf-8") as out:
        out.write("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n%d\n" % len(used))
        out.writelines('%d %d "%s"\n' % (*GROUPS[name], name) for name in used)
        out.write("$EndPhysicalNames\n$Nodes\n%d\n" % len(section.nodes))
        out.writelines("%d %.17g %.17g 0\n" % (k + 1, *x) for k, x in enumerate(section.nodes))
        out.write("$EndNodes\n$Elements\n%d\n" % len(elements))
        for k, (kind, physical, entity, nodes) in enumerate(elements):
            out.write("%d %d 2 %d %d %s\n" % (k + 1, kind, physical, entity, " ".join(str(n + 1) for n in nodes)))
        out.write("$EndElements\n")


def write_polygons(section, file):
    with open(file, "w", encoding="utf-8") as out:
        out.write("block,x,y\n")
        for k, block in enumerate(section.free_blocks):
            out.writelines("%d,%.17g,%.17g\n" % (k, *x) for x in block)
