# SPDX-License-Identifier: GPL-3.0-or-later
"""How deep blocks are in each other and in the ground, from the pictures of a run."""

import numpy as np
from matplotlib.path import Path
from scipy.spatial import cKDTree
from vtu_file import picture_at, pictures


def deepest(run):
    """Largest overlap of blocks with each other or with the ground over block size in all pictures, and its time [s]."""
    largest, when = 0.0, 0.0
    for time, picture in pictures(run.directory, "blocks"):
        blocks = polygons(picture)
        depth = max(between_blocks(convex_parts(blocks)), into_ground(blocks, ground_line(run, time)))
        if depth > largest:
            largest, when = depth, time
    return largest, when


def polygons(picture):
    """Corners (n x 2) [m] of each block, counter-clockwise."""
    return [picture.points[cell, :2] for cell in picture.cells]


def area(corners):
    x, y = corners.T
    return 0.5 * (x @ np.roll(y, -1) - y @ np.roll(x, -1))


def convex_parts(blocks):
    """The blocks, those that are not convex as triangles (counter-clockwise)."""
    parts = []
    for corners in blocks:
        corners = list(corners)
        while len(corners) > 3 and any(turn(corners, k) < 0 for k in range(len(corners))):
            ear = next(k for k in range(len(corners)) if turn(corners, k) > 0 and is_ear(corners, k))
            parts.append(np.array([corners[ear - 1], corners[ear], corners[(ear + 1) % len(corners)]]))
            del corners[ear]
        parts.append(np.array(corners))
    return [part for part in parts if area(part) > 0]


def turn(corners, k):
    """Positive: the corner is convex [m2]."""
    (ax, ay), (bx, by) = corners[k] - corners[k - 1], corners[(k + 1) % len(corners)] - corners[k]
    return ax * by - ay * bx


def is_ear(corners, k):
    """No other corner is in the triangle that it makes with its neighbours."""
    ear = [corners[k - 1], corners[k], corners[(k + 1) % len(corners)]]
    others = [c for c in corners if not any(c is e for e in ear)]
    return not any(all(turn([ear[i], ear[(i + 1) % 3], c], 1) >= 0 for i in range(3)) for c in others)


def between_blocks(blocks):
    """Largest overlap of two convex blocks over the size (root of the area) of the smaller one.

    The overlap is the shortest way to part them: the smallest overlap of their shadows on the normals of their edges.
    """
    low, high = np.array([b.min(axis=0) for b in blocks]), np.array([b.max(axis=0) for b in blocks])
    reach = np.linalg.norm(high - low, axis=1).max()  # middles of boxes that meet are no farther apart
    i, j = cKDTree((low + high) / 2).query_pairs(reach, output_type="ndarray").T
    meet = ((low[i] < high[j]) & (low[j] < high[i])).all(axis=1)
    i, j = i[meet], j[meet]
    if len(i) == 0:
        return 0.0
    most = max(len(b) for b in blocks)
    padded = np.array([np.vstack([b, np.repeat(b[-1:], most - len(b), axis=0)]) for b in blocks])
    size = np.sqrt([area(b) for b in blocks])
    apart = np.fmin(least_shadow(padded[i], padded[i], padded[j]), least_shadow(padded[j], padded[i], padded[j]))
    return max((apart / np.minimum(size[i], size[j])).max(), 0.0)


def least_shadow(sides, one, other):
    """Smallest overlap (p) of the shadows of p pairs of blocks (p x corners x 2) on the normals of the edges of `sides`."""
    edges = np.roll(sides, -1, axis=1) - sides
    lengths = np.linalg.norm(edges, axis=2, keepdims=True)
    with np.errstate(divide="ignore", invalid="ignore"):
        normals = np.stack([edges[..., 1], -edges[..., 0]], axis=-1) / lengths  # NaN where a corner was repeated
    a, b = (np.einsum("pcx,pex->pce", corners, normals) for corners in (one, other))
    return np.fmin.reduce(np.fmin(a.max(axis=1) - b.min(axis=1), b.max(axis=1) - a.min(axis=1)), axis=1)


def into_ground(blocks, line):
    """Largest depth of a corner below an open polyline (from left to right, blocks above it) over the block's size."""
    depth_below = 10 * np.ptp(line, axis=0).max()
    ends = [[line[-1, 0], line[:, 1].min() - depth_below], [line[0, 0], line[:, 1].min() - depth_below]]
    ring = np.vstack([line, ends])
    corners, size = np.vstack(blocks), np.repeat(np.sqrt([area(b) for b in blocks]), [len(b) for b in blocks])
    below = np.nonzero(Path(ring).contains_points(corners))[0]
    return max((distance(corners[k], line) / size[k] for k in below), default=0.0)


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
    _, nearest = cKDTree(picture.initial()).query(surface)
    return picture.points[nearest][:, :2]
