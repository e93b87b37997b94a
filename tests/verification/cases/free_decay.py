# SPDX-License-Identifier: GPL-3.0-or-later
"""Frequency and damping of one decaying mode, read from a history.

Samples of x = exp(-z w t) cos(w_d t + p) at spacing s obey x_k = 2 exp(-z w s) cos(w_d s) x_{k-1} - exp(-2 z w s) x_{k-2}
(Prony 1795); the two coefficients are found by least squares.
"""

import numpy as np


class Decay:
    def __init__(self, time, values, begin, period):
        """Free decay from time begin [s] on; period: rough [s]."""
        dt = time[1] - time[0]
        stride = max(1, int(round(period / 6 / dt)))
        x = values[time >= begin]
        x = x - 0.0
        matrix = np.column_stack([x[stride:-stride], x[: -2 * stride]])
        p, q = np.linalg.lstsq(matrix, x[2 * stride :], rcond=None)[0]
        spacing = stride * dt
        rate = -np.log(-q) / (2 * spacing)
        turn = np.arccos(p / (2 * np.sqrt(-q))) / spacing
        self.omega = np.hypot(rate, turn)  # undamped [rad/s]
        self.frequency = self.omega / (2 * np.pi)  # [Hz]
        self.ratio = rate / self.omega  # of critical [-]
        self.decrement = 2 * np.pi * rate / turn  # logarithmic [-]


def draw_decay(axes, time, values, begin, omega, ratio, label):
    """The history and the envelope that the closed form gives from its first peak after begin."""
    axes.plot(time, 1e3 * values, lw=0.8, label="program")
    late = time >= begin
    period = 2 * np.pi / omega
    first = late & (time < begin + period)
    k = np.flatnonzero(first)[np.abs(values[first]).argmax()]
    envelope = np.abs(values[k]) * np.exp(-ratio * omega * (time[k:] - time[k]))
    axes.plot(time[k:], 1e3 * envelope, "k--", lw=1, label=label)
    axes.plot(time[k:], -1e3 * envelope, "k--", lw=1)
    axes.set_ylabel("top [mm]")
    axes.legend(loc="upper right")
