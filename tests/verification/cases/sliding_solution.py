# SPDX-License-Identifier: GPL-3.0-or-later
"""Elastic shear column that sticks and slips on a Coulomb plane (Kramer & Smith 1997, Rathje & Bray 2000), by its fixed-base modes.

Per area of the plane, along the plane and downhill, relative to it: x(y, t) = s(t) + sum phi_n(y) q_n(t). With the drive
d = g sin b + a, a the plane's acceleration uphill, and the shear T that the plane bears,

    M s'' + sum L_n q_n''                                              = M d - T
    L_n s'' + m_n (q_n'' + (beta_K w_n^2) q_n' + w_n^2 q_n)            = L_n d

    stick:  s' = 0 while |T| <= mu M g cos b        slip:  T = sign(s') mu M g cos b

Both are linear with a drive that is linear between samples, so a step is exp(A h). Starts and stops are found by halving the step
twelve times. Another method than the program's: modes in place of blocks, no penalty, no time integration.
"""

import numpy as np
import scipy.linalg

HALVINGS = 12  # of a step in which the column starts or stops


class Modes:
    """Participations L [kg/m2], modal masses m [kg/m2], circular frequencies w [rad/s], and the whole mass M [kg/m2]."""

    def __init__(self, mass, participation, modal_mass, frequency):
        self.mass, self.participation, self.modal_mass, self.frequency = mass, participation, modal_mass, frequency


def column_modes(height, density, speed, number):
    """Of a uniform shear column: phi_n = sin((2n - 1) pi y / (2 H)), w_n = (2n - 1) pi c / (2 H)."""
    odd = 2.0 * np.arange(1, number + 1) - 1
    mass = density * height
    return Modes(mass, 2 * mass / (np.pi * odd), np.full(number, mass / 2), odd * np.pi * speed / (2 * height))


def block_modes(height, density, speed):
    """Of a block with one shear strain, phi = y / H: w^2 = 3 c^2 / H^2."""
    mass = density * height
    return Modes(mass, np.array([mass / 2]), np.array([mass / 3]), np.array([np.sqrt(3) * speed / height]))


class SlidingColumn:
    def __init__(self, modes, beta, friction, gravity, slope):
        self.modes, self.beta, self.n = modes, beta, len(modes.frequency)
        self.static = gravity * np.sin(slope)  # [m/s2]
        self.limit = friction * gravity * np.cos(slope)  # T over M [m/s2]

    def _generator(self, sign, step):
        """A of z' = A z, z = (s, s', q, q', d, d', 1), in the phase sign (0: stick, 1 and -1: slip), times the step."""
        n, modes = self.n, self.modes
        inertia = np.diag(np.concatenate([[modes.mass], modes.modal_mass]))
        inertia[0, 1:] = inertia[1:, 0] = modes.participation
        right = np.zeros((n + 1, 2 * n + 5))  # forces on (s, q)
        right[0, 2 * n + 2], right[0, 2 * n + 4] = modes.mass, -sign * modes.mass * self.limit
        right[1:, 2 * n + 2] = modes.participation
        right[1:, 2 : n + 2] = -np.diag(modes.modal_mass * modes.frequency**2)
        right[1:, n + 2 : 2 * n + 2] = -np.diag(modes.modal_mass * self.beta * modes.frequency**2)
        if sign == 0:
            inertia[0, :], inertia[1:, 0], right[0] = 0, 0, 0
            inertia[0, 0] = 1
        rate = np.linalg.solve(inertia, right)
        a = np.zeros((2 * n + 5, 2 * n + 5))
        a[0, 1], a[1] = 1, rate[0]
        a[2 : n + 2, n + 2 : 2 * n + 2] = np.eye(n)
        a[n + 2 : 2 * n + 2] = rate[1:]
        a[2 * n + 2, 2 * n + 3] = 1
        return a * step

    def _shear(self, z):
        """T / M [m/s2] of a column that sticks."""
        return self.shear_row @ z

    def _breaks(self, z, sign):
        """Whether the state is beyond the phase."""
        return sign * z[1] < 0 if sign else abs(self._shear(z)) > self.limit

    def response(self, time, uphill, locked=False):
        """Slip s [m] downhill and T / M [m/s2] at the times; uphill: the plane's acceleration there [m/s2]. locked: it never slips."""
        step = time[1] - time[0]
        power = {sign: [scipy.linalg.expm(self._generator(sign, step) / 2**k) for k in range(HALVINGS + 1)] for sign in (-1, 0, 1)}
        n, modes = self.n, self.modes
        generator = self._generator(0, 1.0)
        self.shear_row = -(modes.participation / modes.mass) @ generator[n + 2 : 2 * n + 2]
        self.shear_row[2 * n + 2] += 1
        z = np.zeros(2 * n + 5)
        z[2 : n + 2] = modes.participation * self.static / (modes.modal_mass * modes.frequency**2)
        z[-1] = 1
        slip, shear, sign = np.zeros(len(time)), np.full(len(time), self.static), 0
        for i in range(len(time) - 1):
            z[-3], z[-2] = self.static + uphill[i], (uphill[i + 1] - uphill[i]) / step
            trial = power[sign][0] @ z
            if locked or not self._breaks(trial, sign):
                z = trial
            else:
                z, sign = self._through(z, sign, power)
            slip[i + 1] = z[0]
            shear[i + 1] = self._shear(z) if sign == 0 else sign * self.limit
        return slip, shear

    def _through(self, z, sign, power):
        """State and phase after a step with starts and stops: each lasts as long as it holds, in pieces of step / 2^k."""
        left = 2**HALVINGS
        while left:
            for k in range(HALVINGS + 1):
                piece = 2 ** (HALVINGS - k)
                while piece <= left:
                    trial = power[sign][k] @ z
                    if self._breaks(trial, sign):
                        break
                    z, left = trial, left - piece
            if left:  # the smallest piece breaks the phase: the other begins with it
                z, sign = self._next(z, sign)
                z, left = power[sign][HALVINGS] @ z, left - 1
        return z, sign

    def _next(self, z, sign):
        if sign:
            z = z.copy()
            z[1] = 0.0
            shear = self._shear(z)
            return z, 0 if abs(shear) <= self.limit else int(np.sign(shear))
        return z, int(np.sign(self._shear(z)))
