#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Beside two busy processes, a run with two threads uses little more processor time than with one (those that wait
sleep), and gives the same bits. Wall times are printed: they say how the machine shares itself out, too.

Usage: threads_test.py HYBRID_BINARY SOURCE_DIR WORK_DIR
"""
import multiprocessing
import os
import pathlib
import shutil
import subprocess
import sys
import time

from determinism_test import differences, read

MOST_PROCESSOR = 1.5  # of one thread; threads that spin need 5 times
ATTEMPTS = 3  # other work on the machine may fall on one of the two runs


def busy():
    while True:
        pass


def run(binary, scene, directory, threads, most_seconds):
    """(wall time, processor time) [s] of a run; infinite if it was ended after @p most_seconds."""
    words = [binary, scene, "--force"]
    for setting in ("Mesh/Numbers=Resolution/h = 4", "Time/Time step=0.001", "Time/End time=0.1", "Time/Error estimate=one run",
                    "Mesh/Error estimate=one run", f"Output/Directory={directory}", f"Parallel/Threads={threads}"):
        words += ["-s", setting]
    environment = {name: value for name, value in os.environ.items() if name not in ("OMP_WAIT_POLICY", "GOMP_SPINCOUNT")}
    start, before = time.monotonic(), os.times()
    try:
        subprocess.run(words, check=True, stdout=subprocess.DEVNULL, env=environment, timeout=most_seconds)
    except subprocess.TimeoutExpired:
        return float("inf"), float("inf")
    after = os.times()
    return time.monotonic() - start, after[2] + after[3] - before[2] - before[3]


def compare(binary, scene, work):
    """Whether two threads cost little beside two busy processes."""
    one = run(binary, scene, work / "one", 1, 600)
    two = run(binary, scene, work / "two", 2, 600)
    print(f"one thread {one[0]:.1f} s, processor {one[1]:.1f} s; two threads {two[0]:.1f} s, processor {two[1]:.1f} s: "
          f"{two[0] / one[0]:.2f} and {two[1] / one[1]:.2f} of one, allowed {MOST_PROCESSOR} of processor time")
    return two[1] <= MOST_PROCESSOR * one[1]


def main():
    binary, source, work = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    shutil.rmtree(work, ignore_errors=True)
    others = [multiprocessing.Process(target=busy, daemon=True) for _ in range(2)]
    for other in others:
        other.start()
    good = any(compare(binary, source / "parameters/majiagou/badong_long_periods.prm", work) for _ in range(ATTEMPTS))
    for other in others:
        other.terminate()
    if not good:
        return 1
    names = differences(read(work / "one"), read(work / "two"))
    for name in names:
        print(f"{name} differs with two threads")
    return 1 if names else 0


if __name__ == "__main__":
    sys.exit(main())
