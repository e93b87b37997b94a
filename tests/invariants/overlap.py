# SPDX-License-Identifier: GPL-3.0-or-later
"""How deep polygons are in each other, and in the ground below a polyline. Independent of the program and of convexity."""

import numpy as np

PLACES = np.linspace(0.0, 1.0, 5)[:-1]  # of the points that are looked at, on every edge: its corner and three more


def area(corners):
    x, y = corners.T
    return 0.5 * (x @ np.roll(y, -1) - y @ np.roll(x, -1))


def outline_points(corners):
    after = np.roll(corners, -1, axis=0)
    return np.concatenate([(1 - t) * corners + t * after for t in PLACES])


def depth_inside(points, polygon):
    """Distance of each point to the outline of a polygon if it lies inside [m], else 0."""
    a, b = polygon, np.roll(polygon, -1, axis=0)
    x, y = points[:, None, 0], points[:, None, 1]
    crosses = (a[:, 1] > y) != (b[:, 1] > y)
    with np.errstate(divide="ignore", invalid="ignore"):
        at = a[:, 0] + (y - a[:, 1]) / (b[:, 1] - a[:, 1]) * (b[:, 0] - a[:, 0])
    inside = (np.where(crosses, x < at, False).sum(axis=1) % 2) == 1
    return np.where(inside, distance(points, a, b), 0.0)


def distance(points, a, b):
    """Of each point to the nearest of the segments a-b [m]."""
    along = b - a
    length2 = (along**2).sum(axis=1)
    part = np.clip(((points[:, None] - a) * along).sum(axis=2) / length2, 0.0, 1.0)
    return np.sqrt((((a + part[..., None] * along) - points[:, None]) ** 2).sum(axis=2)).min(axis=1)


def between(blocks, others):
    """Deepest point of a block in another one over the size (root of the area) of the smaller, and the two numbers.

    blocks are looked at with each other and with `others` (the bedrock's, which are not looked at among themselves).
    """
    every = list(blocks) + list(others)
    low, high = np.array([p.min(axis=0) for p in every]), np.array([p.max(axis=0) for p in every])
    size = np.sqrt([abs(area(p)) for p in blocks])
    deepest = (0.0, -1, -1)
    for i in range(len(blocks)):
        meet = ((low[i] < high) & (low < high[i])).all(axis=1)
        for j in np.nonzero(meet)[0]:
            if j == i or (j < i and j < len(blocks)):
                continue
            depth = max(depth_inside(outline_points(every[i]), every[j]).max(),
                        depth_inside(outline_points(every[j]), every[i]).max())
            relative = depth / (min(size[i], size[j]) if j < len(blocks) else size[i])
            deepest = max(deepest, (relative, i, int(j)))
    return deepest


def into_ground(blocks, line):
    """Deepest point of a block below a polyline (from left to right) or of its nodes in a block, over the block's size."""
    depth = 10 * np.ptp(line, axis=0).max()
    bottom = line[:, 1].min() - depth
    ground = np.vstack([line, [[line[-1, 0], bottom], [line[0, 0], bottom]]])
    on_line = np.concatenate([(1 - t) * line[:-1] + t * line[1:] for t in PLACES])
    deepest = (0.0, -1, -1)
    for i, block in enumerate(blocks):
        size = np.sqrt(abs(area(block)))
        deepest = max(deepest, (depth_inside(outline_points(block), ground).max() / size, i, -1))
        low, high = block.min(axis=0), block.max(axis=0)
        near = on_line[((on_line >= low) & (on_line <= high)).all(axis=1)]
        if len(near):
            deepest = max(deepest, (depth_inside(near, block).max() / size, i, -2))
    return deepest
