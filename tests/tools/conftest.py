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

import make_synthetic_run  # noqa: E402 (needs the path above)


@pytest.fixture(scope="session")
def hybrid():
    """hybrid("plot", "output", ..., cwd=...): the program with these words; its output as text."""
    def call(*words, **options):
        return subprocess.run([os.environ["HYBRID_PROGRAM"], *map(str, words)], capture_output=True, text=True,
                              timeout=3000 if "HYBRID_LONG" in os.environ else 600, **options)

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
