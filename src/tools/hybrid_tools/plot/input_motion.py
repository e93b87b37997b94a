# SPDX-License-Identifier: GPL-3.0-or-later
"""The outcrop motion: acceleration, velocity, displacement, Fourier and response spectrum (beside the target)."""

import matplotlib.pyplot as plt
import numpy as np

from hybrid_run import MissingData, pseudo_acceleration
from hybrid_tools import style

COMPONENTS = (("horizontal", style.HORIZONTAL), ("vertical", style.VERTICAL))


def moving_components(values):
    """Components that are not at rest: the index and its peak row."""
    peaks = np.abs(values).max(axis=0)
    if peaks.max() == 0:
        raise MissingData("no input motion")
    return [c for c in range(2) if peaks[c] > 1e-9 * peaks.max()]


def draw_history(axes, time, values, label, unit):
    for c in moving_components(values):
        name, colour = COMPONENTS[c]
        axes.plot(time, values[:, c], color=colour, lw=0.8, label=name)
    component = max(moving_components(values), key=lambda c: np.abs(values[:, c]).max())
    row = np.abs(values[:, component]).argmax()
    peak = values[row, component]
    axes.plot(time[row], peak, "o", ms=4, mfc="none", color=style.TEXT, mew=0.9)
    axes.text(0.995, 0.96, "peak %.3g %s at %.2f s" % (abs(peak), unit, time[row]), transform=axes.transAxes,
              ha="right", va="top", fontsize=8, bbox={"fc": "white", "ec": "none", "alpha": 0.8, "pad": 1})
    axes.set_ylabel("%s\n[%s]" % (label, unit))
    axes.set_xlim(time[0], time[-1])
    axes.margins(y=0.15)


def draw_spectrum(axes, time, values):
    dt = time[1] - time[0]
    f = np.fft.rfftfreq(len(time), dt)
    for c in moving_components(values):
        amplitude = np.abs(np.fft.rfft(values[:, c])) * dt
        axes.loglog(f[1:], amplitude[1:], color=COMPONENTS[c][1], lw=0.8, label=COMPONENTS[c][0])
        if c == max(moving_components(values), key=lambda k: np.abs(values[:, k]).max()):
            top = amplitude[1:].max()
            axes.set_ylim(1e-4 * top, 2 * top)
            above = f[1:][amplitude[1:] > 3e-4 * top]
            axes.set_xlim(max(f[1], 0.05), min(max(1.3 * above.max(), 10), 0.5 / dt))
    axes.set_xlabel("frequency [Hz]")
    axes.set_ylabel("Fourier amplitude\n[m/s]")
    axes.grid(True, which="minor", color="#f1f1f1", lw=0.5)


def response(run, time, values):
    """Frequencies [Hz], damping, and factor from outcrop to the given motion for the response spectrum of a run."""
    if run.has("spectrum/frequency"):
        outcrop = run.text(run.attribute("spectrum", "outcrop", "yes")) == "yes"
        damping = float(np.ravel(run.attribute("spectrum", "damping", 0.05))[0])
        return run.get("spectrum/frequency"), damping, 1.0 if outcrop else 0.5
    lowest = max(0.1, 1 / (time[-1] - time[0]))
    return np.geomspace(lowest, max(min(50.0, 0.2 / (time[1] - time[0])), 2 * lowest), 60), 0.05, 1.0


def draw_response(run, axes, time, values):
    frequency, damping, factor = response(run, time, values)
    moving = moving_components(values)
    for c in moving:
        amplitude = pseudo_acceleration(factor * values[:, c], time[1] - time[0], frequency, damping)
        label = COMPONENTS[c][0] if len(moving) > 1 else "motion"
        axes.loglog(1 / frequency, amplitude, color=COMPONENTS[c][1], lw=1.0, label=label if factor == 1 else "incident " + label)
    if run.has("spectrum/target"):
        axes.loglog(1 / frequency, run.get("spectrum/target"), "--", color=style.TEXT, lw=1.0, label="target")
    axes.legend(loc="lower left")
    axes.set_xlabel("period [s]")
    axes.set_ylabel("pseudo-acceleration\n[m/s²], %g %% damping" % (100 * damping))
    axes.grid(True, which="minor", color="#f1f1f1", lw=0.5)


def draw(run, directory):
    time, acceleration = run.equal_steps(run.history("input/acceleration"))
    moving_components(acceleration)
    figure = plt.figure(figsize=(9, 8), constrained_layout=True)
    panels = figure.subplot_mosaic([["a", "a"], ["v", "v"], ["u", "u"], ["fourier", "response"]], height_ratios=[1, 1, 1, 1.25])
    axes = [panels[name] for name in ("a", "v", "u", "fourier")]
    draw_history(axes[0], time, acceleration, "acceleration", "m/s²")
    draw_history(axes[1], time, run.equal_steps(run.history("input/velocity"))[1], "velocity", "m/s")
    displacement = run.equal_steps(run.history("input/displacement"))[1]
    factor, unit = style.length_unit(np.abs(displacement).max())
    draw_history(axes[2], time, factor * displacement, "displacement", unit)
    for i in (0, 1):
        axes[i].sharex(axes[2])
        axes[i].tick_params(labelbottom=False)
    axes[2].set_xlabel("time [s]")
    draw_spectrum(axes[3], time, acceleration)
    draw_response(run, panels["response"], time, acceleration)
    if len(moving_components(acceleration)) > 1:
        axes[0].legend(loc="upper left", ncol=2)
    style.title(figure, "Input motion (outcrop): " + run.title())
    style.save(figure, directory, "input_motion")
