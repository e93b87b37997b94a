# SPDX-License-Identifier: GPL-3.0-or-later
"""Response spectra of the monitors (pseudo-acceleration, 5 % of critical damping), beside that of the outcrop motion."""

import numpy as np
from matplotlib.lines import Line2D

from hybrid_run import MissingData, pseudo_acceleration

from . import curves
from .quantities import G
from .spectral_ratios import frequency_axis

DAMPING = 0.05
POINTS = 120


def frequencies(comparison):
    """From one period in the common time to the low-pass, a quarter of the sampling rate or 50 Hz [Hz]."""
    highest = min(comparison.corner or np.inf, 0.25 / comparison.dt, 50.0)
    return np.geomspace(min(max(0.1, 1 / comparison.end), 0.5 * highest), highest, POINTS)


def spectrum(comparison, acceleration, at):
    """[g]"""
    if not np.isfinite(acceleration).all():
        return np.full(len(at), np.nan)
    return pseudo_acceleration(acceleration, comparison.dt, at, DAMPING) / G


def draw(comparison, directory):
    names = curves.monitors_to_show(comparison)
    if not names:
        raise MissingData("no monitors")
    at = frequencies(comparison)
    columns = min(len(names), 3)
    figure, axes = curves.panels(-(-len(names) // columns), columns, (3.7 if columns > 1 else 6, 2.8))
    for axis in axes.flat[len(names):]:
        axis.set_axis_off()
    motions = {}
    for axis, name in zip(axes.flat, names):
        c = curves.component(comparison, name)
        if c not in motions:
            motions[c] = outcrop(comparison, c, at)
        if motions[c] is not None:
            axis.plot(at, motions[c], color="#9a9a9a", lw=1.0, zorder=1.5)
        for i in range(len(comparison.runs)):
            axis.plot(at, spectrum(comparison, comparison.acceleration(i, name)[:, c], at), **curves.look(i))
        frequency_axis(axis, at)
        axis.set_ylim(bottom=0)
        axis.set_title("%s, %s" % (name, "vertical" if c else "horizontal"))
    for row in axes:
        row[0].set_ylabel("pseudo-acceleration [g]")
    handles = [Line2D([], [], label=label, **curves.look(i)) for i, label in enumerate(comparison.labels)]
    if any(motion is not None for motion in motions.values()):
        handles.append(Line2D([], [], color="#9a9a9a", lw=1.0, label="outcrop motion of " + comparison.labels[0]))
    filtered = ", accelerations below %g Hz" % comparison.corner if comparison.corner else ""
    title = "Response spectra, damping %g %%%s" % (100 * DAMPING, filtered)
    curves.finish(figure, comparison, title, directory, "response_spectra", handles)


def outcrop(comparison, c, at):
    if not comparison.reference.has("input/acceleration") or not np.abs(comparison.outcrop(0)[:, c]).max() > 0:
        return None
    return spectrum(comparison, comparison.outcrop(0)[:, c], at)
