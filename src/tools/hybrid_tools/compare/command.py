# SPDX-License-Identifier: GPL-3.0-or-later
"""hybrid compare A B ...: runs side by side in a table, files and figures.

Exit code 1 if a run differs by more than --tolerance, or a figure failed.
"""

import importlib
import math
import os
import sys
import traceback

from hybrid_run import MissingData, Run, UserError
from hybrid_run.geometry import other_section
from hybrid_tools import style
from hybrid_tools.arguments import Arguments

from .comparison import Comparison, labels_of
from .quantities import rows_of
from .scenes import Scenes
from .warnings import warnings_of
from .words import Answer

# Modules of this folder with draw(comparison, directory), in the order of drawing.
FIGURES = ("histories", "peaks", "differences", "spectral_ratios", "response_spectra", "boreholes", "slip", "section_maps", "failures", "cost")

EXAMPLES = """  hybrid compare output/continuum output/triangles output/rigid
  hybrid compare output/old output/new --tolerance 5%          exit code 1 if they differ by more
"""


def words_of(words):
    a = Arguments("compare", "Runs that share monitors side by side: what differs in their scenes and in their results.", EXAMPLES)
    a.add_argument("runs", metavar="DIRECTORY", nargs="+", help="output directories of runs; the first is the reference")
    a.add_argument("--reference", metavar="DIRECTORY", help="another one of them is the reference")
    a.add_argument("--tolerance", metavar="5%", help="exit code 1 if a run differs by more in any judged number, or has not finished")
    a.add_argument("--output", "--out", metavar="DIRECTORY", help="where table.csv, .json, .md and figures/ go; by default compare/ beside the runs")
    a.add_argument("--force", action="store_true", help="compare runs of different sections, too")
    a.add_argument("--all", action="store_true", help="print every row of the table, not only those of the monitors that differ most")
    a.add_argument("--no-figures", action="store_true", help="the table only")
    return a.read(words)


def read_tolerance(text):
    """5% or 0.05 as a fraction. @raises UserError"""
    if text is None:
        return None
    try:
        value = float(text.rstrip("% ")) / (100 if text.rstrip().endswith("%") else 1)
    except ValueError:
        value = math.nan
    if not 0 <= value < math.inf:
        raise UserError("--tolerance = '%s' is not a part such as 5%% or 0.05" % text)
    return value


def ordered(directories, reference):
    """The reference first. @raises UserError"""
    if len(directories) < 2:
        raise UserError("one run alone is nothing to compare; give at least two directories")
    if reference is None:
        return directories
    same = [d for d in directories if os.path.abspath(d) == os.path.abspath(reference) or os.path.basename(os.path.abspath(d)) == reference]
    if len(same) != 1:
        raise UserError("--reference = '%s' is none of the runs; they are %s" % (reference, ", ".join(directories)) if not same else
                        "--reference = '%s' may be %s; give its path" % (reference, " or ".join(same)))
    return same + [d for d in directories if d != same[0]]


def check_sections(comparison):
    """@raises UserError if a run is of another section than the reference."""
    for i, label in comparison.others:
        other = other_section(comparison.runs[i], comparison.reference)
        if other:
            raise UserError("'%s' is of another section than '%s': %s; hybrid compare --force compares them all the same" % (
                label, comparison.labels[0], other))


def directory_for(runs, given):
    """Where the files go. @raises UserError if a run lies there."""
    directory = given or os.path.join(os.path.dirname(runs[0].directory.rstrip("/")), "compare")
    if os.path.exists(os.path.join(directory, "run.h5")):
        raise UserError("'%s' holds a run; give another directory with --out" % directory)
    try:
        os.makedirs(directory, exist_ok=True)
    except OSError as error:
        raise UserError("cannot make the directory '%s': %s" % (directory, error.strerror)) from error
    return directory


def compare(comparison, directory, tolerance=None, with_figures=True):
    """The table's files and the figures in the directory. @return (Answer, figures drawn, how many failed)."""
    rows = rows_of(comparison)
    answer = Answer(comparison, Scenes(comparison.runs), rows, warnings_of(comparison, rows), tolerance)
    above, below = answer.markdown()
    answer.table().write(directory, "table", answer.json(), above, below)
    return (answer, *(draw_figures(comparison, directory) if with_figures else (0, 0)))


def draw_figures(comparison, directory):
    """All figures for which there are data; those of an earlier comparison are taken away. @return (drawn, how many failed)."""
    style.apply()
    figures = os.path.join(directory, "figures")
    os.makedirs(figures, exist_ok=True)
    drawn, failed = 0, 0
    for name in FIGURES:
        path = os.path.join(figures, name + ".png")
        if os.path.exists(path):
            os.remove(path)
        try:
            importlib.import_module("hybrid_tools.compare." + name).draw(comparison, figures)
            drawn += 1
        except MissingData:
            pass
        except Exception:
            failed += 1
            print("error: %s could not be drawn:" % name, file=sys.stderr)
            traceback.print_exc()
    return drawn, failed


def main(words):
    found = words_of(words)
    tolerance = read_tolerance(found.tolerance)
    directories = ordered(found.runs, found.reference)
    comparison = Comparison([Run(d) for d in directories], labels_of(directories))
    if not found.force:
        check_sections(comparison)
    directory = directory_for(comparison.runs, found.output)
    answer, drawn, failed = compare(comparison, directory, tolerance, not found.no_figures)
    files = "%s: table.csv, table.json, table.md%s" % (directory, "; %d figures in figures/" % drawn if drawn else "")
    print(answer.terminal(files, found.all))
    return 1 if failed or answer.beyond else 0
