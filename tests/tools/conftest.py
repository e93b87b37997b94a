# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of the tools share: the program, scenes that take a second, runs made from formulas."""
import os
import pathlib
import subprocess
import sys

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
TOOLS = ROOT / "src/tools"
ONE_RUN = ["-s", "Time/Error estimate=one run", "-s", "Mesh/Error estimate=one run"]  # no further ones, which tell its errors
sys.path[:0] = [str(TOOLS), str(pathlib.Path(__file__).parent)]

import forked_tool  # noqa: E402 (needs the path above)
import make_synthetic_run  # noqa: E402


def around(exact, error=0.005):
    """Words of hybrid fos: two trials show a factor to be where it must be, to this part of it. Other tests search from 1 on."""
    return ["--range", (1 - error) * exact, (1 + error) * exact, "--tolerance", 2.02 * error]


@pytest.fixture(scope="session")
def hybrid():
    """hybrid("plot", "output", ..., cwd=...): the program with these words; its output as text.

    The program itself calls a tool the first time in each file of tests. Its start takes a second, that of a tool another: from then on
    the tool runs in a copy of this process.
    """
    begun, limit = set(), 3000 if "HYBRID_LONG" in os.environ else 600

    def call(*words, **options):
        name, *others = map(str, words)
        if name in begun:
            return forked_tool.run(name, others, limit, **options)
        begun.update({name} & forked_tool.NAMES)
        return subprocess.run([os.environ["HYBRID_PROGRAM"], name, *others], capture_output=True, text=True, timeout=limit, **options)

    return call


@pytest.fixture
def synthetic_run(tmp_path):
    """synthetic_run("complete" | "runout" | "away" | "bare"): directory of a run made from formulas."""
    def make(kind, name="run"):
        directory = tmp_path / name
        directory.mkdir()
        make_synthetic_run.main(str(directory), kind)
        return directory

    return make
