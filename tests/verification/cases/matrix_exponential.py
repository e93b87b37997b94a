# SPDX-License-Identifier: GPL-3.0-or-later
"""Exact steps of linear motion x' = A x: x(t + dt) = exp(A dt) x(t)."""

import numpy as np


def exponential(a):
    """exp(a) of a small matrix (n x n, norm of a few at most) by its series."""
    result, term = np.eye(len(a)), np.eye(len(a))
    for k in range(1, 30):
        term = term @ a / k
        result += term
    return result
