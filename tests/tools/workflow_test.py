# SPDX-License-Identifier: GPL-3.0-or-later
"""The Snakemake workflow of a study, run by Snakemake itself: a worker that is killed goes on, nothing is computed twice."""
import json
import os
import pathlib
import signal
import subprocess
import time

from conftest import ROOT

SCENE = ROOT / "parameters/verification/bonded_bar.prm"


def snakemake(directory, *words):
    return ["snakemake", "--snakefile", str(directory / "Snakefile"), "--cores", "1", "--directory", str(directory), *words]


def worker_of(name):
    """Process number of the `hybrid study DIRECTORY --only NAME` that computes a run; None if there is none."""
    for path in pathlib.Path("/proc").glob("[0-9]*/cmdline"):
        try:
            words = path.read_bytes().decode(errors="replace").split("\0")
        except OSError:  # it has ended
            continue
        if "--only" in words and name in words:
            return int(path.parent.name)
    return None


def manifests(directory):
    return {path.parent.name: json.loads(path.read_text()) for path in directory.glob("runs/*/manifest.json")}


def test_a_worker_that_is_killed_goes_on_and_nothing_is_computed_twice(hybrid, tmp_path):
    directory = tmp_path / "study"
    planned = hybrid("study", SCENE, "--vary", "Time/Time step=4e-3,2e-4", "--directory", directory, "--snakemake")
    assert planned.returncode == 0, planned.stderr
    fine = next(name for name in manifests(directory) if "2e-4" in name)
    coarse = next(directory.glob("runs/*4e-3*"))
    with open(tmp_path / "said.txt", "w+", encoding="utf-8") as said:
        with subprocess.Popen(snakemake(directory, "--retries", "1"), stdout=said, stderr=subprocess.STDOUT) as workflow:
            until = time.monotonic() + 300
            console = directory / "runs" / fine / "console.txt"
            while not (console.exists() and " steps/s" in console.read_text()):
                assert time.monotonic() < until and workflow.poll() is None
                time.sleep(0.05)
            os.kill(worker_of(fine), signal.SIGKILL)
            assert workflow.wait(timeout=300) == 0, said.seek(0) or said.read()
        said.seek(0)
        assert "Error in rule run" in said.read()
    found = manifests(directory)
    assert {manifest["state"] for manifest in found.values()} == {"done"} and found[fine]["resumed"] == 1
    assert "Resumed from the checkpoint" in (directory / "runs" / fine / "log.txt").read_text()
    assert found[coarse.name]["resumed"] == 0 and (directory / "tables/runs.csv").exists()

    stamps = {path: path.stat().st_mtime_ns for path in directory.glob("runs/*/run.h5")}
    again = subprocess.run(snakemake(directory), capture_output=True, text=True, timeout=300)
    assert again.returncode == 0 and "Nothing to be done" in again.stdout + again.stderr
    (directory / "ended" / fine).unlink()  # of a job that ended unseen
    again = subprocess.run(snakemake(directory), capture_output=True, text=True, timeout=300)
    assert again.returncode == 0 and {path: path.stat().st_mtime_ns for path in stamps} == stamps
