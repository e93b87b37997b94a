#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs a verification scene and compares it with its closed form.

    verify.py HYBRID CASE WORK_DIR            exit code 1 and a sentence if a number is out of tolerance
    verify.py HYBRID CASE WORK_DIR --figure   also draws doc/verification/CASE.png from this run

CASE is the name of parameters/verification/CASE.prm and of tests/verification/cases/CASE.py, a module with

    check(case)         runs the scene (case.run) and asks for numbers (case.near, case.below)
    draw(case, figure)  optional: draws what check() computed into a matplotlib figure

Numbers at default settings are those of the scene: overrides are for variants (other angles, finer steps).
"""

import importlib
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "src/output/plot"), str(ROOT / "tests"), str(ROOT / "tests/verification/cases")]

from run_data import RunData  # noqa: E402 (needs the path above)
from run_hybrid import run_hybrid  # noqa: E402


class Case:
    """One verification case: its runs, and the judgement of their numbers."""

    def __init__(self, binary, name, work):
        self.binary, self.name, self.work = binary, name, pathlib.Path(work)
        self.scene = ROOT / "parameters/verification" / (name + ".prm")
        self.failures, self.asked = [], 0

    def run(self, variant="default", *overrides, expect=0):
        """RunData of the scene with overrides ("Section/Name=value"), made in WORK_DIR/variant."""
        directory = self.work / variant
        code, output, errors, command = run_hybrid(self.binary, self.scene, directory, overrides)
        if code != expect:
            sys.exit("error: %s ended with code %d\n%s%s" % (command, code, output[-2000:], errors[-2000:]))
        return RunData(str(directory)) if expect == 0 else None

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

    def below(self, what, found, limit, unit=""):
        """|found| <= limit."""
        self._ask(abs(found) <= limit, "%s: %.3g %s, allowed %.3g" % (what, found, unit, limit))

    def true(self, what, fulfilled):
        self._ask(bool(fulfilled), what)


def draw(case, module):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plot

    figure = plot.figure(figsize=(8, 4.5), dpi=110, constrained_layout=True)
    module.draw(case, figure)
    figure.savefig(ROOT / "doc/verification" / (case.name + ".png"))


def main():
    arguments = [a for a in sys.argv[1:] if a != "--figure"]
    if len(arguments) != 3:
        sys.exit(__doc__)
    case = Case(*arguments)
    module = importlib.import_module(case.name)
    module.check(case)
    if "--figure" in sys.argv:
        draw(case, module)
    if not case.asked:
        sys.exit("error: the case asked for nothing")
    if case.failures:
        sys.exit("error: %d of %d requirements are not met, first: %s" % (len(case.failures), case.asked, case.failures[0]))


if __name__ == "__main__":
    main()
