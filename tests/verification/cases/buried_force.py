# SPDX-License-Identifier: GPL-3.0-or-later
"""Horizontal motion of the surface of a half space under a line force below it, plane strain, by Cagniard and de Hoop's method.

By reciprocity it is the motion of the place of the force under a horizontal line force F(t) on the surface. With z downwards, the
Laplace variable s, horizontal slowness p (exp(i s p x)), a = sqrt(1/c_p^2 + p^2), b = sqrt(1/c_s^2 + p^2), chi = b^2 + p^2,

    u_x = F/(2 pi mu) int [-2 p^2 b/R exp(-s a z) + b chi/R exp(-s b z)] exp(i s p x) dp        R = chi^2 - 4 p^2 a b
    u_z = F/(2 pi mu) int [-2 i p a b/R exp(-s a z) + i p chi/R exp(-s b z)] exp(i s p x) dp

On the path of real times tau = gamma z - i p x, with tau = (r/c) cosh w, p = (i sin(th) cosh w + cos(th) sinh w)/c, so that the wave's front is
no singularity (Aki & Richards 2002, section 6.4). Beyond sin(th) = c_s/c_p the S term has a head wave before its front: tau = (r/c_s) cos v,
p = i sin(th - v)/c_s.
"""

import numpy as np

NODES, WEIGHTS = np.polynomial.legendre.leggauss(400)


class BuriedForce:
    def __init__(self, density, young, poisson):
        self.mu = young / (2 * (1 + poisson))
        self.c_s = np.sqrt(self.mu / density)
        self.c_p = self.c_s * np.sqrt(2 * (1 - poisson) / (1 - 2 * poisson))

    def _kernels(self, p, along, wave):
        """Integrand of one wave for the motion along x (0) or z (1)."""
        a, b = np.sqrt(1 / self.c_p**2 + p * p), np.sqrt(1 / self.c_s**2 + p * p)
        chi = b * b + p * p
        r = chi * chi - 4 * p * p * a * b
        if wave == "P":
            return (-2 * p * p * b if along == 0 else -2j * p * a * b) / r
        return (b * chi if along == 0 else 1j * p * chi) / r

    def surface(self, offset, depth, along, time, force):
        """u_x(t) [m] at a place of the surface, the force [N/m] being at offset (to the right of it) and depth, along x (0) or down (1).

        force(t) is zero or negligible for t < 0.
        """
        side, x = (np.sign(offset) or 1.0), abs(offset)
        r, theta = np.hypot(x, depth), np.arctan2(x, depth)
        total = np.zeros(len(time))
        for wave, speed in (("P", self.c_p), ("S", self.c_s)):
            last = np.arccosh(max(1.0 + 1e-12, time[-1] * speed / r))
            w = 0.5 * last * (NODES + 1)
            p = (1j * np.sin(theta) * np.cosh(w) + np.cos(theta) * np.sinh(w)) / speed
            slope = (1j * np.sin(theta) * np.sinh(w) + np.cos(theta) * np.cosh(w)) / speed
            factor = 0.5 * last * WEIGHTS * 2 * (self._kernels(p, along, wave) * slope).real
            total += self._convolve(time, r / speed * np.cosh(w), factor, force)
            if wave == "S" and np.sin(theta) > self.c_s / self.c_p:
                total += self._head_wave(r, theta, along, time, force)
        return (side if along == 1 else 1.0) * total / (2 * np.pi * self.mu)

    def _head_wave(self, r, theta, along, time, force):
        first = theta - np.arcsin(self.c_s / self.c_p)
        q = np.sqrt(first) * 0.5 * (NODES + 1)  # v = first - q^2 takes the root at 1/c_p away
        v = first - q * q
        p = 1j * np.sin(theta - v) / self.c_s + 1e-18
        slope = -1j * np.cos(theta - v) / self.c_s * -2 * q
        factor = np.sqrt(first) * 0.5 * WEIGHTS * 2 * (self._kernels(p, along, "S") * slope).real
        return self._convolve(time, r / self.c_s * np.cos(v), factor, force)

    @staticmethod
    def _convolve(time, delays, factor, force):
        return np.array([np.sum(factor * force(t - delays)) for t in time])
