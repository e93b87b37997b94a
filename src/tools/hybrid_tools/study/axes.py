# SPDX-License-Identifier: GPL-3.0-or-later
"""What a study varies: one parameter, its values, which of them is the finest."""

import fnmatch
import os
from dataclasses import dataclass, field

from hybrid_run import UserError

# Parameters that are refined: the size h of a level, of which the error is a power, by its number; None: it has no such size.
REFINED = {
    "Time/Time step": lambda number: number,
    "Time/Maximum displacement ratio": lambda number: number,
    "Blocks/Tolerance": lambda number: number,
    "Blocks/Penalty ratio": lambda number: 1 / number,
    "Continuum/Degree": None,
    "Mesh/Numbers:Resolution/*": lambda number: number,
}
UNITS = {"Time/Time step": "s", "Mesh/Numbers:Resolution/*": "m"}
GROWING = ("Continuum/Degree", "Blocks/Penalty ratio")  # finer where they are larger
# Other numerics of the same problem: they are compared with one of them. All else that is not refined is another problem.
NUMERICS = ("Time/Scheme", "Time/Maximum halvings", "Blocks/Maximum iterations", "Blocks/Stiffness correction", "Blocks/Shear ratio", "Mesh/File",
            "Monitors/*", "Output/*", "Checkpoint/*", "Parallel/*")
# Another problem each, of the same kind.
SAMPLES = ("Heterogeneity/Seed", "Motion/Seed", "Motion/File", "Motion/Spectrum file", "Mesh/Numbers:Seed")


@dataclass
class Axis:
    """A varied parameter. kind: "ladder" (refined, coarse to fine), "samples" (seeds, records), "options" (numerics of the same problem:
    errors are told against one of them) or "models" (other problems: what they change is told, but it is no error).

    key: Section/Name. entry: of Mesh/Numbers, the number that is varied. labels: its values, as they are shown. sizes: of a ladder, or None.
    reference: index of the finest level, or of the option or model that the others are compared with.
    """

    key: str
    entry: str
    labels: list
    kind: str = "options"
    sizes: list = None
    reference: int = 0
    short: str = field(default="", compare=False)

    @property
    def name(self):
        """Unique among the axes of a study."""
        return self.key + (":" + self.entry if self.entry else "")

    @property
    def title(self):
        """Short name with its unit."""
        unit = next((unit for name, unit in UNITS.items() if fnmatch.fnmatchcase(self.name, name)), "")
        return self.short + (" [%s]" % unit if unit else "")

    def override(self, level, base):
        """-s of one level; base: the scene's parameters, of whose Mesh/Numbers the others stay."""
        value = self.labels[level]
        if not self.entry:
            return "%s=%s" % (self.key, value)
        return "%s=%s" % (self.key, merge_numbers(base.get(self.key, ""), self.entry, value))


def merge_numbers(numbers, entry, value):
    """'a = 1; b = 2' with another number."""
    kept = [part.strip() for part in numbers.split(";") if part.strip() and part.split("=")[0].strip() != entry]
    return "; ".join(kept + ["%s = %s" % (entry, value)])


def parse_axis(text):
    """Of --vary "Section/Name=a,b,c", or with | between values that have commas; Mesh/Numbers=Resolution/h = 8|4|2 varies one number."""
    key, equals, values = text.partition("=")
    if not equals or not key.strip():
        raise UserError("--vary needs \"Section/Name=value,value,...\", not '%s'" % text)
    return make_axis(key.strip(), values.split("|") if "|" in values else values.split(","))


def make_axis(key, values):
    """An axis from the values of a study file or of --vary. @raises UserError if there is nothing to vary."""
    values = [str(value).lower() if isinstance(value, bool) else " ".join(str(value).split()) for value in values]
    entry = ""
    if key == "Mesh/Numbers":
        entries = {value.partition("=")[0].strip() for value in values if "=" in value}
        if len(entries) != 1 or any(";" in value for value in values):
            raise UserError("--vary of Mesh/Numbers takes one number, as in \"Mesh/Numbers=Resolution/h = 8|4|2\", not '%s'"
                            % "|".join(values))
        entry = entries.pop()
        values = [value.partition("=")[2].strip() if "=" in value else value for value in values]
    if key.lower().endswith("file"):
        values = [os.path.abspath(value) if value else value for value in values]
    if key.startswith("Output/Directory"):
        raise UserError("a study does not vary Output/Directory: each run has a directory of its own")
    if len(set(values)) != len(values):
        raise UserError("--vary %s has the value '%s' twice" % (key, next(v for v in values if values.count(v) > 1)))
    return sort_levels(Axis(key, entry, values))


def number(text):
    """Of a value, or None."""
    try:
        return float(text)
    except ValueError:
        return None


def sort_levels(axis, finest=None):
    """Kind, order of the levels and reference. finest: the value that the user says is the finest; else by the parameter."""
    numbers = [number(label) for label in axis.labels]
    rule = next((name for name in REFINED if fnmatch.fnmatchcase(axis.name, name)), None)
    if finest is not None and finest not in axis.labels:
        raise UserError("--finest %s=%s is none of the values: %s" % (axis.name, finest, ", ".join(axis.labels)))
    if finest is not None and None not in numbers and number(finest) in (min(numbers), max(numbers)):
        size, growing = (lambda value: value), number(finest) == max(numbers)
        if growing:
            size = (lambda value: 1 / value) if min(numbers) > 0 else None
        elif min(numbers) <= 0:
            size = None
    elif finest is None and rule and None not in numbers:
        size, growing = REFINED[rule], axis.name in GROWING
    else:
        is_same = finest is not None or any(fnmatch.fnmatchcase(axis.name, name) for name in NUMERICS)
        axis.kind = "samples" if axis.name in SAMPLES else "options" if is_same else "models"
        axis.reference = axis.labels.index(finest) if finest is not None else 0
        return axis
    order = sorted(range(len(numbers)), key=lambda k: numbers[k], reverse=not growing)
    axis.labels = [axis.labels[k] for k in order]
    axis.kind, axis.reference = "ladder", len(order) - 1
    axis.sizes = [size(numbers[k]) for k in order] if size else None
    return axis


def name_shortly(axes):
    """Short names for tables: the last word, unless two axes share it."""
    words = [(axis.entry or axis.key).split("/")[-1] for axis in axes]
    for axis, word in zip(axes, words):
        axis.short = word if words.count(word) == 1 else axis.name


def label_text(label):
    """How a value is shown: of a file (a path with an extension, unlike 1 m/s2) its name alone, "none" for nothing."""
    return (os.path.basename(label) if os.path.splitext(label)[1] else label) or "none"
