# SPDX-License-Identifier: GPL-3.0-or-later
"""The numbers that runs are compared by: a row for each, with a value and a change for each run."""

import math
from dataclasses import dataclass, field

import numpy as np

from hybrid_run import MissingData, misfit
from hybrid_tools import style

G = 9.80665  # [m/s2]
SMALL = 1e-3  # of the largest of its kind: not judged
SMALL_SLIP = 1e-2  # of the largest displacement: what springs give
FLOOR = {"m": 1e-9, "m/s2": 1e-6}  # below it nothing moves
LITTLE_LEFT = 0.1  # of the peak: what is left is then judged by the peak
SIDE = 0.2  # of the larger component: the other one has rows of its own


@dataclass
class Row:
    """One quantity. values: of each run in SI units, None where there is none; changes: against the first, None where not comparable.

    kind: rows of a kind have one scale; "" for rows that are not judged. is_count: people see differences.
    """

    place: str
    quantity: str
    unit: str
    values: list
    kind: str = ""
    changes: list = field(default_factory=list)
    small: set = field(default_factory=set)  # numbers of the runs whose value is small, as that of the reference
    is_count: bool = False
    of_peak: bool = False  # changes refer to the peak
    scale: float = None  # what they refer to; None: to themselves
    monitor: str = ""  # "" for what is not of a monitor
    is_side: bool = False  # of the smaller component

    def is_judged(self, i):
        """Whether the change of run i counts."""
        return bool(self.kind) and self.changes[i] is not None and i not in self.small


def rows_of(comparison):
    """All rows, in the order of the table."""
    rows = []
    for name in sorted(comparison.monitors, key=lambda name: name == comparison.base):  # the base last
        rows += monitor_rows(comparison, name)
    weigh(rows)
    blocks, slip = block_rows(comparison), slip_rows(comparison)
    moved = [value for row in rows + blocks if row.kind in ("u", "blocks") for value in row.values]
    for row in slip:
        if largest_of(row.values) < SMALL_SLIP * largest_of(moved):
            row.small.update(range(1, len(row.values)))
    return rows + slip + bedding_rows(comparison) + blocks + joint_rows(comparison) + run_rows(comparison)


def largest_of(values):
    """The largest of the values that are there and finite."""
    return max((abs(value) for value in values if value is not None and math.isfinite(value)), default=0.0)


def monitor_rows(comparison, name):
    """Peaks and rests of the components that matter, and the misfit of the history."""
    n = range(len(comparison.runs))
    place = name + " (absolute)" if name == comparison.base else name
    kind = "base " if name == comparison.base else ""
    displacement = [comparison.displacement(i, name) for i in n]
    acceleration = [comparison.acceleration(i, name) for i in n]
    u, a = np.array([misfit.peak(x) for x in displacement]), np.array([misfit.peak(x) for x in acceleration])
    rows = []
    for c in components(u, a):
        words = ", up" if c else ""
        left = [x[-1, c] for x in displacement]
        rows.append(peak_row(place, "peak u" + words, "m", np.abs(u[:, c]), kind + "u"))
        rows.append(left_row(place, "left u" + words, left, abs(u[0, c]), kind + "u"))
        rows.append(peak_row(place, "peak a" + words, "m/s2", np.abs(a[:, c]), kind + "a"))
        for row in rows[-3:]:
            row.is_side = c == 1 and rows[0].quantity == "peak u"
    differences = [misfit.relative_l2(x, displacement[0]) for x in displacement]
    rows.append(Row(place, "misfit u, L2", "1", [None] + differences[1:], kind + "misfit", [None] + differences[1:]))
    for row in rows:
        row.monitor = name
    return rows


def components(u, a):
    """Horizontal, vertical or both: what moves by a fifth of the other in any run."""
    def matter(peaks):
        largest = np.nanmax(np.abs(peaks), axis=0, initial=0)
        return largest >= SIDE * max(largest.max(), 1e-300)

    chosen = matter(u) | matter(a)
    return [c for c in (0, 1) if chosen[c]] or [0]


def peak_row(place, quantity, unit, values, kind):
    values = [float(value) for value in values]
    changes = [misfit.relative_change(value, values[0]) for value in values[1:]]
    return Row(place, quantity, unit, values, kind, [None] + changes, scale=abs(values[0]))


def left_row(place, quantity, values, peak, kind):
    """What is left of a history; its change is positive if more is left, and refers to the peak near zero."""
    values = [None if value is None else float(value) for value in values]
    first = values[0]
    of_peak = first is not None and abs(first) < LITTLE_LEFT * peak
    scale = None if first is None else peak if of_peak else abs(first)
    sign = -1.0 if first is not None and first < 0 else 1.0
    changes = [None if value is None or first is None else sign * misfit.relative_change(value, first, scale)
               for value in values[1:]]
    return Row(place, quantity, "m", values, kind, [None] + changes, of_peak=of_peak, scale=scale)


def weigh(rows):
    """Which values are small, each run with the reference. Changes of what is small in the reference alone are infinite: its digits mean
    nothing."""
    for row in rows:
        if row.unit == "1":
            continue
        for i in range(1, len(row.values)):
            alike = [other.values[k] for other in rows if other.kind == row.kind for k in (0, i)]
            weigh_pair(row, i, max(SMALL * largest_of(alike), FLOOR[row.unit]))
    for row in rows:
        if row.unit == "1":
            weigh_misfit(row, [other for other in rows if other.place == row.place and other.quantity.startswith("peak u")])


def weigh_pair(row, i, limit):
    """limit: below it a value is small."""
    first, value = row.values[0], row.values[i]
    if row.changes[i] is None or not row.scale < limit or math.isnan(value):
        return
    if abs(first) < limit and abs(value) < limit:
        row.small.add(i)
    else:
        row.changes[i] = math.copysign(math.inf, value)


def weigh_misfit(row, peaks):
    """A misfit is as small, or from rest, as the displacements of its monitor."""
    for i in range(1, len(row.values)):
        if all(i in peak.small for peak in peaks):
            row.small.add(i)
        elif all(i in peak.small or math.isinf(peak.changes[i]) for peak in peaks):
            row.changes[i] = row.values[i] = math.inf


def slip_rows(comparison):
    """Mean and largest slip on the sliding surface, and what is left of it."""
    rows = []
    for path, words in (("slip/mean", "mean"), ("slip/largest", "largest")):
        histories = []
        for i, run in enumerate(comparison.runs):
            histories.append(comparison.on_axis(i, path) if run.has(path) else None)
        if any(history is not None for history in histories):
            peaks = [None if history is None else misfit.peak(history) for history in histories]
            left = [None if history is None else history[-1] for history in histories]
            rows.append(left_row("slip", "%s, peak" % words, peaks, 0.0, "slip"))
            rows.append(left_row("slip", "%s, left" % words, left, abs(peaks[0] or 0.0), "slip"))
    weigh(rows)
    return rows


def bedding_rows(comparison):
    """Largest slip (magnitude) of each bedding plane, and joint line of the mass, that slips in any run."""
    rows = []
    for group, name in [(group, name) for group in ("bedding", "joint_lines") for name in comparison.reference.names(group)]:
        path = "%s/%s/slip" % (group, name)
        if name == "time" or not comparison.has_everywhere(path):
            continue
        slips = []
        for run in comparison.runs:
            slip, time = run.get(path), run.get(group + "/time")
            n = min(len(slip), len(time))
            slips.append(float(np.max(np.abs(slip[:n][time[:n] <= comparison.end * (1 + 1e-9)]), initial=0)))
        if max(slips) > 0:
            rows.append(left_row(name, "largest slip", slips, 0.0, "bedding"))
    weigh(rows)
    return rows


def block_rows(comparison):
    """How far blocks of the mass have moved, of runs that end where the comparison does (run.h5 has it at the end only)."""
    path = "section/blocks_peak_displacement"
    known = [run.has(path) and comparison.ends_with(i) for i, run in enumerate(comparison.runs)]
    if sum(known) < 2 or not known[0]:
        return []
    largest = [float(np.max(run.get(path)[run.blocks.mass], initial=0)) if is_known else None for run, is_known in zip(comparison.runs, known)]
    row = left_row("blocks", "farthest", largest, 0.0, "blocks")
    weigh([row])
    return [row]


def joint_rows(comparison):
    """Joints that failed in the shaking."""
    counts = []
    for i in range(len(comparison.runs)):
        try:
            counts.append(len(comparison.failed_joints(i)))
        except MissingData:
            counts.append(None)
    if all(count is None for count in counts):
        return []
    first = counts[0]
    changes = [None if count is None or first is None else (count - first) / max(first, 1) for count in counts[1:]]
    return [Row("failed joints", "", "", counts, "joints", [None] + changes, is_count=True)]


def run_rows(comparison):
    """What a run says about itself; not judged."""
    residuals, costs, totals = [], [], []
    for run in comparison.runs:
        has_audit = run.has("energy/residual") and run.has("energy/time")
        if has_audit:
            within = run.get("energy/time") <= comparison.end
            residual = run.get("energy/residual")
            residuals.append(float(np.max(np.abs(residual[: len(within)][within[: len(residual)]]), initial=0)))
        else:
            residuals.append(None)
        wall = wall_times(run, comparison.end)
        costs.append(None if wall is None else float(wall.mean()))
        totals.append(None if wall is None else float(wall.sum()))
    none = [None] * len(residuals)
    rows = [Row("energy residual", "", "1", residuals, changes=none), Row("cost", "per step", "s", costs, changes=none),
            Row("cost", "all steps", "s", totals, changes=none)]
    return [row for row in rows if any(value is not None for value in row.values)]


def wall_times(run, end):
    """Wall time of each step up to the common end [s]; None if it was not recorded."""
    if not run.has("steps/wall_time") or not len(run.file["steps/wall_time"]):
        return None
    wall = run.get("steps/wall_time")[: run.n]
    chosen = wall[run.time[: len(wall)] <= end * (1 + 1e-9)]
    return chosen if len(chosen) else None


def shown_unit(rows, unit):
    """(factor, unit) in which people see rows of this unit."""
    if unit == "m":
        return style.length_unit(largest_of([value for row in rows if row.unit == "m" for value in row.values]))
    return {"m/s2": (1 / G, "g"), "1": (100.0, "%"), "s": (1.0, "s")}.get(unit, (1.0, unit))
