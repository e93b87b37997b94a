#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Loose blocks: the errors that runs in steps of 8, 4, 2 and 1 ms say they have, and whether they say that blocks strike each other, beside true
errors: the median of the largest differences to runs in steps of 0.25, 0.2 and 0.167 ms.

Usage: loose_errors_test.py HYBRID_BINARY SOURCE_DIR WORK_DIR [--write doc/accuracy.md]
The first form runs the scenes of SHORT in one step, anew: displacements and velocities within a factor of 3, accelerations too unless blocks
strike, strikes where there are some.
--write runs all (20 to 40 minutes) and writes the table of the page; runs that are in WORK_DIR already are kept.
"""
import json
import pathlib
import shutil
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from run_hybrid import must_run  # noqa: E402 (needs the path above)

STEPS = (8e-3, 4e-3, 2e-3, 1e-3)
FINE = (2.5e-4, 2e-4, 1e-3 / 6)
SHORT = {"columns, rigid": (4e-3, False), "squares on a ridge, rigid": (2e-3, False), "tower": (4e-3, True),
         "20 at rest in a bin": (2e-3, False)}  # step, whether blocks strike


def compute(binary, work, name, step, further):
    """The run with this step, if it is not there yet. @return its directory"""
    from loose_scenes import write_scene

    place = work / name.replace(" ", "_").replace(",", "") / ("%.3g" % step)
    if not (place / "summary.json").exists():
        file = write_scene(name, place.parent)
        words = [file, "--force"]
        for setting in ("Output/Directory=%s" % place, "Time/Time step=%.12g" % step, "Output/Picture interval=0", "Checkpoint/Wall interval=0", *further):
            words += ["-s", setting]
        must_run(binary, words)
    return place


def measure(binary, work, name, steps):
    """By step: what is told over what is true (three quantities; None: nothing is told), whether blocks strike. Then how far the fine runs scatter."""
    from probable_error_test import FLOOR, ONE_RUN, parts_of, true_errors

    fine = [compute(binary, work, name, step, ONE_RUN) for step in FINE]
    rows = []
    for step in steps:
        place = compute(binary, work, name, step, [])
        said = json.loads((place / "summary.json").read_text())["probable_error"]
        true = np.median([true_errors(place, other, 1e9, 1, None) for other in fine], axis=0)
        ratio = np.maximum(parts_of(said), FLOOR) / np.maximum(true, FLOOR) if said["estimated"] else None
        rows.append((ratio, said.get("blocks_strike", False)))
    scatter = np.max([true_errors(a, b, 1e9, 1, None) for a in fine for b in fine if a != b], axis=0)
    return rows, scatter


def short(binary, work):
    bad = 0
    for name, (step, strikes) in SHORT.items():
        (ratio, found), = measure(binary, work, name, (step,))[0]
        good = found == strikes and all(1 / 3 < r < 3 for r in (ratio[:2] if strikes else ratio))
        print("%-24s told over true %s, blocks %s%s" % (name, " ".join("%.2f" % r for r in ratio), "strike" if found else "do not strike",
                                                       "" if good else "  <-- not as it should be"))
        bad += not good
    sys.exit(1 if bad else 0)


def span(values):
    return "%.2g to %.2g" % (min(values), max(values))


def write(binary, work, page):
    from loose_scenes import ON_BEDROCK, ON_GROUND
    from probable_error_test import put

    lines, all_of = [], {True: [], False: []}
    for name in (*ON_BEDROCK, *ON_GROUND):
        rows, scatter = measure(binary, work, name, STEPS)
        told = [ratio for ratio, _ in rows if ratio is not None]
        for ratio, strikes in rows:
            if ratio is not None:
                all_of[strikes].append(ratio)
        lines.append("| %s | %.2g | %d of %d | %s | %s | %s |" % (name, 100 * scatter[1], sum(s for r, s in rows if r is not None), len(told),
                                                           *(span([r[q] for r in told]) for q in range(3))))
        print(lines[-1], flush=True)
    for strikes, found in all_of.items():
        values = np.array(found)
        print("strike" if strikes else "do not", len(values), "too small", (values < 1 / 3).sum(axis=0), "too large", (values > 3).sum(axis=0))
    put(page, ((lines, "loose blocks"),))


def main():
    binary, source, work = sys.argv[1], pathlib.Path(sys.argv[2]).resolve(), pathlib.Path(sys.argv[3]).resolve()
    sys.path[:0] = [str(source / part) for part in ("src/tools", "tests/verification/cases", "tests/verification", "tests/invariants")]
    if "--write" not in sys.argv:
        shutil.rmtree(work, ignore_errors=True)  # of an earlier program
    work.mkdir(parents=True, exist_ok=True)
    if "--write" in sys.argv:
        write(binary, work, pathlib.Path(sys.argv[sys.argv.index("--write") + 1]))
    else:
        short(binary, work)


if __name__ == "__main__":
    main()
