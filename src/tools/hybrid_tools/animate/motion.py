# SPDX-License-Identifier: GPL-3.0-or-later
"""What moves in a run: blocks, failed joints and bedrock at the times of its pictures, relative to the base."""

import numpy as np

from hybrid_run import MissingData

DISPLACEMENT, VELOCITY = "displacement [m]", "velocity [m/s]"
TENSILE, SHEAR = 1, 2


class Motion:
    """Where things are at each picture. scale: displacements are drawn so many times as large."""

    def __init__(self, run, scale=1.0):
        self.run, self.scale = run, scale
        self.blocks = series(run, "blocks")
        self.joints = series(run, "joints")
        self.bedrock = series(run, "continuum")
        shown = self.blocks if self.blocks is not None else self.bedrock
        if shown is None or len(shown) < 2:
            raise MissingData("'%s' holds fewer than two pictures of the motion; they come every Output/Picture interval" % run.directory)
        self.times = shown.times
        self.base_path = base_path(run)

    def base_displacement(self, time):
        """What displacements are relative to [m]: the base monitor, or the motion of a rigid base; else nothing."""
        if self.base_path is None:
            return np.zeros(2)
        values = self.run.history(self.base_path)
        return np.array([np.interp(time, self.run.time, values[:, c], left=0.0) for c in range(2)])

    def drawn(self, picture, time):
        """Points of a picture where they are drawn [m]: displacement relative to the base, times the scale."""
        displacement = picture.fields[DISPLACEMENT]
        return picture.points - displacement + self.scale * (displacement - self.base_displacement(time))

    def polygons(self, picture, points):
        return np.split(points[picture.connectivity], picture.starts[1:])

    def values(self, picture, time, quantity):
        """Of each block: displacement relative to the base [m] or speed [m/s]."""
        field = picture.fields[VELOCITY] if quantity == "velocity" else picture.fields[DISPLACEMENT] - self.base_displacement(time)
        return np.hypot(*picture.of_cells(field).T)

    def failed(self, k):
        """[(kind, segments n x 2 x 2)] of the joints that have failed by picture k."""
        if self.joints is None or k >= len(self.joints):
            return []
        picture = self.joints[k]
        kinds = picture.fields.get("failure (1 tensile, 2 shear)")
        if kinds is None or not len(kinds):
            return []
        ends = self.drawn(picture, self.joints.times[k])[picture.connectivity].reshape(-1, 2, 2)
        return [(kind, ends[kinds == kind]) for kind in (TENSILE, SHEAR)]


class Extent:
    """What all pictures have in common: the range of places and of values; the first pass through the files."""

    def __init__(self, motion, quantity, chosen):
        lows, highs, values, means, moved = [], [], [], [], []
        for k in chosen:
            picture, time = motion.blocks[k], motion.times[k]
            points = motion.drawn(picture, time)
            lows.append(np.quantile(points, 0.01, axis=0) if len(points) > 200 else points.min(axis=0))
            highs.append(np.quantile(points, 0.99, axis=0) if len(points) > 200 else points.max(axis=0))
            found = motion.values(picture, time, quantity)
            values.append(found)
            means.append(found.mean())
            moved.append(np.abs(picture.fields[DISPLACEMENT] - motion.base_displacement(time)).max())
        first = motion.drawn(motion.blocks[0], motion.times[0])
        self.first = np.array([first.min(axis=0), first.max(axis=0)])
        self.low, self.high = np.min(lows + [self.first[0]], axis=0), np.max(highs + [self.first[1]], axis=0)
        values = np.array(values)
        self.top = max(np.quantile(values, 0.995) if values.shape[1] > 200 else values.max(), 1e-12)
        self.means, self.moved = np.array(means), max(moved)


def base_path(run):
    """Displacements of what others are relative to, in run.h5; None: they are absolute."""
    if run.base and run.has("monitors/%s/displacement" % run.base):
        return "monitors/%s/displacement" % run.base
    return "input/displacement" if run.parameters.get("Model/Bedrock") == "rigid" and run.has("input/displacement") else None


def series(run, name):
    try:
        found = run.pictures(name)
    except MissingData:
        return None
    return found if len(found) else None
