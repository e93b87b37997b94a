# SPDX-License-Identifier: GPL-3.0-or-later
"""Histories of one monitor."""

import numpy as np

from .spectra import has_energy, spectral_ratio


class Monitor:
    """A point of a run whose motion was recorded. Histories are n x 2, [x, y], at run.time."""

    def __init__(self, run, name):
        self.run, self.name = run, name

    def __repr__(self):
        return "Monitor %s at %s" % (self.name, self.position)

    @property
    def position(self):
        """Where it lay at first [m]."""
        return self.run.attribute("monitors/" + self.name, "position")

    @property
    def displacement(self):
        """Relative to the base [m]; of the base monitor itself absolute."""
        return self.absolute_displacement if self.name == self.run.base else self.run.relative_displacement(self.name)

    @property
    def absolute_displacement(self):
        """[m]"""
        return self._raw("displacement")

    @property
    def velocity(self):
        """Absolute, not filtered [m/s]."""
        return self._raw("velocity")

    @property
    def acceleration(self):
        """Absolute, not filtered [m/s2]."""
        return self._raw("acceleration")

    def filtered(self, quantity):
        """(time [s], history) of "velocity" or "acceleration" below run.corner [Hz]."""
        return self.run.filtered("monitors/%s/%s" % (self.name, quantity))

    def peak(self, quantity="acceleration"):
        """Largest absolute value of each component: displacement relative to the base; velocity and acceleration below run.corner."""
        values = self.displacement if quantity == "displacement" else self.filtered(quantity)[1]
        return np.abs(values).max(axis=0)

    def spectral_ratio(self, component=0, bandwidth=40.0, points=200):
        """(frequency [Hz], ratio [-]) of its acceleration to that of the outcrop motion, smoothed (Konno and Ohmachi 1998); NaN where that has
        next to no energy (spectra.has_energy())."""
        time, acceleration = self.run.equal_steps(self.acceleration)
        _, outcrop = self.run.equal_steps(self.run.history("input/acceleration"))
        frequency = self.run.frequencies(points)
        motion, dt = outcrop[:, component], time[1] - time[0]
        ratio = spectral_ratio(acceleration[:, component], motion, dt, frequency, bandwidth)
        return frequency, np.where(has_energy(motion, dt, frequency, bandwidth), ratio, np.nan)

    def _raw(self, quantity):
        return self.run.history("monitors/%s/%s" % (self.name, quantity))
