# SPDX-License-Identifier: GPL-3.0-or-later
"""Vertical motion of the surface of a half space under a vertical line force on it (Lamb 1904), plane strain.

By Cagniard's path, which at the surface is the real axis of slowness p (Aki & Richards 2002, section 6.5), an impulse gives
u(r, t) = g(t/r)/r in the direction of the force, so that for a force F(t)

    u(r, t) = integral g(p) F(t - p r) dp,   g(p) = -Im[ a / (c_s^2 R(p)) ] / (pi mu)
    R = (1/c_s^2 - 2 p^2)^2 + 4 p^2 a b,     a = sqrt(1/c_p^2 - p^2),  b = sqrt(1/c_s^2 - p^2),  a and b in i R+ beyond

p from 1/c_p; R = 0 at the Rayleigh slowness: principal value, by pairing p_R + x with p_R - x.
"""

import numpy as np

NODES, WEIGHTS = np.polynomial.legendre.leggauss(160)


class LambSurface:
    def __init__(self, density, young, poisson):
        self.mu = young / (2 * (1 + poisson))
        self.c_s = np.sqrt(self.mu / density)
        self.c_p = self.c_s * np.sqrt(2 * (1 - poisson) / (1 - 2 * poisson))
        self.rayleigh = self._rayleigh_slowness()

    def _rayleigh_function(self, p):
        a2, b2 = p * p - 1 / self.c_p**2, p * p - 1 / self.c_s**2
        return (1 / self.c_s**2 - 2 * p * p) ** 2 - 4 * p * p * np.sqrt(a2 * b2)

    def _rayleigh_slowness(self):
        low, high = 1 / self.c_s, 2 / self.c_s
        for _ in range(200):
            middle = 0.5 * (low + high)
            if self._rayleigh_function(middle) > 0:
                low = middle
            else:
                high = middle
        return 0.5 * (low + high)

    def impulse(self, p):
        """g(p) [m^2/(N s)]."""
        a = np.sqrt(1 / self.c_p**2 - p * p + 0j)
        b = np.sqrt(1 / self.c_s**2 - p * p + 0j)
        r = (1 / self.c_s**2 - 2 * p * p) ** 2 + 4 * p * p * a * b
        return -(a / (self.c_s**2 * r)).imag / (np.pi * self.mu)

    def displacement(self, r, time, force):
        """u(r, t) [m] in the direction of the force; force(t) [N/m] is zero or negligible for t < 0."""
        start, shear, pole = 1 / self.c_p, 1 / self.c_s, self.rayleigh
        middle, half = 0.5 * (start + shear), 0.5 * (pole - shear)
        points, factors = [], []

        def panel(low, high, path, slope):
            x = 0.5 * (low + high) + 0.5 * (high - low) * NODES
            points.append(path(x))
            factors.append(0.5 * (high - low) * WEIGHTS * slope(x) * self.impulse(points[-1]))

        # quadratic paths take the roots at 1/c_p and 1/c_s away
        panel(0, np.sqrt(middle - start), lambda x: start + x * x, lambda x: 2 * x)
        panel(0, np.sqrt(shear - middle), lambda x: shear - x * x, lambda x: 2 * x)
        panel(0, np.sqrt(pole - half - shear), lambda x: shear + x * x, lambda x: 2 * x)
        panel(0, half, lambda x: pole + x, lambda x: 1.0)
        panel(0, half, lambda x: pole - x, lambda x: 1.0)
        edges = np.linspace(pole + half, max(time[-1] / r, pole + 2 * half), 9)
        for low, high in zip(edges[:-1], edges[1:]):
            panel(low, high, lambda x: x, lambda x: 1.0)
        p, factor = np.concatenate(points), np.concatenate(factors)
        return np.array([np.sum(factor * force(t - p * r)) for t in time])
