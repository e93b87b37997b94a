# SPDX-License-Identifier: GPL-3.0-or-later
"""The blocks of a run: where they lay, how far they moved."""

import numpy as np


class Blocks:
    """Blocks of the sliding mass, then those of a bedrock of blocks (layers, triangles); arrays have a row for each."""

    def __init__(self, run):
        self.run = run

    def __len__(self):
        return len(self.run.get("section/blocks_offsets")) - 1

    @property
    def mass(self):
        """Which of them are the sliding mass: a slice."""
        count = self.run.attribute("section", "mass_blocks")
        return slice(len(self) if count is None else int(np.ravel(count)[0]))

    @property
    def polygons(self):
        """Vertices of each block at first [m]: a list of arrays k x 2."""
        return self._split(self.run.get("section/blocks_points"))

    @property
    def final_polygons(self):
        """Vertices of each block at the end [m]."""
        return self._split(self.run.get("section/blocks_points_final"))

    @property
    def centroids(self):
        """Mean of the vertices at first [m], b x 2."""
        return np.array([polygon.mean(axis=0) for polygon in self.polygons])

    @property
    def displacement(self):
        """Of the centroids at the end, relative to the base [m], b x 2."""
        return self.run.get("section/blocks_displacement")

    @property
    def peak_displacement(self):
        """Largest magnitude during the run, relative to the base [m], b."""
        return self.run.get("section/blocks_peak_displacement")

    def _split(self, points):
        return np.split(points, self.run.get("section/blocks_offsets").astype(int)[1:-1])
