# SPDX-License-Identifier: GPL-3.0-or-later
"""hybrid plot RUN...: RUN/figures/*.png (pdf, svg) from its run.h5 and summary.json.

With --all also a film of each run, and several runs side by side as hybrid compare shows them.
A figure whose data the run did not record is left out, with a word on why. Exit code 1 if a figure failed.
"""

import contextlib
import importlib
import os
import sys
import traceback

from hybrid_run import MissingData, NotInScene, Run, UserError
from hybrid_tools.arguments import Arguments

from . import catalogue, monitor_choice

# Modules of this folder with draw(run, directory), in the order of drawing.
FIGURES = ("input_motion", "monitor_histories", "velocities", "boreholes", "section_view", "failure_process", "slip", "planes",
           "heterogeneity", "energy_balance", "step_costs", "overview")


EXAMPLES = """  hybrid plot output/badong
  hybrid plot --format pdf --figures section,slip output/a output/b
  hybrid plot --figures velocities --groups "S1 | S2-S4 | S5-S8" output/a
  hybrid plot --all output/a output/b          all figures and a film of both, and output/compare: both side by side
"""


def draw_growing(module, run, directory, options, attempts=3):
    """Draw; options: of modules, for their draw(). A file that grew while it was read (the run goes on) is opened anew."""
    figure = importlib.import_module("hybrid_tools.plot." + module)
    for attempt in range(attempts):
        try:
            figure.draw(run, directory, **options.get(module, {}))
            return
        except OSError:
            if attempt == attempts - 1:
                raise
            run.reopen()


def draw_each(run, directory, modules, missing, chosen, options):
    """Draw these figures; missing(module, reason) is told what the run lacks; chosen: were they asked for by name.

    @return how many failed.
    """
    failed = 0
    for module in modules:
        try:
            draw_growing(module, run, directory, options)
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


def draw_run(run, modules=FIGURES, chosen=False, options=None):
    """Figures of a run, in its directory. @return how many failed."""
    from hybrid_tools import style

    directory = os.path.join(run.directory, "figures")
    os.makedirs(directory, exist_ok=True)
    def leave_out(module, reason):
        print("%s: left out, %s" % (catalogue.name_of(module), reason))

    before = len(style.written)
    failed = draw_each(run, directory, modules, leave_out, chosen, options or {})
    catalogue.say("figures", style.written[before:])
    return failed


def list_figures(run, modules, options=None):
    """Print which figures the run has, and why not the others. @return how many failed."""
    from hybrid_tools import style

    about = catalogue.descriptions(modules)
    reasons, files, failed = {}, {}, 0
    for module in modules:
        with style.taken(lambda figure, name: files.setdefault(module, []).append(name)):  # noqa: B023 (called at once)
            failed += draw_each(run, "", [module], reasons.__setitem__, True, options or {})
    print(run.directory)
    for module in modules:
        what = "not there: %s" % reasons[module] if module in reasons else about[module]
        print("  %-13s  %s" % (catalogue.name_of(module), what))
        if len(files.get(module, [])) > 1:
            print("  %-13s  files: %s" % ("", ", ".join(files[module])))
    return failed


def words_of(words):
    arguments = Arguments("plot", "Pictures of runs, in RUN/figures.", EXAMPLES + "\nFigures:\n" + catalogue.as_text(FIGURES))
    arguments.add_argument("runs", metavar="RUN", nargs="+", help="output directory of a run; with --all the first is the reference")
    arguments.add_argument("--figures", metavar="NAME,NAME", help="these alone (default: all that the run has data for)")
    arguments.add_argument("--all", action="store_true",
                           help="also a film of each run (RUN/figures/motion.mp4), and of several runs what hybrid compare writes, in compare/ beside the first")
    arguments.add_argument("--groups", metavar="'A | B,C | D-G'",
                           help="monitors of each panel of the figure velocities (default: neighbours with peaks of a size)")
    arguments.add_argument("--format", choices=("png", "pdf", "svg"), default="png", help="png (default), pdf or svg")
    arguments.add_argument("--list", action="store_true", help="say which figures a run has, and why not the others; draw nothing")
    given = arguments.read(words)
    if given.all and (given.figures is not None or given.list):
        raise UserError("--all draws everything: it goes with neither --figures nor --list")
    return given


def check_groups(text, runs):
    """@raises UserError before anything is drawn, for monitors that a run does not have."""
    for run in runs if text is not None else []:
        monitor_choice.read_groups(text, run.names("monitors"))


def main(words):
    given = words_of(words)
    modules = FIGURES if given.figures is None else catalogue.modules(given.figures, FIGURES)
    with contextlib.ExitStack() as files:
        runs = [Run(directory) for directory in given.runs]
        for run in runs:
            files.callback(run.file.close)
        check_groups(given.groups, runs)

        from hybrid_tools import style  # matplotlib takes its time: not for a word that is wrong

        style.apply()
        style.use_format(given.format)
        options = {"velocities": {"groups": given.groups}}
        if given.list:
            failed = sum(list_figures(run, modules, options) for run in runs)
        else:
            failed = sum(draw_run(run, modules, given.figures is not None, options) for run in runs)
        if given.all:
            from . import everything

            everything.films(runs)
            failed += everything.side_by_side(runs)
    return 1 if failed else 0
