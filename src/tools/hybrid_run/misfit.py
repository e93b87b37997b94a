# SPDX-License-Identifier: GPL-3.0-or-later
"""How far histories and numbers of two runs are apart."""

import numpy as np


def relative_l2(values, reference):
    """L2 norm of the difference over that of the reference [-], of histories at the same equal steps (all columns together).

    0 if both are zero throughout, infinite if only the reference is, NaN if a value is not finite.
    """
    difference, size = np.linalg.norm(np.subtract(values, reference)), np.linalg.norm(reference)
    return _over(float(difference), float(size))


def relative_change(value, reference, scale=None):
    """value - reference over |scale|, by default over |reference| [-].

    0 if both are the same, infinite if the scale is zero, NaN if a value is not finite.
    """
    return _over(float(value) - float(reference), abs(float(reference if scale is None else scale)))


def peak(values):
    """Signed value of largest magnitude of each column; NaN where a value is not finite."""
    values = np.asarray(values, float)
    columns = values.reshape(len(values), -1)
    rows = np.abs(np.where(np.isfinite(columns), columns, np.inf)).argmax(axis=0)
    peaks = columns[rows, np.arange(columns.shape[1])]
    peaks[~np.isfinite(columns).all(axis=0)] = np.nan
    return float(peaks[0]) if values.ndim == 1 else peaks


def _over(difference, size):
    if difference == 0:
        return 0.0
    if not (np.isfinite(difference) and np.isfinite(size)):
        return float("nan")
    return difference / size if size > 0 else float(np.copysign(np.inf, difference))
