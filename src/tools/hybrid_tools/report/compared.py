# SPDX-License-Identifier: GPL-3.0-or-later
"""Several runs side by side, as hybrid compare says it."""

import importlib
from dataclasses import dataclass

from hybrid_run import MissingData, UserError
from hybrid_run.geometry import other_section
from hybrid_tools import style
from hybrid_tools.compare.command import FIGURES
from hybrid_tools.compare.comparison import Comparison
from hybrid_tools.compare.quantities import rows_of
from hybrid_tools.compare.result_table import for_terminal, make_table
from hybrid_tools.compare.scenes import Scenes
from hybrid_tools.compare.warnings import warnings_of
from hybrid_tools.compare.words import Answer, head

from .panels import Panel
from .vector import to_svg


@dataclass
class Compared:
    """For the template."""

    verdict: list
    about: str = ""
    warnings: tuple = ()
    head: tuple = ()
    rows: tuple = ()
    shown: tuple = ()
    labels: tuple = ()
    differs: tuple = ()
    panels: tuple = ()
    notes: tuple = ()


def compare(runs, labels):
    """The first run is the reference. Runs that cannot be compared are told, not refused: each has its own part of the page."""
    for run, label in zip(runs[1:], labels[1:]):
        other = other_section(run, runs[0])
        if other:
            return Compared(["Not compared: '%s' is of another section than '%s': %s." % (label, labels[0], other)])
    try:
        comparison = Comparison(runs, labels)
        rows = rows_of(comparison)
    except (MissingData, UserError) as reason:
        return Compared(["Not compared: %s." % reason])
    scenes = Scenes(runs)
    answer = Answer(comparison, scenes, rows, warnings_of(comparison, rows))
    shown, _ = for_terminal(comparison, rows)
    heads, lines = words_of(answer.table())
    _, few = words_of(make_table(comparison, shown, rows))
    differs = [[name] + list(values) for name, values, _ in scenes.differing()] if scenes.is_known else []
    return Compared(answer.verdicts, head(comparison), answer.warnings, heads, lines, few, labels, differs, drawn(comparison), answer.notes)


def words_of(table):
    """(heads, rows) as people read them: place and quantity in one column."""
    lines = [[column.words(value) for column, value in zip(table.columns, row)] for row in table.rows]
    heads = [column.title if column.head is None else column.head for column in table.columns]
    return ["", ""] + heads[3:], [[" ".join(line[:2])] + line[2:] for line in lines]


def drawn(comparison):
    """[Panel] of every figure of hybrid compare for which there are data."""
    panels = []
    for name in FIGURES:
        module = importlib.import_module("hybrid_tools.compare." + name)
        about = module.__doc__.strip().split("\n")[0]
        found = []
        with style.taken(lambda figure, file, found=found, about=about: found.append(to_svg(figure, "compare-" + file, about))):
            try:
                module.draw(comparison, "")
            except MissingData:
                continue
        panels += [Panel(svg, about, True) for svg in found]
    return panels
