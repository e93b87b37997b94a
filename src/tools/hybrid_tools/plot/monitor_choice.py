# SPDX-License-Identifier: GPL-3.0-or-later
"""Which monitors stand in one picture: as the user says, or those that move alike."""

import difflib

import numpy as np

from hybrid_run import UserError

ALIKE = 2.0  # largest over smallest peak velocity of a group, unless there were too many groups
MOST = 6  # groups that are found
LITTLE = 1e-3  # of the largest peak: smaller ones are alike


def read_groups(text, known):
    """[[names]] of "S1 | S2-S4 | S5,S7": groups apart by |, names by commas; A-B is all from A to B, in the order of known.

    @raises UserError for a monitor that is not there
    """
    groups = [[name.strip() for name in part.split(",") if name.strip()] for part in text.split("|")]
    found = [[name for word in words for name in names_of(word, known)] for words in groups if words]
    if not found:
        raise UserError("--groups names no monitor; there are: %s" % ", ".join(known))
    return [list(dict.fromkeys(names)) for names in found]


def names_of(word, known):
    """The monitor of this name, or those of a range."""
    if word in known:
        return [word]
    for k in (k for k, letter in enumerate(word) if letter == "-"):
        first, last = word[:k].strip(), word[k + 1:].strip()
        if first in known and last in known:
            ends = sorted((known.index(first), known.index(last)))
            return known[ends[0]:ends[1] + 1]
    near = difflib.get_close_matches(word, known, 1)
    raise UserError("unknown monitor '%s' in --groups%s; there are: %s" % (
        word, " (did you mean '%s'?)" % near[0] if near else "", ", ".join(known)))


def along_slope(run, names):
    """In the order of x, where all places are known."""
    places = [run.attribute("monitors/" + name, "position") for name in names]
    if any(place is None for place in places):
        return names
    return [names[k] for k in np.argsort([place[0] for place in places], kind="stable")]


def part(names, peaks, ratio):
    """Neighbours together as long as the largest of their peaks is at most ratio times the smallest."""
    groups = []
    for name in names:
        group = groups[-1] if groups else []
        of_group = [peaks[other] for other in group + [name]]
        if group and max(of_group) <= ratio * min(of_group):
            group.append(name)
        else:
            groups.append([name])
    return groups


def alike(run, peaks):
    """(groups, ratio): neighbours on the surface, and those at depth, whose peaks [m/s] differ by no more than the ratio; at most six
    groups, or one of each kind. The base is none of them."""
    still = max(LITTLE * max(peaks.values(), default=0.0), 1e-300)
    peaks = {name: max(peak, still) for name, peak in peaks.items()}
    kinds = [along_slope(run, names) for kind, names in run.monitor_groups().items() if kind != "base"]
    ratio = ALIKE
    while True:
        groups = [group for names in kinds for group in part(names, peaks, ratio)]
        if len(groups) <= max(MOST, len(kinds)):
            return groups, ratio
        ratio *= 1.5


def name_of(names, known):
    """S2 to S4 for neighbours in a row, else all names."""
    if len(names) > 2 and known[known.index(names[0]):][:len(names)] == names:
        return "%s to %s" % (names[0], names[-1])
    return ", ".join(names)
