# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs one row once, alone, and takes what it cost from the run's own summary."""

import functools
import json
import os
import shutil
import signal
import subprocess
import sys
import time

from hybrid_run import MissingData, Run, UserError
from hybrid_tools.benchmark import catalogue
from hybrid_tools.study.program import ONE_RUN
from hybrid_tools.study.runner import busy_time, die_with_parent, own_time

POLL = 0.02  # [s]
GRACE = 120.0  # for a run that was told to end after its step [s]
ENVIRONMENT = {"OPENBLAS_NUM_THREADS": "1", "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
TIMES = ("wall_time_s", "processor_time_s", "processor_times_s", "timings_s", "peak_memory_mb")  # differ between equal runs


class TookTooLong(Exception):
    """Nothing can be told of a run that reached its limit before its first step."""


def processor_time(process):
    """Of a child that is at work [s]."""
    try:
        with open("/proc/%d/stat" % process, encoding="ascii") as line:
            user, system = line.read().rpartition(")")[2].split()[11:13]
    except (OSError, ValueError):
        return 0.0
    return (int(user) + int(system)) / os.sysconf("SC_CLK_TCK")


def wait(child, limit):
    """Until it ends; beyond the limit of processor time [s] it is asked to end after its step, then killed."""
    asked = None
    while child.poll() is None:
        time.sleep(POLL)
        if asked is None and limit and processor_time(child.pid) > limit:
            child.send_signal(signal.SIGINT)
            asked = time.monotonic()
        elif asked is not None and time.monotonic() > asked + GRACE:
            child.kill()
            child.wait()
    return asked is not None


@functools.lru_cache
def one_run(program):
    """Settings that leave out runs for the errors; an old program makes none and does not know them."""
    said = subprocess.run([program, "--print-parameters"], capture_output=True, text=True, check=False).stdout
    return ONE_RUN if "Error estimate" in said else []


def run(program, row, directory, overrides=(), limit=None, threads=1):
    """summary.json of one run, with "stopped" (it reached the limit) and "other_load" (cores that other work took meanwhile)."""
    shutil.rmtree(directory, ignore_errors=True)
    settings = list(overrides) + ["Output/Directory=" + directory, "Checkpoint/Wall interval=0", *one_run(program), "Parallel/Threads=%d" % threads]
    words = [program, row.path, "--force"] + [word for setting in settings for word in ("-s", setting)]
    begin, others = time.monotonic(), busy_time() - own_time()
    os.makedirs(directory, exist_ok=True)
    console = os.path.join(directory, "console.txt")
    with open(console, "wb") as output:
        # pylint: disable=subprocess-popen-preexec-fn (one thread; no other way to ask for the signal)
        child = subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=output, stderr=subprocess.STDOUT, start_new_session=True,
                                 preexec_fn=die_with_parent, env=dict(os.environ, **ENVIRONMENT))
    stopped = wait(child, limit)
    file = os.path.join(directory, "summary.json")
    if stopped and not os.path.exists(file):
        raise TookTooLong
    if child.returncode not in ((0, 130) if stopped else (0,)):
        with open(console, encoding="utf-8", errors="replace") as text:
            lines = text.read().strip().splitlines() or ["exit code %d" % child.returncode]
        raise UserError("%s: %s" % (row.name, lines[-1].removeprefix("error: ")))
    with open(file, encoding="utf-8") as text:
        summary = json.load(text)
    if "processor_times_s" not in summary:
        raise UserError("'%s' is too old: its summary.json has no processor_times_s" % program)
    load = (busy_time() - own_time() - others) / max(time.monotonic() - begin, 1e-3)
    summary.update(stopped=stopped, other_load=round(max(0.0, load), 2), **iterations(directory))
    return summary


def iterations(directory):
    """Of the linear solver, all steps together, and the most open-close iterations of a step; None without blocks."""
    try:
        run = Run(directory)
        return {"solver_iterations": int(run.get("steps/solver_iterations").sum()), "most_iterations": int(run.get("steps/iterations").max())}
    except (MissingData, UserError):
        return {"solver_iterations": None, "most_iterations": None}


def value(row, summary):
    """What the row measures, in its unit; None where the run did not come so far."""
    times, steps = summary["processor_times_s"], summary["steps"]
    stepping = times.get("steps", 0.0)
    if row.kind == catalogue.STATIC:
        return times.get("static_stage")
    if row.kind == catalogue.RUN:
        return None if summary["stopped"] else summary["processor_time_s"]
    if row.kind == catalogue.SIMULATED:
        simulated = summary["simulated_time_s"]
        return (times.get("first_step", 0.0) + stepping) / simulated if simulated > 0 else None
    if steps < 2 or stepping <= 0:
        return None
    if row.kind == catalogue.WAVES:
        return 1e9 * stepping / (steps - 1) / summary["continuum_unknowns"]
    return 1e3 * stepping / (steps - 1) if row.kind == catalogue.STEP else summary["blocks"] * (steps - 1) / stepping


def wall_of_steps(summary):
    """Wall time of all steps [s]."""
    return sum(summary["timings_s"].get(part, 0.0) for part in ("blocks", "continuum"))


def without_times(summary):
    """What two equal runs must have in common."""
    return {name: content for name, content in summary.items() if name not in TIMES + ("other_load", "stopped")}


class Busy:
    """Another process that keeps one core busy, while it is entered."""

    def __enter__(self):
        # pylint: disable=subprocess-popen-preexec-fn
        self.process = subprocess.Popen([sys.executable, "-c", "while True: pass"], preexec_fn=die_with_parent)

    def __exit__(self, *_):
        self.process.kill()
        self.process.wait()


def on_threads(program, row, directory, overrides=(), limit=None):
    """(wall time of two threads over that of one, summary with two). @raises UserError if their results differ."""
    single = run(program, row, directory, overrides, limit)
    if row.beside_work:
        with Busy():
            double = run(program, row, directory, overrides, limit, threads=2)
    else:
        double = run(program, row, directory, overrides, limit, threads=2)
    if single["stopped"] or double["stopped"]:
        return None, double
    if without_times(single) != without_times(double):
        raise UserError("%s: two threads do not have the results of one" % row.name)
    return wall_of_steps(double) / wall_of_steps(single), double
