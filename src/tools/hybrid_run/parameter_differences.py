# SPDX-License-Identifier: GPL-3.0-or-later
"""What several scenes have in common and in what they differ, by their parameter files."""

from dataclasses import dataclass

WITHOUT_EFFECT = ("Output", "Checkpoint", "Parallel")  # sections that change no result
RECORDS = ("Monitors", "Boreholes")
NAMES = ("Title", "Output/Directory")  # of a run: differ always
FIRST = ("Model/Bedrock", "Model/Blocks")  # what two scenes are compared for if it differs
DEPENDS = {  # sections that count only with another choice than this
    "Continuum": ("Model/Bedrock", "rigid"), "Bedding planes": ("Model/Bedrock", "rigid"),
    "Blocks": ("Model/Blocks", "none"), "Heterogeneity": ("Model/Blocks", "none")}


@dataclass(frozen=True)
class Difference:
    """A parameter and its value in each scene; None where it does not count."""

    name: str
    values: tuple

    @property
    def has_effect(self):
        return self.name.split("/")[0] not in WITHOUT_EFFECT


def differences(scenes):
    """Every parameter that differs, in the order of the files. scenes: {"Section/Name": "value"} of each."""
    found = []
    for name in dict.fromkeys(name for scene in scenes for name in scene):
        values = tuple(scene.get(name) if counts(name, scene) else None for scene in scenes)
        given = [value for value in values if value is not None]
        some_lack_it = any(name not in scene and counts(name, scene) for scene in scenes)
        if name not in NAMES and given and (some_lack_it or not all(same_value(given[0], value) for value in given)):
            found.append(Difference(name, values))
    return found


def main_difference(found):
    """The one that the scenes seem to be compared for: the model, else what takes most values; None if nothing with an effect differs."""
    effective = [difference for difference in found if difference.has_effect]
    effective = [d for d in effective if d.name != "Time/End time" and d.name.split("/")[0] not in RECORDS] or effective
    for name in FIRST:
        for difference in effective:
            if difference.name == name:
                return difference
    return max(effective, key=lambda difference: len(set(difference.values)), default=None)


def counts(name, scene):
    """Whether the scene has what the parameter belongs to."""
    section = name.split("/")[0]
    return section not in DEPENDS or scene.get(DEPENDS[section][0]) != DEPENDS[section][1]


def same_value(a, b):
    """Whether two values mean the same: 1e-3 and 0.001 do."""
    first, second = _words(a), _words(b)
    return len(first) == len(second) and all(x == y or _number(x) == _number(y) is not None for x, y in zip(first, second))


def _words(value):
    for mark in ",;:|=":
        value = value.replace(mark, " %s " % mark)
    return value.split()


def _number(word):
    try:
        return float(word)
    except ValueError:
        return None
