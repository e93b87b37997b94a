# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes under mpirun: how tests start, stop and resume them. The command line of a test is HYBRID_BINARY PART WORK_DIR."""
import concurrent.futures
import json
import os
import pathlib
import shutil
import subprocess
import sys
import time

from runs_alike import series

BINARY, PART, WORK = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3]).resolve()
ROOT = pathlib.Path(__file__).resolve().parents[2]
SCENES = ROOT / "parameters/verification"
ENVIRONMENT = dict(os.environ, OPENBLAS_NUM_THREADS="1", OMP_NUM_THREADS="1")
ONE_RUN = ["Time/Error estimate=one run", "Mesh/Error estimate=one run"]
ERRORS = ["Time/Error estimate=automatic", "Mesh/Error estimate=automatic"]
ALONE = "computed by the first one alone"
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
    require(expect in (None, result.returncode), f"{processes} processes, {words[1:6]}: exit code {expect}, not {result.returncode}: {result.stderr[-400:]}")
    return result


def two_at_once(compute, names):
    """Runs of one process each leave half of two cores alone."""
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        list(pool.map(compute, names))


def resume(processes, directory, overrides=()):
    words = [BINARY, "--resume", str(directory)]
    for override in overrides:
        words += ["-s", override]
    return run(processes, words)


def require_same_bits(expected, directory, what):
    found = series(directory)
    different = [n for n in expected if n not in found or expected[n].tobytes() != found[n].tobytes()]
    require(not different, f"{what}: the same bits, but for {different[:4]}")


def require_same_errors(what, *directories):
    """Of runs by one and by two processes; further ones with fewer blocks are computed by the first process alone."""
    one, two = ({name: summary[name] for name in ("probable_error", "mesh_error")}
                for summary in (json.loads((directory / "summary.json").read_text()) for directory in directories))
    require(one["mesh_error"]["estimated"] and one == two, f"{what}: two processes tell the same errors as one: {one}, {two}")
    has_monitors = any(name.startswith("monitors/") for name in series(directories[0]))
    require((one["probable_error"]["watched"] == "") == has_monitors, f"{what}: points are watched without monitors only")


def children(process):
    """Ids of the processes that mpirun has started."""
    text = subprocess.run(["ps", "-o", "pid=,args=", "--ppid", str(process.pid)], capture_output=True, text=True).stdout
    return [int(line.split()[0]) for line in text.splitlines() if BINARY in line]


def stopped(directory, how, overrides, scene="lamb", output=None, patience=1):
    """A run of two processes that is stopped once it has written a checkpoint. @param output gets what it says. @param patience of mpirun
    before it kills those that are left [s]. @return its exit code."""
    process = subprocess.Popen([*launcher(2), "--mca", "odls_base_sigkill_timeout", str(patience), *words_of(scene, directory, overrides)],
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


def main(parts):
    shutil.rmtree(WORK, ignore_errors=True)
    parts[PART]()
    if complaints:
        sys.exit(f"{len(complaints)} complaints, first: {complaints[0]}")
    print("ok")
