# SPDX-License-Identifier: GPL-3.0-or-later
"""Observed orders of convergence, the value at a step of zero, and what does not converge.

Levels go from coarse to fine. An error is taken to be c h^p: h is the size (step, mesh size) of a level, p the order (Roache 1998, ch. 5).
"""

import itertools
from dataclasses import dataclass

import numpy as np

EQUAL = 1e-9  # differences below this part of the value are rounding
CLEAN = (0.5, 6.0)  # orders that are extrapolated with
STEADY = 0.25  # orders of a clean convergence differ by at most this part
NOTABLE = 0.01  # differences above this part of the value are no small disorder


def order(sizes, differences):
    """p of three levels from the sizes h1 > h2 > h3 and the two differences |f1 - f2|, |f2 - f3|; NaN if there is none from 0.05 to 12.

    Solves (h1^p - h2^p) / (h2^p - h3^p) = |f1 - f2| / |f2 - f3|: log2 of the ratio if each size is half of the one before.
    """
    (h1, h2, h3), (coarse, fine) = sizes, differences
    if not (coarse > 0 and fine > 0):
        return np.nan

    from scipy.optimize import brentq  # a third of a second, which few need

    def excess(p):
        return np.log((h1 / h2) ** p - 1) - np.log(1 - (h3 / h2) ** p) - np.log(coarse / fine)

    return brentq(excess, 0.05, 12) if excess(0.05) < 0 < excess(12) else np.nan


def order_of_errors(sizes, errors):
    """p of two levels whose errors are known; NaN if one of them is zero."""
    (h1, h2), (coarse, fine) = sizes, errors
    return np.log(coarse / fine) / np.log(h1 / h2) if coarse > 0 and fine > 0 else np.nan


def correction(sizes, p):
    """Factor c of Richardson's value f = f2 + c (f2 - f1) from two levels h1 > h2 of order p."""
    return 1 / ((sizes[0] / sizes[1]) ** p - 1)


@dataclass
class Convergence:
    """What a ladder of levels does.

    verdict: "converges" (differences fall); "equal" (they are rounding); "irregular" (they are small or fall, but to and fro);
    "does not converge" (they are notable, and do not fall or are no larger than those of runs that differ by next to nothing);
    "two levels"; "one level".
    orders: of each three successive levels. is_clean: Richardson's value can be trusted. fine, coarse: last and first of the differences.
    is_doubtful: notable, to and fro, and nobody knows how far runs scatter that differ by next to nothing.
    """

    verdict: str
    orders: list
    is_clean: bool = False
    fine: float = np.nan
    coarse: float = np.nan
    is_doubtful: bool = False

    @property
    def order(self):
        """Of the three finest levels; NaN if there is none."""
        return self.orders[-1] if self.verdict == "converges" and self.orders else np.nan


def assess(sizes, differences, directions=None, scatter=None):
    """Whether levels converge.

    differences: norms |f_k - f_(k+1)| of successive levels over a norm of the finest. directions: cosine between each two successive
    differences (numbers: their signs, +1 or -1; values that scatter at random have -0.5 on average). scatter: largest difference among
    runs of the finest level that differ by next to nothing, over the same norm; None: there are none.
    """
    differences = np.asarray(differences, float)
    if len(differences) == 0:
        return Convergence("one level", [])
    fine, coarse = float(differences[-1]), float(differences[0])
    if not np.isfinite(differences).all():
        return Convergence("does not converge", [], fine=fine, coarse=coarse)
    if differences.max() <= EQUAL and (scatter or 0.0) <= EQUAL:
        return Convergence("equal", [], True, fine, coarse)
    if len(differences) > 1 and fine >= differences[-2] or scatter is not None and scatter > EQUAL and scatter >= 0.3 * fine:
        return Convergence("does not converge" if max(fine, scatter or 0.0) > NOTABLE else "irregular", [], fine=fine, coarse=coarse)
    if len(differences) == 1:
        return Convergence("two levels", [], fine=fine, coarse=coarse)
    if directions is not None and directions[-1] < 0:
        return Convergence("irregular", [], fine=fine, coarse=coarse, is_doubtful=scatter is None and fine > NOTABLE)
    if sizes is None:
        return Convergence("converges", [], fine=fine, coarse=coarse)
    orders = [order(sizes[k : k + 3], differences[k : k + 2]) for k in range(len(differences) - 1)]
    return Convergence("converges", orders, _is_clean(orders, directions), fine, coarse)


def _is_clean(orders, directions):
    last = orders[-2:]
    if directions is not None and min(list(directions)[-2:], default=1.0) < 0.9:
        return False
    if not all(np.isfinite(p) and CLEAN[0] <= p <= CLEAN[1] for p in last):
        return False
    return max(last) - min(last) <= STEADY * min(last)


def pareto(costs, errors):
    """Indices of the settings that no other beats in both cost and error, by rising cost."""
    front, best = [], np.inf
    for index in sorted(range(len(costs)), key=lambda i: (costs[i], errors[i])):
        if errors[index] < best:
            front.append(index)
            best = errors[index]
    return front


def scatter(values, size):
    """Largest norm of the difference of two of these over a size [-]: 0 for one of them."""
    pairs = itertools.combinations(values, 2)
    return max((float(np.linalg.norm(np.subtract(a, b))) / size for a, b in pairs), default=0.0)
