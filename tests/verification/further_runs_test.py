#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What one run does not tell of its errors others do: that of the step one with half or twice the step (Time/Error estimate), that of a mesh of
blocks two with coarser ones (Mesh/Error estimate). Its own results stay as they are, nothing of the others is left, and what ends them
does no harm.

    further_runs_test.py HYBRID ROOT WORK_DIR   exit code 1 and a sentence if a requirement is not met
"""

import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import time

import h5py

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from run_hybrid import run_program  # noqa: E402 (needs the path above)

SLIDES = "shaken_base"                           # friction takes all
BREAKS = "brittle_release"                       # a joint fails at 1.17 s
STEP = 0.001


def command(binary, root, name, directory, *overrides):
    words = [str(binary), str(root / "parameters/verification" / (name + ".prm")), "--force"]
    for override in ("Output/Directory=%s" % directory, "Output/Picture interval=0", *overrides):
        words += ["-s", override]
    return words


def ask(line):
    """Exit code and output of the program."""
    code, output, errors = run_program(line[0], line[1:])
    return code, output + errors


def run(*words):
    return ask(command(*words))


def summary_of(directory):
    return json.loads((directory / "summary.json").read_text(encoding="utf-8"))


def nothing_left(directory):
    return not (directory / "checkpoint/further_run").exists()


def without_monitors(root, work):
    """The scene that slides, without monitors; its paths are those of the scene."""
    text = (root / "parameters/verification" / (SLIDES + ".prm")).read_text(encoding="utf-8")
    text = re.sub(r"subsection Monitors.*?\nend\n", "", text, flags=re.S)
    work.mkdir(parents=True, exist_ok=True)
    copy = work / (SLIDES + "_without_monitors.prm")
    copy.write_text(re.sub(r"= \.\./\.\./", "= %s/" % root, text), encoding="utf-8")
    return copy


def check_without_monitors(words, root, work, require):
    """It watches the centre of the block, as the monitor of the scene does."""
    scene = without_monitors(root, work)
    binary = words[0]

    def compute(place, *overrides):
        line = [str(binary), str(scene), "--force"]
        for override in ("Output/Directory=%s" % place, "Output/Picture interval=0", *overrides):
            line += ["-s", override]
        return ask(line)

    code, output = compute(work / "watched")
    error, beside = (summary_of(work / name)["probable_error"] for name in ("watched", "two"))
    require(code == 0 and error["estimated"] and error["watched"] == "1 block", "a run without monitors tells its error, too", output)
    require("at 1 block, as there are no monitors, by the run" in output.splitlines()[-1], "and says what was watched", output)
    for quantity in ("velocity", "acceleration"):
        parts = [found["time_step"][quantity]["part_of_peak"] for found in (error, beside)]
        require(0.9 < parts[0] / parts[1] < 1.1, "which is that of a monitor in the same place: " + quantity, output)
    require(summary_of(work / "watched")["monitors"] == {}, "it has no monitors for that", output)
    require(summary_of(work / "watched")["slip_m"] == summary_of(work / "two")["slip_m"], "it slips as with monitors", output)
    with h5py.File(work / "watched/run.h5", "r") as file:
        require("monitors" not in file and "filtered/monitors" not in file, "run.h5 has no rows of what was watched", output)
    compute(work / "watched_parts", "Time/End time=6", "Time/Error estimate=one run", "Checkpoint/Step interval=1000")
    code, output = ask([binary, "--resume", work / "watched_parts", "-s", "Time/End time=12", "-s", "Time/Error estimate=automatic"])
    require(code == 0 and summary_of(work / "watched_parts")["probable_error"]["time_step"] == error["time_step"],
            "a run that goes on tells the same, as its checkpoint has what was watched", output)


def check_error(words, work, same_bits, require):
    code, output = run(*words, SLIDES, work / "two")
    _, alone = run(*words, SLIDES, work / "one", "Time/Error estimate=one run")
    error = summary_of(work / "two")["probable_error"]
    require(code == 0 and error["estimated"] and error["measured_from_time_step_s"] == STEP / 2, "a second run tells the error", output)
    require("by the run in steps of 0.0005 s: displacement" in output.splitlines()[-1], "the last line says it", output)
    _, longer = run(*words, SLIDES, work / "longer", "Time/Error estimate=twice the step")
    other = summary_of(work / "longer")["probable_error"]
    require(other["measured_from_time_step_s"] == 2 * STEP and "in steps of 0.002 s tells it, below" in longer, "one in longer steps, if asked for", longer)
    parts = [found["time_step"]["velocity"]["part_of_peak"] for found in (error, other)]
    require(1 / 3 < parts[0] / parts[1] < 3, "both tell the same but for a factor of 3", longer)
    require("by the run in steps" in (work / "two/log.txt").read_text(encoding="utf-8"), "log.txt has it, too", output)
    require(not summary_of(work / "one")["probable_error"]["estimated"] and "hybrid accuracy tells it" in alone,
            "one run leaves it out, and says what tells it", alone)
    require(same_bits(work / "one", work / "two"), "the histories have the same bits", output)
    require(summary_of(work / "two")["mesh_error"]["estimated"] is False, "a block that is given has no coarser mesh", output)
    require(nothing_left(work / "two"), "nothing is left of the second run", output)
    _, output = run(*words, "time_order", work / "waves")
    require("the scene once more" not in output and summary_of(work / "waves")["probable_error"]["measured_from_time_step_s"] is None,
            "a run that tells its error has no second one", output)


def check_monitors_of_both(words, work, require):
    """A loose block that vertical shaking throws up, beside a monitor of the ground, which says nothing of the block."""
    directory = work / "both"
    thrown = ("Motion/Type=sine", "Motion/Peak=16 m/s2", "Motion/Angle=90", "Motion/Frequency=1", "Motion/Cycles=2", "Motion/Taper=1", "Time/End time=2.5",
              "Mesh/Numbers=Angle = 0; Block width = 2", "Monitors/Points=block: 1, 0.5; ground: -5, 0", "Monitors/Base=")
    _, output = run(*words, SLIDES, directory, *thrown)
    found = summary_of(directory)["probable_error"]
    require("1 of 2 monitors are on blocks that no joint holds" in output and found["time_step"]["velocity"]["part_of_peak"] > 0.01,
            "a block that flies beside a monitor of the ground: errors by a second run", output)


def check_resumed(words, work, require):
    """A run that is resumed after its end says what further runs have told; one that goes on asks them anew."""
    binary, place = str(words[0]), work / "two"
    before = summary_of(place)["probable_error"]
    said = (place / "log.txt").read_text(encoding="utf-8").splitlines()[-1]
    code, output = ask([binary, "--resume", place])
    log = (place / "log.txt").read_text(encoding="utf-8")
    require(code == 0 and "iterations/step" not in output, "it is not computed again", output)
    require(summary_of(place)["probable_error"] == before and log.splitlines()[-1] == said, "and says the same", output)
    require(ask([binary, "--resume", place, "-s", "Time/End time=14"])[0] == 0, "it goes on", log)
    after = summary_of(place)["probable_error"]
    require(after["estimated"] and after["time_step"] != before["time_step"], "two seconds more have errors of their own", log)


def check_beginning(words, work, require):
    """A run that ends as the motion begins at its top: one run does not tell its error. Resumed, it says the same; a longer one tells it alone."""
    binary, short = str(words[0]), ["Time/End time=0.2", "Mesh/Error estimate=one run"]
    _, output = run(*words, "coupled_column", work / "begins", *short)
    error = summary_of(work / "begins")["probable_error"]
    require("not estimated, the run ends as the motion begins at top; the scene once more" in output and "by the run in steps of 0.001 s" in output,
            "a run that ends as the motion begins has a second one", output)
    _, alone = run(*words, "coupled_column", work / "begins_alone", *short, "Time/Error estimate=one run")
    require("the run ends as the motion begins at top; hybrid accuracy tells it" in alone
            and not summary_of(work / "begins_alone")["probable_error"]["estimated"], "one run says that it does not tell it", alone)
    run(*words, "coupled_column", work / "begins_parts", "Time/End time=0.12", "Time/Error estimate=one run", "Mesh/Error estimate=one run")

    def go_on(end, *overrides):
        line = [binary, "--resume", str(work / "begins_parts"), "-s", "Time/End time=%g" % end]
        for override in overrides:
            line += ["-s", override]
        output = ask(line)[1]
        return summary_of(work / "begins_parts")["probable_error"], output

    told, output = go_on(0.2, "Time/Error estimate=automatic")
    require(told["time_step"] == error["time_step"] and told["measured_from_time_step_s"] == error["measured_from_time_step_s"],
            "a run that was resumed decides and tells the same", output)
    told, output = go_on(0.5)
    require(told["estimated"] and told["measured_from_time_step_s"] is None, "once the motion is there, the run tells it alone", output)


def check_mesh(words, work, same_bits, require):
    """A bar of bonded blocks: two meshes that are coarser tell the error of its own."""
    code, output = run(*words, "bonded_bar", work / "mesh")
    _, alone = run(*words, "bonded_bar", work / "mesh_alone", "Mesh/Error estimate=one run")
    error = summary_of(work / "mesh")["mesh_error"]
    require(code == 0 and error["estimated"] and error["coarser_meshes"] == 2, "two coarser meshes tell the error", output)
    halved = error["half_the_size"]["velocity"]["part_of_peak"] / error["mesh"]["velocity"]["part_of_peak"]
    require(0.2 < halved < 0.5, "half the size leaves a quarter to a half", output)
    require("by those twice and four times as large: displacement" in output.splitlines()[-1], "the last line says it", output)
    require(summary_of(work / "mesh_alone")["mesh_error"]["estimated"] is False and "hybrid accuracy" in alone, "one run leaves it out", alone)
    require(same_bits(work / "mesh", work / "mesh_alone") and nothing_left(work / "mesh"), "the run stays as it is", output)


def check_failure(words, work, require):
    _, output = run(*words, BREAKS, work / "breaks")
    second = output[output.index("Results"):]
    until = summary_of(work / "breaks")["probable_error"]["until_s"]
    require(1.0 < until < 1.18 and "of %.4g s" % (until + STEP) in second.replace("t = ", ""),
            "the second run ends with the first failed joint, as there is no filter", second)


def check_flutter(words, work, require):
    """Blocks with little damping slide: what runs in longer steps damp, others resolve, so they tell the least that the error is."""
    _, output = run(*words, "direct_shear", work / "flutter")
    _, damped = run(*words, "direct_shear", work / "damped", "Blocks/Damping ratio=0.05")
    require("by the run in steps" in output and "may flutter in yet shorter steps (Blocks/Damping ratio)" in output
            and summary_of(work / "flutter")["probable_error"]["blocks_may_flutter"],
            "blocks that may flutter: the least that their error is, and what helps", output)
    require("by the run in steps" in damped and "flutter" not in damped, "damped ones have theirs", damped)
    for little in ("Blocks/Damping ratio=0.0003", "Maxwell damping/Block ratio=0.02"):
        _, output = run(*words, "direct_shear", work / "little", little)
        require("may flutter" in output, "nor does %s end it" % little, output)
    _, flat = run(*words, "direct_shear", work / "flat", "Materials/joint/Friction angle=10")
    require("by the run in steps" in flat and "flutter" not in flat, "so have those on a belt of 10 degrees", flat)


def check_interruption(words, work, require):
    """Ctrl-C while the second run is under way."""
    directory = work / "interrupted"
    shutil.rmtree(directory, ignore_errors=True)
    # 60,000 steps of the second one; a sine, as the sum of waves of so long a synthetic motion would take most of the time
    long = ["Time/End time=30", "Motion/Type=sine", "Motion/Frequency=2", "Motion/Cycles=60", "Motion/Peak=3.2"]
    process = subprocess.Popen(command(*words, SLIDES, directory, *long), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    second = directory / "checkpoint/further_run/run.h5"
    while process.poll() is None and not second.exists():
        time.sleep(0.002)
    in_time = process.poll() is None
    process.send_signal(signal.SIGINT)
    output, _ = process.communicate()
    summary = summary_of(directory)
    require(in_time and process.returncode == 0 and summary["finished"] and not summary["probable_error"]["estimated"],
            "an interruption leaves a complete run", output)
    require("the further run did not come to its end" in output and nothing_left(directory)
            and not (directory / "checkpoint/told_errors.bin").exists(), "and says so; --resume tries again", output)


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    binary, root, work = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    sys.path[:0] = [str(root / "tests"), str(root / "tests/verification")]
    from error_target_test import same_bits
    from run_hybrid import require

    os.environ.update(OPENBLAS_NUM_THREADS="1", OMP_NUM_THREADS="1")
    words = (binary, root)
    check_error(words, work, same_bits, require)
    check_without_monitors(words, root, work, require)
    check_monitors_of_both(words, work, require)
    check_resumed(words, work, require)
    check_beginning(words, work, require)
    check_mesh(words, work, same_bits, require)
    check_failure(words, work, require)
    check_flutter(words, work, require)
    check_interruption(words, work, require)


if __name__ == "__main__":
    main()
