# SPDX-License-Identifier: GPL-3.0-or-later
"""The zero-phase low-pass that peaks and filtered histories of the program are taken after (include/hybrid/scene/motion/filter.h)."""

import math


def low_pass(values, dt, corner):
    """Histories with equal steps dt [s] (a column each) below the corner [Hz]: Butterworth of second order, forwards and backwards.

    As in the program: mirrored at both ends about the first and last value; unchanged if the corner is 0 or beyond half the sampling rate.
    """
    if len(values) < 2 or corner <= 0 or corner * dt >= 0.5:
        return values
    from scipy import signal  # half a second, which few need

    b, a = signal.butter(2, corner, fs=1 / dt)
    return signal.filtfilt(b, a, values, axis=0, padtype="odd", padlen=min(len(values) - 1, math.ceil(3 / (corner * dt))))
