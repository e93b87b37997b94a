# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of the page: one panel each, narrow enough for a phone, with words for those who cannot see them."""

from dataclasses import dataclass

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.ticker import FormatStrFormatter, LogLocator, NullFormatter

from hybrid_run import MissingData, NotInScene
from hybrid_run.spectra import FAINT
from hybrid_tools import style
from hybrid_tools.plot import boreholes, energy_balance, input_motion, monitor_histories, section_view, slip

from . import facts
from .vector import to_svg

MOST_PARTS = 100  # of a collection in a figure of several sections; denser ones become a picture inside the drawing
WIDTH = 5.2  # [inches]; on a phone of 390 px the letters have 8 px then


@dataclass
class Panel:
    """A drawing with what stands below it."""

    svg: str
    caption: str
    is_wide: bool = False


def page(height, rows=1):
    return plt.subplots(rows, 1, figsize=(WIDTH, height), constrained_layout=True, squeeze=False, sharex=rows > 1)


def legend_below(axes, columns):
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.22), ncol=columns, handlelength=1.2, columnspacing=1.0, fontsize=7)


def plain_numbers(axis, low, high):
    """0.2, 1, 5 on a logarithmic axis, not powers; fewer where it spans much."""
    axis.set_major_locator(LogLocator(subs=(1, 2, 5) if high < 200 * low else (1,)))
    axis.set_major_formatter(FormatStrFormatter("%g"))
    axis.set_minor_formatter(NullFormatter())


def give_room(axes):
    """A flat section keeps a box that is as high as its labels."""
    (left, right), (bottom, top) = axes.get_xlim(), axes.get_ylim()
    if top - bottom < 0.25 * (right - left):
        axes.set_aspect("equal", adjustable="datalim")


def section(run):
    """Blocks where they lay, by how far they moved."""
    found = section_view.Section(run)
    size = found.high - found.low
    figure, axes = page(np.clip(3.9 * size[1] / size[0], 1.4, 4.4) + 0.9)
    section_view.draw_main(found, axes[0, 0])
    give_room(axes[0, 0])
    axes[0, 0].set_xlabel("x [m]")
    axes[0, 0].set_title("")
    values = found.peak if found.peak is not None else found.final
    if values is None:
        return figure, "The blocks at their first place; displacements are known when a run has ended."
    farthest = np.vstack([block.mean(axis=0) for block in found.blocks])[values.argmax()]
    marks = "" if found.joints is None else " Red and blue lines are failed joints."
    return figure, "Largest displacement of each block, drawn at its first place: up to %s %s, at x = %.0f m.%s" % (
        facts.length(values.max()) + (farthest[0], marks))


def final(run):
    """Where the blocks lie at the end, if they moved visibly."""
    found = section_view.Section(run)
    size = found.high - found.low
    if found.final_blocks is None or found.final is None or found.final.max() <= 0.01 * size.max():
        raise NotInScene("nothing moved visibly")
    figure, axes = page(np.clip(3.9 * size[1] / size[0], 1.6, 4.4) + 0.9)
    section_view.draw_final(found, axes[0, 0])
    give_room(axes[0, 0])
    axes[0, 0].set_xlabel("x [m]")
    axes[0, 0].set_title("")
    return figure, "The blocks where they lie at the end, to scale: moved by up to %s %s." % facts.length(found.final.max())


def model(run):
    """The whole section with its materials."""
    found = section_view.Section(run)
    figure, axes = page(3.2)
    section_view.draw_whole(found, axes[0, 0])
    give_room(axes[0, 0])
    axes[0, 0].set_title("")
    axes[0, 0].set_xlabel("x [m]")
    legend = axes[0, 0].get_legend()
    if legend:
        handles = legend.legend_handles if hasattr(legend, "legend_handles") else legend.legendHandles  # matplotlib before 3.7
        names = [text.get_text() for text in legend.get_texts()]
        axes[0, 0].legend(handles, names, loc="upper center", bbox_to_anchor=(0.5, -0.25), ncol=2, fontsize=7)
    return figure, "The model: %d blocks%s." % (len(found.blocks), ", %d cells of bedrock" % len(found.cells) if len(found.cells) else "")


def motion(run):
    """The motion that comes in: acceleration."""
    time, acceleration = run.equal_steps(run.history("input/acceleration"))
    figure, axes = page(2.1)
    input_motion.draw_history(axes[0, 0], time, acceleration, "outcrop\nacceleration", "m/s²")
    axes[0, 0].set_xlabel("time [s]")
    peak = np.abs(acceleration).max()
    return figure, "Acceleration of the outcrop motion: peak %.3g m/s² (%.2g g)." % (peak, peak / facts.GRAVITY)


def spectrum(run):
    """Response spectrum of the motion."""
    time, acceleration = run.equal_steps(run.history("input/acceleration"))
    input_motion.moving_components(acceleration)
    figure, axes = page(2.6)
    input_motion.draw_response(run, axes[0, 0], time, acceleration)
    for axis, limits in ((axes[0, 0].xaxis, axes[0, 0].get_xlim()), (axes[0, 0].yaxis, axes[0, 0].get_ylim())):
        plain_numbers(axis, *limits)
    return figure, "Response spectrum of the motion, by period of the oscillator."


def displacements(run):
    """Horizontal displacement of the monitors of the surface."""
    groups = run.monitor_groups()
    names = groups.get("S") or groups.get("D") or groups.get("other")
    if not names or run.n < 2:
        raise MissingData("no monitors in run.h5")
    figure, axes = page(2.9)
    monitor_histories.draw_overlay(run, axes[0, 0], names)
    legend_below(axes[0, 0], 4)
    peaks = {name: np.abs(run.relative_displacement(name)[:, 0]).max() for name in names}
    most = max(peaks, key=peaks.get)
    return figure, "Horizontal displacement%s: %s moves most, by %s %s." % (
        (" relative to " + run.base if run.base else "", most) + facts.length(peaks[most]))


def ratios(run):
    """Spectral ratios of the monitors to the outcrop."""
    component = max(input_motion.moving_components(run.history("input/acceleration")),
                    key=lambda c: np.abs(run.history("input/acceleration")[:, c]).max())
    groups = run.monitor_groups()
    names = groups.get("S") or groups.get("D") or groups.get("other")
    if not names:
        raise MissingData("no monitors in run.h5")
    figure, axes = page(2.9)
    resolved, most = facts.resolved_frequency(run), (0.0, 0.0, "")
    for name, colour in zip(names, plt.get_cmap("viridis")(np.linspace(0.0, 0.92, len(names)))):
        frequency, ratio = run.monitors[name].spectral_ratio(component)
        axes[0, 0].loglog(frequency, ratio, color=colour, lw=1.0, label=name)
        counted = np.nan_to_num(np.where(frequency <= (resolved or np.inf), ratio, 0.0))
        most = max(most, (counted.max(), frequency[counted.argmax()], name))
    axes[0, 0].axhline(1, color="#8a8a8a", lw=0.7)
    if resolved and resolved < frequency[-1]:
        axes[0, 0].axvspan(resolved, frequency[-1], color="#8a8a8a", alpha=0.18, lw=0, label="not resolved")
    axes[0, 0].set(xlabel="frequency [Hz]", ylabel="acceleration /\noutcrop [-]", xlim=(frequency[0], frequency[-1]))
    plain_numbers(axes[0, 0].xaxis, frequency[0], frequency[-1])
    plain_numbers(axes[0, 0].yaxis, *axes[0, 0].get_ylim())
    legend_below(axes[0, 0], 4)
    caption = ("Spectral ratio of %s acceleration to the outcrop motion where that has over %g %% of its largest amplitude, smoothed after Konno and Ohmachi (1998): "
               "largest %.3g%s, at %s, %.2g Hz.")
    return figure, caption % (("horizontal", "vertical")[component], 100 * FAINT, most[0], " of what the mesh resolves" if resolved else "", most[2], most[1])


def slip_history(run):
    """Slip against time."""
    largest = run.history("slip/largest")
    factor, unit = style.length_unit(np.abs(largest).max())
    figure, axes = page(2.5)
    slip.draw_history(run, axes[0, 0], factor, unit)
    return figure, "Slip on the sliding surface against time: of the sole that has slid farthest, and the mean over all."


def slip_profile(run):
    """Slip along the surface."""
    factor, unit = style.length_unit(np.abs(run.history("slip/largest")).max())
    figure, axes = page(2.9)
    slip.draw_profiles(run, axes[0, 0], factor, unit)
    legend_below(axes[0, 0], 4)
    return figure, "Slip along the sliding surface at some times."


def energy(run):
    """Terms of the audit."""
    time, terms = energy_balance.read_terms(run)
    figure, axes = page(3.8)
    energy_balance.draw_terms(axes[0, 0], time, terms)
    axes[0, 0].set_xlabel("time [s]")
    legend_below(axes[0, 0], 3)
    residual = run.summary.get("energy_residual")
    missing = ": %.2g %% of the energy is missing at the end" % (100 * abs(residual)) if isinstance(residual, float) else ""
    rest = energy_balance.grouped(terms)[1]
    small = " Smaller terms: %s." % ", ".join(name.replace("_", " ") for name in rest) if rest else ""
    return figure, "Energy audit: all terms add up to zero, work put in is negative%s.%s" % (missing.replace(":", ";"), small)


def of_monitor(run, name):
    """Displacement, velocity and acceleration of one monitor."""
    monitor = run.monitors[name]
    factor, unit = style.length_unit(np.abs(monitor.displacement).max())
    time, velocity = monitor.filtered("velocity")
    acceleration = monitor.filtered("acceleration")[1]
    figure, axes = page(3.3, 3)
    for axis, (t, values, label) in zip(axes[:, 0], ((run.time, factor * monitor.displacement, "displ.\n[%s]" % unit),
                                                      (time, velocity, "velocity\n[m/s]"), (time, acceleration, "accel.\n[m/s²]"))):
        axis.plot(t, values[:, 1], color=style.VERTICAL, lw=0.7, label="vertical (up)")
        axis.plot(t, run.downhill * values[:, 0], color=style.HORIZONTAL, lw=0.8, label="horizontal (%s)" % run.along())
        axis.set_ylabel(label)
    figure.align_ylabels()
    axes[-1, 0].set(xlabel="time [s]", xlim=(run.time[0], run.time[-1]))
    handles, labels = axes[0, 0].get_legend_handles_labels()
    axes[0, 0].legend(handles[::-1], labels[::-1], loc="lower right", bbox_to_anchor=(1.0, 0.98), ncol=2, borderaxespad=0.1)
    axes[0, 0].set_title(name)
    where = monitor_histories.position_text(run, name)
    low_pass = "; velocity and acceleration below %g Hz" % run.corner if run.corner > 0 else ""
    return figure, "%s%s: peak %s %s, %.3g m/s, %.3g m/s²%s." % (
        (name, " at " + where if where else "") + facts.length(np.abs(monitor.displacement).max()) +
        (np.abs(velocity).max(), np.abs(acceleration).max(), low_pass))


def of_borehole(run, name):
    """Displacement with depth."""
    figure, axes = page(4.3)
    boreholes.draw_profile(run, axes[0, 0], name)
    axes[0, 0].set_ylabel("depth [m]")
    return figure, "Borehole %s: displacement with depth." % name


def panel(run, draw, identifier, *words):
    """A Panel, or None if the run lacks what it shows."""
    try:
        figure, caption = draw(run, *words)
    except MissingData:
        plt.close("all")
        return None
    return Panel(to_svg(figure, identifier, caption), caption)


def wide(figures, identifier):
    """[Panel] of figures of other tools, wider than a phone: [(figure, caption)]."""
    return [Panel(to_svg(figure, "%s-%d" % (identifier, i), caption), caption, True) for i, (figure, caption) in enumerate(figures)]


def of_plot(run, module, identifier, caption):
    """[Panel] of a figure of hybrid plot, wider than a phone; none if the run lacks what it shows."""
    found = []
    try:
        with style.taken(lambda figure, name: found.append(Panel(to_svg(figure, "%s-%s" % (identifier, name), caption, MOST_PARTS), caption, True))):
            module.draw(run, "")
    except MissingData:
        plt.close("all")
    return found
