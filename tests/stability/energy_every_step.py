#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The energy audit of every step of every scene with every scheme.

    energy_every_step.py HYBRID WORK_DIR [SCENE...]   exit code 1 and a sentence if an audit does not close

Runs the scenes of parameters/verification and parameters/hard (the latter as listed in hard_case_list.py), or those named, with
each scheme of Time/Scheme that they admit, audited in every step. Asked of every audit: the residual is below 0.1 % of the energy
exchanged so far where nothing slides or breaks and below 1 % elsewhere (and a millionth of a joule, for what is at rest), and what
the model holds never rises above what it had and was given.
"""

import pathlib
import shutil
import sys

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "src/tools"), str(ROOT / "tests"), str(ROOT / "tests/verification/cases"), str(ROOT / "tests/stability")]

from hard_case_list import CASES  # noqa: E402 (needs the path above)
from hard_cases import NOISE, created_energy, energy_terms, exchanged_energy, physical_total  # noqa: E402
from hybrid_run import Run  # noqa: E402
from run_hybrid import run_hybrid  # noqa: E402

SCHEMES = ("filtered", "dissipative", "trapezoidal", "fourth order", "shi")
NOT_ADMITTED = "is for a continuum alone"  # what the program says of the scheme of fourth order elsewhere
TOO_LONG = ("lamb_80x60",)  # lamb is the same problem
EVERY_STEP = ["Output/Audit interval=1e-12", "Output/Picture interval=0"]
SMOOTH, ROUGH = 0.001, 0.01


def scenes(names):
    """(title, file, overrides) of every run without its scheme."""
    for file in sorted((ROOT / "parameters/verification").glob("*.prm")):
        if file.stem in names or not names and file.stem not in TOO_LONG:
            yield file.stem, file, []
    for name, wanted in sorted(CASES.items()):
        for variant, overrides in wanted.runs(False) if name in names or not names else ():
            yield "%s, %s" % (name, variant), ROOT / "parameters/hard" / (name + ".prm"), overrides


def is_smooth(run):
    """Nothing has slid or broken."""
    losses = [name for name in run.names("energy") if name in ("friction_loss", "fracture_loss", "bedding_loss")]
    return all(abs(run.get("energy/" + name)).max() == 0 for name in losses)


def largest_residual(run, limit):
    """Residual over energy exchanged so far and what moved at the start, largest of all audits, where NOISE does not hide it."""
    moved = sum(run.file["energy"][name].attrs["start"][0] for name in run.names("energy") if name.endswith("_kinetic"))
    so_far = moved + np.maximum.accumulate(physical_total(run))
    unexplained = np.abs(sum(term.ravel() for term in energy_terms(run).values()))
    return (unexplained / (so_far + NOISE / limit)).max()


def judge(title, run):
    """Prints the numbers of a run. Returns whether they are within their limits."""
    limit = SMOOTH if is_smooth(run) else ROUGH
    residual, exchanged, created = largest_residual(run, limit), exchanged_energy(run), created_energy(run)
    every_step = len(run.get("energy/time")) >= len(run.time)
    good = run.summary["finished"] and every_step and residual <= limit and created <= limit * exchanged + NOISE
    print("%s %-45s %6d steps, residual %.1e of %g, created %.1e of %.3g J/m, %d cuts"
          % ("ok   " if good else "FAIL ", title, run.summary["steps"], residual, limit, created, exchanged, run.summary["cuts"]), flush=True)
    return good


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    binary, work, failures, judged = sys.argv[1], pathlib.Path(sys.argv[2]), [], 0
    for title, file, overrides in scenes(sys.argv[3:]):
        for scheme in SCHEMES:
            code, output, errors, command = run_hybrid(binary, file, work / "run", overrides + EVERY_STEP + ["Time/Scheme=" + scheme])
            name = "%s, %s" % (title, scheme)
            if code != 0 and NOT_ADMITTED in output + errors:
                continue
            if code != 0:
                failures.append("%s ended with code %d (%s)\n%s" % (name, code, command, (output + errors)[-1500:]))
                print("FAIL  " + failures[-1], flush=True)
                continue
            judged += 1
            if not judge(name, Run(str(work / "run"))):
                failures.append(name)
    shutil.rmtree(work / "run", ignore_errors=True)
    if not judged:
        sys.exit("error: no scene was run")
    if failures:
        sys.exit("error: %d of %d runs, first: %s" % (len(failures), judged, failures[0]))


if __name__ == "__main__":
    main()
