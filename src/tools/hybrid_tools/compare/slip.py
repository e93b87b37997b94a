# SPDX-License-Identifier: GPL-3.0-or-later
"""Slip on the sliding surface: in time, and along it at the last common picture."""

import numpy as np

from hybrid_run import MissingData
from hybrid_tools import style

from . import curves


def having(comparison):
    return [i for i, run in enumerate(comparison.runs) if run.has("slip/mean") and run.has("slip/largest")]


def last_profile(comparison, i):
    """(x of the soles [m], slip [m], time [s]) of run i at its last picture within the common time."""
    run = comparison.runs[i]
    time, profile, position = run.get("slip/time"), run.get("slip/profile"), run.get("slip/position")
    n = min(len(time), len(profile))
    profile = profile[:n].reshape(n, -1)
    row = int(np.searchsorted(time[:n], comparison.end * (1 + 1e-9), side="right")) - 1
    if row < 0:
        raise MissingData("no picture")
    order = np.argsort(position[:, 0])
    return position[order, 0], run.downhill * comparison.downhill * profile[row][order], time[row]


def draw(comparison, directory):
    runs = having(comparison)
    if not runs:
        raise MissingData("no slip")
    figure, axes = curves.panels(1, 2, (5.2, 3.6))
    histories = {i: (comparison.on_axis(i, "slip/mean"), comparison.on_axis(i, "slip/largest")) for i in runs}
    factor, unit = style.length_unit(max(np.nanmax(np.abs(h), initial=0) for pair in histories.values() for h in pair))
    for i, (mean, largest) in histories.items():
        axes[0, 0].plot(comparison.axis, factor * mean, **curves.look(i))
        axes[0, 0].plot(comparison.axis, factor * largest, **dict(curves.look(i), lw=0.7, alpha=0.6))
    axes[0, 0].set_title("mean (thin: largest)")
    axes[0, 0].set_xlabel("time [s]")
    axes[0, 0].set_xlim(0, comparison.end)
    times = draw_profiles(comparison, runs, axes[0, 1], factor)
    axes[0, 1].set_title("along the surface at %s s" % " | ".join("%.4g" % time for time in times))
    axes[0, 1].set_xlabel("x of the block's sole at rest [m]")
    for axis in axes[0]:
        axis.set_ylabel("slip %s[%s]" % ("" if comparison.reference.is_level else "downhill ", unit))
        axis.axhline(0, color="#8a8a8a", lw=0.7, zorder=1)
    curves.finish(figure, comparison, "Slip on the sliding surface", directory, "slip")


def draw_profiles(comparison, runs, axis, factor):
    """@return the times that are drawn [s]"""
    times = []
    for i in runs:
        try:
            x, slip, time = last_profile(comparison, i)
        except MissingData:
            continue
        axis.plot(x, factor * slip, marker=".", ms=3, **curves.look(i))
        times.append(time)
    return sorted(set(times)) or [0.0]
