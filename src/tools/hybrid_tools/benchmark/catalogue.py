# SPDX-License-Identifier: GPL-3.0-or-later
"""The rows of the table: which scene of parameters/benchmarks, what is measured, and the goal if there is one.

A new row is a scene and a line here. Rows of a family differ in size alone: their growth exponent is fitted.
"""

import fnmatch
import pathlib
from dataclasses import dataclass

from hybrid_run import UserError

STEP, SIMULATED, RATE, RUN, STATIC, THREADS, WAVES = "step", "simulated", "rate", "run", "static", "threads", "waves"
UNITS = {STEP: "ms/step", SIMULATED: "ms/ms", RATE: "block-steps/s", RUN: "s", STATIC: "s", THREADS: "of one thread's time", WAVES: "ns per unknown"}
MEANINGS = {
    STEP: "processor time per accepted step, without the first, in which factors are made",
    SIMULATED: "processor time of all steps per simulated time",
    RATE: "blocks times steps over the processor time of the steps, without the first",
    RUN: "processor time of the whole run",
    STATIC: "processor time of the static stage",
    WAVES: "processor time per step and unknown of the bedrock, without the first step",
    THREADS: "wall time of the steps with two threads over that with one",
}


@dataclass(frozen=True)
class Row:
    """name: unique. kind: what is measured. goal: in the kind's unit; at most this, of RATE at least; None: none. is_long: --long alone.

    scene: name of the parameter file, by default that of the row. beside_work: another process keeps a core busy.
    """

    name: str
    kind: str
    goal: float = None
    family: str = ""
    is_long: bool = False
    scene: str = ""
    beside_work: bool = False

    @property
    def path(self):
        return self.scene if self.scene.endswith(".prm") else str(folder() / ((self.scene or self.name) + ".prm"))

    @property
    def unit(self):
        return UNITS[self.kind]


def family(name, kind, goals, is_long=()):
    return [Row("%s_%s" % (name, size), kind, goal, name, size in is_long) for size, goal in goals.items()]


ROWS = (
    family("slide", SIMULATED, {"100": 1, "400": 4, "900": 10, "2000": 25, "10000": 150}, is_long=("10000",))
    + family("rest", SIMULATED, {"100": 0.1, "400": 0.4, "900": 0.9, "2000": 2})
    + family("badong", STEP, {"8": 3, "4": 6, "2": 20}, is_long=("2",))
    + family("static", STATIC, {"8": None, "4": 1, "2": 5, "1": None}, is_long=("2", "1"))
    + family("waves", WAVES, {"155k": 15, "617k": 15})
    + family("bonded", RATE, {"5000": 5e5, "20000": 5e5, "100000": 5e5, "1000000": 5e5}, is_long=("100000", "1000000"))
    + family("coupled", RATE, {"10000": None, "long": None, "1000000": None}, is_long=("long", "1000000"))
    + [
        Row("bin_30", RUN),
        Row("bin_1000", RUN),
        Row("majiagou_1g_12", RUN),
        Row("triangles_8", STEP, 6),
        Row("threads_badong_4", THREADS, 0.65, scene="badong_4"),
        Row("threads_bonded_20000", THREADS, 0.65, scene="bonded_20000"),
        Row("threads_beside_work", THREADS, 1.3, scene="badong_4", beside_work=True),
        Row("badong_12s", RUN, 40, is_long=True),
        Row("bin_1000_8s", RUN, 120, is_long=True),
    ]
    + family("majiagou_1g", RUN, {"4": 120, "2": 900}, is_long=("4", "2"))
)
FOREVER = ("bonded_1000000", "coupled_1000000")  # only where they are named: they take about 20 GB


def folder():
    """parameters/benchmarks, beside the sources or where they are installed. @raises UserError where there is none."""
    here = pathlib.Path(__file__).resolve()
    for root in here.parents[3:5]:
        if (root / "parameters/benchmarks").is_dir():
            return root / "parameters/benchmarks"
    raise UserError("the scenes were found neither in '%s' nor above it" % (here.parents[3] / "parameters/benchmarks"))


def choose(names, with_long=False):
    """Rows whose name or family is one of these words (* stands for anything) and scenes that are named by their file; all without words.

    Long rows are among them where their own name is given, or with_long. @raises UserError for a word that no row fits.
    """
    chosen = []
    for word in names or ["*"]:
        if word.endswith(".prm"):
            if not pathlib.Path(word).is_file():
                raise UserError("there is no scene '%s'" % word)
            chosen.append(Row(pathlib.Path(word).stem, STEP, scene=word))
            continue
        found = [row for row in ROWS if fnmatch.fnmatchcase(row.name, word) or row.family == word]
        if not found:
            raise UserError("no row is called '%s'; there are %s" % (word, ", ".join(row.name for row in ROWS)))
        chosen += [row for row in found if row.name == word or (row.name not in FOREVER and (with_long or not row.is_long))]
    if not chosen:
        raise UserError("only long rows are called that; --long asks for them")
    return list(dict.fromkeys(chosen))
