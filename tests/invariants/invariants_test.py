#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The net: what must hold in any scene (judge.py), over combinations that nobody chose by hand.

    invariants_test.py HYBRID WORK_DIR pairs [--long]        every sixth scene of a covering array of all pairs of options;
                                                             --long: all of them, and random triples
    invariants_test.py HYBRID WORK_DIR random [--long]       random options and numbers (hypothesis), made small if one fails
    invariants_test.py HYBRID WORK_DIR metamorphic [--long]  pairs of scenes that must move alike (metamorphic.py)
    invariants_test.py HYBRID WORK_DIR pairs --only 17       one of them; its files stay in WORK_DIR

Exit code 1 and the scenes with what is wrong if one is. A defect that is known and not mended yet stands in OPEN: it is run
and told like the others, and so is that it holds once it is mended.
"""

import argparse
import pathlib
import shutil
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

import covering  # noqa: E402 (needs the path above)
import metamorphic  # noqa: E402
import random_scenes  # noqa: E402
from run_scene import judge_scene  # noqa: E402
from scenes import Scene  # noqa: E402

ONE_OF_TWO = "a place between two welded triangles is the corner of one of them, in the mirror of the other: 0.17 mm of 129 mm"
TWO_SOLUTIONS = "a step in which bonds tear has two solutions: all contacts agree to 1e-9 before it, and one bond more tears in one of them"
OPEN = {
    "triangles: mirrored": ONE_OF_TWO,
    "large, breaks: renumbered": TWO_SOLUTIONS,
}
TRIPLES, SEED = 40, 1


class Net:
    """Results of the scenes so far."""

    def __init__(self):
        self.asked, self.red, self.open = 0, [], []

    def tell(self, name, what, wrong):
        self.asked += 1
        known = OPEN.get(name)
        if wrong:
            (self.open if known else self.red).append(name)
        state = ("OPEN " if wrong else "HOLDS, take it off OPEN:") if known else ("FAIL " if wrong else "ok   ")
        print(state, name, what, *(["(%s)" % known] if known else []), flush=True)
        for sentence in wrong:
            print("        " + sentence, flush=True)


def run_pairs(net, arguments):
    rows = covering.all_pairs()
    chosen = list(range(0, len(rows), 1 if arguments.long else 6))
    if arguments.long:
        rows += covering.random_triples(TRIPLES, SEED)
        chosen = list(range(len(rows)))
    for k in [arguments.only] if arguments.only is not None else chosen:
        directory = arguments.work / ("pairs_%d" % k)
        wrong = judge_scene(arguments.hybrid, Scene(rows[k]), directory)
        net.tell("pairs %d" % k, "", wrong)
        if wrong:
            print("        " + Scene(rows[k]).name())
        elif arguments.only is None:
            shutil.rmtree(directory)


def run_metamorphic(net, arguments):
    pairs = metamorphic.Pairs(arguments.hybrid, arguments.work / "metamorphic")
    for name, relation in metamorphic.relations(arguments.long):
        try:
            wrong = list(relation(pairs))
        except RuntimeError as error:  # a run did not finish
            wrong = [str(error)]
        net.tell(name, "", wrong)


def run_random(net, arguments):
    wrong = random_scenes.search(arguments.hybrid, arguments.work / "random", 60 if arguments.long else 8)
    net.tell("random", "", wrong)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("hybrid")
    parser.add_argument("work", type=pathlib.Path)
    parser.add_argument("part", choices=("pairs", "random", "metamorphic"))
    parser.add_argument("--long", action="store_true")
    parser.add_argument("--only", type=int)
    arguments = parser.parse_args()
    net = Net()
    {"pairs": run_pairs, "random": run_random, "metamorphic": run_metamorphic}[arguments.part](net, arguments)
    for found, what in ((net.red, "not as they must be"), (net.open, "known not to be")):
        print("%d of %d are %s%s" % (len(found), net.asked, what, ": " + ", ".join(found) if found else ""))
    sys.exit(1 if net.red else 0)


if __name__ == "__main__":
    main()
