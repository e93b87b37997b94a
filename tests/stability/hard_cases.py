#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs a hard case and asks whether it stayed stable.

    hard_cases.py HYBRID CASE WORK_DIR [--long]   exit code 1 and a sentence if a requirement is not met
    hard_cases.py HYBRID CASE WORK_DIR --table    also prints the row of doc/hard-cases.md

CASE is the name of parameters/hard/CASE.prm, whose comment states the bound on the velocity. Asked of every run of it:
it finished; every number of run.h5 is finite; the energy audit closes; blocks and bedrock never hold more energy than they
started with and work brought in; the middles of the blocks stay below the bound on the velocity, their corners below twice
that (a wave that is reflected at a free face doubles there); blocks neither in each other nor in the ground.
"""

import json
import pathlib
import re
import sys

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "src/tools"), str(ROOT / "tests"), str(ROOT / "tests/verification/cases"), str(ROOT / "tests/stability")]

import overlaps  # noqa: E402 (needs the path above)
from hard_case_list import CASES  # noqa: E402
from hybrid_run import Run  # noqa: E402
from run_hybrid import run_hybrid  # noqa: E402
from vtu_file import pictures  # noqa: E402

HELD = ("blocks_kinetic", "blocks_strain", "blocks_gravity", "joints_and_contacts", "bedrock_kinetic", "bedrock_strain",
        "bedrock_static_stress", "boundary_springs", "bedding_static_stress")
WORK = ("base_work", "input_work", "edge_load_work", "water_work")  # minus what was brought in
SCHEME = ("blocks_integration_loss", "bedrock_integration_loss", "spring_replacement_loss")
WEIGHT = ("blocks_gravity", "water_work", "bedrock_static_stress")
NOISE = 1e-6  # J/m, at rest: what forces balanced to 1e-8 do on ways of micrometres
NEVER_FAILED = "joints/failure_time"  # NaN where nothing failed


class HardCase:
    """One hard case: its runs, and the judgement of them."""

    def __init__(self, binary, name, work):
        self.binary, self.name, self.work = binary, name, pathlib.Path(work)
        self.scene = ROOT / "parameters/hard" / (name + ".prm")
        stated = re.search(r"^# Velocity bound: ([0-9.e-]+) m/s", self.scene.read_text(encoding="utf-8"), re.MULTILINE)
        if not stated:
            sys.exit("error: %s states no velocity bound" % self.scene)
        self.speed_bound = float(stated[1])
        self.failures, self.rows = [], []

    def start(self, variant, overrides):
        """Exit code and output of a run in WORK_DIR/variant."""
        code, output, errors, _ = run_hybrid(self.binary, self.scene, self.work / variant, overrides)
        return code, output + errors

    def run(self, variant, overrides):
        """Run of a run that must finish."""
        code, text = self.start(variant, overrides)
        if code != 0:
            sys.exit("error: %s/%s ended with code %d\n%s" % (self.name, variant, code, text[-2000:]))
        run = Run(str(self.work / variant))
        run.directory_path = self.work / variant
        return run

    def refused(self, variant, overrides, words):
        """The program must end with a message that has these words."""
        code, text = self.start(variant, overrides)
        said = " ".join(text.split())
        self.true("%s: refused with '%s' (code %d)" % (variant, words, code), code not in (0, None) and code > 0 and words in said)

    def true(self, sentence, fulfilled):
        print(("ok    " if fulfilled else "FAIL  ") + sentence)
        if not fulfilled:
            self.failures.append(sentence)

    def below(self, what, found, limit, unit=""):
        self.true("%s: %.3g %s, allowed %.3g" % (what, found, unit, limit), found <= limit)

    def judge(self, variant, run, limits):
        """What is asked of every run; limits: residual, penetration."""
        summary = run.summary
        self.true("%s: finished" % variant, summary["finished"])
        self.true("%s: every number is finite" % variant, not not_finite(run.file))
        residual, created = summary["energy_residual"], created_energy(run)
        self.below("%s: energy residual" % variant, residual, limits["residual"])
        self.below("%s: energy created" % variant, created, limits["residual"] * exchanged_energy(run) + NOISE, "J/m")
        speed, corner = fastest(run.directory_path)
        self.below("%s: largest velocity of a block's middle" % variant, speed, self.speed_bound, "m/s")
        self.below("%s: largest velocity of a corner" % variant, corner, 2 * self.speed_bound, "m/s")
        depth, when = overlaps.deepest(run)
        self.below("%s: largest overlap, of the block size, at %.3g s" % (variant, when), depth, limits["penetration"])
        lost = 100 * summary["unconverged_iterations"] / max(summary["iterations"], 1)
        self.rows.append("| %s, %s | %d | %d | %d | %.1f %% | %.1e | %.3g / %.3g m/s | %.1e |"
                         % (self.name, variant, summary["steps"], summary["cuts"], summary["cuts_moved_too_far"], lost,
                            residual, speed, self.speed_bound, depth))


def not_finite(file):
    """Names of the data sets that hold NaN or infinity."""
    found = []

    def look(name, item):
        if name != NEVER_FAILED and getattr(item, "dtype", np.dtype("S1")).kind == "f" and not np.isfinite(item[()]).all():
            found.append(name)

    file.visititems(look)
    if found:
        print("      not finite: " + ", ".join(found))
    return found


def energy_terms(run):
    return {n: run.get("energy/" + n) for n in run.names("energy") if n not in ("time", "residual")}


def physical_total(run):
    """Sum of the terms' magnitudes at every audit, those of the scheme left out, weight and static stress as one [J/m]."""
    terms = {n: t.ravel() for n, t in energy_terms(run).items() if n not in SCHEME}
    weight = sum(terms.pop(n) for n in WEIGHT if n in terms)
    return np.abs(weight) + sum(np.abs(t) for t in terms.values())


def exchanged_energy(run):
    """Largest energy in play [J/m]."""
    return physical_total(run).max()


def created_energy(run):
    """Largest gain of held energy minus the work brought in [J/m]."""
    terms = energy_terms(run)
    balance = sum(terms[n] for n in HELD + WORK if n in terms)
    return max((balance - balance[0]).max(), 0.0)


def fastest(directory):
    """Largest speed of the middle of a block, and of a corner, in all pictures of a run [m/s]."""
    middles, corners = [0.0], [0.0]
    for _, picture in pictures(directory, "blocks"):
        velocity = picture.point_fields["velocity [m/s]"][:, :2]
        corners.append(np.linalg.norm(velocity, axis=1).max())
        middles.append(max(np.linalg.norm(velocity[c].mean(axis=0)) for c in picture.cells))
    return max(middles), max(corners)


def main():
    options = [a for a in sys.argv[1:] if a.startswith("--")]
    arguments = [a for a in sys.argv[1:] if not a.startswith("--")]
    if len(arguments) != 3 or arguments[1] not in CASES:
        sys.exit(__doc__ + "\nCases: " + ", ".join(sorted(CASES)))
    case, wanted = HardCase(*arguments), CASES[arguments[1]]
    if "--long" in options and wanted.full_speed:
        case.speed_bound = wanted.full_speed
    for variant, overrides in wanted.runs("--long" in options):
        run = case.run(variant, overrides)
        penetration = "--long" in options and wanted.full_penetration or wanted.penetration
        case.judge(variant, run, {"residual": wanted.residual, "penetration": penetration})
        if wanted.more:
            wanted.more(case, variant, run)
    for variant, overrides, words in wanted.refusals:
        case.refused(variant, overrides, words)
    if "--table" in options:
        print("\n".join(case.rows))
    (case.work / "judged.json").write_text(json.dumps({"failures": case.failures, "rows": case.rows}, indent=1), encoding="utf-8")
    if case.failures:
        sys.exit("error: %d requirements are not met, first: %s" % (len(case.failures), case.failures[0]))


if __name__ == "__main__":
    main()
