#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes under mpirun: the same answers on any number of processes, and nothing is lost when one ends.

Usage: processes_test.py HYBRID_BINARY PART WORK_DIR     PART: equal, solvers, faults, long
"""
import json
import os
import resource
import shutil
import signal
import subprocess
import sys
import time

import h5py
import numpy

from processes import (ALONE, BINARY, ENVIRONMENT, ERRORS, ROOT, WORK, children, main, require, require_same_bits, require_same_errors, resume, run, stopped,
                       two_at_once, words_of)
from runs_alike import arrays_by_vtk, largest_difference, series, unlike

sys.path.insert(0, str(ROOT / "src/tools"))
from hybrid_run.pictures import Pictures  # noqa: E402

EXPLICIT = "Continuum/Time integrator=explicit"
SMALL_LAMB = [EXPLICIT, "Mesh/Numbers=Width = 400; Height = 300; Resolution/h = 25", "Time/End time=0.3",
              "Point loads/Forces=force: 100, 300, 0, -1e10", "Monitors/Points=a: 200, 300; b: 310, 120",
              "Output/Picture interval=0.1", "Output/Audit interval=0.01", "Gravity/Acceleration=9.81", "Checkpoint/Step interval=50"]
# Planes that reach free-field sides.
ELASTIC = ["Bedding planes/Names=bedding_1, bedding_2", "Bedding planes/Strength=elastic",
           "Mesh/Numbers=Length = 150; Width = 100; Planes = 2; First plane = 60; Spacing = 40; Resolution/h = 10"]
DAMPED = ["Continuum/Rayleigh mass=0.3", "Maxwell damping/Bedrock ratio=0.03", "Continuum/Boundary springs=true"]
HEAVY = ["Mesh/Numbers=Width = 1400; Base height = 700; Middle height = 50; Top height = 500; Resolution/h = 50", "Continuum/Base=fixed",
         "Continuum/Sides=roller", "Gravity/Acceleration=9.81", "Gravity/Horizontal coefficient=0.1", "Output/Picture interval=0.1"]
# Point loads, free field without monitors, a mesh of cells of all sizes, an initial wave and weight on elastic planes between fixed sides, planes that reach
# free-field sides, a rigid base, damping of both kinds.
SHARED = {
    "lamb": ("lamb", SMALL_LAMB),
    "free_field": ("free_field", [EXPLICIT, "Time/End time=0.8", *DAMPED, "Monitors/Points=", "Output/Picture interval=0.4", "Checkpoint/Step interval=50"]),
    "canyon": ("canyon", [EXPLICIT, "Mesh/Numbers=Radius = 100; Half width = 900; Depth = 600; Resolution/h = 50; Resolution/canyon = 20", "Time/End time=0.8"]),
    "joints": ("oblique_joints", [EXPLICIT, *HEAVY, "Time/End time=0.4", "Checkpoint/Step interval=50"]),
    "columns": ("column_planes", [EXPLICIT, *ELASTIC, "Time/End time=1", "Continuum/Rayleigh mass=0.3"]),
    "rigid": ("free_field", [EXPLICIT, "Time/End time=0.5", "Continuum/Base=rigid", "Continuum/Rayleigh stiffness=0"]),
}
# With pictures that are compared, too.
PICTURED = ("lamb", "joints", "free_field")
ITERATED = "Continuum/Linear solver=conjugate gradients"
FACTOR = "Continuum/Linear solver=factor"
# Implicit steps without a matrix; the factor gives the same motion.
IMPLICIT = {
    "lamb": ("lamb", [o for o in SMALL_LAMB if o != EXPLICIT] + ["Time/Time step=0.002"]),
    "free_field": ("free_field", ["Time/End time=0.3", *DAMPED]),
    "rigid": ("free_field", ["Time/End time=0.3", "Continuum/Base=rigid", "Time/Scheme=filtered"]),
    "joints": ("oblique_joints", [HEAVY[0], "Time/End time=0.2"]),
    "columns": ("column_planes", [*ELASTIC, "Time/End time=0.5", "Continuum/Rayleigh stiffness=1e-4"]),
}


def static_stress(directory):
    """Of the last picture [Pa], in single precision."""
    pictures = Pictures(str(directory), "continuum")
    return pictures[len(pictures) - 1].fields["static stress xx, yy, xy [Pa]"]


def check_static_stress():
    """Explicit scenes find it without a matrix, shared out; the factor of an implicit one knows it."""
    known = WORK / "rest"
    run(1, words_of("oblique_joints", known, [*HEAVY, "Time/End time=0.0025"]))
    peak = numpy.abs(static_stress(known)).max()
    require(peak > 1e7, f"the rock has weight: {peak:.3g} Pa")
    for processes in (1, 2, 4):
        worst = numpy.abs(static_stress(WORK / f"joints_{processes}") - static_stress(known)).max() / peak
        print(f"static stress, {processes} processes: {worst:.2g} of the largest off that of the factor")
        require(worst < 1e-7, f"static stress, {processes} processes: {worst:.2g} of the largest off")


def check_solvers():
    """Conjugate gradients on 2 processes, with Lamb's load on 1 and 4, too, and the factor have the same histories."""
    two_at_once(lambda name: run(1, words_of(IMPLICIT[name][0], WORK / f"factor_{name}", [*IMPLICIT[name][1], FACTOR])), IMPLICIT)
    for name, (scene, overrides) in IMPLICIT.items():
        known = WORK / f"factor_{name}"
        for processes in (1, 2, 4) if name == "lamb" else (2,):
            directory = WORK / f"iterated_{name}_{processes}"
            result = run(processes, words_of(scene, directory, [*overrides, ITERATED]))
            require(result.stdout.count("Finished") == 1 and ALONE not in result.stdout, f"iterated {name}, {processes} processes: all compute")
            for prefix in ("monitors/", "energy/", "fields/"):
                worst, where = largest_difference(series(known), series(directory), prefix)
                print(f"implicit {name}: factor and {processes} iterating processes differ by {worst:.2g} of the peak ({where})")
                require(worst < 1e-8, f"implicit {name}: factor and {processes} iterating processes differ by {worst:.2g} in {where}")
    scene, overrides = IMPLICIT["rigid"]
    part = WORK / "iterated_part"
    run(2, words_of(scene, part, [o for o in overrides if "End time" not in o] + ["Time/End time=0.15", "Checkpoint/Step interval=20", ITERATED]))
    resume(2, part, ["Time/End time=0.3"])
    expected, found = series(WORK / "iterated_rigid_2"), series(part)
    different = [n for n in expected if n.startswith(("monitors/", "energy/")) and expected[n].tobytes() != found[n].tobytes()]
    require(not different, f"iterated, resumed by as many: the same bits, but for {different[:4]}")


def check_watched_points(name, directories):
    """Waves without monitors: what is watched for the error moves alike on any number of processes; what it tells to three digits (MotionAnswer)."""
    told = {}
    for processes, directory in directories.items():
        error = json.loads((directory / "summary.json").read_text())["probable_error"]
        require(error["estimated"] and "bedrock" in error["watched"], f"{name}, no monitors, {processes} processes: {error}")
        told[processes] = [error["time_step"][q]["part_of_peak"] for q in ("velocity", "acceleration")]
        require(min(told[1]) > 0. and numpy.allclose(told[processes], told[1], rtol=1e-3, atol=0),
                f"{name}, no monitors: {processes} processes tell {told[processes]}, one {told[1]}")


def check_waves(name, counts):
    """Histories and peaks of waves alone on so many processes, and files that all of them write."""
    scene, overrides = SHARED[name]
    directories = {processes: WORK / f"{name}_{processes}" for processes in (1, *counts)}
    prefixes = ("energy/", "fields/") if "Monitors/Points=" in overrides else ("monitors/", "energy/", "fields/")
    one = series(directories[1])
    for processes in counts:
        compute_waves(name, processes)
        found = series(directories[processes])
        require(set(found) == set(one), f"{name}: the same series")
        for prefix in prefixes:
            worst, where = largest_difference(one, found, prefix)
            print(f"{name}: 1 and {processes} processes differ by {worst:.2g} of the peak ({where})")
            require(worst < 1e-8, f"{name}: 1 and {processes} processes differ by {worst:.2g} in {where}")
    if name in PICTURED:
        check_files(name, directories)
    if "monitors/" not in prefixes:
        check_watched_points(name, directories)


def compute_waves(name, processes=1):
    scene, overrides = SHARED[name]
    result = run(processes, words_of(scene, WORK / f"{name}_{processes}", overrides))
    require(result.stdout.count("Finished") == 1, f"{name}, {processes} processes: one of them speaks")


def check_equal():
    two_at_once(compute_waves, SHARED)
    for name in SHARED:
        check_waves(name, (2, 4) if name == "joints" else (2,))
    watched = WORK / "watched"
    run(2, words_of(SHARED["joints"][0], watched, [*SHARED["joints"][1], "Monitors/Peak fields=false"]))
    worst, where = largest_difference(series(WORK / "joints_2"), series(watched), "monitors/")
    require(worst == 0., f"without peak fields only what is watched is collected: {worst:.2g} in {where}")
    check_twice()
    check_static_stress()
    check_resume()
    check_alone()


def check_long():
    """As above on 4 processes, without monitors, and killed at more moments."""
    SHARED["lamb"] = (SHARED["lamb"][0], [o for o in SHARED["lamb"][1] if "Monitors/" not in o] + ["Monitors/Points=", "Time/End time=0.8"])
    SHARED["wave"] = ("wave_packet", [EXPLICIT, "Time/End time=0.1"])
    for name, counts in (("lamb", (2, 4)), ("free_field", (4,)), ("wave", (2,))):
        compute_waves(name)
        check_waves(name, counts)
    whole_lamb()
    check_kills(range(8))


def check_twice():
    again = WORK / "again"
    run(2, words_of(SHARED["lamb"][0], again, SHARED["lamb"][1]))
    require_same_bits(series(WORK / "lamb_2"), again, "two runs of two processes")
    for file in [*(WORK / "lamb_2").glob("vtu/*.vtu"), WORK / "lamb_2/peaks.vtu"]:
        require(file.read_bytes() == (again / file.relative_to(WORK / "lamb_2")).read_bytes(), f"two runs of two processes have the same {file.name}")


def check_resume():
    """Another number of processes goes on; the same number with the same bits."""
    scene, overrides = SHARED["lamb"]
    whole, stopped_one = WORK / "lamb_2", WORK / "part"
    run(2, words_of(scene, stopped_one, [o for o in overrides if "End time" not in o] + ["Time/End time=0.15"]))
    expected = series(whole)
    for processes in (2, 1, 3):
        part = WORK / f"part_{processes}"
        shutil.copytree(stopped_one, part)
        resume(processes, part, ["Time/End time=0.3"])
        found = series(part)
        require(len(found["time"]) == len(expected["time"]) > len(series(stopped_one)["time"]), f"resumed by {processes}: steps are taken")
        if processes == 2:
            names = [n for n in expected if n.startswith(("monitors/", "energy/", "time"))]
            different = [n for n in names if expected[n].tobytes() != found[n].tobytes()]
            require(not different, f"resumed by as many: the same bits, but for {different[:4]}")
        require((static_stress(part) == static_stress(whole)).all(), f"resumed by {processes}: the static stress of before")
        for prefix in ("monitors/", "fields/"):
            worst, where = largest_difference(expected, found, prefix)
            print(f"resumed by {processes} of 2 processes: {worst:.2g} of the peak off ({where})")
            require(worst < 1e-8, f"resumed by {processes}: {worst:.2g} off in {where}")


def check_pictures(name, known, found):
    """All pictures of two runs: 1e-6 of the largest value that a field has in any, more than single precision rounds off."""
    files = sorted(file.relative_to(known) for file in [*known.glob("vtu/*.vtu"), known / "peaks.vtu"])
    require(len(files) > 2 and files == sorted(f.relative_to(found) for f in [*found.glob("vtu/*.vtu"), found / "peaks.vtu"]), f"{name}: the same pictures")
    require((known / "continuum.pvd").read_bytes() == (found / "continuum.pvd").read_bytes(), f"{name}: the same series of pictures")
    largest = {}
    for file in files:
        for field, values in arrays_by_vtk(known / file).items():
            if field not in ("cells", "region"):
                largest[field] = max(largest.get(field, 0.), float(numpy.abs(values).max()))
    motion = largest["displacement [m]"]
    require(motion > 0. and largest["velocity [m/s]"] > 0. and largest["peak velocity [m/s]"] > 0., f"{name}: something moves")
    tolerances = {field: 1e-6 * value for field, value in largest.items()} | {"points": 1e-9 * motion + 1e-12}
    for file in files:
        for sentence in unlike(known / file, found / file, tolerances):
            require(False, sentence)


def no_leftovers(directory):
    left = [str(file) for file in directory.rglob("*.tmp")]
    require(not left, f"{directory.name}: no file is left half written: {left}")


def check_files(name, directories):
    """Files that all processes write: those of one, in the same order."""
    for directory in directories.values():
        no_leftovers(directory)
    sizes = {(directory / "checkpoint/state.bin").stat().st_size for directory in directories.values()}
    require(len(sizes) == 1, f"{name}: checkpoints of {list(directories)} processes are of one size: {sizes}")
    for processes, directory in directories.items():
        if processes == 1:
            continue
        check_pictures(f"{name}, {processes} processes", directories[1], directory)
        with h5py.File(directories[1] / "run.h5") as one, h5py.File(directory / "run.h5") as other:
            names = []
            one["fields/nodes"].visit(names.append)
            require(names, f"{name}: there are tables of nodes")
            for table in names:
                a, b = one["fields/nodes/" + table], other["fields/nodes/" + table]
                require(a.shape == b.shape and a.dtype == b.dtype and dict(a.attrs) == dict(b.attrs), f"{name}: {table} is described as by one process")
                off = numpy.abs(a[()] - b[()]).max() / max(numpy.abs(a[()]).max(), 1e-300)
                print(f"{name}: {table} of {processes} processes is {off:.2g} off")
                require(off < 1e-10, f"{name}: {table} of {processes} processes is {off:.2g} off")


# Long enough to be stopped on the way.
LONG_LAMB = [o for o in SMALL_LAMB if "interval" not in o] + ["Time/End time=1", "Output/Audit interval=0.01", "Checkpoint/Step interval=10", "Output/Picture interval=0.02"]


def whole_lamb():
    whole = WORK / "whole"
    run(2, words_of("lamb", whole, LONG_LAMB))
    return series(whole)


def check_full_disk_of_some(expected):
    """A process whose files may not grow any more: all end with one sentence, the checkpoint is that of before."""
    for which in (0, 1):
        directory = WORK / f"full_{which}"
        output = []
        stopped(directory, lambda process: resource.prlimit(children(process)[which], resource.RLIMIT_FSIZE, (1000, 1000)), LONG_LAMB, output=output)
        require(output[1].count("error: ") == 1 and "cannot write" in output[1] and "File too large" in output[1], f"process {which} cannot write: one says so: {output[1][-400:]}")
        no_leftovers(directory)
        resume(2, directory)
        found = series(directory)
        different = [n for n in expected if n.startswith(("monitors/", "fields/")) and expected[n].tobytes() != found[n].tobytes()]
        require(not different, f"process {which} could not write: resumed to the same bits, but for {different[:4]}")


def wait_for_pictures(directory, count=3):
    """Steps are taken: the checkpoint of the start comes before the first."""
    for _ in range(6000):
        if len(list(directory.glob("vtu/continuum_*.vtu"))) >= count:
            return
        time.sleep(0.01)


def check_kills(rounds):
    """Killed at many moments while pictures and checkpoints are written in each step: what is there can be read, and goes on; two processes with the bits of a run that
    was not killed."""
    words = [o for o in LONG_LAMB if "interval" not in o] + ["Checkpoint/Step interval=1", "Output/Picture interval=0.0001", "Time/End time=3", "Output/Flush interval=0"]
    expected = series(WORK / "whole")
    for k in rounds:
        directory = WORK / f"killed_{k}"
        stopped(directory, lambda process: (wait_for_pictures(directory), time.sleep(0.037 * k), os.kill(children(process)[k % 2], signal.SIGKILL)), words)
        with h5py.File(directory / "run.h5") as file:
            steps = len(file["time"])
            require("fields" not in file, f"{directory.name}: no peaks before the end")
        require(steps > 0, f"{directory.name}: run.h5 can be read")
        series_of = Pictures(str(directory), "continuum")
        for number in range(len(series_of)):
            series_of[number]
        processes = 1 + k // 2 % 2
        resume(processes, directory, [f"Time/End time={series_of.times[-1] + 0.004:.4f}"])
        no_leftovers(directory)
        found = series(directory)
        alike = int((found["time"] == expected["time"][:len(found["time"])]).sum())
        require(alike > steps, f"{directory.name}: steps are taken, {alike} after {steps}")
        different = [n for n in expected if n.startswith("monitors/") and expected[n][:alike].tobytes() != found[n][:alike].tobytes()]
        require(processes == 1 or not different, f"{directory.name}: resumed to the same bits, but for {different[:4]}")


def check_alone():
    """A few blocks on finite elements are computed by the first process alone, the further runs, too."""
    alone, told = WORK / "alone_1", WORK / "alone_2"
    overrides = ["Time/End time=0.1", *ERRORS]
    subprocess.run(words_of("coupled_column", alone, overrides), check=True, capture_output=True, env=ENVIRONMENT, timeout=600)
    result = run(2, words_of("coupled_column", told, overrides))
    require(ALONE in result.stdout + result.stderr, "few blocks: it is told that one process computes")
    require_same_bits(series(alone), told, "few blocks, two processes")
    require_same_errors("few blocks", alone, told)
    again = run(2, [BINARY, "accuracy", str(alone)])
    require(again.stdout.count("Error of the mesh:") == 1 and ALONE not in again.stdout, "a tool, and what it starts, is one process")


def check_faults():
    expected = whole_lamb()
    directory = WORK / "terminated"
    code = stopped(directory, lambda process: process.send_signal(signal.SIGTERM), LONG_LAMB, patience=5)
    require(code != 0, "terminated: an exit code that tells of it")
    resume(2, directory)
    found = series(directory)
    different = [n for n in expected if n.startswith("monitors/") and expected[n].tobytes() != found[n].tobytes()]
    require(not different, f"terminated: resumed to the same bits, but for {different[:4]}")
    check_full_disk_of_some(expected)
    check_kills((0, 3, 5, 6))

    nowhere = run(2, words_of("lamb", WORK / "wrong", [*SMALL_LAMB, "Materials/rock/Poisson ratio=0.7"]), expect=2)
    require(nowhere.stderr.count("error: ") == 1, f"a wrong value: one says so: {nowhere.stderr[-300:]}")
    twice = [word for word in words_of("lamb", WORK / "whole", SMALL_LAMB) if word != "--force"]
    refused = run(2, twice, expect=2)
    require(refused.stderr.count("error: ") == 1, f"an earlier run: one says so: {refused.stderr[-300:]}")


main({"equal": check_equal, "solvers": check_solvers, "faults": check_faults, "long": check_long})
