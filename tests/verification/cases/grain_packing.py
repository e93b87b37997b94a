# SPDX-License-Identifier: GPL-3.0-or-later
"""Columns of grains: irregular convex polygons that have settled between two walls, and what is left of them up to a height.

Each grain is drawn in a cell of 1 m (5 to 8 corners on a circle of 0.35 to 0.5 m, odd rows shifted by half a cell), falls and comes to
rest between a wall at x = 0 and a gate at x = cells across. A column of height H is what lies below H.
"""

import csv

import numpy as np

CORNERS = (5, 8)  # fewest and most
RADIUS = (0.35, 0.5)  # m
UNEVEN = 0.3  # of the angle between two corners of a regular grain: how far each corner may be off
FLOOR = 40  # widths of the column
LEDGE = 2  # m of ground behind a wall
PARTED = 1e-5  # by which settled grains shrink: as much as they overlap under their load
SETTLING = ("Time/End time=20", "Time/Time step=0.002", "Time/Rest speed=0.01", "Output/Picture interval=0")


def grain(random):
    """Corners (n x 2) [m] about the origin, counter-clockwise."""
    n = random.integers(CORNERS[0], CORNERS[1] + 1)
    angles = (np.arange(n) + random.uniform(-UNEVEN, UNEVEN, n)) * 2 * np.pi / n + random.uniform(0, 2 * np.pi)
    return random.uniform(*RADIUS) * np.column_stack([np.cos(angles), np.sin(angles)])


def drawn(seed, across, rows):
    """Grains before they fall: rows of `across` and `across` - 1 in turn."""
    random = np.random.default_rng(seed)
    return [grain(random) + [0.5 + k + 0.5 * (row % 2), 0.5 + row] for row in range(rows) for k in range(across - row % 2)]


def below(grains, height):
    """Grains with no corner above a height [m]."""
    return [g for g in grains if g[:, 1].max() <= height]


def parted(grains):
    """Settled grains, a little smaller, so that a column does not begin under load."""
    return [g.mean(axis=0) + (1 - PARTED) * (g - g.mean(axis=0)) for g in grains]


def write_grains(path, grains):
    with open(path, "w", encoding="utf-8") as file:
        file.write("# Settled grains of tests/verification/cases/grain_packing.py [m].\nblock,x,y\n")
        for b, corners in enumerate(grains):
            for x, y in corners:
                file.write("%d,%.6f,%.6f\n" % (b + 1, x, y))


def write_ground(path, width, height, has_gate=False):
    """Wall with ground behind it, floor and, while the grains settle, the gate."""
    end = [(width, 0), (width, height), (width + LEDGE, height)] if has_gate else [(FLOOR * width, 0)]
    with open(path, "w", encoding="utf-8") as file:
        file.write("x,y\n" + "".join("%g,%g\n" % point for point in [(-LEDGE, height), (0, height), (0, 0)] + end))


def read_grains(path):
    """Corners of each grain of a table of blocks."""
    grains = {}
    with open(path, encoding="utf-8") as file:
        for row in csv.DictReader(line for line in file if not line.startswith("#")):
            grains.setdefault(row["block"], []).append((float(row["x"]), float(row["y"])))
    return [np.array(corners) for corners in grains.values()]
