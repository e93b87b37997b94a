# SPDX-License-Identifier: GPL-3.0-or-later
"""A comparison in words: for the terminal, as Markdown, for table.json."""

import math
import os

from . import verdict
from .result_table import for_terminal, make_table

LINE, SHORTEST = 100, 16  # characters of all values of a parameter in the terminal, and of each at least
FEW = 4  # runs whose values stand in their order
MOST = 20  # parameters that differ in the terminal

NOTES = ("u: displacement relative to the base, downhill (+x where the surface is level) positive; peaks are largest magnitudes; left: at "
         "the last common time, its change refers to the peak where it is below a tenth of it")
SMALL = ("small: below a thousandth of the largest of its kind in run and reference (slip: a hundredth of the largest displacement), not "
         "judged; from 0: small in the reference alone")


def head(comparison):
    cut = "" if all(comparison.ends_with(i) for i in range(len(comparison.runs))) else " (the shortest run)"
    titles = list(dict.fromkeys(run.title() for run in comparison.runs))
    return '%d runs of %s, first %.4g s%s, reference %s' % (
        len(comparison.runs), " | ".join('"%s"' % title for title in titles), comparison.end, cut, comparison.reference.directory)


def entries_that_differ(values):
    """Of lists such as 'a = 1; b = 2' what is not in all of them; other values as they are."""
    lists = [[entry.strip() for entry in value.split(";")] for value in values]
    if not any(len(entries) > 1 for entries in lists):
        return values
    return ["; ".join(entry for entry in entries if not all(entry in other for other in lists)) or "-" for entries in lists]


def shortened(values, labels):
    """Values that fit side by side in a line, however long; what differs in them is kept in view. Many runs are told by their values."""
    values = entries_that_differ(values)
    groups = {}
    for value, label in zip(values, labels):
        groups.setdefault(value, []).append(label)
    texts = list(groups) if len(values) > FEW else values
    room, alike = max(SHORTEST, LINE // len(texts)), len(os.path.commonprefix(texts))
    short = {value: clipped(value, alike, room) for value in texts}
    if len(values) <= FEW:
        return [short[value] for value in values]
    return ["%s (%s)" % (short[value], group[0] if len(group) == 1 else "%d runs" % len(group)) for value, group in groups.items()]


def clipped(value, alike, room):
    """About `room` characters of a value, among them what comes after the first `alike`."""
    if len(value) <= room:
        return value
    start = max(0, min(alike - room // 3, len(value) - room))
    return ("..." if start else "") + value[start : start + room].strip() + ("..." if start + room < len(value) else "")


def scene_lines(scenes, labels=None):
    """(word, text) lines: same, differs. labels: of the runs; shortened for the terminal if given."""
    if not scenes.is_known:
        return [("differs", "unknown: a run has no params.used.prm")]
    lines = [("same", ", ".join(scenes.same()) or "nothing")]
    rows = [(name, " | ".join(shortened(values, labels) if labels else values), remark) for name, values, remark in scenes.differing()]
    left_out = len(rows) - MOST if labels and len(rows) > MOST + 1 else 0
    if left_out:
        rows = rows[:MOST] + [("%d more are in the files" % left_out, "", "")]
    width = max((len(name) for name, _, _ in rows), default=0)
    texts = ["%-*s  %s  %s" % (width, *row) for row in rows] or ["nothing: the scenes are the same"]
    return lines + [("differs" if k == 0 else "", text.rstrip()) for k, text in enumerate(texts)]


def accelerations(comparison):
    return "a: absolute acceleration, " + (
        "all below %g Hz (zero-phase low-pass)" % comparison.corner if comparison.corner else "not filtered")


def notes(comparison, rows):
    words = [NOTES, accelerations(comparison)] if comparison.monitors else []
    if any(row.small or math.inf in map(abs, filter(None, row.changes)) for row in rows):
        words.append(SMALL)
    if any(row.place == "cost" for row in rows):
        words.append("cost: wall time, other work on the machine counts")
    return words + ["verdict: " + verdict.RULES]


def key(comparison):
    """The notes in a line, for the terminal."""
    c = comparison
    words = []
    if c.monitors:
        words = ["u: displacement%s, %s" % (" relative to " + c.base if c.base else "", c.reference.along()),
                 "a: below %g Hz" % c.corner if c.corner else "a: not filtered",
                 "misfit: L2 norm of the difference over that of " + c.labels[0]]
    return "; ".join(words + ["'=' to %g %%, 'near' to %g %%" % (100 * verdict.EQUAL, 100 * verdict.NEAR)])


class Answer:
    """All that is said of a comparison."""

    def __init__(self, comparison, scenes, rows, warnings, tolerance=None):
        self.comparison, self.scenes, self.rows = comparison, scenes, rows
        self.warnings, self.verdicts, self.notes = warnings, verdict.verdicts(comparison, rows), notes(comparison, rows)
        self.tolerance = tolerance
        self.beyond = [] if tolerance is None else verdict.beyond(comparison, rows, tolerance)

    def judgement(self):
        """(word, text) lines on the tolerance."""
        if self.tolerance is None:
            return []
        limit = "%g %%" % (100 * self.tolerance)
        return [("beyond", "%s: %s" % (limit, "; ".join(self.beyond))) if self.beyond else ("within", "%s: all runs" % limit)]

    def table(self):
        return make_table(self.comparison, self.rows, self.rows)

    def terminal(self, files, everything=False):
        """What is printed; files: words on what was written."""
        shown, left_out = (self.rows, "") if everything else for_terminal(self.comparison, self.rows)
        lines = [("compare", head(self.comparison))] + scene_lines(self.scenes, None if everything else self.comparison.labels)
        end = [("note", key(self.comparison))] + several("verdict", self.verdicts) + self.judgement()
        end += several("warning", self.warnings, repeat=True)
        return "\n".join(columns(lines) + [make_table(self.comparison, shown, self.rows).text()] + columns(
            ([("more", left_out + " are in the files; --all shows them")] if left_out else []) + end + [("files", files)]))

    def markdown(self):
        """(above, below) the table."""
        above = "# Comparison\n\n" + head(self.comparison) + "\n\n" + "\n".join(
            "    " + line for line in columns(scene_lines(self.scenes)))
        below = "".join("- **%s**: %s\n" % pair for pair in [("verdict", text) for text in self.verdicts] + self.judgement() + [
            ("warning", text) for text in self.warnings]) + "\n" + "".join("- %s\n" % text for text in self.notes)
        return above, below

    def json(self):
        """Members of table.json beside the rows."""
        c = self.comparison
        runs = [{"label": label, "directory": run.directory, "title": run.title(), "finished": bool(run.summary.get("finished")),
                 "end_s": float(run.time[-1])} for run, label in zip(c.runs, c.labels)]
        changes = [{"parameter": d.name, "values": list(d.values), "changes_results": d.has_effect} for d in self.scenes.differences]
        result = {"runs": runs, "reference": c.labels[0], "compared_s": c.end, "step_s": c.dt, "low_pass_hz": c.corner,
                  "base_monitor": c.base, "differences": changes, "verdict": self.verdicts, "warnings": self.warnings, "notes": self.notes}
        if self.tolerance is not None:
            result.update(tolerance=self.tolerance, within_tolerance=not self.beyond, beyond=self.beyond)
        return result


def several(word, texts, repeat=False):
    return [(word if repeat or k == 0 else "", text) for k, text in enumerate(texts)]


def columns(lines):
    return ["%-8s %s" % line for line in lines]
