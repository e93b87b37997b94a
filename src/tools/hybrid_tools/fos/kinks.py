# SPDX-License-Identifier: GPL-3.0-or-later
"""Kinks of the sliding surface, or of blocks, that hold blocks whatever their strength: rock would crush there, blocks do not."""

import numpy as np

BEND = 3.0  # by which kinks that are told flatten the surface, together: a factor of safety is 4 % too high then [degrees]
LEAST = 0.5  # of a kink that counts [degrees]
STEEPEST = 89.0  # on which a block rests; against a riser, or below an overhang, it only stands [degrees]
NEAR = 1e-3  # of a block's size: its corner lies in the kink


def holding_kink(surface, polygons, downhill):
    """(point [m] of the sharpest, bends of all together [degrees]) of kinks in which a block that rests on the steeper side has a corner; None
    where they hardly bend it.

    surface: points along x, [n, 2]; polygons: corners of each block of the mass; downhill: sign of x.
    """
    line = np.asarray(surface)[:: int(downhill)]  # downhill
    along = np.diff(line, axis=0)
    fall = np.degrees(np.arctan2(-along[:, 1], downhill * along[:, 0]))
    sharpest, bends = None, 0.0
    for k in np.argsort(fall[1:] - fall[:-1]) + 1:  # the sharpest first
        bend = fall[k - 1] - fall[k]
        if bend < LEAST:
            break
        if fall[k - 1] > STEEPEST:
            continue
        direction = -along[k - 1] / np.linalg.norm(along[k - 1])
        if any(rests_beyond(np.asarray(polygon), line[k], direction) for polygon in polygons):
            sharpest = line[k] if sharpest is None else sharpest
            bends += float(bend)
    return (sharpest, bends) if bends >= BEND else None


def kink_of_blocks(polygons, downhill):
    """The same of the kinks in the outline of a block, in which another one that rests on it has a corner."""
    found = []
    for k, outline in enumerate(polygons):
        ring = np.asarray(outline)[::-1]  # from left to right along its upper side
        if not is_convex(ring):
            found.append(holding_kink(np.vstack([ring, ring[:2]]), polygons[:k] + polygons[k + 1 :], downhill))
    return max(filter(None, found), key=lambda kink: kink[1], default=None)


def is_convex(clockwise):
    along = np.roll(clockwise, -1, axis=0) - clockwise
    after = np.roll(along, -1, axis=0)
    return (along[:, 0] * after[:, 1] - along[:, 1] * after[:, 0] <= 1e-9 * np.linalg.norm(along, axis=1) * np.linalg.norm(after, axis=1)).all()


def rests_beyond(polygon, corner, direction):
    """The polygon has this corner, and an edge that leaves it in this direction."""
    near = NEAR * np.sqrt(np.ptp(polygon[:, 0]) * np.ptp(polygon[:, 1]))
    for k in np.flatnonzero(np.linalg.norm(polygon - corner, axis=1) < near):
        for other in (polygon[k - 1], polygon[(k + 1) % len(polygon)]):
            edge = other - polygon[k]
            if abs(edge[0] * direction[1] - edge[1] * direction[0]) < near and edge @ direction > near:
                return True
    return False
