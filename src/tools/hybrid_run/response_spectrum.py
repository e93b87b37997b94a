# SPDX-License-Identifier: GPL-3.0-or-later
"""Response spectrum of a motion that is linear between its samples (recurrence of Nigam & Jennings 1969)."""

import numpy as np


def pseudo_acceleration(acceleration, dt, frequency, damping):
    """w^2 max|u| of u'' + 2 z w u' + w^2 u = -a(t) [unit of a] at each frequency [Hz], from rest."""
    w, z = 2 * np.pi * np.asarray(frequency, dtype=float), damping
    parts = max(1, int(np.ceil(30 * w.max() / (2 * np.pi) * dt)))  # 30 points per shortest period
    rest = int(np.ceil(1 / (w.min() / (2 * np.pi)) / dt))  # one more period after the end
    a = np.concatenate([acceleration, np.zeros(rest)])
    a = np.interp(np.arange((len(a) - 1) * parts + 1) / parts, np.arange(len(a)), a)
    h = dt / parts
    wd, e = w * np.sqrt(1 - z * z), np.exp(-z * w * h)
    c, s = np.cos(wd * h), np.sin(wd * h) / wd
    uu, uv, vu, vv = e * (c + z * w * s), e * s, -w * w * e * s, e * (c - z * w * s)
    u = v = np.zeros(len(w))
    largest = np.zeros(len(w))
    for k in range(len(a) - 1):
        slope = (a[k + 1] - a[k]) / h
        shift = 2 * z * slope / w**3
        u0, v0 = u + a[k] / w**2 - shift, v + slope / w**2
        u, v = uu * u0 + uv * v0 - a[k + 1] / w**2 + shift, vu * u0 + vv * v0 - slope / w**2
        np.maximum(largest, np.abs(u), out=largest)
    return w**2 * largest
