# SPDX-License-Identifier: GPL-3.0-or-later
"""Slip on the sliding surface: in time, and along it at the last common picture."""

import numpy as np

from hybrid_run import MissingData
from hybrid_tools import style
from hybrid_tools.plot.slip import broken, slide_breaks

from . import curves


def having(comparison):
    return [i for i, run in enumerate(comparison.runs) if run.has("slip/mean") and run.has("slip/largest")]


def last_profile(comparison, i):
    """(x of the soles [m], slip [m], time [s], breaks between slides) of run i at its last picture within the common time; slip is
    positive as of the reference's sole next to it."""
    run = comparison.runs[i]
    time, profile, position = run.get("slip/time"), run.get("slip/profile"), run.get("slip/position")
    n = min(len(time), len(profile))
    profile = profile[:n].reshape(n, -1)
    row = int(np.searchsorted(time[:n], comparison.end * (1 + 1e-9), side="right")) - 1
    if row < 0 or len(position) < 2:
        raise MissingData("no picture, or one block alone")
    order = np.argsort(position[:, 0])
    reference = comparison.reference
    others = reference.get("slip/position").reshape(-1, 2)[:, 0]
    nearest = np.abs(position[:, :1] - others).argmin(axis=1)
    sign = signs(run) * signs(reference)[nearest]
    return position[order, 0], (sign * profile[row])[order], time[row], slide_breaks(run, order)


def signs(run):
    """Of x, of slip that is positive on each sole."""
    return np.where(run.downhill_of_soles < 0, -1.0, 1.0)


def draw(comparison, directory):
    runs = having(comparison)
    if not runs:
        raise MissingData("no slip")
    histories = {i: (comparison.on_axis(i, "slip/mean"), comparison.on_axis(i, "slip/largest")) for i in runs}
    factor, unit = style.length_unit(max(np.nanmax(np.abs(h), initial=0) for pair in histories.values() for h in pair))
    profiles = profiles_of(comparison, runs)
    figure, axes = curves.panels(1, 2 if profiles else 1, (5.2 if profiles else 7, 3.6))
    for i, (mean, largest) in histories.items():
        axes[0, 0].plot(comparison.axis, factor * mean, **curves.look(i))
        axes[0, 0].plot(comparison.axis, factor * largest, **dict(curves.look(i), lw=0.7, alpha=0.6))
    axes[0, 0].set_title("mean (thin: largest)")
    axes[0, 0].set_xlabel("time [s]")
    axes[0, 0].set_xlim(0, comparison.end)
    if profiles:
        draw_profiles(axes[0, 1], profiles, factor)
    for axis in axes[0]:
        axis.set_ylabel("slip %s[%s]" % ("downhill " if comparison.reference.slips_downhill else "", unit))
        axis.axhline(0, color="#8a8a8a", lw=0.7, zorder=1)
    curves.finish(figure, comparison, "Slip on the sliding surface", directory, "slip")


def profiles_of(comparison, runs):
    """{run: last_profile()} of those that have a picture; without pictures there are none."""
    found = {}
    for i in runs:
        try:
            found[i] = last_profile(comparison, i)
        except MissingData:
            pass
    return found


def draw_profiles(axis, profiles, factor):
    for i, (x, slip, _, breaks) in profiles.items():
        axis.plot(*broken(x, factor * slip, breaks), marker=".", ms=3, **curves.look(i))
    times = sorted({time for _, _, time, _ in profiles.values()})
    axis.set_title("along the surface at %s s" % " | ".join("%.4g" % time for time in times))
    axis.set_xlabel("x of the block's sole at rest [m]")
