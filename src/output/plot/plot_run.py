# SPDX-License-Identifier: GPL-3.0-or-later
"""All pictures of a run: plot_run.py DIR writes DIR/figures/*.png from DIR/run.h5 and DIR/summary.json.

A figure whose data the run did not record is left out, with a word on why. Exit code 1 if a figure failed.
"""

import importlib
import importlib.util
import os
import sys
import traceback

MODULES = {"h5py": "python3-h5py", "matplotlib": "python3-matplotlib", "numpy": "python3-numpy"}  # Debian's packages
missing = [name for name in MODULES if importlib.util.find_spec(name) is None]
if missing:
    sys.exit("error: pictures need the Python %s %s, which %s does not have; on Debian: apt-get install %s" % (
        "module" if len(missing) == 1 else "modules", ", ".join(missing), sys.executable, " ".join(MODULES[m] for m in missing)))

import style  # isort: skip
from run_data import MissingData, NotInScene, RunData  # isort: skip

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


def main(directory):
    style.apply()
    try:
        run = RunData(directory)
    except (OSError, ValueError) as error:
        print("error: cannot read the run in '%s': %s" % (directory, error), file=sys.stderr)
        return 1
    figures = os.path.join(directory, "figures")
    os.makedirs(figures, exist_ok=True)
    failed = 0
    for name in FIGURES:
        try:
            draw_growing(importlib.import_module(name), run, figures)
        except NotInScene:
            pass
        except MissingData as reason:
            print("%s: left out, %s" % (name, reason))
        except Exception:
            failed += 1
            print("error: %s could not be drawn:" % name, file=sys.stderr)
            traceback.print_exc()
    print("figures: " + figures)
    return 1 if failed else 0


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: plot_run.py DIR")
    sys.exit(main(sys.argv[1]))
