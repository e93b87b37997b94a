# SPDX-License-Identifier: GPL-3.0-or-later
"""Response spectrum of a motion that is linear between its samples (exact recurrence, Nigam & Jennings 1969)."""

import numpy as np

POINTS = 30  # per shortest period


def pseudo_acceleration(acceleration, dt, frequency, damping):
    """w^2 max|u| of u'' + 2 z w u' + w^2 u = -a(t) [unit of a] at each frequency [Hz], from rest."""
    frequency = np.asarray(frequency, dtype=float)
    parts = max(1, int(np.ceil(POINTS * frequency.max() * dt)))
    rest = int(np.ceil(1 / frequency.min() / dt))  # one more period after the end
    a = np.concatenate([acceleration, np.zeros(rest)])
    a = np.interp(np.arange((len(a) - 1) * parts + 1) / parts, np.arange(len(a)), a)
    return np.array([largest_response(a, dt / parts, 2 * np.pi * f, damping) for f in frequency])


def largest_response(a, h, w, z):
    """w^2 max|u| of one oscillator: u = -Im q / w_d, q' = s q + a, s = -z w + i w_d, the recurrence in its complex form.

    A pole of first order keeps the digits that one of second order loses where w h is small.
    """
    from scipy.signal import lfilter  # half a second, which few need

    damped = w * np.sqrt(1 - z * z)
    x = h * complex(-z * w, damped)
    one = np.expm1(x) / x  # mean of exp(x t) over 0 < t < 1
    late = h * (one - 1) / x  # of the sample at the end of a step; the other has the rest
    q, _ = lfilter([late, h * one - late], [1, -np.exp(x)], a, zi=[-late * a[0]])
    return w * w / damped * np.abs(q.imag).max()
