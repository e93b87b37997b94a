# SPDX-License-Identifier: GPL-3.0-or-later
"""The low-pass behind the filtered histories of a run (scene/motion/filter.h), by scipy."""

import numpy as np
import scipy.signal


def low_pass(series, dt, corner):
    """Butterworth of second order, forwards and backwards; both ends are continued by point reflection."""
    if corner == 0:
        return series
    pad = min(len(series) - 1, int(np.ceil(3 / (corner * dt))))
    return scipy.signal.filtfilt(*scipy.signal.butter(2, corner, fs=1 / dt), series, axis=0, padlen=pad)
