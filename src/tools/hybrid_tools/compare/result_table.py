# SPDX-License-Identifier: GPL-3.0-or-later
"""The rows of a comparison as a table: SI units in files, mm, g and percent for people."""

import math

from hybrid_tools.table import Cell, Column, Table, percent

from . import verdict
from .quantities import shown_unit

MANY = 6  # monitors in the terminal


def for_terminal(comparison, rows):
    """(rows to show, words on the others): the larger component of the few monitors that differ most, and what the verdict names."""
    def largest(name):
        changes = [change for row in rows if row.monitor == name for i, change in enumerate(row.changes) if row.is_judged(i)]
        return max([math.inf if math.isnan(change) else abs(change) for change in changes], default=0.0)

    monitors = list(dict.fromkeys(row.monitor for row in rows if row.monitor))
    kept = sorted(monitors, key=largest, reverse=True)[:MANY]
    named = {id(row) for i, _ in comparison.others for _, row in verdict.most(rows, i)}
    shown = [row for row in rows if not row.monitor or (row.monitor in kept and not row.is_side) or id(row) in named]
    left_out = ["%d more monitors" % (len(monitors) - len(kept))] if len(monitors) > len(kept) else []
    left_out += ["vertical components"] if any(row.is_side and id(row) not in named for row in rows) else []
    return shown, " and ".join(left_out)


def make_table(comparison, shown, rows):
    """A value for each run, and a change for each but the reference. rows: all of them, whose largest choose the units."""
    columns = [Column("place", head=""), Column("quantity", head=""), Column("unit", head="")]
    for i, label in enumerate(comparison.labels):
        columns.append(Column(label))
        if i:
            columns.append(Column(label + ": change", head=""))
    table = Table(columns)
    for row in shown:
        factor, unit = unit_of(rows, row)
        cells = [row.place, row.quantity, Cell(row.unit, unit)]
        for i, (value, change) in enumerate(zip(row.values, row.changes)):
            cells.append(value_cell(row, value, factor))
            if i:
                cells.append(change_cell(row, i, change))
        table.add(*cells)
    return table


def unit_of(rows, row):
    if row.place == "cost" and row.quantity == "per step":
        return 1e3, "ms"
    alike = [other for other in rows if other.kind == row.kind] if row.kind.startswith("base") or row.kind in ("slip", "blocks") else rows
    return shown_unit([other for other in alike if other.kind.startswith("base") == row.kind.startswith("base")], row.unit)


def value_cell(row, value, factor):
    if value is None or row.is_count:
        return value if value is None else Cell(value, "%d" % value)
    if not math.isfinite(value):
        return Cell(value, "not a number" if math.isnan(value) else "from 0")
    if row.quantity.startswith("misfit"):
        return Cell(value, percent(value).lstrip("+"))
    return Cell(value, number(factor * value))


def number(value):
    """Three digits, and two decimals at most."""
    if value == 0:
        return "0"
    if abs(value) < 0.095:
        return "%.2g" % value
    return "%.*f" % (2 if abs(value) < 99.5 else 1 if abs(value) < 999.5 else 0, value)


def change_cell(row, i, change):
    """The change of run i; of counts the difference, of misfits none (they are changes themselves)."""
    if change is None or row.quantity.startswith("misfit"):
        return None if change is None else Cell(change, "")
    if row.is_count:
        return Cell(change, "%+d" % (row.values[i] - row.values[0]) if change else "0")
    if i in row.small:
        return Cell(change, "small")
    return Cell(change, percent(change) + (" of peak" if row.of_peak and change and math.isfinite(change) else ""))
