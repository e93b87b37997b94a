# SPDX-License-Identifier: GPL-3.0-or-later
"""Which slides of a run fall one way: where some lie on either flank of a valley, an answer is of those alone."""

import numpy as np


def name_of(towards):
    """Of a sign of x."""
    return "+x" if towards > 0 else "-x"


def falls(run, towards):
    """Per sole: whether it counts where the answer is towards this sign of x; all of them unless slides face each other."""
    downhill = run.downhill_of_soles
    return downhill == towards if run.is_on_both_flanks else np.ones(len(downhill), bool)


def sole_edges(run, chosen):
    """(number of the block, its edge [2 x 2, m]) of each sole that is chosen: the edge that its point lies on."""
    polygons = run.blocks.polygons[run.blocks.mass]
    first = np.vstack(polygons)
    second = np.vstack([np.roll(polygon, -1, axis=0) for polygon in polygons])
    block = np.repeat(np.arange(len(polygons)), [len(polygon) for polygon in polygons])
    along = second - first
    size = np.linalg.norm(along, axis=1)
    found = []
    for point, length in zip(run.get("slip/position").reshape(-1, 2)[chosen], np.ravel(run.get("slip/length"))[chosen]):
        part = np.clip(((point - first) * along).sum(axis=1) / size**2, 0, 1)
        off = np.linalg.norm(first + part[:, None] * along - point, axis=1) + np.abs(size - length)
        nearest = int(off.argmin())
        found.append((int(block[nearest]), np.array([first[nearest], second[nearest]])))
    return found


def slope(run, towards):
    """Mean angle of the soles [rad], positive where they fall towards this sign of x: of the line through them, or of the only one."""
    chosen = falls(run, towards)
    if chosen.sum() == 1:
        dx, dy = np.subtract(*sole_edges(run, chosen)[0][1])
        gradient = dy / dx
    else:
        x, y = run.get("slip/position")[chosen].T
        gradient = np.polyfit(x, y, 1, w=np.sqrt(run.get("slip/length")[chosen]))[0]
    return np.arctan(-towards * gradient)


def slip(run, towards):
    """(time [s], mean [m], largest at the end [m]) of slip, positive towards this sign of x: of every step, or, of a part of the soles, at
    the times of the pictures."""
    if not run.is_on_both_flanks:
        sign = run.downhill * towards  # on a level surface slip is positive along +x
        return run.time, sign * run.history("slip/mean"), sign * float(run.history("slip/largest")[-1])
    chosen = falls(run, towards)
    time, profile = run.get("slip/time"), run.get("slip/profile")
    n = min(len(time), len(profile))
    profile = profile[:n, chosen]
    return time[:n], profile @ run.get("slip/length")[chosen] / run.get("slip/length")[chosen].sum(), float(
        profile[-1, np.abs(profile[-1]).argmax()])
