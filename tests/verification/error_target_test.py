#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A run that misses Time/Error target is repeated with the step that its estimate asks for; killed in the repetition, it goes on to
the same bits; where the error is not estimated the difference of two runs tells it.

    error_target_test.py HYBRID ROOT WORK_DIR   exit code 1 and a sentence if a requirement is not met
"""

import json
import os
import pathlib
import shutil
import subprocess
import sys
import time

import h5py
import numpy as np

LONG = "Time/End time=20"  # a kill comes in time on a busy machine, too


def same_bits(one, other):
    """Whether all histories of monitors are equal."""
    with h5py.File(one / "run.h5") as a, h5py.File(other / "run.h5") as b:
        names = []
        a["monitors"].visititems(lambda name, item: names.append("monitors/" + name) if isinstance(item, h5py.Dataset) else None)
        return len(names) > 0 and all(np.array_equal(a[name][()], b[name][()]) for name in ["time", *names])


def step_of(directory):
    """Time/Time step in params.used.prm [s]."""
    lines = (directory / "params.used.prm").read_text(encoding="utf-8").splitlines()
    return float(next(line for line in lines if line.split("=")[0].strip() == "set Time step").split("=")[1].split("#")[0])


def killed_in_repetition(binary, scene, directory, overrides):
    """Start a run, kill it in its repetition once there is a checkpoint, and resume it. @return whether the kill came in time"""
    shutil.rmtree(directory, ignore_errors=True)
    environment = dict(os.environ, OPENBLAS_NUM_THREADS="1", OMP_NUM_THREADS="1")
    words = [binary, str(scene), "-s", "Output/Directory=%s" % directory]
    for override in [*overrides, "Checkpoint/Step interval=100"]:
        words += ["-s", override]
    process = subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env=environment)
    log, state = directory / "log.txt", directory / "checkpoint/state.bin"

    def is_repeating():
        try:
            return "Repeated" in log.read_text(encoding="utf-8") and state.exists()
        except FileNotFoundError:  # not yet, or just being replaced
            return False

    while process.poll() is None and not is_repeating():
        time.sleep(0.002)
    in_time = process.poll() is None
    process.kill()
    process.wait()
    resumed = subprocess.run([binary, "--resume", str(directory)], capture_output=True, text=True, check=False, env=environment)
    return in_time and resumed.returncode == 0


def probable_error(directory):
    return json.loads((directory / "summary.json").read_text(encoding="utf-8"))["probable_error"]


def check_slip(binary, scene, work, run_hybrid, require):
    """Friction: one run does not tell its error, two do."""
    base = ["Time/Time step=0.004", "Output/Picture interval=0"]
    _, output, _, _ = run_hybrid(binary, scene, work / "slip_alone", base)
    require("hybrid accuracy tells it from a run with twice the step" in output, "a run that slips tells how its error is found", output)
    target = [*base, "Time/Error target=1"]
    code, output, errors, _ = run_hybrid(binary, scene, work / "slip", target)
    step = step_of(work / "slip")
    require(code == 0 and not errors and output.count("Repeated") == 1 and step == 0.002, "repeated once", output + errors)
    log = (work / "slip/log.txt").read_text(encoding="utf-8")
    require(output.count("Effects") == 1 and log.count("Effects") == 1, "the card is on the screen once, and in log.txt", output)
    error = probable_error(work / "slip")
    require(error["measured_from_time_step_s"] == 0.004 and error["time_step"]["displacement"]["part_of_peak"] <= 0.01,
            "the difference of both runs meets the target", output)
    run_hybrid(binary, scene, work / "slip_given", [*base, "Time/Time step=%g" % step])
    require(same_bits(work / "slip", work / "slip_given"), "the bits of a run with this step", output)
    require(killed_in_repetition(binary, scene, work / "slip_killed", target) and same_bits(work / "slip_killed", work / "slip_given")
            and probable_error(work / "slip_killed")["time_step"] == error["time_step"],
            "the same bits and the same error after a kill in the repetition", output)
    record = work / "slip/checkpoint/longer_steps.bin"
    require(record.exists(), "the run before is kept for the comparison", output)
    subprocess.run([binary, scene, "--force", "-s", "Output/Directory=%s" % (work / "slip"), "-s", "Time/End time=0.1"], check=True,
                   capture_output=True)
    require(not record.exists(), "a new run forgets it", output)
    _, output, _, _ = run_hybrid(binary, scene, work / "short", [*target, "Time/Time step=0.001"])
    require("Repeated in steps of 0.0005 s:" in output, "a short step is printed as others are", output)
    _, output, errors, _ = run_hybrid(binary, scene, work / "damped", [*target, "Time/Dynamic coefficient=0.99"])
    log = (work / "damped/log.txt").read_text(encoding="utf-8")
    require(all("warning: Time/Error target is not known to be met" in text for text in (output, log)),
            "where runs in other steps would not tell it, it says so, in log.txt too", output + errors)


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    binary, root, work = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    sys.path.insert(0, str(root / "tests"))
    from run_hybrid import require, run_hybrid

    scene = root / "parameters/verification/coupled_column.prm"
    target = [LONG, "Time/Time step=0.008", "Time/Error target=1 %"]
    code, output, errors, _ = run_hybrid(binary, scene, work / "target", target)
    step = step_of(work / "target")
    require(code == 0 and not errors and output.count("Repeated in steps of %g s" % step) == 1 and step < 0.008,
            "repeated once, in steps of %g s" % step, output + errors)
    error = probable_error(work / "target")["time_step"]
    largest = max(error["displacement"]["part_of_peak"], error["velocity"]["part_of_peak"])
    require(largest <= 0.01, "probable error %.2g %%" % (100 * largest), output)
    run_hybrid(binary, scene, work / "given", [LONG, "Time/Time step=%g" % step])
    require(same_bits(work / "target", work / "given"), "the bits of a run with this step", output)
    require(killed_in_repetition(binary, scene, work / "killed", target) and same_bits(work / "killed", work / "given"),
            "the same bits after a kill in the repetition", output)
    _, output, errors, _ = run_hybrid(binary, scene, work / "met", [LONG, "Time/Time step=%g" % step, "Time/Error target=1"])
    require("Repeated" not in output and "known to be met" not in output and not errors, "a run that meets the target stands", output + errors)
    check_slip(binary, root / "parameters/verification/shaken_base.prm", work, run_hybrid, require)
    code, _, errors, _ = run_hybrid(binary, scene, work / "refused", ["Time/Error target=1 mm"])
    require(code == 2 and "Time/Error target" in errors, "another unit is refused", errors)


if __name__ == "__main__":
    main()
