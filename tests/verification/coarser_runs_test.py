#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The errors of the mesh that `hybrid accuracy` says a run has, beside the true ones, from the same scene with a far finer mesh.

Usage: coarser_runs_test.py HYBRID_BINARY SOURCE_DIR WORK_DIR [--write doc/accuracy.md]
The first form runs the scenes of SHORT and asks that no history is off by more than is said times a factor of 3. --write runs all and
writes the table of the page (half an hour, most of it Badong); runs that are in WORK_DIR already are kept.
"""
import json
import pathlib
import shutil
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from run_hybrid import must_run  # noqa: E402 (needs the path above)

FACTOR = 3.0

# name: label, Mesh/Numbers, how many times as fine the reference is, sizes that it divides, and what is set besides
SCENES = {
    "bonded_bar": ("bonded_bar, h = 4 m, one coarser mesh", "Width = 8; Height = 320", {"h": 4}, 4, []),
    "bedrock_triangles": ("bedrock_triangles, h = 4 m", "Width = 12; Height = 240", {"h": 4}, 4, []),
    "block_decrement": ("block_decrement, h = 1.25 m", "Width = 10; Height = 25; Block height = 20", {"h": 1.25}, 4, []),
    "coupled_column": ("coupled_column, h = 0.6 m", "Width = 10; Height = 20; Block height = 10", {"h": 0.625}, 4, []),
    "continuum_into_blocks": ("continuum_into_blocks, h = 5 m", "Pit width = 75; Pit depth = 150; Margin = 60; Rock below = 120",
                              {"h": 5, "far": 15}, 3, []),
    "canyon": ("canyon, twice as coarse", "Radius = 100; Half width = 900; Depth = 600", {"h": 100, "canyon": 20}, 4, []),
    "step": ("step", "Height = 50; Angle = 90; Half width = 800; Depth = 500", {"h": 40, "step": 25}, 4, []),
    "badong": ("Badong, h = 4 m, 4 s", "", {"h": 4}, 2, ["Time/End time=4"])}
# and what is set besides in both runs: a step of a 170th of the pulse's period is no error of the mesh
SHORT = {"bedrock_triangles": ["Time/Time step=0.004"], "coupled_column": []}


def scene_file(source, name):
    return source / "parameters" / ("majiagou" if name == "badong" else "verification") / (name + ".prm")


def compute(binary, source, place, name, finer, further):
    """The run with the scene's sizes over `finer`, if it is not there yet."""
    _, numbers, sizes, _, settings = SCENES[name]
    if not (place / "summary.json").exists():
        meshed = "; ".join(filter(None, [numbers, *("Resolution/%s = %.10g" % (size, h / finer) for size, h in sizes.items())]))
        words = [scene_file(source, name), "-s", "Output/Directory=%s" % place]
        for setting in [*settings, *further, "Mesh/Numbers=" + meshed, "Output/Picture interval=0", "Time/Error estimate=one run"]:
            words += ["-s", setting]
        must_run(binary, words, source)


def errors(binary, source, work, name, further=()):
    """{quantity: (said, true)} of the mesh."""
    from hybrid_tools.study import quantities
    from hybrid_tools.study.analysis import distance

    own, fine = work / name, work / (name + "-fine")
    compute(binary, source, own, name, 1, further)
    compute(binary, source, fine, name, SCENES[name][3], further)
    subprocess.run([binary, "accuracy", own, "--mesh"], check=True, cwd=source, stdout=subprocess.DEVNULL)
    said = json.loads((own / "accuracy/accuracy.json").read_text(encoding="utf-8"))
    end = min(quantities.end_of(str(place)) for place in (own, fine))
    found, reference = quantities.read(str(own), end), quantities.read(str(fine), end)
    return {row["quantity"]: (row["error of the mesh"], distance(found[row["quantity"]], reference[row["quantity"]]))
            for row in said["rows"] if row["error of the mesh"] is not None and row["quantity"] in reference}


def is_history(name):
    return name.split("/")[-1] in ("displacement", "velocity")


def counts(pairs):
    ratios = [said / true for said, true in pairs if true > 0]
    below, above = sum(r < 1 / FACTOR for r in ratios), sum(r > FACTOR for r in ratios)
    return "%d / %d / %d" % (len(ratios) - below - above, below, above)


def median(pairs):
    ratios = sorted(said / true for said, true in pairs if true > 0)
    return "%.2g" % (0.5 * (ratios[(len(ratios) - 1) // 2] + ratios[len(ratios) // 2])) if ratios else "-"


def percent(values):
    return "%.2g" % (100 * max(values, default=0.0))


def row(name, found):
    histories = [pair for quantity, pair in found.items() if is_history(quantity)]
    numbers = [pair for quantity, pair in found.items() if not is_history(quantity)]
    said, true = ([percent([pair[i] for pair in part]) for part in (histories, numbers)] for i in (0, 1))
    return "| %s | %s (%s) | %s (%s) | %s | %s | %s, %s |" % (SCENES[name][0], *said, *true, counts(histories), counts(numbers),
                                                             median(histories), median(numbers))


def short(binary, source, work):
    bad = 0
    for name, further in SHORT.items():
        for quantity, (said, true) in errors(binary, source, work, name, further).items():
            if is_history(quantity):
                good = true <= FACTOR * said
                print("%s %s, %s: said %.2g %%, true %.2g %%" % ("ok   " if good else "FAIL ", name, quantity, 100 * said, 100 * true))
                bad += not good
    sys.exit(1 if bad else 0)


def main():
    binary, source, work = sys.argv[1], pathlib.Path(sys.argv[2]).resolve(), pathlib.Path(sys.argv[3]).resolve()
    sys.path.insert(0, str(source / "src/tools"))
    if "--write" not in sys.argv:
        shutil.rmtree(work, ignore_errors=True)  # of an earlier program
    work.mkdir(parents=True, exist_ok=True)
    if "--write" not in sys.argv:
        short(binary, source, work)
    from hybrid_tools.marked_page import put

    rows = [row(name, errors(binary, source, work, name)) for name in SCENES]
    head = "| scene | said, largest: histories (numbers) [%] | true, largest [%] | histories: within 3 / below a third / above 3 | numbers | median |"
    put(sys.argv[sys.argv.index("--write") + 1], "<!-- coarser runs -->", "<!-- end of coarser runs -->",
        "\n".join([head, "|---|---|---|---|---|---|", *rows]) + "\n")


if __name__ == "__main__":
    main()
