# SPDX-License-Identifier: GPL-3.0-or-later
"""Bedding planes, and joint lines of the mass, that have slipped: the largest slip over time, and slip along the plane."""

import matplotlib.pyplot as plt
import numpy as np

from hybrid_run import MissingData, NotInScene
from hybrid_tools import style

GROUPS = ("bedding", "joint_lines")
MOST_PLANES = 4
MOST_PROFILES = 5  # besides the last one
SEEN = 1e-6  # [m], of planes: their slip has no elastic part
LEAST_OPENING = 0.01  # beside the slip [-], to be drawn
SLIP_OR_OPENING = "slip of the upper side along +x\n(of a vertical plane: left side, upwards)\nor opening [%s]"


class Plane:
    """What run.h5 says about one plane of a group, its points in order from left to right (of a steep one upwards)."""

    def __init__(self, run, group, name):
        path = group + "/" + name + "/"
        points = run.get(path + "position")
        n = min(len(run.get(group + "/time")), len(run.get(path + "slip")), len(run.get(path + "opening")))  # of a run that goes on
        towards = np.linalg.svd(points - points.mean(axis=0), full_matrices=False)[2][0]
        towards *= np.sign(towards[np.argmax(np.abs(towards))])
        along = points @ towards
        order = np.argsort(along, kind="stable")
        self.name = name
        self.seen = float(np.ravel(run.attribute(group, "threshold", SEEN))[0])
        self.along = along[order] - along.min()
        self.time = run.get(group + "/time")[:n]
        self.slip = run.get(path + "slip")[:n, order]
        self.opening = run.get(path + "opening")[:n, order]

    def most(self):
        return max(np.abs(self.slip).max(), self.opening.max())


def has_history(run, group):
    return run.has(group + "/time") and len(run.get(group + "/time")) > 1


def planes_of(run):
    """Those that have slipped or opened most, by name."""
    names = [(group, name) for group in GROUPS if has_history(run, group)
             for name in run.names(group) if name != "time" and run.get("%s/%s/position" % (group, name)).ndim == 2]
    planes = sorted((Plane(run, *name) for name in names), key=lambda plane: -plane.most())
    return sorted((plane for plane in planes[:MOST_PLANES] if plane.most() > plane.seen), key=lambda plane: plane.name)


def draw_history(plane, axes, factor, unit):
    farthest = np.argmax(np.abs(plane.slip), axis=1)
    axes.plot(plane.time, factor * plane.slip[np.arange(len(farthest)), farthest], color=style.SHEAR, lw=1.1, label="slip, largest")
    if plane.opening.max() > max(plane.seen, LEAST_OPENING * np.abs(plane.slip).max()):
        axes.plot(plane.time, factor * plane.opening.max(axis=1), color=style.TENSILE, lw=0.9, label="opening, largest")
    axes.axhline(0, color="#8a8a8a", lw=0.7)
    axes.set_xlim(plane.time[0], plane.time[-1])
    axes.margins(y=0.12)
    axes.set_ylabel(SLIP_OR_OPENING % unit)
    axes.legend(loc="best")
    axes.set_title(plane.name)


def draw_profiles(plane, axes, factor):
    rows = sorted({int(round(row)) for row in np.linspace(0, len(plane.time) - 1, MOST_PROFILES + 1)} - {0, len(plane.time) - 1})
    for row, colour in zip(rows, plt.get_cmap("viridis")(np.linspace(0.1, 0.9, max(len(rows), 1)))):
        axes.plot(plane.along, factor * plane.slip[row], color=colour, lw=0.9, label="%.3g s" % plane.time[row])
    axes.plot(plane.along, factor * plane.slip[-1], color=style.TEXT, lw=1.6, label="%.3g s" % plane.time[-1])
    axes.axhline(0, color="#8a8a8a", lw=0.7)
    axes.margins(x=0.01, y=0.12)
    axes.legend(loc="center left", bbox_to_anchor=(1.0, 0.5), handlelength=1.2)


def draw(run, directory):
    if not any(has_history(run, group) for group in GROUPS):
        raise NotInScene("no bedding planes or joint lines that may slip in run.h5")
    planes = planes_of(run)
    if not planes:
        raise MissingData("no bedding plane has slipped by more than %.3g mm, and no joint line by Output/Slip threshold" % (1e3 * SEEN))
    factor, unit = style.length_unit(max(plane.most() for plane in planes))
    figure, axes = plt.subplots(len(planes), 2, figsize=(11, 3.0 * len(planes) + 0.6), constrained_layout=True, squeeze=False, sharey="row")
    for plane, (left, right) in zip(planes, axes):
        draw_history(plane, left, factor, unit)
        draw_profiles(plane, right, factor)
    axes[-1][0].set_xlabel("time [s]")
    axes[-1][1].set_xlabel("way along the plane [m]")
    style.title(figure, "Slip of planes and joints: " + run.title())
    style.save(figure, directory, "planes")
