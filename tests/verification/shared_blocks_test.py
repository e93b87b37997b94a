#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Blocks that processes share out have the bits of one, also where another number goes on.

Usage: shared_blocks_test.py HYBRID_BINARY PART WORK_DIR     PART: equal, long
"""
import json
import os
import signal
import subprocess

import numpy

from processes import (ALONE, ENVIRONMENT, ERRORS, WORK, children, launcher, main, require, require_same_bits, require_same_errors, resume, run, stopped, two_at_once,
                       words_of)
from runs_alike import series

# 2,000 blocks or more, as fewer are computed by one: bonded on a rigid base; loose ones that slide, and that come to rest; a row that moves over the others by more than a
# block, so that blocks get other owners (18 of three processes); Badong on a bedrock of triangles; and a mass on bedrock a part of
# which is thrown off, so that joints tear, blocks slide and yield.
LEVEL = "Angle = 0; Columns = 100; Rows = 20; Base above = 200"
MOVING = [f"Mesh/Numbers={LEVEL}", "Materials/rock/Young modulus=50e6", "Blocks/Initial velocities=top: -1000, 1000, 19, 20, 120, 0, 0"]
BADONG = ("../benchmarks/badong_4", ["Time/End time=0.04", "Output/Audit interval=0.01", "Output/Picture interval=0.02"])
BLOCKS = {
    "bonded": ("../benchmarks/bonded_5000", ["Mesh/Numbers=Width = 60; Height = 18; Resolution/h = 1", "Time/End time=0.02"]),
    "sliding": ("../benchmarks/slide_2000", ["Time/End time=0.002"]),
    "resting": ("../benchmarks/rest_2000", ["Mesh/Numbers=Angle = 0; Columns = 500; Rows = 4; Base above = 600", "Time/End time=0.003"]),
    "moving": ("../benchmarks/slide_2000", [*MOVING, "Time/End time=0.01"]),
    "triangles": ("../benchmarks/triangles_8", ["Time/End time=0.02"]),
}
TORN = ("coupled_column", ["Mesh/Numbers=Width = 640; Height = 15; Block height = 10; Resolution/h = 2.5", "Monitors/Points=top: 5, 15; base: 5, 0",
                           "Materials/rock/Cohesion=40e3", "Materials/rock/Tensile strength=5e3", "Blocks/Initial velocities=half: 0, 40, 5, 15, 3, 2, 0",
                           "Continuum/Degree=1", "Blocks/Yielding=true", "Time/Time step=0.0005", "Time/End time=0.035", "Output/Audit interval=0.01",
                           "Checkpoint/Step interval=10"])
# Badong on its bedrock, and with blocks that yield; a higher pile at rest.
MORE_BLOCKS = {
    "sliding": BLOCKS["sliding"],
    "resting": ("../benchmarks/rest_2000", [f"Mesh/Numbers={LEVEL}", "Time/End time=0.003"]),
    "moving": BLOCKS["moving"],
    "badong": BADONG,
    "yielding": (BADONG[0], ["Time/End time=0.02", "Blocks/Yielding=true"]),
}
# Numbers of processes, and of threads of each.
COUNTS = {"bonded": ((2, 2), (4, 1)), "moving": ((3, 1),)}
MORE_COUNTS = {"sliding": ((2, 1), (3, 1)), "moving": ((2, 1),), "badong": ((2, 1), (4, 1), (2, 2))}


def compare_blocks(scenes, counts):
    """Blocks shared out among processes have the bits of one."""
    def compute(name, processes, threads=1):
        scene, overrides = scenes[name]
        further = ERRORS if name == "bonded" and processes < 4 else []
        directory = WORK / f"{name}_{processes}{'_threads' if threads > 1 else ''}"
        result = run(processes, words_of(scene, directory, [*overrides, *further, f"Parallel/Threads={threads}"]))
        require(result.stdout.count("Finished") == 1 and ALONE not in result.stdout, f"{name}, {processes} processes: all compute, one speaks")
        return directory

    two_at_once(lambda name: compute(name, 1), scenes)
    for name in scenes:
        expected = series(WORK / f"{name}_1")
        require(expected, f"{name}: there are series")
        for processes, threads in counts.get(name, ((2, 1),)):
            require_same_bits(expected, compute(name, processes, threads), f"{name}, {processes} processes of {threads} threads")


def check_blocks():
    compare_blocks(BLOCKS, COUNTS)
    moved = numpy.abs(series(WORK / "moving_1")["section/blocks_displacement"]).max()
    require(moved > 1., f"moving: the row has moved over the others by {moved:.2g} m, more than a block")
    require_same_errors("bonded", WORK / "bonded_1", WORK / "bonded_2_threads")

    # What cannot stand ends with one sentence, not with a crash of those that do not write.
    falls = ["Mesh/Numbers=Angle = 30; Columns = 2000; Rows = 1; Base above = 200", "Time/End time=0.001"]
    refused = run(2, words_of("../benchmarks/rest_2000", WORK / "falls", falls), expect=1)
    require(refused.stdout.count("no static equilibrium was found") == 1 and "signal" not in refused.stderr, "a mass that slides: refused in a sentence")
    check_stops_of_blocks()
    check_kinds_of_machines()


def check_blocks_long():
    """The same on more processes, errors with monitors and without, and a run that is ended by more processes than began it without being killed."""
    compare_blocks(MORE_BLOCKS, MORE_COUNTS)
    loss = series(WORK / "yielding_1")["energy/yield_loss"]
    require(loss[-1] > loss[0], "yielding: blocks yield")
    scene, overrides = BADONG
    for what, further in (("badong_errors", []), ("watched", ["Monitors/File=", "Monitors/Names=", "Monitors/Base="])):
        for processes in (1, 2):
            run(processes, words_of(scene, WORK / f"{what}_{processes}", [*overrides, *ERRORS, *further]))
        require_same_errors(what, WORK / f"{what}_1", WORK / f"{what}_2")
    part = WORK / "badong_part"
    run(2, words_of(scene, part, [*overrides[1:], "Time/End time=0.021", "Checkpoint/Step interval=7"]))
    resume(3, part, ["Time/End time=0.04"])
    whole = series(WORK / "badong_1")
    require_same_bits({n: v for n, v in whole.items() if n.startswith(("monitors/", "energy/"))}, part, "begun by two, ended by three")


def check_stops_of_blocks():
    """Stopped or killed on the way, ended by as many or by more: the bits of one process, while joints tear, blocks slide and yield."""
    scene, overrides = TORN
    whole = WORK / "torn"
    run(1, words_of(scene, whole, overrides))
    expected = series(whole)
    told = json.loads((whole / "summary.json").read_text())
    require(told["joints"]["tensile"] > 0 and told["slip_m"]["part_slipped"] > 0.01 and expected["energy/yield_loss"][-1] > 0.,
            f"torn: joints tear, blocks slide and yield: {told['joints']}, {told['slip_m']}")
    for name, patience, how in (("blocks_terminated", 5, lambda process: process.send_signal(signal.SIGTERM)),
                                ("blocks_killed", 1, lambda process: os.kill(children(process)[1], signal.SIGKILL))):
        directory = WORK / name
        code = stopped(directory, how, overrides, scene, patience=patience)
        require(code != 0, f"{name}: an exit code that tells of it")
        resume(3 if name == "blocks_killed" else 2, directory)
        require_same_bits(expected, directory, name)


def check_kinds_of_machines():
    """Processes with other mathematical functions come to other bits: they end, and say so."""
    scene, overrides = BLOCKS["moving"]
    overrides = [*MOVING[:-1], MOVING[-1][:-1] + "3", "Time/End time=0.002"]  # the row spins, so sines and cosines are needed
    other = "GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2_Usable,-FMA_Usable,-AVX2,-FMA,-FMA4"
    words = words_of(scene, WORK / "kinds", overrides)
    result = subprocess.run([*launcher(1), *words, ":", "-n", "1", "-x", other, *words], capture_output=True, text=True, env=ENVIRONMENT, timeout=600)
    if result.returncode != 0 and "come to different results" in result.stdout + result.stderr:
        return
    directories = [WORK / "kind_one", WORK / "kind_other"]
    for directory, settings in zip(directories, ([], ["-x", other])):
        words = words_of(scene, directory, overrides)
        subprocess.run([*launcher(1), *settings, *words], capture_output=True, env=ENVIRONMENT, timeout=600, check=True)
    one, two = (series(directory) for directory in directories)
    require(all(one[n].tobytes() == two[n].tobytes() for n in one), "machines of two kinds: refused in a sentence")
    print("kinds of machines: this one has no other functions to try")


main({"equal": check_blocks, "long": check_blocks_long})
