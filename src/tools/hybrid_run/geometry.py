# SPDX-License-Identifier: GPL-3.0-or-later
"""Sizes of the section of a run, by which two sections are told apart."""

import numpy as np

from .errors import MissingData

SAME = 0.02  # of the section's size: meshes of another fineness cut curves otherwise
BLOCKS = ("layers", "triangles")  # bedrock that run.h5 counts among the blocks; the lowest of the layers is not there


def measures(run):
    """{what: (value [m or m2], size it is judged by)} of what run.h5 holds of mass, sliding surface and bedrock."""
    found = {}
    if run.has("section/blocks_points"):
        area = sum(_area(block) for block in run.blocks.polygons)
        bedrock = bedrock_model(run)
        if run.has("section/cells"):
            whole = area + sum(_area(cell.reshape(4, 2)) for cell in run.get("section/cells"))
            found["area of the section"] = (whole, whole)
        elif bedrock == "triangles":
            found["area of the section"] = (area, area)
        if bedrock not in BLOCKS:
            _add_extent(found, "sliding mass", np.vstack(run.blocks.polygons))
            found["area of the sliding mass"] = (area, area)
    if run.has("section/surface"):
        _add_extent(found, "sliding surface", run.get("section/surface"))
    if run.has("section/outline"):
        _add_extent(found, "bedrock", run.get("section/outline").reshape(-1, 2))
    return found


def joint_edges(run):
    """Edges of the mass on lines that have a material of their own (Blocks/Joint materials), as drawn [m], n x 2 x 2."""
    given = run.parameters.get("Blocks/Joint materials", "")
    named = {pair.split(":")[0].strip() for pair in given.split(";")} if ":" in given else None
    found = [run.get("section/lines/" + line).reshape(-1, 2, 2) for line in run.names("section/lines")
             if given and line.startswith("joint_") and (named is None or named & {line, "*"})]
    return np.concatenate(found) if found else np.zeros((0, 2, 2))


def bedrock_model(run):
    """Model/Bedrock of the scene; "" where it is not known."""
    try:
        return run.parameters.get("Model/Bedrock", "")
    except MissingData:
        return ""


def other_section(run, reference):
    """How the section of a run differs from that of the reference, in words; "" if it does not, as far as both recorded it."""
    own, others = measures(run), measures(reference)
    for what in own.keys() & others.keys():
        value, size = others[what]
        if abs(own[what][0] - value) > SAME * max(size, 1e-9):
            return "%s %.6g instead of %.6g %s" % (what, own[what][0], value, "m2" if what.startswith("area") else "m")
    return ""


def chains(segments):
    """Segments (n x 2 x 2) that meet end to end as polylines, in the order of their first segments: dashes run on along them."""
    segments = np.asarray(segments, float)
    if not len(segments):
        return []
    size = max(float(np.ptp(segments.reshape(-1, 2), axis=0).max()), 1e-30)
    keys = [[tuple(end) for end in pair] for pair in np.round(segments / (1e-7 * size)).astype(np.int64).tolist()]
    at = {}
    for k, pair in enumerate(keys):
        for end in pair:
            at.setdefault(end, []).append(k)
    left, found = set(range(len(segments))), []
    for first in range(len(segments)):
        if first not in left:
            continue
        left.discard(first)
        line = [(keys[first][end], segments[first][end]) for end in (0, 1)]
        for is_front in (False, True):
            while len(near := at[line[0 if is_front else -1][0]]) == 2 and (more := [k for k in near if k in left]):
                left.discard(more[0])
                far = 1 - keys[more[0]].index(line[0 if is_front else -1][0])
                line.insert(0 if is_front else len(line), (keys[more[0]][far], segments[more[0]][far]))
        found.append(np.array([point for _, point in line]))
    return found


def _add_extent(found, what, points):
    low, high = points.min(axis=0), points.max(axis=0)
    size = float(np.hypot(*(high - low)))
    ends = {"left end": low[0], "right end": high[0], "lowest point": low[1], "highest point": high[1]}
    for end, value in ends.items():
        found["%s of the %s at" % (end, what)] = (float(value), size)


def _area(polygon):
    x, y = polygon.T
    return 0.5 * abs(float(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1))))
