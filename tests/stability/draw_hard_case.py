#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws snapshots of a hard case's run: blocks coloured by speed or displacement, and the ground.

    draw_hard_case.py RUN_DIRECTORY FIGURE.png TIME TIME ... [--window X0,X1,Y0,Y1] [--displacement]

RUN_DIRECTORY is WORK_DIR/VARIANT of hard_cases.py; times in s; the window in m (default: around the blocks).
"""

import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plot  # noqa: E402 (needs the backend above)
import numpy as np  # noqa: E402
from matplotlib.collections import PolyCollection  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "src/tools"), str(ROOT / "tests/verification/cases"), str(ROOT / "tests/stability")]

import overlaps  # noqa: E402
from hybrid_run import Run  # noqa: E402
from vtu_file import picture_at  # noqa: E402


def magnitudes(picture, field):
    """Length of a vector field, "velocity [m/s]" or "displacement [m]", in the middle of each block."""
    vectors = picture.point_fields[field][:, :2]
    return np.array([np.linalg.norm(vectors[c].mean(axis=0)) for c in picture.cells])


def edge_width(n_blocks):
    """Of the blocks' edges [points]: the smaller the blocks, the thinner."""
    return 0.6 if n_blocks <= 300 else 0.3 if n_blocks <= 3000 else 0.0


def window_around(pictures):
    """Limits of x and y of the blocks in all pictures, a little more [m]."""
    points = np.vstack([p.points[:, :2] for p in pictures])
    low, high = points.min(axis=0), points.max(axis=0)
    room = 0.05 * (high - low).max()
    return [low[0] - room, high[0] + room, low[1] - room, high[1] + room]


def draw(run, times, window, file, field):
    found = [picture_at(run.directory, "blocks", t) for t in times]
    window = window or window_around([p for p, _ in found])
    largest = max(magnitudes(p, field).max() for p, _ in found)
    wide = (window[1] - window[0]) > 2 * (window[3] - window[2])
    rows, columns = (len(times), 1) if wide else (1, len(times))
    ratio = (window[3] - window[2]) / (window[1] - window[0])
    width = 8 / columns
    figure, axes = plot.subplots(rows, columns, figsize=(9, min(9.0, rows * (width * ratio + 0.45) + 0.3)), dpi=100,
                                 squeeze=False, sharex=True, sharey=True, constrained_layout=True)
    for axis, (picture, time) in zip(axes.flat, found):
        shown = PolyCollection(overlaps.polygons(picture), array=magnitudes(picture, field), cmap="viridis",
                               edgecolors="black", linewidths=edge_width(len(picture.cells)), clim=(0, max(largest, 1e-12)))
        axis.add_collection(shown)
        line = overlaps.ground_line(run, time)
        axis.fill_between(*line.T, window[2] - 1, color="0.8", zorder=-1)
        axis.plot(*line.T, color="black", linewidth=0.8)
        axis.set_aspect("equal")
        axis.set_xlim(window[:2])
        axis.set_ylim(window[2:])
        axis.set_title("t = %.3g s" % time, fontsize=9)
        axis.tick_params(labelsize=7)
    figure.supxlabel("x [m]", fontsize=8)
    figure.supylabel("y [m]", fontsize=8)
    figure.colorbar(shown, ax=axes, shrink=0.8).set_label(field.replace("velocity", "speed"), fontsize=8)
    figure.savefig(file)


def main():
    arguments, window = [a for a in sys.argv[1:] if a != "--displacement"], None
    field = "displacement [m]" if "--displacement" in sys.argv else "velocity [m/s]"
    if "--window" in arguments:
        at = arguments.index("--window")
        window = [float(x) for x in arguments[at + 1].split(",")]
        del arguments[at:at + 2]
    if len(arguments) < 3:
        sys.exit(__doc__)
    run = Run(arguments[0])
    run.directory_path = pathlib.Path(arguments[0])
    draw(run, [float(t) for t in arguments[2:]], window, arguments[1], field)


if __name__ == "__main__":
    main()
