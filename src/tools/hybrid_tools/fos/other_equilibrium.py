# SPDX-License-Identifier: GPL-3.0-or-later
"""Loose blocks that touch have more than one equilibrium, as friction may act either way at each contact: the static stage finds the one
that its springs lead to, and columns that topple may stand beyond limit equilibrium (Goodman and Bray 1976). Softer shear springs lead to
another one."""

SHEAR_RATIO = "Blocks/Shear ratio"
SOFTER = 0.3  # of the scene's shear stiffness
CLEARLY = {"fos": 0.98, "yield": 0.95}  # of the value at which it stands: a bracket has a width


def warn_of_other_equilibrium(name, bracket, trials, change, results):
    """One more static stage a little below the limit.

    @param name "fos" or "yield". @param change the parameter that was varied, with its sign: value -> {parameter: value}."""
    run = bracket.stands.run()
    if run.parameters.get("Model/Blocks") != "loose":
        return
    softer = SOFTER * float(run.parameters[SHEAR_RATIO].split()[0])
    value = CLEARLY[name] * bracket.stands.value
    other = trials("softer_%.6g" % value, value, dict(change(value), **{SHEAR_RATIO: softer}))
    trials.done.remove(other)  # of another scene
    results["stands_with_softer_shear"] = other.stands
    if not other.stands:
        print('warning: with softer shear springs it fails at %.4f already: blocks that touch have more than one equilibrium, and which one is\n'
              '  found depends on how they were loaded (columns that topple: doc/limits.md); repeat with -s "%s=%.3g" and take the\n'
              '  smaller value' % (value, SHEAR_RATIO, softer))
