# SPDX-License-Identifier: GPL-3.0-or-later
"""hybrid plot DIRECTORY: DIRECTORY/figures/*.png from its run.h5 and summary.json.

A figure whose data the run did not record is left out, with a word on why. Exit code 1 if a figure failed.
"""

import importlib
import os
import sys
import traceback

from hybrid_run import MissingData, NotInScene, Run
from hybrid_tools import style
from hybrid_tools.arguments import Arguments

# Modules of this folder with draw(run, directory), in the order of drawing.
FIGURES = ("input_motion", "monitor_histories", "boreholes", "section_view", "slip", "heterogeneity",
           "energy_balance", "step_costs", "overview")


def draw_growing(figure, run, figures, attempts=3):
    """Draw; a file that grew while it was read (the run goes on) is opened anew."""
    for attempt in range(attempts):
        try:
            figure.draw(run, figures)
            return
        except OSError:
            if attempt == attempts - 1:
                raise
            run.reopen()


def draw_run(run):
    """All figures of a run. @return how many failed."""
    style.apply()
    figures = os.path.join(run.directory, "figures")
    os.makedirs(figures, exist_ok=True)
    failed = 0
    for name in FIGURES:
        try:
            draw_growing(importlib.import_module("hybrid_tools.plot." + name), run, figures)
        except NotInScene:
            pass
        except MissingData as reason:
            print("%s: left out, %s" % (name, reason))
        except Exception:
            failed += 1
            print("error: %s could not be drawn:" % name, file=sys.stderr)
            traceback.print_exc()
    print("figures: " + figures)
    return failed


def main(words):
    arguments = Arguments("plot", "All pictures of a run, in DIRECTORY/figures.", "  hybrid plot output/badong\n")
    arguments.add_argument("directory", metavar="DIRECTORY", help="output directory of a run")
    return 1 if draw_run(Run(arguments.read(words).directory)) else 0
