# SPDX-License-Identifier: GPL-3.0-or-later
"""Combinations of options in which every pair of values that may be combined occurs (allpairspy), and random ones."""

import itertools
import random

from allpairspy import AllPairs
from scenes import FACTORS, RULES, is_allowed

NAMES = list(FACTORS)


def all_pairs():
    """Rows {factor: value} that cover all pairs. allpairspy gives up pairs that its filter makes hard to reach: they follow."""
    found = AllPairs(list(FACTORS.values()), filter_func=lambda row: is_allowed(dict(zip(NAMES, row))))
    rows = [dict(zip(NAMES, row)) for row in found]
    rows = [row for row in rows if is_allowed(row)]
    return complete(rows, 2, list(itertools.combinations(NAMES, 2)), seed=1)


def random_triples(count, seed):
    """Rows in which `count` triples of values, drawn at random, occur."""
    draw = random.Random(seed)
    rows, tried = [], 0
    while len(rows) < count and tried < 100 * count:
        tried += 1
        row = any_row({n: draw.choice(FACTORS[n]) for n in draw.sample(NAMES, 3)}, draw)
        if row:
            rows.append(row)
    return rows


def complete(rows, strength, groups, seed):
    """rows and further ones, until every combination of `strength` values that a row can have is in one."""
    draw = random.Random(seed)
    seen = {key(row, names) for row in rows for names in groups}
    for names in groups:
        for values in itertools.product(*(FACTORS[n] for n in names)):
            wanted = dict(zip(names, values))
            if key(wanted, names) in seen or not is_allowed(wanted):
                continue
            row = best_row(wanted, groups, seen, draw)
            if row:
                rows.append(row)
                seen |= {key(row, other) for other in groups}
    assert all(len(names) == strength for names in groups)
    return rows


def best_row(wanted, groups, seen, draw, attempts=20):
    """The row with these values that covers most of what is not covered yet; None if there is none."""
    first = any_row(wanted, draw)
    if first is None:
        return None
    found = [first] + [row for row in (any_row(wanted, draw) for _ in range(attempts)) if row]
    return max(found, key=lambda row: sum(key(row, names) not in seen for names in groups))


def key(row, names):
    return tuple((n, row[n]) for n in names)


def any_row(wanted, draw, repairs=200):
    """A random row with the values that are wanted, or None: options of a broken rule are drawn again until none is broken."""
    row = {n: draw.choice(values) for n, values in FACTORS.items()}
    row.update(wanted)
    for _ in range(repairs):
        broken = [names for names, rule in RULES if not rule(*(row[n] for n in names))]
        if not broken:
            return row
        free = [n for n in draw.choice(broken) if n not in wanted]
        if not free:
            return None
        name = draw.choice(free)
        row[name] = draw.choice(FACTORS[name])
    return None
