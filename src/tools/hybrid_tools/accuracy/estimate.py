# SPDX-License-Identifier: GPL-3.0-or-later
"""Errors of a run from what coarser ones say."""

import math
from dataclasses import dataclass

from hybrid_tools.study import quantities
from hybrid_tools.study.analysis import SMALL, common_times, weights_at
from hybrid_tools.study.quantities import norm

RATIO = 2.0                        # from one level to the next
LEAST_ORDER, HIGHEST_ORDER = 0.5, 2.0
SAFE_ORDER = 1.0                   # where it is not known: one of second order is overestimated threefold


@dataclass
class Error:
    """Of one quantity. value: part of its size [-]. order: observed, NaN without a third run. converges: False where finer runs do not come closer."""

    value: float
    order: float = math.nan
    converges: bool = True


def differences(levels):
    """Norms of the differences from each value to the next coarser one, over the size of the first [-]."""
    times = common_times(levels)
    weights, samples = weights_at(times), [value.at(times) for value in levels]
    size = max(norm(samples[0], weights), *(value.floor for value in levels))
    found = [norm(b - a, weights) for a, b in zip(samples, samples[1:])]
    return [0.0 if difference == 0 else difference / size if size > 0 else math.inf for difference in found]


def error_of(finest, coarser, coarsest=None):
    """Error of the finest of two or three values: d / (2^p - 1), d its difference to the next (Richardson 1911).

    p is observed where there are three, at most 2: beyond, it is the difference of the coarser two that counts, as the finer two may be
    close by luck. Below 0.5 the values do not converge: then d says how far they scatter.
    """
    levels = [value for value in (finest, coarser, coarsest) if value is not None]
    near, *far = differences(levels)
    if coarsest is None:
        return Error(near / (RATIO**SAFE_ORDER - 1))
    far = far[0]
    if near == 0 or not math.isfinite(near + far):
        return Error(near)
    order = math.log(far / near) / math.log(RATIO) if far > 0 else -math.inf
    if order < LEAST_ORDER:
        return Error(near, order, False)
    gain = RATIO ** min(order, HIGHEST_ORDER)
    return Error(max(near, far / gain) / (gain - 1), order)


def judged(values):
    """Names of quantities that an error is made of: no counts, and none far below the largest of its unit."""
    sizes = {name: quantities.root_mean_square(value) for name, value in values.items() if name not in quantities.COUNTS}
    largest = {}
    for name, size in sizes.items():
        largest[quantities.unit(name)] = max(largest.get(quantities.unit(name), 0.0), size)
    return [name for name, size in sizes.items() if size > SMALL * largest[quantities.unit(name)]]


def errors(run, coarser_runs):
    """{quantity: Error} of a run's values from those of one or two runs, each coarser than the one before."""
    found = {}
    for name in judged(run):
        values = [values[name] for values in [run] + coarser_runs if name in values]
        if len(values) == 1 + len(coarser_runs):
            found[name] = error_of(*values)
    return found


def largest(found):
    """(name, Error) of the largest; (None, None) if there is none."""
    return max(found.items(), key=lambda item: item[1].value, default=(None, None))
