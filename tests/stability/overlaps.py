# SPDX-License-Identifier: GPL-3.0-or-later
"""How deep blocks are in each other and in the ground, from the pictures of a run."""

import numpy as np
from vtu_file import picture_at, pictures


def deepest(run):
    """Largest overlap of blocks with each other or with the ground over block size in all pictures, and its time [s]."""
    largest, when = 0.0, 0.0
    for time, picture in pictures(run.directory, "blocks"):
        blocks = polygons(picture)
        depth = max(between_blocks(blocks), into_ground(blocks, ground_line(run, time)))
        if depth > largest:
            largest, when = depth, time
    return largest, when


def polygons(picture):
    """Corners (n x 2) [m] of each block, counter-clockwise."""
    return [picture.points[cell, :2] for cell in picture.cells]


def area(corners):
    x, y = corners.T
    return 0.5 * (x @ np.roll(y, -1) - y @ np.roll(x, -1))


def between_blocks(blocks):
    """Largest overlap of two convex blocks over the size (root of the area) of the smaller one.

    The overlap is the shortest way to part them: the smallest overlap of their shadows on the normals of their edges.
    """
    low, high = np.array([b.min(axis=0) for b in blocks]), np.array([b.max(axis=0) for b in blocks])
    size = np.sqrt([area(b) for b in blocks])
    largest = 0.0
    for i, block in enumerate(blocks):
        near = np.nonzero((low < high[i]).all(axis=1) & (high > low[i]).all(axis=1))[0]
        for j in near[near > i]:
            largest = max(largest, overlap(block, blocks[j]) / min(size[i], size[j]))
    return largest


def overlap(one, other):
    least = np.inf
    for corners in (one, other):
        edges = np.roll(corners, -1, axis=0) - corners
        normals = np.column_stack([edges[:, 1], -edges[:, 0]]) / np.linalg.norm(edges, axis=1)[:, None]
        a, b = one @ normals.T, other @ normals.T
        least = min(least, np.minimum(a.max(axis=0) - b.min(axis=0), b.max(axis=0) - a.min(axis=0)).min())
    return max(least, 0.0)


def into_ground(blocks, line):
    """Largest depth of a corner below an open polyline (from left to right, blocks above it) over the block's size."""
    depth_below = 10 * np.ptp(line, axis=0).max()
    ends = [[line[-1, 0], line[:, 1].min() - depth_below], [line[0, 0], line[:, 1].min() - depth_below]]
    ring = np.vstack([line, ends])
    largest = 0.0
    for block in blocks:
        for corner in block[inside(block, ring)]:
            largest = max(largest, distance(corner, line) / np.sqrt(area(block)))
    return largest


def inside(points, ring):
    """Which points are inside a closed polygon (crossings of a ray to the right)."""
    a, b = ring[:, None], np.roll(ring, -1, axis=0)[:, None]
    spans = (a[..., 1] > points[:, 1]) != (b[..., 1] > points[:, 1])
    with np.errstate(divide="ignore", invalid="ignore"):
        x = a[..., 0] + (points[:, 1] - a[..., 1]) * (b[..., 0] - a[..., 0]) / (b[..., 1] - a[..., 1])
    return (spans & (x > points[:, 0])).sum(axis=0) % 2 == 1


def distance(point, line):
    a, b = line[:-1], line[1:]
    along = b - a
    part = np.clip(((point - a) * along).sum(axis=1) / (along**2).sum(axis=1), 0.0, 1.0)
    return np.linalg.norm(a + part[:, None] * along - point, axis=1).min()


def ground_line(run, time):
    """Surface of the ground (n x 2) [m] from left to right, where it is in the picture nearest to a time."""
    if (run.directory_path / "continuum.pvd").exists():
        return bedrock_surface(run, time)
    line = chained(run.get("section/outline").reshape(-1, 2, 2))
    if "input" in run.file:  # a rigid base moves as prescribed
        line = line + [np.interp(time, run.time, u) for u in run.get("input/displacement").T]
    return line


def chained(segments):
    """Points of a polyline (n x 2) from its segments in any order, each from left to right."""
    end_of = {tuple(a): b for a, b in segments}
    ends = {tuple(b) for b in end_of.values()}
    line = [next(a for a in segments[:, 0] if tuple(a) not in ends)]
    while tuple(line[-1]) in end_of:
        line.append(end_of[tuple(line[-1])])
    return np.array(line)


def bedrock_surface(run, time):
    """Nodes of the contact surface, displaced as in a picture of the bedrock."""
    picture, _ = picture_at(run.directory, "continuum", time)
    surface = run.get("interface/position")
    at = picture.points[:, :2]
    moved = picture.point_fields["displacement [m]"]
    nearest = [np.argmin(np.linalg.norm(at - p, axis=1)) for p in surface]
    return surface + moved[nearest][:, :2]
