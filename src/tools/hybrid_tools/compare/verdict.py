# SPDX-License-Identifier: GPL-3.0-or-later
"""What the numbers of a comparison say, in a sentence for each run; whether they are within a tolerance."""

import math

import numpy as np

from hybrid_run import MissingData
from hybrid_tools.table import percent

EQUAL, NEAR = 0.02, 0.10  # largest change of a judged row: "=", "near"; beyond: "differs"
HARDLY_BEGUN = 0.01  # of the motion's peak
WHOLE = ("slip", "blocks", "failed joints")  # rows of the mass as a whole: zero says something
NAMED = 2  # quantities that differ most

RULES = ("%g %% or less is '=', %g %% or less 'near', more 'differs'; judged are peaks, what is left at the end, slip, failed joints "
         "and the L2 misfit of displacement histories (of the difference over that of the reference)" % (100 * EQUAL, 100 * NEAR))


def name_of(row):
    return ("%s %s" % (row.place, row.quantity)).strip()


def judged(rows, i):
    """(change, row) of run i, of the rows that are judged."""
    return [(row.changes[i], row) for row in rows if row.is_judged(i)]


def motion_begun(comparison):
    """Peak outcrop acceleration of the reference up to the common end over the largest in any run; None without a motion."""
    try:
        within = float(np.abs(comparison.outcrop(0)).max())
        whole = max(float(np.abs(run.get("input/acceleration")).max()) for run in comparison.runs if run.has("input/acceleration"))
    except MissingData:
        return None
    return within / whole if whole > 0 else None


def nothing_to_say(comparison, rows):
    """Why the numbers decide nothing; "" if they do."""
    begun = motion_begun(comparison)
    if begun is not None and begun < HARDLY_BEGUN:
        return "none: the motion has hardly begun in the first %.4g s, its acceleration reaches %.2g %% of its peak there" % (
            comparison.end, 100 * begun)
    if not any(judged(rows, i) for i, _ in comparison.others):
        return "none: nothing moves in any of the runs" if comparison.monitors else "none: the runs have no quantity in common"
    return ""


def verdicts(comparison, rows):
    """A sentence for each run but the reference."""
    reason = nothing_to_say(comparison, rows)
    return [reason] if reason else [sentence(comparison, rows, i) for i, _ in comparison.others]


def sentence(comparison, rows, i):
    label, reference = comparison.labels[i], comparison.labels[0]
    changes = judged(rows, i)
    if not changes:
        return "%s: no quantity in common with %s" % (label, reference)
    broken = [row for change, row in changes if math.isnan(change)]
    if broken:
        who = "; ".join(comparison.labels[k] for k in (0, i) if any(math.isnan(row.values[k] or 0.0) for row in broken))
        return "%s: not to be judged, %d of %d numbers are not finite%s, first %s" % (
            label, len(broken), len(changes), " (in %s)" % who if who else "", name_of(broken[0]))
    worst = max(abs(change) for change, _ in changes)
    if worst == 0:
        return "%s = %s in every digit of all %d numbers" % (label, reference, len(changes))
    still = at_rest(rows, i)
    moving = [row for row in rows if row.place not in still and (row.values[i] != 0 or row.place in WHOLE)]
    words = named((most(moving, i) if worst > NEAR else []) or most(rows, i))
    words += "; %s do%s not move" % (", ".join(still), "" if len(still) > 1 else "es") if still and worst > NEAR else ""
    if worst <= EQUAL:
        return "%s = %s within %s everywhere (most: %s)" % (label, reference, rounded_up(worst), words)
    within = sum(abs(change) <= EQUAL for change, _ in changes)
    verb = "near" if worst <= NEAR else "differs from"
    return "%s %s %s: %s; %d of %d numbers within %g %%" % (label, verb, reference, words, within, len(changes), 100 * EQUAL)


def at_rest(rows, i):
    """Monitors that move in the reference and not at all in run i: within a bedrock that is rigid."""
    return [row.place for row in rows if row.quantity == "peak u" and row.values[i] == 0 and row.values[0] and row.is_judged(i)]


def most(rows, i):
    """(change, row) of run i: the numbers that differ most, and the largest misfit."""
    changes = sorted((pair for pair in judged(rows, i) if pair[0]), key=size, reverse=True)
    numbers = [pair for pair in changes if not is_misfit(pair[1])]
    return numbers[:NAMED] + [pair for pair in changes if is_misfit(pair[1])][:1]


def size(pair):
    """Of a change; what is not a number is worse than all."""
    return math.inf if math.isnan(pair[0]) else abs(pair[0])


def named(pairs):
    def words(change, row):
        if not is_misfit(row):
            return "%s %s" % (name_of(row), words_of(change, row))
        return "history of u off by %s (%s)" % (percent(change).lstrip("+") if math.isfinite(change) else "all it is", row.place)

    return ", ".join(words(change, row) for change, row in pairs)


def words_of(change, row):
    if row.is_count:
        return "%+d" % round(change * max(row.values[0], 1))
    return percent(change) + (" of peak" if row.of_peak and math.isfinite(change) else "")


def is_misfit(row):
    return row.quantity.startswith("misfit")


def rounded_up(change):
    """2 digits above 10 %, else one: never less than it is."""
    number = 100 * change
    step = 10.0 ** (math.floor(math.log10(number)) - (1 if number >= 10 else 0))
    return "%g %%" % float("%.6g" % (math.ceil(number / step * (1 - 1e-12)) * step))


def beyond(comparison, rows, tolerance):
    """What exceeds the tolerance, in words; a run that has not finished does."""
    found = ["'%s' %s" % (label, comparison.status(i)) for i, label in enumerate(comparison.labels) if comparison.status(i)]
    reason = nothing_to_say(comparison, rows)
    if reason:
        return found + [reason.replace("none: ", "", 1)]
    for i, label in comparison.others:
        over = [(change, row) for change, row in judged(rows, i) if not abs(change) <= tolerance]
        if over:
            change, row = max(over, key=size)
            found.append("'%s' in %d numbers, most in %s: %s" % (label, len(over), name_of(row), words_of(change, row)))
    return found
