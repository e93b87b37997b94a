# SPDX-License-Identifier: GPL-3.0-or-later
"""What a run of a study is judged by: histories, peaks and what is left, of each monitor; slip; blocks; failed joints."""

from dataclasses import dataclass

import numpy as np

from hybrid_run import MissingData, Run, UserError

UNITS = {"displacement": "m", "velocity": "m/s", "acceleration": "m/s2"}
COUNTS = ("joints/failed",)  # whole numbers: shown, but no error is made of them


@dataclass
class Number:
    """A value that is sampled as a history of one sample. floor: errors are parts of this if it is larger."""

    value: float
    floor: float = 0.0

    def at(self, times):  # pylint: disable=unused-argument (as History)
        return np.array([[self.value]])

    def weights(self, times):  # pylint: disable=unused-argument
        return np.ones(1)

    time = None


def left(value, highest):
    """What is left at the end: its error is a part of the peak where it is below a tenth of that."""
    return Number(float(value), float(highest) if abs(value) < 0.1 * highest else 0.0)


class History:
    """Columns over time, by cubic splines between the steps."""

    floor = 0.0

    def __init__(self, time, values):
        self.time, self.values = np.asarray(time, float), np.asarray(values, float)
        self._spline = None

    def at(self, times):
        """Values at these times, as they are where the steps are those."""
        if len(times) <= len(self.time) and np.allclose(self.time[: len(times)], times, rtol=0, atol=1e-12):
            return self.values[: len(times)]
        if self._spline is None:
            from scipy.interpolate import CubicSpline  # a third of a second, which few need

            self._spline = CubicSpline(self.time, self.values)
        return self._spline(np.clip(times, self.time[0], self.time[-1]))

    @staticmethod
    def weights(times):
        """Of the samples in an integral over time."""
        return np.gradient(times)


@dataclass
class Blend:
    """Sum of values with factors: what Richardson's extrapolation makes of two levels."""

    parts: list  # of (factor, value)

    def at(self, times):
        return sum(factor * value.at(times) for factor, value in self.parts)

    @property
    def time(self):
        return self.parts[0][1].time

    @property
    def floor(self):
        return max(value.floor for _, value in self.parts)


def norm(values, weights):
    """Root of the weighted sum of squares."""
    return float(np.sqrt(np.sum(weights[:, None] * values**2)))


def root_mean_square(value):
    """Size of a value over time."""
    if isinstance(value, Number):
        return abs(value.value)
    weights = value.weights(value.time)
    return norm(value.at(value.time), weights) / np.sqrt(weights.sum())


def cut(history, end):
    """The same up to a time, with a sample there."""
    inside = history.time < end * (1 - 1e-9)
    time = np.append(history.time[inside], end)
    return History(time, np.vstack([history.values[inside], history.at(np.array([end]))]))


def peak(time, values):
    """Largest magnitude of a history of vectors: that of the parabola through the largest sample and its neighbours."""
    size = np.linalg.norm(values, axis=1)
    k = int(size.argmax())
    if not 0 < k < len(size) - 1:
        return float(size[k])
    (a, b, _), middle = np.polyfit(time[k - 1 : k + 2] - time[k], size[k - 1 : k + 2], 2), size[k]
    highest = middle - b * b / (4 * a) if a < 0 else middle
    return float(min(highest, 1.05 * middle))  # three samples of noise make no peak


def end_of(directory):
    """Last time of a run [s]."""
    run = Run(directory)
    if run.n < 4:
        raise MissingData("fewer than four steps in run.h5 of '%s'" % directory)
    return float(run.time[run.n - 1])


def read(directory, end):
    """{"monitor/quantity": value} of a run up to a time [s]."""
    run = Run(directory)
    found = {}
    for name, monitor in run.monitors.items():
        if name != run.base:
            found.update(of_monitor(run, name, monitor, end))
    if run.has("slip/mean"):
        for name in ("mean", "largest"):
            slip = cut(History(run.time, run.history("slip/" + name).reshape(-1, 1)), end)
            found["slip/%s left" % name] = left(slip.values[-1, 0], np.abs(slip.values).max())
    if run.has("section/blocks_displacement") and run.blocks.mass.stop > 0:
        found["blocks/final displacement"] = Number(float(np.linalg.norm(run.blocks.displacement[run.blocks.mass], axis=1).mean()))
    joints = run.summary.get("joints", {})
    found["joints/failed"] = Number(float(joints.get("tensile", 0) + joints.get("shear", 0)))
    run.file.close()
    return found


def of_monitor(run, name, monitor, end):
    """Displacement and velocity relative to the base; peaks as the program filters them."""
    displacement = cut(History(run.time, monitor.displacement), end)
    velocity = monitor.velocity
    if run.base in run.monitors:
        velocity = velocity - run.monitors[run.base].velocity
    velocity = cut(History(run.time, velocity), end)
    highest = peak(displacement.time, displacement.values)
    found = {"displacement": displacement, "velocity": velocity, "peak displacement": Number(highest)}
    for quantity in ("velocity", "acceleration"):
        time, values = monitor.filtered(quantity)
        inside = time <= end * (1 + 1e-9)
        found["peak " + quantity] = Number(peak(time[inside], values[inside]))
    found["final displacement"] = left(np.linalg.norm(displacement.values[-1]), highest)
    return {"%s/%s" % (name, quantity): value for quantity, value in found.items()}


def unit(name):
    """Of a quantity."""
    return "-" if name in COUNTS else UNITS.get(name.split("/")[1].split()[-1], "m")


def closed_form(entry, end):
    """{quantity: value} that a closed form says: a number, or a history (CSV of time, x, y) with its peak and its end."""
    name, given = entry
    if not isinstance(given, str):
        return {name: Number(float(given))}
    try:
        table = np.genfromtxt(given, delimiter=",", comments="#", ndmin=2)
    except (OSError, ValueError) as error:
        raise UserError("closed form of %s: cannot read '%s': %s" % (name, given, error)) from error
    table = table[np.isfinite(table).all(axis=1)]
    if table.shape[1] != 3 or len(table) < 4 or (np.diff(table[:, 0]) <= 0).any() or table[-1, 0] < end * (1 - 1e-6):
        raise UserError("closed form of %s: '%s' needs the columns time [s], x and y, with rising times up to %g s" % (name, given, end))
    history = cut(History(table[:, 0], table[:, 1:]), end)
    monitor, quantity = name.split("/")
    found = {name: history, "%s/peak %s" % (monitor, quantity): Number(peak(history.time, history.values))}
    if quantity == "displacement":
        found["%s/final displacement" % monitor] = Number(float(np.linalg.norm(history.values[-1])))
    return found
