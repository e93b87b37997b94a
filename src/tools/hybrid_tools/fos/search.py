# SPDX-License-Identifier: GPL-3.0-or-later
"""Bisection for the value at which a slope that stands begins to fail."""

from hybrid_run import UserError

MOST_DOUBLINGS = 12


class FailsAtLowerEnd(UserError):
    """Of the range that was given."""

    def __init__(self, low):
        super().__init__("--range: the slope fails at its lower end, %g; give a smaller one" % low)


class StandsAtUpperEnd(UserError):
    """Of the range that was given."""

    def __init__(self, high):
        super().__init__("--range: the slope stands at its upper end, %g; give a larger one" % high)


class Bracket:
    """The largest value at which the slope stands and the smallest at which it fails. towards: sign of x that it was pushed to; None: it
    was not pushed."""

    towards = None

    def __init__(self, stands, fails):
        self.stands, self.fails = stands, fails

    @property
    def value(self):
        return 0.5 * (self.stands.value + self.fails.value)


def bisect(stands, fails, judge, is_narrow):
    """Halve a bracket of two trials until it is narrow."""
    while not is_narrow(stands.value, fails.value):
        trial = judge(0.5 * (stands.value + fails.value))
        if trial.stands:
            stands = trial
        else:
            fails = trial
    return Bracket(stands, fails)


def factor_of_safety(judge, tolerance, low=None, high=None):
    """Bracket of the factor, its width below tolerance times itself. judge(factor) is a Trial."""
    trial = judge(low if low else 1.0)
    growth = 1.25
    if low and not trial.stands:
        raise FailsAtLowerEnd(low)
    stands, fails = (trial, None) if trial.stands else (None, trial)
    if high:
        fails = judge(high)
        if fails.stands:
            raise StandsAtUpperEnd(high)
    for _ in range(MOST_DOUBLINGS):
        if stands and fails:
            break
        trial = judge(stands.value * growth if stands else fails.value / growth)
        if trial.stands:
            stands = trial
        else:
            fails = trial
    if not (stands and fails):
        only = stands or fails
        why = ("what holds it needs no strength (a kink, a stop, level ground, a side of the section), or its strength is larger than meant" if stands else
               "what drives it no strength holds (blocks that topple or have nothing below them), or its strength is less than meant")
        raise UserError("the slope %s at a strength reduction factor of %g still: no factor of safety was found there; %s" % (
            "stands" if stands else "fails", only.value, why))
    return bisect(stands, fails, judge, lambda a, b: b - a <= tolerance * a)


def yield_coefficient(judge, tolerance, low=None, high=None):
    """Bracket of the horizontal coefficient at which the slope fails, its width below tolerance (absolute)."""
    stands = judge(0.0)
    if not stands.stands:
        raise UserError("the slope fails without any shaking: it has no yield acceleration; hybrid fos tells its factor of safety")
    step, fails = 0.2, None
    if low:
        stands = judge(low)
        if not stands.stands:
            raise FailsAtLowerEnd(low)
    if high:
        fails = judge(high)
        if fails.stands:
            raise StandsAtUpperEnd(high)
        return bisect(stands, fails, judge, lambda a, b: b - a <= tolerance)
    for _ in range(MOST_DOUBLINGS):
        trial = judge(stands.value + step)
        if not trial.stands:
            fails = trial
            break
        stands, step = trial, 2 * step
    if fails is None:
        raise UserError("the slope stands at a horizontal coefficient of %g still: no yield acceleration was found" % stands.value)
    return bisect(stands, fails, judge, lambda a, b: b - a <= tolerance)
