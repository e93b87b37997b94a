# SPDX-License-Identifier: GPL-3.0-or-later
"""hybrid amplification RUN...: the motion along lines over that of an outcrop; RUN/amplification/ has tables and figures."""

import importlib
import os

from hybrid_run import MissingData, Run, UserError
from hybrid_tools import style
from hybrid_tools.amplification import quantities, sensitivity, table
from hybrid_tools.arguments import Arguments

# Modules of this folder with draw(study, directory).
FIGURES = ("section_map", "profiles", "ratio_maps", "point_ratios", "wiggles", "peak_map")

EXAMPLES = """  hybrid amplification output/slope
  hybrid amplification output/slope --lines bedding_1,ground --component x
  hybrid amplification output/k1 output/k2 output/k4 --against "Bedding planes/Shear stiffness"
The scene records lines with Monitors/Lines = bedding_1; ground; crack: 0, 10, 50, 20
"""


def read_words(words):
    arguments = Arguments("amplification", "Amplification along bedding planes, the ground and other lines of a run.", EXAMPLES)
    arguments.add_argument("runs", metavar="RUN", nargs="+", help="output directory of a run; several: how it depends on --against")
    arguments.add_argument("--lines", metavar="NAMES", default="", help="names separated by commas (default: all lines of the run)")
    arguments.add_argument("--component", choices=("x", "y"), help="of the motion (default: the larger one of the outcrop motion)")
    arguments.add_argument("--bandwidth", metavar="b", type=float, default=40.0, help="of the smoothing (Konno and Ohmachi 1998; default: 40)")
    arguments.add_argument("--against", metavar="PARAMETER", help="of several runs: the parameter that differs, 'Section/Name'")
    arguments.add_argument("--output", metavar="DIR", help="for tables and figures (default: amplification/ in the first run's directory)")
    arguments.add_argument("--no-figures", action="store_true", help="tables only")
    found = arguments.read(words)
    if not 1 <= found.bandwidth <= 1000:
        raise UserError("--bandwidth is %g; it must be between 1 and 1000" % found.bandwidth)
    if len(found.runs) > 1 and not found.against:
        raise UserError("--against is missing: %d runs are given, and it names the parameter that differs, such as 'Motion/Frequency'" %
                        len(found.runs))
    return found


def study_of(directory, found):
    names = [name.strip() for name in found.lines.split(",") if name.strip()]
    return quantities.Study(Run(directory), names, {"x": 0, "y": 1, None: None}[found.component], found.bandwidth)


def draw(study, directory):
    """@return names of the figures."""
    style.apply()
    drawn = []
    for name in FIGURES:
        try:
            drawn += importlib.import_module("hybrid_tools.amplification." + name).draw(study, directory)
        except MissingData as reason:
            print("%s: left out, %s" % (name, reason))
    return drawn


def warn(study):
    for name in study.at_rest():
        print("warning    %s does not move: is it on a boundary that is fixed? Its figures are left out" % name)
    for name, points in study.coarse():
        print("note       %s has %d points, between them straight lines are drawn; Monitors/Line points = 100 records more" % (name, points))
    if study.run.parameters.get("Bedding planes/Strength", "elastic") != "elastic":
        print("note       planes may slip in this run, which makes high frequencies of its own: ratios say nothing where the outcrop hardly has any")
    cut = study.cut_short()
    if cut:
        print("warning    %s still shakes with %.0f %% of its largest acceleration as the run ends: sharp resonances come out too low, let it run on" % (
            cut[0], 100 * cut[1]))


def main(words):
    found = read_words(words)
    directory = found.output or os.path.join(found.runs[0], "amplification")
    studies = [study_of(run, found) for run in found.runs]
    os.makedirs(directory, exist_ok=True)
    if len(studies) > 1:
        return sensitivity.main(studies, found.against, directory, not found.no_figures)
    numbers = table.summary(studies[0])
    table.write(studies[0], numbers, directory)
    print(table.text(numbers))
    warn(studies[0])
    figures = [] if found.no_figures else draw(studies[0], directory)
    print("files      %s/: table.csv, table.json, spectral_ratios.csv%s" % (directory, "".join(", " + name + ".png" for name in figures)))
    return 0
