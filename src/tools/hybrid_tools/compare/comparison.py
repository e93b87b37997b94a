# SPDX-License-Identifier: GPL-3.0-or-later
"""Several runs side by side: one time axis, one base, one low-pass for all; the first is the reference."""

import os
from functools import lru_cache

import numpy as np

from hybrid_run import MissingData, UserError
from hybrid_run.low_pass import low_pass
from hybrid_run.resample import common_axis, resample, usual_step

FEWEST = 4  # common samples
RESERVED = {"place", "quantity", "unit"}  # columns of the table


class Comparison:
    """Histories of runs that share a time axis.

    runs, labels: the reference first. axis: common times [s]. monitors: names that all runs have. base: monitor that displacements are
    relative to, "" for absolute ones. corner: of the low-pass of all accelerations [Hz], 0 for none.
    """

    def __init__(self, runs, labels):
        """@raises UserError if the runs have nothing to compare in common."""
        self.runs, self.labels = list(runs), list(labels)
        for run, label in zip(self.runs, self.labels):
            if run.n < FEWEST:
                raise UserError("'%s' has %d steps; %d are needed to compare" % (label, run.n, FEWEST))
        self.axis = common_axis([run.time for run in self.runs])
        if len(self.axis) < FEWEST:
            raise UserError("the runs have less than %d steps in common: %s" % (FEWEST, ", ".join(
                "'%s' from %.4g to %.4g s" % (label, run.time[0], run.time[-1]) for run, label in zip(self.runs, self.labels))))
        self.dt = usual_step(self.axis)
        self.end = float(self.axis[-1])
        self.monitors = self._shared_monitors()
        self.base = self._common_base()
        self.corners = [run.corner or self._parameter(run, "Monitors/Filter frequency") for run in self.runs]
        self.corner = min([corner for corner in self.corners if corner > 0], default=0.0)
        self.downhill = self.reference.downhill

    @property
    def reference(self):
        return self.runs[0]

    @property
    def others(self):
        """(number, label) of the runs that are compared with the reference."""
        return list(enumerate(self.labels))[1:]

    @lru_cache(maxsize=None)
    def displacement(self, i, name):
        """Of a monitor of run i [m]: downhill (or +x) and up; relative to the base, of the base itself absolute."""
        values = self._history(i, name, "displacement")
        if self.base and name != self.base:
            values = values - self._history(i, self.base, "displacement")
        return values * [self.downhill, 1.0]

    @lru_cache(maxsize=None)
    def acceleration(self, i, name):
        """Of a monitor of run i below self.corner [m/s2]: downhill (or +x) and up."""
        return low_pass(self.raw_acceleration(i, name), self.dt, self.corner)

    @lru_cache(maxsize=None)
    def velocity(self, i, name):
        """Of a monitor of run i below self.corner, absolute [m/s]: downhill (or +x) and up."""
        return low_pass(self._history(i, name, "velocity") * [self.downhill, 1.0], self.dt, self.corner)

    def raw_acceleration(self, i, name):
        """The same, not filtered."""
        return self._history(i, name, "acceleration") * [self.downhill, 1.0]

    @lru_cache(maxsize=None)
    def outcrop(self, i):
        """Outcrop acceleration of run i [m/s2]. @raises MissingData"""
        return self.on_axis(i, "input/acceleration") * [self.downhill, 1.0]

    def on_axis(self, i, path):
        """A data set of run i with a row per step on the common axis; accelerations without aliases. @raises MissingData"""
        run = self.runs[i]
        return resample(run.time, run.history(path), self.axis, has_aliases=path.endswith("acceleration"))

    def has_everywhere(self, path):
        return all(run.has(path) for run in self.runs)

    def ends_with(self, i):
        """Whether run i ends where the comparison does: what it says about its end counts."""
        return self.runs[i].time[-1] - self.end <= 1e-6 * self.end

    def status(self, i):
        """"" for a run that has finished, else what it is."""
        run = self.runs[i]
        if not run.summary:
            return "goes on or was killed (%.4g s so far)" % run.time[-1]
        return "" if run.summary.get("finished") else "stopped early, at %.4g s" % run.time[-1]

    def failed_joints(self, i):
        """Times of the failures in the dynamic stage up to the common end [s]. @raises MissingData for a run that has not ended."""
        run = self.runs[i]
        if run.has("joints/failure_time"):
            time = run.file["joints/failure_time"][:]
            return np.sort(time[(time >= 0) & (time <= self.end)])
        if not run.has("section/blocks_points"):
            raise MissingData("no blocks")
        raise MissingData("failed joints are written at the end of a run")

    def _history(self, i, name, quantity):
        return self.on_axis(i, "monitors/%s/%s" % (name, quantity))

    def _shared_monitors(self):
        """Those of the surface before those at depth, the base last."""
        names = [name for group in self.reference.monitor_groups().values() for name in group]
        shared = [name for name in names if all(name in run.names("monitors") for run in self.runs)]
        if not shared and any(run.names("monitors") for run in self.runs):
            raise UserError("the runs share no monitor: " + "; ".join(
                "'%s' has %s" % (label, ", ".join(run.names("monitors")) or "none") for run, label in zip(self.runs, self.labels)))
        return shared

    def _common_base(self):
        """That of the first run whose base all runs have as a monitor."""
        return next((run.base for run in self.runs if run.base in self.monitors), "")

    @staticmethod
    def _parameter(run, name):
        """A number of the scene; 0 where it is not known."""
        try:
            return float(run.parameters.get(name, 0))
        except (MissingData, ValueError):
            return 0.0


def labels_of(directories):
    """As many last parts of the paths as tell them apart."""
    paths = [os.path.abspath(directory).split(os.sep) for directory in directories]
    for parts in range(1, max(map(len, paths)) + 1):
        labels = [os.sep.join(path[-parts:]) for path in paths]
        if len(set(labels)) == len(labels) and not RESERVED & set(labels):
            return labels
    raise UserError("'%s' is given twice" % next(d for d, path in zip(directories, paths) if paths.count(path) > 1))
