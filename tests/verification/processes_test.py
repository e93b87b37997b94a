#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes under mpirun: the same answers on any number of processes, and nothing is lost when one ends.

Usage: processes_test.py HYBRID_BINARY PART WORK_DIR     PART: equal, solvers, resume, faults, files, blocks, blocks_long
"""
import concurrent.futures
import json
import os
import pathlib
import resource
import shutil
import signal
import subprocess
import sys
import time

import h5py
import numpy

from runs_alike import arrays_by_vtk, largest_difference, series, unlike

BINARY, PART, WORK = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3]).resolve()
ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "src/tools"))
from hybrid_run.pictures import Pictures  # noqa: E402

SCENES = ROOT / "parameters/verification"
ENVIRONMENT = dict(os.environ, OPENBLAS_NUM_THREADS="1", OMP_NUM_THREADS="1")
EXPLICIT = "Continuum/Time integrator=explicit"
SMALL_LAMB = [EXPLICIT, "Mesh/Numbers=Width = 400; Height = 300; Resolution/h = 25", "Time/End time=0.3",
              "Point loads/Forces=force: 100, 300, 0, -1e10", "Monitors/Points=a: 200, 300; b: 310, 120",
              "Output/Picture interval=0.1", "Output/Audit interval=0.01", "Gravity/Acceleration=9.81"]
# Planes that reach free-field sides.
ELASTIC = ["Bedding planes/Names=bedding_1, bedding_2", "Bedding planes/Strength=elastic",
           "Mesh/Numbers=Length = 150; Width = 100; Planes = 2; First plane = 60; Spacing = 40; Resolution/h = 10"]
DAMPED = ["Continuum/Rayleigh mass=0.3", "Maxwell damping/Bedrock ratio=0.03", "Continuum/Boundary springs=true"]
# Free field, rigid base, bedding planes, an initial wave, damping of both kinds.
SHARED = {
    "lamb": ("lamb", SMALL_LAMB),
    "free_field": ("free_field", [EXPLICIT, "Time/End time=0.5", *DAMPED]),
    "canyon": ("canyon", [EXPLICIT, "Time/End time=0.8"]),
    "joints": ("oblique_joints", [EXPLICIT, "Time/End time=0.4"]),
    "columns": ("column_planes", [EXPLICIT, *ELASTIC, "Time/End time=1", "Continuum/Rayleigh mass=0.3"]),
    "rigid": ("free_field", [EXPLICIT, "Time/End time=0.5", "Continuum/Base=rigid", "Continuum/Rayleigh stiffness=0"]),
    "wave": ("wave_packet", [EXPLICIT, "Time/End time=0.1"]),
}
ITERATED = "Continuum/Linear solver=conjugate gradients"
FACTOR = "Continuum/Linear solver=factor"
# Implicit steps without a matrix; the factor gives the same motion.
IMPLICIT = {
    "lamb": ("lamb", [o for o in SMALL_LAMB if o != EXPLICIT] + ["Time/Time step=0.002"]),
    "free_field": ("free_field", ["Time/End time=0.3", *DAMPED]),
    "rigid": ("free_field", ["Time/End time=0.3", "Continuum/Base=rigid", "Time/Scheme=filtered"]),
    "joints": ("oblique_joints", ["Time/End time=0.2"]),
    "columns": ("column_planes", [*ELASTIC, "Time/End time=0.5", "Continuum/Rayleigh stiffness=1e-4"]),
}
COUPLED = ("restart_coupled", ["Time/End time=0.05"])
# 2,000 blocks or more, as fewer are computed by one: bonded on a rigid base; loose ones that slide, and that come to rest; a row that moves over the others by more than a
# block, so that blocks get other owners (2 of two processes, 18 of three); Badong on its bedrock, and with blocks that yield; a bedrock of triangles.
BLOCKS = {
    "bonded": ("../benchmarks/bonded_5000", ["Time/End time=0.02"]),
    "sliding": ("../benchmarks/slide_2000", ["Time/End time=0.003"]),
    "resting": ("../benchmarks/rest_2000", ["Mesh/Numbers=Angle = 0; Columns = 100; Rows = 20; Base above = 200", "Time/End time=0.003"]),
    "moving": ("../benchmarks/slide_2000", ["Mesh/Numbers=Angle = 0; Columns = 100; Rows = 20; Base above = 200", "Time/End time=0.03",
                                            "Materials/rock/Young modulus=50e6", "Blocks/Initial velocities=top: -1000, 1000, 19, 20, 40, 0, 0"]),
    "yielding": ("../benchmarks/badong_4", ["Time/End time=0.02", "Blocks/Yielding=true"]),
    "badong": ("../benchmarks/badong_4", ["Time/End time=0.04", "Output/Audit interval=0.01", "Output/Picture interval=0.02"]),
    "triangles": ("../benchmarks/triangles_8", ["Time/End time=0.02"]),
}
# Numbers of processes; blocks_long has more, errors with monitors, too, and a run that is ended by more processes than began it without being killed.
COUNTS = {"badong": (1, 2, 4), "moving": (1, 3)}
MORE_COUNTS = {"moving": (1, 2, 3), "sliding": (1, 2, 3)}
ALONE = "computed by the first one alone"
ONE_RUN = ["Time/Error estimate=one run", "Mesh/Error estimate=one run"]
ERRORS = ["Time/Error estimate=automatic", "Mesh/Error estimate=automatic"]
complaints = []


def require(condition, text):
    if not condition:
        complaints.append(text)
        print("FAILED:", text)


def launcher(processes):
    return [os.environ["HYBRID_MPIEXEC"], "-n", str(processes), "--oversubscribe", "--allow-run-as-root", "--mca", "mpi_yield_when_idle", "1"]


def words_of(scene, directory, overrides=()):
    words = [BINARY, str(SCENES / (scene + ".prm")), "--force", "-s", f"Output/Directory={directory}"]
    for override in [*ONE_RUN, *overrides]:
        words += ["-s", override]
    return words


def run(processes, words, expect=0):
    result = subprocess.run([*launcher(processes), *words], capture_output=True, text=True, env=ENVIRONMENT, timeout=600)
    require(result.returncode == expect, f"{processes} processes, {words[1:6]}: exit code {expect}, not {result.returncode}: {result.stderr[-400:]}")
    return result


def two_at_once(compute, names):
    """Runs of one process each leave half of two cores alone."""
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        list(pool.map(compute, names))


def static_stress(directory):
    """Of the last picture [Pa], in single precision."""
    pictures = Pictures(str(directory), "continuum")
    return pictures[len(pictures) - 1].fields["static stress xx, yy, xy [Pa]"]


def check_static_stress():
    """Explicit scenes find it without a matrix, shared out; the factor of an implicit one knows it."""
    words = ["Time/End time=0.02", "Gravity/Acceleration=9.81", "Gravity/Horizontal coefficient=0.1", "Output/Picture interval=0.02"]
    known = WORK / "rest"
    run(1, words_of("oblique_joints", known, words))
    peak = numpy.abs(static_stress(known)).max()
    require(peak > 1e7, f"the rock has weight: {peak:.3g} Pa")
    for processes in (1, 2, 4):
        found = WORK / f"rest_{processes}"
        run(processes, words_of("oblique_joints", found, [*words, EXPLICIT]))
        worst = numpy.abs(static_stress(found) - static_stress(known)).max() / peak
        print(f"static stress, {processes} processes: {worst:.2g} of the largest off that of the factor")
        require(worst < 1e-7, f"static stress, {processes} processes: {worst:.2g} of the largest off")


def check_solvers():
    """Conjugate gradients on 1, 2 and 4 processes and the factor have the same histories."""
    two_at_once(lambda name: run(1, words_of(IMPLICIT[name][0], WORK / f"factor_{name}", [*IMPLICIT[name][1], FACTOR])), IMPLICIT)
    for name, (scene, overrides) in IMPLICIT.items():
        known = WORK / f"factor_{name}"
        for processes in (1, 2, 4) if name == "lamb" else (1, 2):
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


def check_watched_points():
    """Waves without monitors: what is watched for the error moves alike on any number of processes; what it tells to three digits (MotionAnswer)."""
    for name in ("lamb", "free_field"):
        scene, overrides = SHARED[name]
        told = {}
        for processes in (1, 2, 4):
            directory = WORK / f"no_monitors_{name}_{processes}"
            run(processes, words_of(scene, directory, [o for o in overrides if "Monitors/" not in o] + ["Monitors/Points=", "Time/End time=0.8"]))
            error = json.loads((directory / "summary.json").read_text())["probable_error"]
            require(error["estimated"] and "bedrock" in error["watched"], f"{name}, no monitors, {processes} processes: {error}")
            told[processes] = [error["time_step"][q]["part_of_peak"] for q in ("velocity", "acceleration")]
            require(numpy.allclose(told[processes], told[1], rtol=1e-3, atol=0), f"{name}, no monitors: {processes} processes tell {told[processes]}, one {told[1]}")


def check_equal():
    def compute(name, processes=1):
        scene, overrides = SHARED[name]
        result = run(processes, words_of(scene, WORK / f"{name}_{processes}", overrides))
        require(result.stdout.count("Finished") == 1, f"{name}, {processes} processes: one of them speaks")

    two_at_once(compute, SHARED)
    for name in SHARED:
        runs = {}
        counts = (1, 2, 4) if name in ("lamb", "joints") else (1, 2)
        for processes in counts:
            if processes > 1:
                compute(name, processes)
            runs[processes] = series(WORK / f"{name}_{processes}")
            require(set(runs[processes]) == set(runs[1]), f"{name}: the same series")
        for processes in counts[1:]:
            for prefix in ("monitors/", "energy/", "fields/"):
                worst, where = largest_difference(runs[1], runs[processes], prefix)
                print(f"{name}: 1 and {processes} processes differ by {worst:.2g} of the peak ({where})")
                require(worst < 1e-8, f"{name}: 1 and {processes} processes differ by {worst:.2g} in {where}")
    watched = WORK / "watched"
    run(2, words_of(SHARED["joints"][0], watched, [*SHARED["joints"][1], "Monitors/Peak fields=false", "Output/Picture interval=0.1"]))
    worst, where = largest_difference(series(WORK / "joints_2"), series(watched), "monitors/")
    require(worst == 0., f"without peak fields only what is watched is collected: {worst:.2g} in {where}")
    again = WORK / "again"
    run(2, words_of(SHARED["lamb"][0], again, SHARED["lamb"][1]))
    before, after = series(WORK / "lamb_2"), series(again)
    require(all(before[n].tobytes() == after[n].tobytes() for n in before), "two runs of two processes have the same bits")

    check_static_stress()
    check_watched_points()

    alone, told = WORK / "coupled_1", WORK / "coupled_2"
    subprocess.run(words_of(*COUPLED[:1], alone, COUPLED[1]), check=True, capture_output=True, env=ENVIRONMENT, timeout=600)
    result = run(2, words_of(COUPLED[0], told, COUPLED[1]))
    require("computed by the first one alone" in result.stdout, "few blocks: it is told that one process computes")
    one, other = series(alone), series(told)
    require(all(one[n].tobytes() == other[n].tobytes() for n in one), "few blocks: the bits of one process")

    again = run(2, [BINARY, "accuracy", str(alone)])
    require(again.stdout.count("Error of the mesh:") == 1 and ALONE not in again.stdout, "a tool, and what it starts, is one process")


def resume(processes, directory, overrides=()):
    words = [BINARY, "--resume", str(directory)]
    for override in overrides:
        words += ["-s", override]
    return run(processes, words)


def check_resume():
    """Another number of processes goes on; the same number with the same bits."""
    scene, overrides = SHARED["lamb"]
    whole = WORK / "whole"
    run(2, words_of(scene, whole, overrides))
    expected = series(whole)
    for processes in (2, 1, 4):
        part = WORK / f"part_{processes}"
        run(2, words_of(scene, part, [o for o in overrides if "End time" not in o] + ["Time/End time=0.15", "Checkpoint/Step interval=50"]))
        resume(processes, part, ["Time/End time=0.3"])
        found = series(part)
        if processes == 2:
            names = [n for n in expected if n.startswith(("monitors/", "energy/", "time"))]
            different = [n for n in names if expected[n].tobytes() != found[n].tobytes()]
            require(not different, f"resumed by as many: the same bits, but for {different[:4]}")
        require((static_stress(part) == static_stress(whole)).all(), f"resumed by {processes}: the static stress of before")
        for prefix in ("monitors/", "fields/"):
            worst, where = largest_difference(expected, found, prefix)
            print(f"resumed by {processes} of 2 processes: {worst:.2g} of the peak off ({where})")
            require(worst < 1e-8, f"resumed by {processes}: {worst:.2g} off in {where}")


def require_same_bits(expected, directory, what):
    found = series(directory)
    different = [n for n in expected if n not in found or expected[n].tobytes() != found[n].tobytes()]
    require(not different, f"{what}: the same bits, but for {different[:4]}")


def check_blocks():
    """Blocks shared out among processes have the bits of one, also where another number goes on."""
    counts = COUNTS | (MORE_COUNTS if PART == "blocks_long" else {})

    def compute(name, processes):
        scene, overrides = BLOCKS[name]
        further = ERRORS if PART == "blocks_long" and name == "badong" and processes < 4 else []
        result = run(processes, words_of(scene, WORK / f"{name}_{processes}", [*overrides, *further]))
        require(result.stdout.count("Finished") == 1 and ALONE not in result.stdout, f"{name}, {processes} processes: all compute, one speaks")

    two_at_once(lambda name: compute(name, 1), BLOCKS)
    for name in BLOCKS:
        expected = series(WORK / f"{name}_1")
        require(expected, f"{name}: there are series")
        for processes in counts.get(name, (1, 2))[1:]:
            compute(name, processes)
            require_same_bits(expected, WORK / f"{name}_{processes}", f"{name}, {processes} processes")
    scene, overrides = BLOCKS["badong"]
    threads = WORK / "badong_threads"
    run(2, words_of(scene, threads, [*overrides, "Parallel/Threads=2"]))
    require_same_bits(series(WORK / "badong_1"), threads, "badong, two processes of two threads")
    check_errors_of_blocks()
    if PART == "blocks_long":
        check_more_processes_end_it()

    # What cannot stand ends with one sentence, not with a crash of those that do not write.
    falls = ["Mesh/Numbers=Angle = 30; Columns = 2000; Rows = 1; Base above = 200", "Time/End time=0.001"]
    refused = run(2, words_of("../benchmarks/rest_2000", WORK / "falls", falls), expect=1)
    require(refused.stdout.count("no static equilibrium was found") == 1 and "signal" not in refused.stderr, "a mass that slides: refused in a sentence")
    check_stops_of_blocks()
    check_kinds_of_machines()


def check_errors_of_blocks():
    """Runs that tell the errors; one with fewer blocks is computed by the first process alone."""
    scene, overrides = BLOCKS["badong"]
    for processes in (1, 2):
        run(processes, words_of(scene, WORK / f"watched_{processes}", [*overrides, *ERRORS, "Monitors/File=", "Monitors/Names=", "Monitors/Base="]))
    for what in ("badong", "watched") if PART == "blocks_long" else ("watched",):
        errors = {}
        for processes in (1, 2):
            summary = json.loads((WORK / f"{what}_{processes}/summary.json").read_text())
            errors[processes] = {name: summary[name] for name in ("probable_error", "mesh_error")}
        require(errors[1]["mesh_error"]["estimated"] and errors[1] == errors[2], f"{what}: two processes tell the same errors as one")
        require((errors[1]["probable_error"]["watched"] != "") == (what == "watched"), f"{what}: points are watched without monitors only")


def check_more_processes_end_it():
    scene, overrides = BLOCKS["badong"]
    part = WORK / "badong_part"
    run(2, words_of(scene, part, [*overrides[1:], "Time/End time=0.021", "Checkpoint/Step interval=7"]))
    resume(3, part, ["Time/End time=0.04"])
    whole = series(WORK / "badong_1")
    require_same_bits({n: v for n, v in whole.items() if n.startswith(("monitors/", "energy/"))}, part, "begun by two, ended by three")


def check_stops_of_blocks():
    """Stopped or killed on the way, ended by as many or by more: the bits of one process. 150 steps are to come when it is stopped."""
    scene, overrides = BLOCKS["badong"]
    long_run = [*overrides[1:], "Time/End time=0.2", "Checkpoint/Step interval=20"]
    whole = WORK / "badong_long"
    run(1, words_of(scene, whole, long_run))
    expected = {n: v for n, v in series(whole).items() if n.startswith(("monitors/", "energy/"))}
    require(expected, "there are series of the whole run")
    for name, how in (("blocks_terminated", lambda process: process.send_signal(signal.SIGTERM)),
                      ("blocks_killed", lambda process: os.kill(children(process)[1], signal.SIGKILL))):
        directory = WORK / name
        code = stopped(directory, how, long_run, scene)
        require(code != 0, f"{name}: an exit code that tells of it")
        resume(3 if name == "blocks_killed" else 2, directory)
        require_same_bits(expected, directory, name)


def check_kinds_of_machines():
    """Processes with other mathematical functions come to other bits: they end, and say so."""
    scene, overrides = BLOCKS["moving"]
    overrides = [*overrides[:-1], overrides[-1][:-1] + "3", "Time/End time=0.006"]  # the row spins, so sines and cosines are needed
    other = "GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2_Usable,-FMA_Usable,-AVX2,-FMA,-FMA4"
    directories = [WORK / "kind_one", WORK / "kind_other"]
    for directory, settings in zip(directories, ([], ["-x", other])):
        words = words_of(scene, directory, overrides)
        subprocess.run([*launcher(1), *settings, *words], capture_output=True, env=ENVIRONMENT, timeout=600, check=True)
    one, two = (series(directory) for directory in directories)
    if all(one[n].tobytes() == two[n].tobytes() for n in one):
        print("kinds of machines: this one has no other functions to try")
        return
    words = words_of(scene, WORK / "kinds", overrides)
    result = subprocess.run([*launcher(1), *words, ":", "-n", "1", "-x", other, *words], capture_output=True, text=True, env=ENVIRONMENT, timeout=600)
    require(result.returncode != 0 and "come to different results" in result.stdout + result.stderr, "machines of two kinds: refused in a sentence")


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


def check_files():
    """Files that all processes write: those of one, in the same order; nothing is lost on a full disk or by a kill while they write."""
    pictures = ["Output/Picture interval=0.1", "Checkpoint/Step interval=50"]
    for name in ("lamb", "joints", "free_field"):
        scene, overrides = SHARED[name]
        directories = {processes: WORK / f"files_{name}_{processes}" for processes in (1, 2, 4)}
        for processes, directory in directories.items():
            run(processes, words_of(scene, directory, [*overrides, *pictures]))
            no_leftovers(directory)
        sizes = {(directory / "checkpoint/state.bin").stat().st_size for directory in directories.values()}
        require(len(sizes) == 1, f"{name}: checkpoints of 1, 2, 4 processes are of one size: {sizes}")
        for processes in (2, 4):
            check_pictures(f"{name}, {processes} processes", directories[1], directories[processes])
            with h5py.File(directories[1] / "run.h5") as one, h5py.File(directories[processes] / "run.h5") as other:
                names = []
                one["fields/nodes"].visit(names.append)
                for table in names:
                    a, b = one["fields/nodes/" + table], other["fields/nodes/" + table]
                    require(a.shape == b.shape and a.dtype == b.dtype and dict(a.attrs) == dict(b.attrs), f"{name}: {table} is described as by one process")
                    off = numpy.abs(a[()] - b[()]).max() / max(numpy.abs(a[()]).max(), 1e-300)
                    print(f"{name}: {table} of {processes} processes is {off:.2g} off")
                    require(off < 1e-10, f"{name}: {table} of {processes} processes is {off:.2g} off")
    scene, overrides = SHARED["lamb"]
    again = WORK / "files_again"
    run(2, words_of(scene, again, [*overrides, *pictures]))
    for file in [*(WORK / "files_lamb_2").glob("vtu/*.vtu"), WORK / "files_lamb_2/peaks.vtu"]:
        require(file.read_bytes() == (again / file.relative_to(WORK / "files_lamb_2")).read_bytes(), f"two runs of two processes have the same {file.name}")
    check_full_disk_of_some()
    check_kills()


LONG_LAMB = [o for o in SMALL_LAMB if "End time" not in o and "Picture" not in o] + ["Time/End time=0.4", "Checkpoint/Step interval=10", "Output/Picture interval=0.02"]


def check_full_disk_of_some():
    """A process whose files may not grow any more: all end with one sentence, the checkpoint is that of before."""
    whole = WORK / "full_whole"
    run(2, words_of("lamb", whole, LONG_LAMB))
    expected = series(whole)
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


def check_kills():
    """Killed at many moments while pictures and checkpoints are written in each step: what is there can be read, and goes on."""
    words = [o for o in LONG_LAMB if "interval" not in o] + ["Checkpoint/Step interval=1", "Output/Picture interval=0.0001", "Time/End time=3", "Output/Flush interval=0"]
    for k in range(8):
        directory = WORK / f"killed_{k}"
        stopped(directory, lambda process: (wait_for_pictures(directory), time.sleep(0.037 * k), os.kill(children(process)[k % 2], signal.SIGKILL)), words)
        with h5py.File(directory / "run.h5") as file:
            steps = len(file["time"])
            require("fields" not in file, f"{directory.name}: no peaks before the end")
        require(steps > 0, f"{directory.name}: run.h5 can be read")
        series_of = Pictures(str(directory), "continuum")
        for number in range(len(series_of)):
            series_of[number]
        resume(2 if k % 2 else 1, directory, [f"Time/End time={series_of.times[-1] + 0.004:.4f}"])
        no_leftovers(directory)


def children(process):
    """Ids of the processes that mpirun has started."""
    text = subprocess.run(["ps", "-o", "pid=,args=", "--ppid", str(process.pid)], capture_output=True, text=True).stdout
    return [int(line.split()[0]) for line in text.splitlines() if BINARY in line]


def stopped(directory, how, overrides, scene="lamb", output=None):
    """A run of two processes that is stopped once it has written a checkpoint. @param output gets what it says. @return its exit code."""
    process = subprocess.Popen([*launcher(2), "--mca", "odls_base_sigkill_timeout", "5", *words_of(scene, directory, overrides)],
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=ENVIRONMENT)
    while process.poll() is None and not (directory / "checkpoint/state.bin").exists():
        time.sleep(0.01)
    time.sleep(0.3)
    require(process.poll() is None, f"{directory.name}: still runs when it is stopped")
    how(process)
    said = process.communicate(timeout=120)
    if output is not None:
        output.extend(said)
    return process.returncode


def check_alone():
    """The further runs of a scene that the first process computes alone, too: a few blocks on finite elements."""
    errors = {}
    for processes in (1, 2):
        result = run(processes, words_of("coupled_column", WORK / f"alone_{processes}", ["Time/End time=0.1", *ERRORS]))
        summary = json.loads((WORK / f"alone_{processes}/summary.json").read_text())
        errors[processes] = {name: summary[name] for name in ("probable_error", "mesh_error")}
        require((ALONE in result.stdout + result.stderr) == (processes == 2), f"{processes} processes: the first one computes alone")
    require(errors[1]["mesh_error"]["estimated"] and errors[1] == errors[2], "computed alone: the same errors as by one process")


def check_faults():
    scene, small = SHARED["lamb"]
    # Long enough to be stopped on the way.
    long_run = [o for o in small if "End time" not in o] + ["Time/End time=1.5", "Checkpoint/Step interval=100"]
    whole = WORK / "whole"
    run(2, words_of(scene, whole, long_run))
    expected = series(whole)
    for name, how in (("terminated", lambda process: process.send_signal(signal.SIGTERM)),
                      ("first_killed", lambda process: os.kill(children(process)[0], signal.SIGKILL)),
                      ("second_killed", lambda process: os.kill(children(process)[1], signal.SIGKILL))):
        directory = WORK / name
        code = stopped(directory, how, long_run)
        require(code != 0, f"{name}: an exit code that tells of it")
        resume(2, directory)
        found = series(directory)
        different = [n for n in expected if n.startswith("monitors/") and expected[n].tobytes() != found[n].tobytes()]
        require(not different, f"{name}: resumed to the same bits, but for {different[:4]}")

    check_alone()

    nowhere = run(2, words_of(scene, WORK / "wrong", [*small, "Materials/rock/Poisson ratio=0.7"]), expect=2)
    require(nowhere.stderr.count("error: ") == 1, f"a wrong value: one says so: {nowhere.stderr[-300:]}")
    twice = [word for word in words_of(scene, whole, small) if word != "--force"]
    refused = run(2, twice, expect=2)
    require(refused.stderr.count("error: ") == 1, f"an earlier run: one says so: {refused.stderr[-300:]}")


shutil.rmtree(WORK, ignore_errors=True)
{"equal": check_equal, "solvers": check_solvers, "resume": check_resume, "faults": check_faults, "files": check_files, "blocks": check_blocks, "blocks_long": check_blocks}[PART]()
if complaints:
    sys.exit(f"{len(complaints)} complaints, first: {complaints[0]}")
print("ok")
