# SPDX-License-Identifier: GPL-3.0-or-later
"""Spectral ratios of the monitors to the outcrop motion, with the frequency up to which each run resolves waves."""

import numpy as np
from matplotlib.lines import Line2D
from matplotlib.ticker import FormatStrFormatter, NullFormatter

from hybrid_run import MissingData
from hybrid_run.spectra import FAINT, has_energy, spectral_ratio

from hybrid_tools import style

from . import curves

POINTS = 250
BANDWIDTH = 40.0  # of Konno and Ohmachi
ZEROS = 3  # lengths of the history: frequencies so close that the smoothing sees no steps in short runs
WEAK = 1e-6  # of the motion's other component: there is no ratio to what does not shake


def frequencies(comparison):
    """From three periods in the common time to the low-pass or half the sampling rate [Hz]."""
    highest = min(comparison.corner or np.inf, 0.5 / comparison.dt)
    return np.geomspace(min(3 / comparison.end, 0.5 * highest), highest, POINTS)


def component(comparison):
    """The one in which the motion of the reference is stronger."""
    peaks = np.abs(comparison.outcrop(0)).max(axis=0)
    if peaks.max() == 0:
        raise MissingData("no motion")
    return int(peaks.argmax())


def ratio(comparison, i, name, c, at):
    """Of run i, each to its own outcrop motion, over the common time [-]; NaN where that has next to no energy."""
    motion = comparison.outcrop(i)
    if np.abs(motion[:, c]).max() <= WEAK * np.abs(motion).max():
        return np.full(len(at), np.nan)
    histories = [comparison.raw_acceleration(i, name)[:, c], motion[:, c]]
    acceleration, outcrop = (np.pad(history, (0, ZEROS * len(history))) for history in histories)
    found = spectral_ratio(acceleration, outcrop, comparison.dt, at, BANDWIDTH)
    return np.where(has_energy(outcrop, comparison.dt, at, BANDWIDTH), found, np.nan)


def draw(comparison, directory):
    names = curves.monitors_to_show(comparison)
    if not names or not comparison.has_everywhere("input/acceleration"):
        raise MissingData("no monitors or no motion")
    c, at = component(comparison), frequencies(comparison)
    columns = min(len(names), 3)
    figure, axes = curves.panels(-(-len(names) // columns), columns, (3.7 if columns > 1 else 6, 2.8))
    for axis in axes.flat[len(names):]:
        axis.set_axis_off()
    for axis, name in zip(axes.flat, names):
        for i in range(len(comparison.runs)):
            axis.plot(at, ratio(comparison, i, name, c, at), **curves.look(i))
        axis.axhline(1, color="#8a8a8a", lw=0.7)
        mark_limits(comparison, axis, at)
        frequency_axis(axis, at)
        axis.set_xlabel("frequency [Hz]\n(outcrop over %g %% of its largest amplitude)" % (100 * FAINT))
        axis.set_ylim(bottom=0)
        axis.set_title(name)
    for row in axes:
        row[0].set_ylabel("|a| / |a outcrop|, %s [-]" % ("vertical" if c else "horizontal"))
    handles = [Line2D([], [], label=label, **curves.look(i)) for i, label in enumerate(comparison.labels)]
    if limits(comparison):
        handles.append(Line2D([], [], color="#555555", ls=":", lw=1.4, label="resolved up to here"))
    title = "Spectral ratios to the outcrop motion (Konno and Ohmachi, b = %g)" % BANDWIDTH
    curves.finish(figure, comparison, title, directory, "spectral_ratios", handles)


def limits(comparison):
    """{frequency [Hz]: number of the first run that resolves no more}"""
    found = {}
    for i, run in enumerate(comparison.runs):
        if run.summary.get("resolved_frequency_hz"):
            found.setdefault(round(run.summary["resolved_frequency_hz"], 3), i)
    return found


def mark_limits(comparison, axis, at):
    """A dotted line where a run stops to resolve, in its colour, black if it is that of several."""
    shared = limits(comparison)
    for frequency, i in shared.items():
        if at[0] < frequency < at[-1]:
            axis.axvline(frequency, color=curves.look(i)["color"] if len(shared) > 1 else "#555555", ls=":", lw=1.4, zorder=1)


def frequency_axis(axis, at):
    axis.set_xscale("log")
    axis.set_xlim(at[0], at[-1])
    axis.set_xticks(style.frequency_ticks(at[0], at[-1]))
    axis.xaxis.set_major_formatter(FormatStrFormatter("%g"))
    axis.xaxis.set_minor_formatter(NullFormatter())
    axis.set_xlabel("frequency [Hz]")
