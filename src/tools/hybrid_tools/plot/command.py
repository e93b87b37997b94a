# SPDX-License-Identifier: GPL-3.0-or-later
"""hybrid plot RUN...: RUN/figures/*.png (pdf, svg) from its run.h5 and summary.json.

A figure whose data the run did not record is left out, with a word on why. Exit code 1 if a figure failed.
"""

import contextlib
import importlib
import os
import sys
import traceback

from hybrid_run import MissingData, NotInScene, Run
from hybrid_tools.arguments import Arguments

from . import catalogue

# Modules of this folder with draw(run, directory), in the order of drawing.
FIGURES = ("input_motion", "monitor_histories", "boreholes", "section_view", "failure_process", "slip", "heterogeneity",
           "energy_balance", "step_costs", "overview")


def draw_growing(module, run, directory, attempts=3):
    """Draw; a file that grew while it was read (the run goes on) is opened anew."""
    figure = importlib.import_module("hybrid_tools.plot." + module)
    for attempt in range(attempts):
        try:
            figure.draw(run, directory)
            return
        except OSError:
            if attempt == attempts - 1:
                raise
            run.reopen()


def draw_each(run, directory, modules, missing, chosen):
    """Draw these figures; missing(module, reason) is told what the run lacks; chosen: were they asked for by name.

    @return how many failed.
    """
    failed = 0
    for module in modules:
        try:
            draw_growing(module, run, directory)
        except NotInScene as reason:
            if chosen:
                missing(module, reason)
        except MissingData as reason:
            missing(module, reason)
        except Exception:
            failed += 1
            print("error: %s could not be drawn:" % catalogue.name_of(module), file=sys.stderr)
            traceback.print_exc()
    return failed


def draw_run(run, modules=FIGURES, chosen=False):
    """Figures of a run, in its directory. @return how many failed."""
    directory = os.path.join(run.directory, "figures")
    os.makedirs(directory, exist_ok=True)
    def leave_out(module, reason):
        print("%s: left out, %s" % (catalogue.name_of(module), reason))

    failed = draw_each(run, directory, modules, leave_out, chosen)
    print("figures: " + directory)
    return failed


def list_figures(run, modules):
    """Print which figures the run has, and why not the others. @return how many failed."""
    from hybrid_tools import style

    about = catalogue.descriptions(modules)
    reasons, files, failed = {}, {}, 0
    for module in modules:
        with style.taken(lambda figure, name: files.setdefault(module, []).append(name)):  # noqa: B023 (called at once)
            failed += draw_each(run, "", [module], reasons.__setitem__, True)
    print(run.directory)
    for module in modules:
        what = "not there: %s" % reasons[module] if module in reasons else about[module]
        print("  %-13s  %s" % (catalogue.name_of(module), what))
        if len(files.get(module, [])) > 1:
            print("  %-13s  files: %s" % ("", ", ".join(files[module])))
    return failed


def main(words):
    arguments = Arguments("plot", "Pictures of runs, in RUN/figures.",
                          "  hybrid plot output/badong\n  hybrid plot --format pdf --figures section,slip output/a output/b\n"
                          "\nFigures:\n" + catalogue.as_text(FIGURES))
    arguments.add_argument("runs", metavar="RUN", nargs="+", help="output directory of a run")
    arguments.add_argument("--figures", metavar="NAME,NAME", help="these alone (default: all that the run has data for)")
    arguments.add_argument("--format", choices=("png", "pdf", "svg"), default="png", help="png (default), pdf or svg")
    arguments.add_argument("--list", action="store_true", help="say which figures a run has, and why not the others; draw nothing")
    given = arguments.read(words)
    modules = FIGURES if given.figures is None else catalogue.modules(given.figures, FIGURES)
    runs = [Run(directory) for directory in given.runs]

    from hybrid_tools import style  # matplotlib takes its time: not for a word that is wrong

    style.apply()
    style.use_format(given.format)
    draw = list_figures if given.list else lambda run, which: draw_run(run, which, given.figures is not None)
    with contextlib.ExitStack() as files:
        for run in runs:
            files.callback(run.file.close)
        failed = sum(draw(run, modules) for run in runs)
    return 1 if failed else 0
