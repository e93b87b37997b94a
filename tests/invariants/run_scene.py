# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs a scene of the net and judges it."""

import atexit
import functools
import pathlib
import shutil
import sys
import traceback

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / part) for part in ("src/tools", "tests", "tests/verification/cases", "tests/invariants")]

from finished_run import FinishedRun  # noqa: E402 (needs the path above)
from judge import judge  # noqa: E402
from run_hybrid import program_for_many  # noqa: E402


@functools.cache
def program_of(binary):
    """Waiting threads sleep: the machine may be busy."""
    program = program_for_many(binary, OMP_WAIT_POLICY="passive")
    atexit.register(program.end)
    return program


def run_program(binary, arguments):
    """Exit code and everything that was said."""
    code, said, errors = program_of(str(binary)).ask(arguments)
    return code, said + errors


def run_scene(binary, scene, directory, *overrides):
    """Exit code, what was said, and the FinishedRun (None if there is none). The directory is replaced."""
    shutil.rmtree(directory, ignore_errors=True)
    file = scene.write(directory)
    results = pathlib.Path(directory) / "out"
    arguments = [file, "-s", "Output/Directory=%s" % results, "-s", "Time/Error estimate=one run",
               "-s", "Mesh/Error estimate=one run"]
    for override in overrides or ("Output/Picture interval=0.02",):
        arguments += ["-s", override]
    code, said = run_program(binary, arguments)
    return code, said, FinishedRun(scene, results) if (results / "summary.json").exists() else None


def judge_scene(binary, scene, directory):
    """Sentences about what is wrong with the scene."""
    code, said, run = run_scene(binary, scene, directory)
    if code != 0:
        return ["ends with code %d: %s" % (code, " ".join(said.split())[-300:])]
    try:
        return judge(run)
    except Exception:  # a run that cannot be judged is not well
        return ["cannot be judged: " + traceback.format_exc()]
