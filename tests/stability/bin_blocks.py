#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Blocks of the hard case bin: random triangles that do not overlap, above a trough.

    bin_blocks.py COUNT DIRECTORY     writes bin_COUNT.csv and bin_COUNT_surface.csv

Same count, same triangles: the seed is fixed.
"""

import pathlib
import sys

import numpy as np

CELL = 1.25  # m: each triangle lies within a cell of its own


def triangle(random):
    """Three corners within a circle of 0.3 to 0.6 m, counter-clockwise, no angle below 25 degrees."""
    while True:
        angles = np.sort(random.uniform(0, 2 * np.pi, 3))
        gaps = np.diff(np.append(angles, angles[0] + 2 * np.pi))  # twice the angle of the corner opposite
        if gaps.min() > np.radians(50):
            return random.uniform(0.3, 0.6) * np.column_stack([np.cos(angles), np.sin(angles)])


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    count, directory = int(sys.argv[1]), pathlib.Path(sys.argv[2])
    random = np.random.default_rng(1)
    columns = int(np.ceil(np.sqrt(0.6 * count)))
    made = "# Made by tests/stability/bin_blocks.py %d [m].\n" % count
    with open(directory / ("bin_%d.csv" % count), "w", encoding="utf-8") as file:
        file.write(made + "block,x,y\n")
        for b in range(count):
            for x, y in triangle(random) + CELL * np.array([b % columns - 0.5 * (columns - 1), b // columns + 0.6]):
                file.write("%d,%.3f,%.3f\n" % (b + 1, x, y))
    half, height = 0.5 * CELL * columns, 1.5 * CELL * columns
    with open(directory / ("bin_%d_surface.csv" % count), "w", encoding="utf-8") as file:
        file.write(made + "x,y\n")
        for x, y in ((-half - 0.25 * height, height), (-half, 0), (half, 0), (half + 0.25 * height, height)):
            file.write("%.3f,%.3f\n" % (x, y))


if __name__ == "__main__":
    main()
