#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The same scene with one and with two threads, and run twice, gives the same bits in run.h5; so do loose blocks that
begin to slide, with sparse factors of which threads share subtrees.

Usage: determinism_test.py HYBRID_BINARY SCENE.prm LOOSE.prm WORK_DIR
"""
import os
import pathlib
import shutil
import subprocess
import sys

import h5py
import numpy

EXCEPT = {"steps/wall_time"}
ONE_RUN = ["Time/Error estimate=one run", "Mesh/Error estimate=one run"]  # further ones change nothing in run.h5

# A quiet scene, one whose mass breaks and slides, and one with so many blocks that threads share all loops
# (is_worth_sharing), a part of which is thrown off.
BREAKS = ["Materials/rock/Cohesion=40e3", "Materials/rock/Tensile strength=5e3", "Motion/Peak=60"]
MANY = ["Mesh/Numbers=Width = 640; Height = 15; Block height = 10; Resolution/h = 2.5", "Monitors/Points=top: 5, 15; interface: 5, 5; base: 5, 0",
        "Blocks/Initial velocities=half: 0, 40, 5, 15, 3, 2, 0", "Continuum/Degree=1", "Time/Time step=0.001", "Time/End time=0.03"]
VARIANTS = {"bonded": [], "broken": BREAKS, "many": BREAKS + MANY}


def run(binary, scene, directory, threads, overrides):
    """Data sets of run.h5 by name."""
    words = [binary, scene, "-s", f"Output/Directory={directory}", "-s", f"Parallel/Threads={threads}"]
    for override in [*ONE_RUN, *overrides]:
        words += ["-s", override]
    environment = dict(os.environ)
    environment.pop("OMP_NUM_THREADS", None)
    subprocess.run(words, check=True, stdout=subprocess.DEVNULL, env=environment)
    return read(directory)


def read(directory):
    """Data sets of run.h5 by name."""
    data = {}
    with h5py.File(directory / "run.h5", "r") as file:
        file.visititems(lambda name, item: data.update({name: item[()]}) if isinstance(item, h5py.Dataset) else None)
    return data


def differences(one, other):
    """Names of data sets that are not equal to the bit."""
    if one.keys() != other.keys():
        return sorted(one.keys() ^ other.keys())
    return [name for name in sorted(one) if name not in EXCEPT and
            (one[name].shape != other[name].shape or one[name].tobytes() != other[name].tobytes())]


def loose_failures(binary, scene, work):
    """Number of data sets of loose blocks that differ with the number of threads; 1 if nothing was solved."""
    runs = {threads: run(binary, scene, work / f"loose_{threads}", threads, ["Time/End time=0.002"]) for threads in (1, 2, 3)}
    iterations = int(runs[1]["steps/iterations"].sum())
    print(f"loose: {len(runs[1])} data sets, {iterations} iterations")
    failed = 0 if iterations > 10 else 1
    for threads in (2, 3):
        for key in differences(runs[1], runs[threads]):
            print(f"loose: {key} differs with {threads} threads")
            failed += 1
    return failed


def main():
    binary, scene, loose, work = sys.argv[1], sys.argv[2], sys.argv[3], pathlib.Path(sys.argv[4])
    shutil.rmtree(work, ignore_errors=True)
    failed = loose_failures(binary, loose, work)
    for name, overrides in VARIANTS.items():
        runs = [run(binary, scene, work / f"{name}_{i}", threads, overrides) for i, threads in enumerate([1, 2, 2])]
        moved = max(numpy.abs(values).max() for key, values in runs[0].items()
                    if key.startswith("monitors/top/displacement"))
        cut = numpy.count_nonzero(numpy.diff(runs[0]["steps/dt"]))
        joints = runs[0]["joints/failure_time"].size
        print(f"{name}: {len(runs[0])} data sets, {runs[0]['time'].size} steps, {cut} changes of the step, "
              f"top moved {moved:.3g} m, {joints} joints failed")
        if not moved > 0.:
            print(f"{name}: nothing moved")
            failed += 1
        if name != "bonded" and joints == 0:
            print(f"{name}: nothing broke")
            failed += 1
        for other, what in ((runs[1], "two threads"), (runs[2], "a second run")):
            names = differences(runs[0], other)
            failed += len(names)
            for key in names:
                print(f"{name}: {key} differs with {what}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
