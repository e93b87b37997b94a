#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The surface of the bedrock as a band and with all entries: the same histories; the same bits on two processes of two
threads and when resumed; automatic takes the band where the surface is long.

Usage: surface_stiffness_test.py HYBRID_BINARY SOURCE_DIR WORK_DIR
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

import numpy

from determinism_test import BREAKS, differences, read

BINARY, ROOT, WORK = sys.argv[1], pathlib.Path(sys.argv[2]) / "parameters", pathlib.Path(sys.argv[3]).resolve()
COLUMN = ROOT / "verification/coupled_column.prm"
PLANES = ["Bedding planes/Strength=Mohr-Coulomb", "Bedding planes/Friction angle=10"]
# A mass that stays whole; one that slides all along a surface much longer than the band is wide; Badong; planes that slip. Updates are
# solved to the end, else what the tolerance leaves is what differs: 3e-7 of Badong's accelerations, as with a Rayleigh mass of 1e-13.
EXACT = ["Blocks/Tolerance=1e-11"]
SCENES = {
    "column": (COLUMN, []),
    "sliding": (COLUMN, [*BREAKS, "Mesh/Numbers=Width = 640; Height = 20; Block height = 10; Resolution/h = 2.5", "Motion/Frequency=12",
                         "Motion/Peak=120", "Time/End time=0.154"]),
    "badong": (ROOT / "majiagou/badong.prm", ["Mesh/Numbers=Resolution/h = 8", "Time/End time=0.5"]),
    "slipping planes": (ROOT / "majiagou/badong.prm", ["Mesh/Numbers=Resolution/h = 20", "Continuum/Degree=1", "Time/End time=0.1", *PLANES]),
}
ONE_RUN = ["Time/Error estimate=one run", "Mesh/Error estimate=one run"]
LARGEST = 1e-8  # of the peak
# Longer than that the sliding mass flutters, and motions that differ by 1e-12 at the start do not stay near: bits alone can be compared.
ENVIRONMENT = dict(os.environ, OPENBLAS_NUM_THREADS="1", OMP_NUM_THREADS="1")

complaints = []


def require(condition, text):
    if not condition:
        complaints.append(text)
        print("FAILED:", text)


def run(name, scene, overrides, form, processes=1):
    """Directory of a run."""
    directory = WORK / name.replace(" ", "_")
    words = [BINARY, str(scene), "--force"]
    if processes > 1:
        words = [os.environ["HYBRID_MPIEXEC"], "-n", str(processes), "--oversubscribe", "--allow-run-as-root",
                 "--mca", "mpi_yield_when_idle", "1", *words]
    for override in ["Output/Picture interval=0", *overrides, *ONE_RUN, f"Continuum/Surface stiffness={form}",
                     f"Output/Directory={directory}"]:
        words += ["-s", override]
    result = subprocess.run(words, capture_output=True, text=True, env=ENVIRONMENT, check=False)
    require(result.returncode == 0, f"{name}: exit code {result.returncode}: {result.stderr[-300:]}")
    require(result.stdout.count("Finished") == 1 and "the first one alone" not in result.stdout, f"{name}: all compute, one speaks")
    return directory


def largest_difference(one, other):
    """Of histories over the largest value of their kind - displacement, energy - [-], and where."""
    kinds = {name: name.split("/")[-1] if name.startswith("monitors/") else "energy" for name in one
             if name.startswith(("monitors/", "energy/")) and "residual" not in name and "time" not in name and one[name].dtype.kind == "f"}
    peaks = {}
    for name, kind in kinds.items():
        peaks[kind] = max(peaks.get(kind, 0.), numpy.abs(one[name]).max(initial=0.))
    worst = [(numpy.abs(one[name] - other[name]).max() / peaks[kind], name) for name, kind in kinds.items()
             if peaks[kind] > 0. and one[name].shape == other[name].shape]
    require(len(worst) > 3, "there are histories")
    return max(worst)


def check_histories():
    for name, (scene, overrides) in SCENES.items():
        dense, banded = (run(f"{name} {form}", scene, overrides + EXACT, form) for form in ("dense", "banded"))
        one, other = read(dense), read(banded)
        different = one["time"].shape != other["time"].shape or (one["time"] != other["time"]).any()
        require(not different, f"{name}: the same steps")
        if different:
            continue
        worst, where = largest_difference(one, other)
        residual = [json.loads((d / "summary.json").read_text(encoding="utf-8"))["energy_residual"] for d in (dense, banded)]
        print(f"{name}: {worst:.2g} of the peak off ({where}); energy residual {residual[0]:.2g} and {residual[1]:.2g}")
        require(worst < LARGEST, f"{name}: histories differ by {worst:.2g} of the peak in {where}")
    loss = read(WORK / "slipping_planes_banded")["energy/bedding_loss"]
    require(loss[-1] > loss[0], "slipping planes: planes slip while the rock is shaken")
    slip = json.loads((WORK / "sliding_banded/summary.json").read_text(encoding="utf-8"))["slip_m"]
    require(slip["part_slipped"] > 0.9, f"sliding: the mass slides, {slip['part_slipped']} of it by more than 1 mm")


def check_bits():
    """On two processes, which share the blocks, of two threads, and resumed: the same bits."""
    scene, overrides = SCENES["sliding"][0], SCENES["sliding"][1] + EXACT
    whole = read(WORK / "sliding_banded")
    names = differences(whole, read(run("two processes", scene, [*overrides, "Parallel/Threads=2"], "banded", 2)))
    require(not names, f"two processes of two threads: the same bits, but for {names[:4]}")
    part = run("stopped", scene, [*overrides, "Time/End time=0.14", "Checkpoint/Step interval=20"], "banded")
    subprocess.run([BINARY, "--resume", str(part), "-s", "Time/End time=0.154"], check=True, stdout=subprocess.DEVNULL, env=ENVIRONMENT)
    names = [n for n in differences(whole, read(part)) if n.startswith(("monitors/", "energy/", "time"))]
    require(not names, f"resumed: the same bits, but for {names[:4]}")


def check_choice():
    """The card tells which form it is: all entries of a short surface, a band of a long one."""
    def is_banded(width, form):
        card = subprocess.run([BINARY, "--check", str(COLUMN), "-s", f"Continuum/Surface stiffness={form}", "-s", "Mesh/Numbers=Width = "
                               f"{width}; Height = 20; Block height = 10; Resolution/h = 10"], check=True, capture_output=True, text=True).stdout
        unknowns = int(re.search(r"(\d+) on the contact surface", card).group(1))
        return unknowns, "on the contact surface (stiffness banded)" in card
    for width, form, expected in ((100, "automatic", False), (100, "banded", True), (20000, "automatic", True), (20000, "dense", False)):
        unknowns, banded = is_banded(width, form)
        require(banded == expected, f"{unknowns} unknowns of the surface, {form}: banded {expected}, not {banded}")


def main():
    shutil.rmtree(WORK, ignore_errors=True)
    check_choice()
    check_histories()
    check_bits()
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
