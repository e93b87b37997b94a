# SPDX-License-Identifier: GPL-3.0-or-later
"""The hard cases: their runs, limits, and what is asked of one besides that of all."""

import dataclasses
import typing



@dataclasses.dataclass
class Wanted:
    """What a case runs (variant: overrides) and what it must meet."""

    variants: dict = dataclasses.field(default_factory=lambda: {"scene": []})
    full_size: dict = dataclasses.field(default_factory=dict)  # runs of --long, instead of the others
    refusals: list = dataclasses.field(default_factory=list)  # (variant, overrides, words of the message)
    residual: float = 0.01  # of the energy audit; 0.001 where nothing hits or breaks
    penetration: float = 0.01  # overlap over block size
    more: typing.Optional[typing.Callable] = None  # more(case, variant, run)

    def runs(self, long):
        return (self.full_size if long and self.full_size else self.variants).items()


def moved(run):
    """Largest way of a block since the static stage [m]."""
    return run.get("section/blocks_peak_displacement").max()


def rests(limit):
    return lambda case, variant, run: case.below("%s: way of a block" % variant, moved(run), limit, "m")


def rebound_is_slower(case, variant, run):
    kinetic = run.get("energy/blocks_kinetic")
    case.true("%s: the block hit the ground, kinetic energy fell from %.3g to %.3g J/m" % (variant, kinetic.max(), kinetic[-1]),
              kinetic[-1] < 0.9 * kinetic.max())


CASES = {
    "stiffness_ratio": Wanted({"scene": [], "soft_below": ["Continuum/Materials=mud", "Blocks/Material=granite",
                                                           "Blocks/Belt material=mud"]}, residual=0.001),
    "slivers": Wanted(),
    "penalty": Wanted({"40": [], "1.04": ["Blocks/Penalty ratio=1.04"], "40000": ["Blocks/Penalty ratio=40000"]},
                      refusals=[("0.04", ["Blocks/Penalty ratio=0.04"], "Penalty ratio")]),
    "impact_50": Wanted({"scene": [], "shi": ["Time/Scheme=shi"], "0.1 ms": ["Time/Time step=0.0001"]},
                        more=rebound_is_slower),
    "column_50": Wanted(residual=0.001, more=rests(1e-6)),
}
