# SPDX-License-Identifier: GPL-3.0-or-later
"""What the cases of random motions share: the accelerogram of a run and its Fourier spectrum."""

import numpy as np


class Accelerogram:
    """The motion that a run took, in even steps (a run may have cut some), and its spectrum."""

    def __init__(self, run):
        self.step = float(np.median(np.diff(run.time)))
        self.time = self.step * np.arange(round(run.time[-1] / self.step) + 1)
        self.acceleration, self.velocity, self.displacement = (
            np.interp(self.time, run.time, run.history("input/" + name)[:, 0]) for name in ("acceleration", "velocity", "displacement"))
        self.frequency = np.fft.rfftfreq(len(self.time), self.step)  # [Hz]
        self.power = (np.abs(np.fft.rfft(self.acceleration)) * self.step) ** 2  # [(m/s)^2]

    def significant_duration(self):
        """From 5 to 95 % of the Arias intensity [s]."""
        energy = np.cumsum(self.acceleration**2)
        return np.diff(np.interp([0.05, 0.95], energy / energy[-1], self.time))[0]


def octaves(lowest, highest):
    """Bands between two frequencies, each an octave or a little less."""
    edges = np.geomspace(lowest, highest, int(np.ceil(np.log2(highest / lowest) - 1e-9)) + 1)
    return list(zip(edges[:-1], edges[1:]))


def in_band(frequency, low, high):
    return (frequency >= low) & (frequency < high)
