# SPDX-License-Identifier: GPL-3.0-or-later
"""Histories along a line (Monitors/Lines): a bedding plane with both sides, the ground, a polyline."""

import numpy as np

from .errors import MissingData
from .low_pass import low_pass
from .spectra import has_energy, spectral_ratio

SHORT = 16384  # rows


class Line:
    """A line of a run. points: k; rows: r, at `time`. Histories of a side are r x k x 2, [x, y]."""

    def __init__(self, run, name):
        self.run, self.name = run, name

    @property
    def position(self):
        """Of the points at first [m], k x 2."""
        return self.run.get(self._path("position"))

    @property
    def tangent(self):
        """Unit vectors, k x 2; the side `above` is to their left."""
        return self.run.get(self._path("tangent"))

    @property
    def distance(self):
        """Along the line from its first point [m], k."""
        return self.run.get(self._path("distance"))

    @property
    def sides(self):
        """("above", "below"), or ("on",) where the line has one motion."""
        return tuple(side for side in ("above", "below", "on") if self.run.has(self._path(side)))

    @property
    def time(self):
        """Of the rows [s]."""
        return self.run.get("lines/time")[: self._rows()]

    def displacement(self, side):
        """Absolute [m]."""
        return self._history(side, "displacement")

    def acceleration(self, side):
        """Absolute [m/s2]: at the end of each step, or the mean since the row before."""
        return self._history(side, "acceleration")

    def outcrop(self):
        """The outcrop acceleration at the same times, treated as that of the lines is [m/s2], r x 2."""
        rows = np.searchsorted(self.run.time, self.time - 1e-9 * self.run.time[-1])
        if self.run.text(self.run.attribute("lines", "acceleration", "")).startswith("at"):
            return self.run.history("input/acceleration")[rows]
        velocity = np.vstack([[0.0, 0.0], self.run.history("input/velocity")[rows]])
        return np.diff(velocity, axis=0) / np.diff(self.time, prepend=0.0)[:, None]

    def equal_steps(self, values):
        """(spacing [s], values at equal spacing): rows of cut steps are interpolated."""
        time = self.time
        if len(time) < 3:
            raise MissingData("fewer than three rows in lines/%s" % self.name)
        steps = np.diff(time)
        spacing = float(np.median(steps))
        if np.ptp(steps) <= 1e-6 * spacing:
            return spacing, values
        even = np.arange(time[0], time[-1] + 1e-9 * spacing, spacing)
        flat = values.reshape(len(values), -1)
        return spacing, np.column_stack([np.interp(even, time, column) for column in flat.T]).reshape((len(even),) + values.shape[1:])

    def low_passed(self, values):
        """Below the run's Filter frequency, at equal steps, as peaks of its monitors are."""
        spacing, values = self.equal_steps(values)
        return low_pass(values, spacing, self.run.corner)

    def peak_ratio(self, side, component):
        """Peak acceleration over that of the outcrop motion [-], k; both below the Filter frequency."""
        outcrop = np.abs(self.low_passed(self.outcrop()[:, component])).max()
        if not outcrop > 0:
            raise MissingData("the outcrop motion has no component %s" % "xy"[component])
        return np.abs(self.low_passed(self.acceleration(side)[:, :, component])).max(axis=0) / outcrop

    def spectral_ratio(self, side, component, frequency, bandwidth=40.0):
        """To the outcrop motion, smoothed (Konno and Ohmachi 1998) [-]: len(frequency) x k; NaN where that has next to no energy."""
        spacing, values = self.equal_steps(self.acceleration(side)[:, :, component])
        _, outcrop = self.equal_steps(self.outcrop()[:, component])
        fade = np.ones(len(outcrop))  # what does not end at rest would leak over all frequencies
        n = max(2, len(fade) // 20)
        fade[-n:] = np.cos(0.5 * np.pi * np.arange(1, n + 1) / n) ** 2
        rest = 3 * len(fade) if len(fade) < SHORT else 0  # zeros: frequencies close enough for the window
        values, outcrop = (np.pad(part, [(0, rest)] + [(0, 0)] * (part.ndim - 1)) for part in (values * fade[:, None], outcrop * fade))
        ratio = spectral_ratio(values, outcrop, spacing, frequency, bandwidth)
        return np.where(has_energy(outcrop, spacing, frequency, bandwidth)[:, None], ratio, np.nan)

    def jump(self):
        """Displacement of the upper side against the lower [m], r x k x 2: along the tangent, normal to it (opening positive)."""
        difference = self.displacement("above") - self.displacement("below")
        tangent = self.tangent
        normal = np.column_stack([-tangent[:, 1], tangent[:, 0]])
        return np.stack([(difference * tangent).sum(axis=2), (difference * normal).sum(axis=2)], axis=2)

    def _path(self, name):
        return "lines/%s/%s" % (self.name, name)

    def _rows(self):
        """The run may be going on: complete rows."""
        sets = [self.run.file[self._path(side + "/acceleration")] for side in self.sides]
        times = self.run.file["lines/time"]
        return min([len(times)] + [len(s) for s in sets] + [int((times[:] <= self.run.time[-1] * (1 + 1e-9)).sum()) if self.run.n else 0])

    def _history(self, side, quantity):
        if side not in self.sides:
            raise MissingData("line '%s' has no side '%s'; it has %s" % (self.name, side, ", ".join(self.sides)))
        values = self.run.get(self._path(side + "/" + quantity))[: self._rows()].astype(float)
        return values.reshape(len(values), -1, 2)
