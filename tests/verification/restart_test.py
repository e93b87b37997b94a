#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A run that is stopped, killed or runs out of disk loses nothing, and goes on to the bits of an uninterrupted one.

Usage: restart_test.py HYBRID_BINARY PART WORK_DIR     PART: coupled, dda, signals, static, faults
"""
import json
import os
import pathlib
import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import time

import h5py

BINARY, PART, WORK = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3]).resolve()
ROOT = pathlib.Path(__file__).resolve().parents[2]
COUPLED = ROOT / "parameters/verification/restart_coupled.prm"
SQUARES = ROOT / "parameters/verification/unit_squares.prm"
TOPPLING = ["Mesh/Numbers=Angle = 20; Columns = 4; Rows = 4; Base above = 20", "Time/End time=0.35", "Output/Picture interval=0.05",
            "Output/Flush interval=0.02", "Monitors/Points=block: 0.299, 0.641"]
# A static stage that takes most of the time, five steps after it.
FINE = ["Mesh/Numbers=Resolution/h = 0.35", "Time/End time=0.01"]
# A stiffness of the surface that conjugate gradients find for longer than five steps take.
ITERATED = ["Continuum/Linear solver=conjugate gradients", "Bedding planes/Strength=elastic", "Mesh/Numbers=Resolution/h = 1", "Time/End time=0.01"]
ONE_RUN = ["Time/Error estimate=one run", "Mesh/Error estimate=one run"]  # no further ones, which begin when all is done
ENVIRONMENT = dict(os.environ, OPENBLAS_NUM_THREADS="1", OMP_NUM_THREADS="1")
# Of summary.json, besides steps/wall_time of run.h5; a run that goes on makes its list of near blocks anew.
WALL = {"wall_time_s", "processor_time_s", "processor_times_s", "peak_memory_mb", "timings_s", "contact_search"}
complaints = []


def require(condition, text):
    if not condition:
        complaints.append(text)
        print("FAILED:", text)


def words_of(scene, directory, overrides=(), *options):
    words = [BINARY, str(scene), *options, "-s", f"Output/Directory={directory}"]
    for override in [*ONE_RUN, *overrides]:
        words += ["-s", override]
    return words


def run(words, expect=0, full=None):
    """Run to the end. @param full (begun, limit): once begun() is true, no file may grow beyond limit bytes
    (earlier MPI would fail). @return what it printed on stderr, or on stdout if it ends well."""
    process = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=ENVIRONMENT)
    if full is not None:
        while process.poll() is None and not full[0]():
            time.sleep(0.002)
        if process.poll() is None:
            resource.prlimit(process.pid, resource.RLIMIT_FSIZE, (full[1], full[1]))
    output, errors = process.communicate(timeout=600)
    require(process.returncode == expect, f"{words[1:4]}: exit code {expect}, not {process.returncode}: {errors[-300:]}")
    if expect not in (0, 1, 130):
        lines = errors.splitlines()
        require(len(lines) == 1 and lines[0].startswith("error: "), f"one line 'error: ...', not {errors!r}")
    return errors if expect else output


def data_sets(directory):
    data = {}
    with h5py.File(directory / "run.h5", "r") as file:
        file.visititems(lambda name, item: data.update({name: item[()]}) if isinstance(item, h5py.Dataset) else None)
    return data


def results(directory):
    """Everything that must be equal, as bytes by name."""
    found = {name: (str(value.shape), value.tobytes()) for name, value in data_sets(directory).items()
             if name != "steps/wall_time"}
    for file in [*directory.glob("*.pvd"), *directory.glob("vtu/*.vtu")]:
        found[file.name] = file.read_bytes()
    summary = json.loads((directory / "summary.json").read_text(encoding="utf-8"))
    parts = sum(summary["processor_times_s"].values())
    require(abs(parts - summary["processor_time_s"]) < 0.05, f"{directory.name}: parts of the processor time make {parts} s")
    found.update({"summary " + key: value for key, value in summary.items() if key not in WALL})
    log = (directory / "log.txt").read_text(encoding="utf-8").splitlines()
    found["log"] = [line for line in log if not line.startswith("Resumed")]
    return found


def compare(whole, directory, what, besides=()):
    one, other = results(whole), results(directory)
    names = sorted(one.keys() ^ other.keys()) + [name for name in one if name in other and one[name] != other[name]]
    names = [name for name in names if name not in besides]
    require(not names, f"{what}: {', '.join(names[:8])} differ")


def check_readable(directory):
    """After a kill: whatever there is can be read. @return the number of steps in run.h5."""
    for file in directory.glob("*.pvd"):
        listed = [line.split('file="')[1].split('"')[0] for line in file.read_text().splitlines() if "file=" in line]
        require(all((directory / name).is_file() for name in listed), f"{file.name} lists pictures that are there")
    if (directory / "log.txt").exists():  # a run that is killed as its scene is prepared has none yet
        (directory / "log.txt").read_text(encoding="utf-8")
    if not (directory / "run.h5").exists():
        return -1
    try:
        return len(data_sets(directory)["time"])
    except (OSError, RuntimeError, KeyError) as error:
        require(False, f"run.h5 of a killed run can be read: {error}")
        return -1


def processor_time(process):
    """@return what the process has used so far [s]; unlike wall time it does not depend on what else the machine does."""
    fields = pathlib.Path(f"/proc/{process.pid}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def wait_for_processor_time(process, wait):
    """Return once the process has used so much more, or has ended."""
    end = processor_time(process) + wait
    while process.poll() is None and processor_time(process) < end:
        time.sleep(0.005)


def end_or_kill(words, seconds):
    """Run and kill after so much processor time, if it is a number. @return the exit code, None if killed."""
    with open(WORK / "errors.txt", "w") as errors:
        process = subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=errors, env=ENVIRONMENT)
    while process.poll() is None:
        if seconds is not None and processor_time(process) >= seconds:
            time.sleep(random.uniform(0., 0.02))  # between two ticks of the clock
            process.kill()
            process.wait()
            return process.returncode if process.returncode >= 0 else None
        time.sleep(0.002)
    return process.returncode


def kill_and_resume(scene, overrides, rounds, kills):
    """Runs that are killed with SIGKILL at random moments, several times each."""
    whole = WORK / "whole"
    start = os.times().children_user + os.times().children_system
    run(words_of(scene, whole, overrides))
    duration = os.times().children_user + os.times().children_system - start
    data = data_sets(whole)
    print(f"uninterrupted: {len(data)} data sets, {data['time'].size} steps, {duration:.2f} s, "
          f"{data['joints/failure_time'].size} joints failed, "
          f"{len(set(data['steps/dt']))} step sizes")
    seed = int(os.environ.get("HYBRID_SEED", "1"))
    random.seed(seed)
    killed = 0
    for round_number in range(rounds):
        directory = WORK / f"killed_{round_number}"
        interval = random.choice([2, 7, 20])
        words = words_of(scene, directory, [*overrides, f"Checkpoint/Step interval={interval}"])
        moments = []
        while True:
            code = end_or_kill(words, random.uniform(0.1, 1.1) * duration if len(moments) < kills else None)
            if code is not None:
                require(code == 0, f"a resumed run finishes: {(WORK / 'errors.txt').read_text()}")
                break
            if (directory / "params.used.prm").exists():
                words = [BINARY, "--resume", str(directory)]
                moments.append(check_readable(directory))
            else:
                moments.append("nothing yet")
        killed += len(moments)
        print(f"round {round_number}: checkpoint every {interval} steps, steps in run.h5 when killed: {moments}")
        compare(whole, directory, f"killed {len(moments)} times")
    require(killed > 0, "one run at least is killed")


def stop_and_resume(scene, overrides, moments):
    """One run in pieces: each ends at the next moment and goes on with a later end."""
    directory = WORK / "pieces"
    run(words_of(scene, directory, [*overrides, f"Time/End time={moments[0]}"]))
    for end in moments[1:]:
        run([BINARY, "--resume", str(directory), "-s", f"Time/End time={end}"])
    compare(WORK / "whole", directory, f"in {len(moments)} pieces", besides=["log"])  # the card tells the end


def check_coupled():
    WORK.mkdir(parents=True, exist_ok=True)
    table = WORK / "level.csv"
    table.write_text("0,16\n0.2,16\n0.5,19\n")  # of a reservoir that rises past the blocks
    reservoir = ["Water/Method=pressures", f"Water/Level file={table}"]
    kill_and_resume(COUPLED, reservoir, 2, 3)
    stop_and_resume(COUPLED, reservoir, [0.1, 0.32, 0.35, 0.38, 0.41, 0.44, 0.5, 0.6])


def check_dda():
    kill_and_resume(SQUARES, TOPPLING, 2, 3)
    stop_and_resume(SQUARES, TOPPLING, [0.002, 0.08, 0.16, 0.24, 0.31, 0.35])


def interrupt(number, wait, name="signal", overrides=()):
    """Send a signal to a run so much processor time [s] after it has begun. @return its directory."""
    directory = WORK / f"{name}_{number}"
    process = subprocess.Popen(words_of(COUPLED, directory, overrides), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                               env=ENVIRONMENT, preexec_fn=lambda: signal.signal(number, signal.SIG_DFL))
    while process.poll() is None and not (directory / "checkpoint/state.bin").exists():
        time.sleep(0.005)
    wait_for_processor_time(process, wait)
    process.send_signal(number)
    output = process.communicate(timeout=600)[0]
    require(process.returncode == 130, f"signal {number}: exit code 130, not {process.returncode}")
    require(f"hybrid --resume {directory}" in output, f"signal {number}: says how to go on")
    return directory


def check_signals():
    whole = WORK / "whole"
    run(words_of(COUPLED, whole))
    for number, wait in ((signal.SIGINT, 0.), (signal.SIGTERM, 0.05), (signal.SIGHUP, 0.1)):
        directory = interrupt(number, wait)
        steps = check_readable(directory)
        summary = json.loads((directory / "summary.json").read_text(encoding="utf-8"))
        require(not summary["finished"] and summary["steps"] == steps > 0, f"signal {number}: a summary of {steps} steps")
        run([BINARY, "--resume", str(directory)])
        log = [line for line in (directory / "log.txt").read_text().splitlines() if "Interrupted" in line]
        require(not log, "the log goes on from the checkpoint")
        compare(whole, directory, f"signal {number} after {steps} steps")

    # A later end is all that a finished run needs to go on.
    short = WORK / "short"
    run(words_of(COUPLED, short, ["Time/End time=0.4"]))
    run([BINARY, "--resume", str(short), "-s", "Time/End time=0.6"])
    compare(whole, short, "extended from 0.4 to 0.6 s", besides=["log"])
    before = results(short)
    run([BINARY, "--resume", str(short)])
    require(results(short) == before, "resuming a finished run changes nothing")
    refused = subprocess.run([BINARY, "--resume", str(short), "-s", "Time/End time=0.2"], capture_output=True, text=True, env=ENVIRONMENT)
    require(refused.returncode == 2 and "cannot end earlier" in refused.stderr and results(short) == before
            and "End time = 0.2" not in re.sub(" +", " ", (short / "params.used.prm").read_text()),
            f"an end before the present time is refused and changes nothing, not {refused.returncode}: {refused.stderr}")
    check_killed_extension()
    check_search()


def check_search():
    """A signal while the stiffness of the surface is found ends the search with a sentence, and nothing is lost."""
    whole = WORK / "whole_search"
    run(words_of(COUPLED, whole, ITERATED))
    for number in (signal.SIGINT, signal.SIGTERM):
        directory = interrupt(number, 0.05, "search", ITERATED)
        log = (directory / "log.txt").read_text(encoding="utf-8")
        require("Stopped at t = 0 s while the stiffness of the surface was found" in log, f"{directory.name}: says so, not {log[-300:]}")
        require(check_readable(directory) <= 0, f"{directory.name}: run.h5 has no step")
        run([BINARY, "--resume", str(directory)])
        compare(whole, directory, directory.name)


def check_killed_extension():
    """A finished run that is extended and killed: its histories go on, and there are no tables of the earlier end."""
    directory = WORK / "extended"
    run(words_of(COUPLED, directory, ["Time/End time=0.4", "Output/Flush interval=0.01"]))
    rows = check_readable(directory)
    require("section/blocks_displacement" in data_sets(directory), "a finished run has tables of its end")
    for seconds in (0.5, 1., 2., 4., 8.):  # nobody reads run.h5 while it is opened for writing
        end_or_kill([BINARY, "--resume", str(directory), "-s", "Time/End time=60"], seconds)
        if check_readable(directory) > rows:
            break
    left = [name for name in data_sets(directory)
            if name.startswith("joints/") or name in ("section/blocks_displacement", "section/blocks_points_final")]
    require(check_readable(directory) > rows and not left, f"extended and killed: tables of the earlier end are gone, not {left}")


def end_static_stage(number, wait, directory):
    """Send a signal to a run in its static stage, after so much processor time [s] of it. @return exit code and output."""
    shutil.rmtree(directory, ignore_errors=True)
    process = subprocess.Popen(words_of(COUPLED, directory, FINE), stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                               text=True, env=ENVIRONMENT, preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))
    log = directory / "log.txt"
    while process.poll() is None and not (log.exists() and "\nTime " in log.read_text()):  # the end of the card
        time.sleep(0.005)
    wait_for_processor_time(process, wait)
    process.send_signal(number)
    output, errors = process.communicate(timeout=600)
    require(not errors, f"{directory.name}: nothing on stderr, not {errors}")
    return process.returncode, output


def check_interrupted_stage(whole, number, wait):
    """As above; a signal that came too late (processor time, too, varies with what else runs) is sent again, earlier."""
    directory = WORK / f"static_{signal.Signals(number).name}_{wait:.3f}"
    for _ in range(5):
        code, output = end_static_stage(number, wait, directory)
        if "Static stage: relative" not in output:
            break
        wait /= 2.
    require("Static stage: relative" not in output, f"{directory.name}: the signal came in the static stage")
    print(f"{directory.name}: exit code {code}, {(output.splitlines() or ['no output'])[-1]}")
    if number == signal.SIGINT:
        require(code == 130, f"{directory.name}: exit code 130, not {code}")
        require(f"Interrupted in the static stage: there are no results and no checkpoint yet; to begin anew: "
                f"hybrid --resume {directory}" in output, f"{directory.name}: says what is left")
    require(check_readable(directory) <= 0, f"{directory.name}: run.h5 has no step")
    left = {str(file.relative_to(directory)) for file in directory.rglob("*") if file.is_file()}
    unfinished = {"run.h5.tmp"} if number == signal.SIGKILL else set()  # a file being written
    require(left <= {"log.txt", "params.used.prm", "run.h5"} | unfinished, f"{directory.name}: leaves {left}")
    expect_refusal(words_of(COUPLED, directory, FINE), directory, "--force", "--resume")
    run([BINARY, "--resume", str(directory)])
    compare(whole, directory, directory.name)


def check_static_stage():
    """Ctrl-C and SIGKILL in the static stage: told, nothing left to go on from, and begun anew with the same results."""
    whole = WORK / "whole"
    before = os.times()
    run(words_of(COUPLED, whole, FINE))
    after = os.times()
    used = after.children_user + after.children_system - before.children_user - before.children_system
    summary = json.loads((whole / "summary.json").read_text(encoding="utf-8"))
    stage = used * summary["timings_s"]["static_stage"] / summary["wall_time_s"]  # processor time of the static stage
    random.seed(int(os.environ.get("HYBRID_SEED", "1")))
    for number, wait in ((signal.SIGINT, 0.), (signal.SIGINT, random.uniform(0.1, 0.5) * stage), (signal.SIGKILL, random.uniform(0.1, 0.5) * stage)):
        check_interrupted_stage(whole, number, wait)


def check_killed_preparation():
    """Killed while the scene is prepared, before anything is computed: begun anew; run again, it is no earlier run."""
    directory = WORK / "killed_preparation"
    for again in ([BINARY, "--resume", str(directory)], words_of(COUPLED, directory, FINE)):
        shutil.rmtree(directory, ignore_errors=True)
        process = subprocess.Popen(words_of(COUPLED, directory, FINE), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env=ENVIRONMENT)
        while process.poll() is None and not (directory / "params.used.prm").exists():
            time.sleep(0.001)
        process.kill()
        process.wait()
        left = [file.name for file in directory.iterdir()]
        require(left == ["params.used.prm"], f"killed while the scene was prepared: leaves {left}")
        run(again)
        log = (directory / "log.txt").read_text(encoding="utf-8")
        require(("the run begins anew" in log) == ("--resume" in again), f"says that it begins anew: {log[:300]}")


def check_static():
    check_killed_preparation()
    check_static_stage()


def expect_refusal(words, *parts, code=2):
    message = run(words, expect=code)
    for part in parts:
        require(str(part) in message, f"the message names '{part}': {message.strip()}")
    print(message.strip())


def check_existing_directory():
    directory = WORK / "existing"
    words = words_of(COUPLED, directory, ["Time/End time=0.02"])
    run(words)
    before = (directory / "run.h5").read_bytes()
    expect_refusal(words, directory, "--force", "--resume")
    require((directory / "run.h5").read_bytes() == before, "an earlier run is not touched")
    (directory / "vtu/blocks_00099.vtu").write_text("old")
    run(words_of(COUPLED, directory, ["Time/End time=0.04"], "--force"))
    require(len(data_sets(directory)["time"]) == 20, "--force replaces it")
    require(not (directory / "vtu/blocks_00099.vtu").exists(), "--force removes its pictures")
    expect_refusal(words_of(COUPLED, "/proc/hybrid"), "/proc/hybrid")
    expect_refusal([BINARY, "--resume", str(WORK / "nowhere")], "nowhere")


def check_checkpoints(whole):
    """Checkpoints of others and damaged ones."""
    file = whole / "checkpoint/state.bin"
    good = file.read_bytes()
    before = results(whole)
    resume = [BINARY, "--resume", str(whole)]

    def changed(place, value):
        return good[:place] + bytes([value]) + good[place + 1:]

    for content, part in ((changed(12, 99), "version 99"), (changed(16, good[16] ^ 1), "other parts"),
                          (changed(5000, good[5000] ^ 1), "damaged"), (good[:-7], "damaged"),
                          (b"PK" + good[2:], "no checkpoint of hybrid"), (b"", "no checkpoint of hybrid")):
        file.write_bytes(content)
        expect_refusal(resume, file, part)
    file.unlink()
    expect_refusal(resume, "there is no checkpoint")
    file.write_bytes(good)
    expect_refusal([*resume, "-s", "Time/Time step=0.001"], "Time/Time step", "0.002")
    shutil.move(whole / "run.h5", WORK / "run.h5")
    expect_refusal(resume, "run.h5")
    shutil.move(WORK / "run.h5", whole / "run.h5")
    require(results(whole) == before, "refused checkpoints change nothing")


def check_vanished_files():
    """Mesh and record that are gone or changed when the run is resumed."""
    mesh, record = WORK / "mesh.geo", WORK / "record.txt"
    shutil.copy(ROOT / "meshes/blocks_on_layers.geo", mesh)
    record.write_text("\n".join(f"{0.01 * k} {(-1) ** k}" for k in range(50)), encoding="utf-8")
    directory = WORK / "vanished"
    run(words_of(COUPLED, directory, [f"Mesh/File={mesh}", f"Motion/File={record}", "Motion/Type=text",
                                      "Time/End time=0.02"]))
    before = results(directory)
    resume = [BINARY, "--resume", str(directory), "-s", "Time/End time=0.04"]
    for file in (mesh, record):
        text = file.read_text(encoding="utf-8")
        file.unlink()
        expect_refusal(resume, file)
        file.write_text(text.replace("{2.5,", "{2.4,") if file == mesh else text.replace("-1", "-2"), encoding="utf-8")
        expect_refusal(resume, "changed")
        file.write_text(text, encoding="utf-8")
    require(results(directory) == before, "nothing is lost")
    run(resume)


def check_no_convergence():
    """A run that stops at its smallest step has a checkpoint, and stops there again."""
    directory = WORK / "stopped"
    run(words_of(COUPLED, directory, ["Time/Maximum halvings=0", "Time/Maximum displacement ratio=5e-4"]), expect=1)
    before = results(directory)
    steps = json.loads((directory / "summary.json").read_text(encoding="utf-8"))["steps"]
    require(steps > 10, f"the run stops on its way, not after {steps} steps")
    run([BINARY, "--resume", str(directory)], expect=1)
    after = results(directory)
    twice = ("summary cuts", "summary cuts_moved_too_far", "summary unconverged_iterations", "summary iterations", "log")  # the last step is tried and told of again
    names = [name for name in before if name not in twice and before[name] != after[name]]
    require(not names, f"stops again with the same results, but for {names}")


def check_full_disk(whole):
    """No file may grow beyond a limit: what there is stays, and the run goes on when there is space."""
    size = (whole / "run.h5").stat().st_size
    for part in (0.05, 0.4, 0.9):
        limit, directory = int(part * size), WORK / f"full_{part}"
        words = words_of(COUPLED, directory, ["Checkpoint/Step interval=20"])
        message = run(words, expect=3, full=((directory / "log.txt").exists, limit))
        print(message.strip())
        require(f"'hybrid --resume {directory}'" in message, "the message says how to go on")
        steps = check_readable(directory)
        resume = [BINARY, "--resume", str(directory)]
        log = directory / "log.txt"
        before = log.stat().st_mtime_ns
        run(resume, expect=3, full=(lambda: log.exists() and log.stat().st_mtime_ns != before, limit))
        # What came after the last checkpoint, at most its interval, is computed again.
        require(check_readable(directory) >= steps - 20, "a second attempt on the full disk keeps what the checkpoint has")
        run(resume)
        compare(whole, directory, f"disk full at {limit} bytes, {steps} steps")


def check_faults():
    whole = WORK / "whole"
    run(words_of(COUPLED, whole))
    check_existing_directory()
    check_checkpoints(whole)
    check_vanished_files()
    check_no_convergence()
    check_full_disk(whole)


def main():
    shutil.rmtree(WORK, ignore_errors=True)
    WORK.mkdir(parents=True)
    {"coupled": check_coupled, "dda": check_dda, "signals": check_signals, "static": check_static, "faults": check_faults}[PART]()
    print(f"{len(complaints)} complaints")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
