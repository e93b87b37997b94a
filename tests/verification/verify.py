#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs a verification scene and compares it with its closed form.

    verify.py HYBRID CASE WORK_DIR            exit code 1 and a sentence if a number is out of tolerance
    verify.py HYBRID CASE WORK_DIR --figure   also draws doc/verification/CASE.png from this run
    verify.py HYBRID CASE WORK_DIR -s "Section/Name=value" ...   a further case: other parameters in all runs

CASE is the name of parameters/verification/CASE.prm and of tests/verification/cases/CASE.py, a module with

    check(case)         runs the scene (case.run) and asks for numbers (case.near, case.within, case.below)
    draw(case, figure)  optional: draws what check() computed into a matplotlib figure

Numbers at default settings are those of the scene: overrides are for variants (other angles, finer steps). Closed
forms take their numbers from the run (scene_numbers.py), so that they hold for further cases too.
"""

import argparse
import importlib
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "src/tools"), str(ROOT / "tests"), str(ROOT / "tests/verification/cases")]

from hybrid_run import Run, read_parameters  # noqa: E402 (needs the path above)
from run_hybrid import run_hybrid  # noqa: E402
from scene_numbers import assignments  # noqa: E402


class Case:
    """One verification case: its runs, and the judgement of their numbers."""

    def __init__(self, binary, name, work, overrides=()):
        self.binary, self.name, self.work = binary, name, pathlib.Path(work)
        self.scene = ROOT / "parameters/verification" / (name + ".prm")
        self.further = dict(split(override) for override in overrides)  # parameters of a further case, in all runs
        self.failures, self.asked = [], 0
        self.program = None  # that makes the runs

    def run(self, variant="default", *overrides, expect=0, mesh=None):
        """Run of the scene with overrides ("Section/Name=value"), made in WORK_DIR/variant.

        mesh: {"Angle": 20.0}, changes to Mesh/Numbers of the scene.
        """
        directory = self.work / variant
        changed = dict(self.further, **dict(split(override) for override in overrides))
        if mesh:
            numbers = changed.get("Mesh/Numbers", read_parameters(self.scene).get("Mesh/Numbers", ""))
            numbers = dict(assignments(numbers), **mesh)
            changed["Mesh/Numbers"] = "; ".join("%s = %.15g" % pair for pair in numbers.items())
        code, output, errors, command = run_hybrid(
            self.binary, self.scene, directory, ["%s=%s" % pair for pair in changed.items()], self.program)
        if code != expect:
            sys.exit("error: %s ended with code %d\n%s%s" % (command, code, output[-2000:], errors[-2000:]))
        return Run(str(directory)) if expect == 0 else None

    def _ask(self, fulfilled, sentence):
        self.asked += 1
        print(("ok    " if fulfilled else "FAIL  ") + sentence)
        if not fulfilled:
            self.failures.append(sentence)

    def near(self, what, found, expected, tolerance, unit=""):
        """|found - expected| <= tolerance * |expected|."""
        error = abs(found - expected) / abs(expected)
        self._ask(error <= tolerance, "%s: %.6g %s, closed form %.6g, error %.3g %%, allowed %.3g %%"
                  % (what, found, unit, expected, 100 * error, 100 * tolerance))

    def within(self, what, found, expected, tolerance, unit=""):
        """|found - expected| <= tolerance."""
        self._ask(abs(found - expected) <= tolerance, "%s: %.5f %s, closed form %.5f, allowed %.3g off"
                  % (what, found, unit, expected, tolerance))

    def below(self, what, found, limit, unit=""):
        """|found| <= limit."""
        self._ask(abs(found) <= limit, "%s: %.3g %s, allowed %.3g" % (what, found, unit, limit))

    def true(self, what, fulfilled):
        self._ask(bool(fulfilled), what)


def split(override):
    """("Section/Name", "value") of "Section/Name=value"."""
    path, value = override.split("=", 1)
    return path.strip(), value.strip()


def draw(case, module):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plot

    figure = plot.figure(figsize=(8, 4.5), dpi=110, constrained_layout=True)
    module.draw(case, figure)
    figure.savefig(ROOT / "doc/verification" / (case.name + ".png"))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ("hybrid", "case", "work_dir"):
        parser.add_argument(name)
    parser.add_argument("--figure", action="store_true")
    parser.add_argument("-s", dest="overrides", action="append", default=[])
    arguments = parser.parse_args()
    case = Case(arguments.hybrid, arguments.case, arguments.work_dir, arguments.overrides)
    module = importlib.import_module(case.name)
    module.check(case)
    if arguments.figure:
        draw(case, module)
    if not case.asked:
        sys.exit("error: the case asked for nothing")
    if case.failures:
        sys.exit("error: %d of %d requirements are not met, first: %s" % (len(case.failures), case.asked, case.failures[0]))


if __name__ == "__main__":
    main()
