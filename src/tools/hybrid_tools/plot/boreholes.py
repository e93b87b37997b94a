# SPDX-License-Identifier: GPL-3.0-or-later
"""Displacement with depth along each borehole, beside what was measured there."""

import matplotlib.pyplot as plt
import numpy as np

from hybrid_run import MissingData
from hybrid_tools import style

LAST = 2.0  # [s]; what is left is the mean over so much, or over a quarter of a shorter run
AT_REST = 1e-3  # [m]; a mass whose slip changes by more over that time still slides


def depth_of_slip(run, path):
    """Depth of the sliding surface [m]: recorded, or where the surface passes under the borehole; None if unknown."""
    recorded = run.attribute(path, "slip_depth_m")
    position = run.attribute(path, "position")
    if recorded is not None or position is None or not run.has("section/surface"):
        return recorded
    x, top = position[:2]
    for line in run.surface:
        line = line[np.argsort(line[:, 0])]
        if line[0, 0] <= x <= line[-1, 0]:
            return top - np.interp(x, line[:, 0], line[:, 1])
    return None


def still_slides(run, span):
    """Whether the mean or the largest slip goes on growing over the last seconds of the run."""
    if not run.has("slip/mean") or run.n < 2:
        return False
    last = run.time > run.time[-1] - span
    return any(np.ptp(run.history("slip/" + name)[last]) > AT_REST for name in ("mean", "largest"))


def left_at_end(run, x):
    """(profile [m], what it is): the mean over the last seconds, as the mass may still swing when a run ends; where it still slides, the last."""
    time = run.get("time")[: len(x)]
    span = min(LAST, 0.25 * time[-1])
    if still_slides(run, span):
        return x[len(time) - 1], "at the end, %.4g s: it still slides" % time[-1]
    return x[: len(time)][time > time[-1] - span].mean(axis=0), "left: mean of the last %.3g s" % span


def with_jump(depth, x, slip_depth):
    """The profile (depths rising; x: a row per time, or one) with two points at the sliding surface: each side straight on up to it."""
    if slip_depth is None or not depth[0] < slip_depth < depth[-1]:
        return depth, x
    k = int(np.searchsorted(depth, slip_depth))

    def straight_on(near, far):
        """From two samples of one side; where they are not both there, the value of the one."""
        if not 0 <= far < len(depth) or depth[far] == depth[near]:
            return x[..., near]
        return x[..., near] + (x[..., near] - x[..., far]) * (slip_depth - depth[near]) / (depth[near] - depth[far])

    both = np.stack([straight_on(k - 1, k - 2), straight_on(k, k + 1)], axis=-1)
    return np.insert(depth, k, [slip_depth] * 2), np.concatenate([x[..., :k], both, x[..., k:]], axis=-1)


def name_sliding_surface(axes, depth, curves):
    """Its name stands on the side where the curves are not; its line crosses the whole picture."""
    axes.axhline(depth, color=style.SLIP, lw=1.2)
    low, high = axes.get_xlim()
    is_left = np.mean(curves) > 0.5 * (low + high)
    axes.annotate("sliding surface", (0 if is_left else 1, depth), (2 if is_left else -2, 3), xycoords=("axes fraction", "data"),
                  textcoords="offset points", ha="left" if is_left else "right", va="bottom", color=style.SLIP, fontsize=8)


def draw_measured(run, axes, name, factor):
    """What was measured, with its error if it is known. factor: from mm to the axis. @return whether there is something."""
    path = "profiles/" + name
    measured = run.attribute(path, "measured_mm")
    if measured is None:
        return False
    measured = np.atleast_1d(measured)
    depth = np.atleast_1d(run.attribute(path, "measured_depth_m", np.zeros_like(measured)))
    error = run.attribute(path, "measured_error_mm")
    axes.errorbar(factor * measured, depth, xerr=None if error is None else factor * np.atleast_1d(error), fmt="D", color=style.TENSILE, ms=6,
                  mec="white", mew=0.8, ls="none", elinewidth=1.2, capsize=3, label="measured", clip_on=False, zorder=5)
    return True


def largest_of(run, name):
    """Largest horizontal displacement along a borehole [m]."""
    return np.abs(run.get("profiles/%s/displacement" % name)[:, 0::2]).max()


def draw_profile(run, axes, name, with_legend=True, largest=None):
    """largest: displacement that the unit is chosen for [m], by default that of this borehole."""
    path = "profiles/" + name
    depth = run.get(path + "/depth")
    x = run.downhill * run.get(path + "/displacement")[:, 0::2]
    order = np.argsort(depth)
    slip_depth = depth_of_slip(run, path)
    depth, x = with_jump(depth[order], x[:, order], slip_depth)
    row = np.abs(x[:, 0]).argmax()
    factor, unit = style.length_unit(np.abs(x).max() if largest is None else largest)

    axes.fill_betweenx(depth, factor * x.min(axis=0), factor * x.max(axis=0), color="#cfdcea", lw=0, label="envelope of the run")
    time = run.get("time")
    when = " (%.2f s)" % time[row] if with_legend and row < len(time) else ""
    left, what = left_at_end(run, x)
    axes.plot(factor * x[row], depth, color=style.HORIZONTAL, lw=1.8, label="at peak of surface" + when)
    axes.plot(factor * left, depth, color=style.TEXT, lw=1.2, ls="--", label=what)
    draw_measured(run, axes, name, 1e-3 * factor)
    axes.axvline(0, color="#8a8a8a", lw=0.7)
    axes.set_ylim(depth.max(), min(depth.min(), 0))
    axes.margins(x=0.08)
    if slip_depth is not None:
        near = np.abs(depth - slip_depth) < 0.12 * depth.max()  # as high as the words, and a little
        name_sliding_surface(axes, slip_depth, factor * np.concatenate([x[row][near], left[near]]))
    axes.set_xlabel("%s displacement [%s]" % (run.along("horizontal"), unit))
    axes.set_title(name)
    if with_legend:
        axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.12), ncol=1)


def draw(run, directory):
    names = run.names("profiles")
    names = [n for n in names if run.has("profiles/%s/displacement" % n) and len(run.file["profiles/%s/displacement" % n])]
    if not names:
        raise MissingData("no profiles in run.h5")
    figure, axes = plt.subplots(1, len(names), figsize=(max(3.6 * len(names), 5), 6), squeeze=False, sharey=False,
                                constrained_layout=True)
    largest = max(largest_of(run, name) for name in names)  # one unit for all
    for axis, name in zip(axes[0], names):
        draw_profile(run, axis, name, largest=largest)
    axes[0, 0].set_ylabel("depth [m]")
    style.title(figure, "Boreholes: " + run.title())
    style.save(figure, directory, "boreholes")
