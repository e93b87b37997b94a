# SPDX-License-Identifier: GPL-3.0-or-later
"""The one linear, causal law whose Q is the same at all frequencies (Kjartansson 1979).

M(w) = M0 (i w / w0)^(2 g), g = atan(1/Q) / pi, for exp(i w t). The phase velocity is c(w) = c(w0) (w / w0)^g; M0 is such that
c(w0) is the material's. 1/Q = Im M / Re M is twice the damping ratio.
"""

import numpy as np
from scipy.optimize import nnls


class ConstantQ:
    def __init__(self, numbers, ratio):
        """numbers: Numbers of a scene; ratio: of critical."""
        self.power = np.arctan(2 * ratio) / np.pi
        lowest, highest = (numbers.number("Maxwell damping/%s frequency" % end) for end in ("Lowest", "Highest"))
        self.reference = 2 * np.pi * np.sqrt(lowest * highest)

    def modulus(self, omega):
        """Over that of the material; omega [rad/s], complex."""
        # phase velocity of w0: 1 / Re(1 / sqrt(M / rho)) = sqrt(M0 / rho) / cos(pi g / 2)
        return (np.cos(np.pi * self.power / 2) ** 2 * (1j * omega / self.reference) ** (2 * self.power))

    def free_vibration(self, elastic):
        """Complex circular frequency of a mode whose elastic one is given: w^2 = elastic^2 M(w)."""
        omega = complex(elastic)
        for _ in range(50):
            omega = elastic * np.sqrt(self.modulus(omega))
        return omega


class FittedBody(ConstantQ):
    """The branches that the program chooses for it, fitted anew; relaxed and weights of the program within round-off."""

    def __init__(self, numbers, ratio):
        super().__init__(numbers, ratio)
        lowest, highest = (2 * np.pi * numbers.number("Maxwell damping/%s frequency" % end) for end in ("Lowest", "Highest"))
        omega, branches = np.geomspace(lowest, highest, 101), int(numbers.number("Maxwell damping/Branches"))
        places = np.arange(branches) - 0.5 * (branches - 1)
        least = np.inf
        for spacing in range(1, 151):
            times = 10 ** (-0.01 * spacing * places) / self.reference
            x = omega[:, None] * times
            weights = nnls((x - 2 * ratio * x**2) / (1 + x**2) / (2 * ratio), np.ones(len(omega)))[0]
            self.relaxed, self.times, self.weights = 1.0, times, weights
            moduli = np.array([self.modulus(w) for w in omega])
            error = np.abs(moduli.imag / moduli.real / (2 * ratio) - 1).max()
            if error < least:
                least, best = error, (times, weights)
        self.times, self.weights = best
        scale = (1 / np.sqrt(self.modulus(self.reference))).real ** 2
        self.relaxed, self.weights = scale, scale * self.weights

    def modulus(self, omega):
        x = 1j * omega * self.times
        return self.relaxed + np.sum(self.weights * x / (1 + x))


def frequency_and_ratio(omega):
    """Undamped frequency [Hz] and damping ratio of exp(i w t), as of free_decay.Decay."""
    return abs(omega) / (2 * np.pi), omega.imag / abs(omega)
