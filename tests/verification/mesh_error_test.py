#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The error of its mesh that a run says it has (summary.json, mesh_error), beside the true one, from the same scene with smaller cells and
blocks.

True error as in probable_error_test.py. What the finer mesh has left itself (1/r^1.5 of it with blocks, 1/r^2 without, r times as fine) is added.

Usage: mesh_error_test.py HYBRID_BINARY SOURCE_DIR WORK_DIR [--write doc/accuracy.md | --write-others doc/accuracy.md]
The first form runs the scenes of SHORT, asks for a factor of 3 and for a row of each scene in the page. --write runs all and writes the
table of the page (ten minutes); runs that are in WORK_DIR already are kept. --write-others does so with mesh_scenes.py, in the sizes that are
given there and in twice these (ten minutes).
"""
import json
import pathlib
import re
import shutil
import sys

import mesh_scenes
import numpy as np
import probable_error_test as steps
from run_hybrid import must_run

SHORT = ("soft_layer_blocks", "wave_packet")
SHORT_OTHERS = ("step of one cell", "four close planes slip")  # of mesh_scenes.py
# name: how many times as fine the reference is. Meshes of blocks differ by chance, too, so three times is too few for a small error of theirs.
SCENES = {"wave_packet": 3, "free_field": 3, "constant_q_layer": 3, "opening_plane": 3, "oblique_joints": 2, "step": 2, "canyon": 2, "lamb": 2,
          "bonded_bar": 6, "bedrock_triangles": 3, "block_decrement": 6, "constant_q_blocks": 6, "time_order": 6, "coupled_column": 6,
          "soft_layer_blocks": 3, "continuum_into_blocks": 2, "lasting_load": 6, "bonded_mass": 2, "brittle_release": 6, "shakedown": 6,
          "softening_reset": 6, "badong": 2}
OTHERS_REFERENCE = 3  # of mesh_scenes.py
SETTINGS = {"badong": ["Time/End time=4"]}
REFERENCE = {"step": ["Mesh/Corner levels=4"]}  # besides: half the size is not enough at its toe
SIZES = {"badong": "Resolution/h = 8"}


def meshed(source, name, finer):
    text = SIZES.get(name) or re.search(r"set Numbers\s*= ([^#\n]*)", steps.scene_file(source, name).read_text()).group(1)
    return "Mesh/Numbers=" + finer_numbers(text, finer)


def compute(binary, source, work, name, finer):
    """The run with sizes over `finer`, if it is not there yet. @return its directory."""
    place = work / ("%s-%g" % (name, finer))
    if not (place / "summary.json").exists():
        words = [steps.scene_file(source, name), "-s", "Output/Directory=%s" % place]
        for setting in ["Output/Picture interval=0", "Time/Error estimate=one run", meshed(source, name, finer), *SETTINGS.get(name, []),
                        *([steps.ONE_MESH, *REFERENCE.get(name, [])] if finer > 1 else [])]:
            words += ["-s", setting]
        must_run(binary, words, source)
    return place


def compare(binary, source, work, name):
    """(true errors, what the run says; None: nothing; summary.json's mesh_error, blocks)"""
    finer = SCENES[name]
    own, reference = (compute(binary, source, work, name, f) for f in (1, finer))
    true, summary = beside(own, reference, finer, steps.own_step(steps.scene_file(source, name)))
    said = summary["mesh_error"]
    return true, [said["mesh"][q]["part_of_peak"] for q in steps.QUANTITIES] if said["estimated"] else None, said, int(summary["blocks"])


def finer_numbers(text, finer):
    return re.sub(r"(Resolution/\w+ = )([0-9.]+)", lambda found: "%s%.10g" % (found.group(1), float(found.group(2)) / finer), text)


def compute_other(binary, source, work, name, finer):
    """As compute(), of mesh_scenes.py."""
    place = work / ("%s-%g" % (re.sub(r"\W+", "_", name), finer))
    if not (place / "summary.json").exists():
        words = [mesh_scenes.scene_file(binary, source, work, name), "-s", "Output/Directory=%s" % place]
        for setting in ["Output/Picture interval=0", "Time/Error estimate=one run", "Mesh/Numbers=" + finer_numbers(mesh_scenes.SCENES[name][1], finer),
                        *mesh_scenes.settings(source, name), *([steps.ONE_MESH] if finer > 1 else []),
                        *(mesh_scenes.REFERENCE.get(name, []) if finer == OTHERS_REFERENCE else [])]:
            words += ["-s", setting]
        must_run(binary, words, source)
    return place


def beside(own, reference, finer, step):
    """(true errors, summary.json) of a run, by one with a mesh so many times as fine."""
    summary = json.loads((own / "summary.json").read_text())
    until = min((t for t in (summary["mesh_error"].get("until_s"), steps.failure_time(reference)) if t), default=None)
    return steps.true_errors(own, reference, finer, 1.5 if summary["blocks"] else 2, until - step if until else None), summary


def label(name, blocks, meshes):
    return "%s%s%s" % (steps.LABELS.get(name, name), "" if blocks else ", no blocks", "" if meshes == 2 else ", one coarser mesh")


def misplaced(page):
    """Rows of the page's table that are of no scene of SCENES, and scenes that have none."""
    table = page.read_text().split("<!-- mesh lines -->")[1].split("<!-- end -->")[0]
    rows = set(re.findall(r"^\| (.*?) \| [0-9.]+ \|", table, re.MULTILINE))
    labels = {name: {label(name, blocks, meshes) for blocks in (0, 1) for meshes in (1, 2)} for name in SCENES}
    return sorted(rows - set().union(*labels.values())) + sorted(name for name, names in labels.items() if not names & rows)


def is_warned_of(directory):
    """Whether the run says that its mesh does not resolve the motion."""
    return re.search(r"warning: the (continuum|sliding mass) resolves", (directory / "log.txt").read_text()) is not None


def say(found):
    """{what a run is: its ratios of told over true}"""
    for what, ratios in found.items():
        if not ratios:
            continue
        values = np.array(ratios)
        print("%s: %d ratios, %d too small, %d too large, %.2g to %.2g" % (what, len(values), (values < 1 / steps.FACTOR).sum(),
              (values > steps.FACTOR).sum(), values.min(), values.max()))


def ratios_of(told, true):
    return np.maximum(told, steps.FLOOR) / np.maximum(true, steps.FLOOR)


def write(binary, source, work, page):
    rows, found = [], {"the motion is resolved": [], "it is not": []}
    for name in SCENES:
        true, estimated, said, blocks = compare(binary, source, work, name)
        if estimated is None:
            sys.exit("%s: not estimated: %s" % (name, said["reason"]))
        size = min(float(h) for h in re.findall(r"Resolution/\w+ = ([0-9.]+)", meshed(source, name, 1)))
        rows.append(steps.row(label(name, blocks, said["coarser_meshes"]), size, true, estimated))
        found["it is not" if is_warned_of(work / ("%s-1" % name)) else "the motion is resolved"] += list(ratios_of(estimated, true))
    steps.put(page, ((rows, "mesh lines"),))
    say(found)


def told_over_true(binary, source, work, name, finer):
    """(true errors, what is told over them, what the run is) in a mesh so many times as fine; the ratios are None where nothing is told."""
    reference = compute_other(binary, source, work, name, OTHERS_REFERENCE)
    own = compute_other(binary, source, work, name, finer)
    summary = json.loads((own / "summary.json").read_text())
    true, summary = beside(own, reference, OTHERS_REFERENCE / finer, summary["simulated_time_s"] / summary["steps"])
    said = summary["mesh_error"]
    if not said["estimated"]:
        return true, None, ()
    told = [said["mesh"][q]["part_of_peak"] for q in steps.QUANTITIES]
    return true, ratios_of(told, true), ("an order is seen" if said["order_is_seen"] else "none is",
                                         "the motion is not resolved" if is_warned_of(own) else "it is resolved")


def bold(ratios):
    if ratios is None:
        return "the next mesh is hardly coarser"
    return ", ".join("%.2g" % r if 1 / steps.FACTOR <= r <= steps.FACTOR else "**%.2g**" % r for r in ratios)


def write_others(binary, source, work, page):
    rows, found = [], {}
    for name in mesh_scenes.SCENES:
        parts = [told_over_true(binary, source, work, name, finer) for finer in (1, 0.5)]
        rows.append("| %s | %s | %s | %s |" % (name, steps.percent(parts[0][0]), *(bold(ratios) for _, ratios, _ in parts)))
        for _, ratios, kinds in parts:
            for kind in kinds:
                found.setdefault(kind, []).extend(ratios)
        print(rows[-1], flush=True)
    steps.put(page, ((rows, "other meshes"),))
    say(found)


def main():
    binary, source, work = sys.argv[1], pathlib.Path(sys.argv[2]).resolve(), pathlib.Path(sys.argv[3]).resolve()
    sys.path.insert(0, str(source / "src/tools"))
    if "--write" not in sys.argv and "--write-others" not in sys.argv:
        shutil.rmtree(work, ignore_errors=True)  # of an earlier program
    work.mkdir(parents=True, exist_ok=True)
    if "--write-others" in sys.argv:
        write_others(binary, source, work, pathlib.Path(sys.argv[sys.argv.index("--write-others") + 1]))
        return
    if "--write" in sys.argv:
        write(binary, source, work, pathlib.Path(sys.argv[sys.argv.index("--write") + 1]))
        return
    if misplaced(source / "doc/accuracy.md"):
        sys.exit("rows of no scene, or scenes without a row: " + ", ".join(misplaced(source / "doc/accuracy.md")))
    good = True
    for name in SHORT:
        true, estimated, said, _ = compare(binary, source, work, name)
        if estimated is None:
            sys.exit("%s: not estimated: %s" % (name, said["reason"]))
        good = steps.judge(name, "mesh", true, estimated) and good
    for name in SHORT_OTHERS:
        true, ratios, _ = told_over_true(binary, source, work, name, 1)
        if ratios is None:
            sys.exit("%s: not estimated" % name)
        good = steps.judge(name, "mesh", true, ratios * true) and good
    sys.exit(0 if good else 1)


if __name__ == "__main__":
    main()
