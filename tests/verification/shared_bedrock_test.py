#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Blocks on a bedrock by conjugate gradients, which processes share out: the motion of the factor on 1, 2 and 4 of them, equal bits
on equal numbers, stopped and resumed by another number, and what is refused.

Usage: shared_bedrock_test.py HYBRID_BINARY SOURCE_DIR WORK_DIR [--long]     --long: Badong with h = 8 m; four processes go on, too
"""
import concurrent.futures
import json
import os
import shutil
import subprocess
import sys

import numpy

from determinism_test import BREAKS, differences, read
from surface_stiffness_test import BINARY, COLUMN, ENVIRONMENT, EXACT, LARGEST, ROOT, WORK, complaints, largest_difference, require, run

sys.path.insert(0, str(ROOT.parent / "src/tools"))
from hybrid_run.pictures import Picture, Pictures  # noqa: E402

ITERATED = "Continuum/Linear solver=conjugate gradients"
FACTOR = "Continuum/Linear solver=factor"
BADONG = ROOT / "majiagou/badong.prm"
# 16 cells under a mass one half of which is thrown off, so that joints tear and blocks slide at once, while a motion comes in obliquely.
THROWN = [*BREAKS, *EXACT, "Motion/Angle=30", "Mesh/Numbers=Width = 40; Height = 20; Block height = 10; Resolution/h = 5",
          "Blocks/Initial velocities=half: 0, 20, 10, 20, 3, 2, 0", "Time/End time=0.03"]
LEVEL = WORK / "level.csv"
SCENES = {
    "damped": (COLUMN, [*THROWN, "Maxwell damping/Bedrock ratio=0.03", "Continuum/Rayleigh mass=0.3", "Continuum/Sides=free field",
                          "Continuum/Boundary springs=true", "Output/Picture interval=0.03"], (2, 4)),
    "cut water": (COLUMN, [*THROWN, "Time/Maximum displacement ratio=0.003", f"Water/Level file={LEVEL}", "Water/Method=pressures"], (2,)),
    "rigid": (COLUMN, [*THROWN, "Continuum/Base=rigid", "Continuum/Rayleigh stiffness=1e-4"], (2,)),
    "sliding": (COLUMN, [*BREAKS, *EXACT, "Mesh/Numbers=Width = 80; Height = 20; Block height = 10; Resolution/h = 5", "Time/End time=0.31"], (1,)),
    "badong": (BADONG, [*EXACT, "Mesh/Numbers=Resolution/h = 20", "Continuum/Degree=1", "Time/End time=0.2"], (1,)),
}
LONG_SCENES = {"badong 8": (BADONG, [*EXACT, "Mesh/Numbers=Resolution/h = 8", "Time/End time=0.2"], (1,))}
QUIET = ["Output/Audit interval=0.01"]


def compute(name, scene, overrides, processes=1, solver=ITERATED):
    return run(name, scene, [*overrides, *QUIET, solver], "automatic", processes)


def check_peaks(known, found, what):
    """Of all nodes of the bedrock and of all blocks."""
    names = [n for n in known if n.startswith("fields/") and "peak_" in n and numpy.abs(known[n]).max(initial=0.) > 0.]
    require({n.split("/")[1] for n in names} == {"nodes", "blocks"}, f"{what}: there are peaks of nodes and blocks, {names}")
    for name in names:
        worst = numpy.abs(known[name] - found[name]).max() / numpy.abs(known[name]).max()
        require(worst < LARGEST, f"{what}: {name} differ by {worst:.2g} of the largest")


def check_pictures_of_peaks(alone, together):
    """Nodes and blocks in one file, or in two."""
    known, nodes, blocks = Picture(alone / "peaks.vtu"), Picture(together / "peaks.vtu"), Picture(together / "peaks_blocks.vtu")
    require(len(known.points) == len(nodes.points) + len(blocks.points), "peaks.vtu and peaks_blocks.vtu have all nodes and corners of blocks")
    for name in known.fields:
        both = numpy.concatenate([nodes.fields[name], blocks.fields[name]])
        largest = numpy.abs(known.fields[name]).max()
        require(numpy.abs(both - known.fields[name]).max() <= 1e-6 * largest, f"peaks.vtu: {name} differs")  # single precision


def directory_of(name, which):
    return WORK / f"{name} {which}".replace(" ", "_")


def check_motion(scenes):
    """The factor's, on any number of processes."""
    alone = [(name, "factor", FACTOR) for name in scenes] + [(name, "1", ITERATED) for name, scene in scenes.items() if 1 in scene[2]]
    with concurrent.futures.ThreadPoolExecutor(2) as pool:  # runs of one process leave half of two cores alone
        list(pool.map(lambda job: compute(f"{job[0]} {job[1]}", *scenes[job[0]][:2], 1, job[2]), alone))
    for name, (scene, overrides, counts) in scenes.items():
        known = read(directory_of(name, "factor"))
        for processes in counts:
            found = read(compute(f"{name} {processes}", scene, overrides, processes) if processes > 1 else directory_of(name, 1))
            require(known["time"].shape == found["time"].shape, f"{name}, {processes} processes: the same steps")
            if known["time"].shape != found["time"].shape:
                continue
            worst, where = largest_difference(known, found)
            print(f"{name}: factor and {processes} iterating processes differ by {worst:.2g} of the peak ({where})")
            require(worst < LARGEST, f"{name}: factor and {processes} iterating processes differ by {worst:.2g} in {where}")
            check_peaks(known, found, f"{name}, {processes} processes")


def check_effects():
    """What the scenes are for."""
    told = {name: json.loads((directory_of(name, counts[0]) / "summary.json").read_text(encoding="utf-8")) for name, (_, _, counts) in SCENES.items()}
    require(told["damped"]["joints"]["tensile"] > 0, "joints tear")
    require(told["cut water"]["cuts"] > 0, "steps are cut")
    require(told["sliding"]["slip_m"]["part_slipped"] > 0.9, "a mass slides as a whole")


def static_stress(directory):
    pictures = Pictures(str(directory), "continuum")
    return pictures[len(pictures) - 1].fields["static stress xx, yy, xy [Pa]"]


def check_rest():
    """The static stress under a mass."""
    known = static_stress(WORK / "damped_factor")
    peak = numpy.abs(known).max()
    for processes in SCENES["damped"][2]:
        worst = numpy.abs(static_stress(WORK / f"damped_{processes}") - known).max() / peak
        print(f"static stress under the mass, {processes} processes: {worst:.2g} of the largest off that of the factor")
        require(peak > 1e4 and worst < 1e-7, f"static stress: {worst:.2g} of the largest, {peak:.3g} Pa, off")


def resumed(stopped, processes):
    """A run that was stopped on the way, which so many end."""
    part = WORK / f"resumed_by_{processes}"
    shutil.copytree(stopped, part)
    launcher = [os.environ["HYBRID_MPIEXEC"], "-n", str(processes), "--oversubscribe", "--allow-run-as-root", "--mca", "mpi_yield_when_idle", "1"]
    subprocess.run([*launcher, BINARY, "--resume", str(part), "-s", "Time/End time=0.03"], check=True, stdout=subprocess.DEVNULL, env=ENVIRONMENT)
    return read(part)


def check_resume():
    """As many go on with the same bits, another number to round-off."""
    scene, overrides, _ = SCENES["damped"]
    whole = read(WORK / "damped_2")
    again = read(compute("damped again", scene, overrides, 2))
    require(not differences(whole, again), "two processes twice: the same bits")
    stopped = compute("stopped", scene, [*overrides, "Time/End time=0.016", "Checkpoint/Step interval=4"], 2)
    for processes in (2, 1, 4) if "--long" in sys.argv else (2, 1):
        found = resumed(stopped, processes)
        if processes == 2:
            names = [n for n in differences(whole, found) if n.startswith(("monitors/", "energy/", "time"))]
            require(not names, f"resumed by as many: the same bits, but for {names[:4]}")
        worst, where = largest_difference(whole, found)
        print(f"two processes, resumed by {processes}: {worst:.2g} of the peak off ({where})")
        require(worst < LARGEST, f"resumed by {processes}: {worst:.2g} of the peak off in {where}")


def check_refusals():
    wrong = {
        "bedding planes may slip": (BADONG, ["Bedding planes/Strength=Mohr-Coulomb", "Mesh/Numbers=Resolution/h = 8"]),
        "dense is for a factor": (COLUMN, ["Continuum/Surface stiffness=dense"]),
        "set a shorter Time/Time step": (COLUMN, ["Mesh/Numbers=Width = 8000; Height = 20; Block height = 10; Resolution/h = 2.5",
                                                  "Time/Time step=0.5", "Time/End time=0.5"]),
    }
    for reason, (scene, overrides) in wrong.items():
        words = [BINARY, "--check", str(scene)]
        for override in [*overrides, ITERATED]:
            words += ["-s", override]
        result = subprocess.run(words, capture_output=True, text=True, env=ENVIRONMENT, check=False)
        require(result.returncode == 2 and reason in result.stderr, f"'{reason}' is said: {result.returncode}, {result.stderr[-300:]}")


def main():
    shutil.rmtree(WORK, ignore_errors=True)
    WORK.mkdir(parents=True)
    LEVEL.write_text("time [s],level [m]\n0,12\n0.3,14\n", encoding="utf-8")
    if "--long" in sys.argv:
        check_motion(LONG_SCENES)
    check_refusals()
    check_motion(SCENES)
    check_pictures_of_peaks(WORK / "damped_factor", WORK / "damped_2")
    check_effects()
    check_rest()
    check_resume()
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
