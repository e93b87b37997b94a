# SPDX-License-Identifier: GPL-3.0-or-later
"""Acceptance of a Majiagou run.

    majiagou_check.py DIR                      print and judge one run; exit code 1 and a sentence if it fails
    majiagou_check.py --changes DIR REFERENCE  changes of every monitor's peaks against another run (dt or h halved) in %

What is asked of a run:
  - it finished, and its energy balance closes to ENERGY_RESIDUAL;
  - at each borehole the peak displacement relative to the base never falls from the sliding surface to the ground by
    more than ENVELOPE_TOLERANCE of the largest peak;
  - the peak at the ground agrees with the independent column (majiagou_column.py) within COLUMN_TOLERANCE (a coarse check:
    the section is not layered; where nothing slips majiagou_fem.py is the exact one);
  - what is left at the end (mean over the last REST seconds) is below REST_PART of the peak, or the slip of the sliding
    surface explains it.
Joints that failed, the cost and the accelerations are reported, not judged.
"""

import json
import os
import sys

import numpy as np

from majiagou_column import Scene, compare_boreholes, compare_monitors, peak, print_table
from run_data import RunData

ENERGY_RESIDUAL = 0.01
ENVELOPE_TOLERANCE = 0.05
COLUMN_TOLERANCE = 0.25
REST_PART = 0.1
REST = 2.0  # [s]


class Judgement:
    """Collects what failed."""

    def __init__(self):
        self.failures = []

    def ask(self, fulfilled, sentence):
        print(("ok    " if fulfilled else "FAIL  ") + sentence)
        if not fulfilled:
            self.failures.append(sentence)


def read_summary(directory):
    with open(os.path.join(directory, "summary.json"), encoding="utf-8") as text:
        return json.load(text)


def judge_completion(summary, judgement):
    judgement.ask(
        summary["finished"],
        "the run %s: %d steps, %.4g s" % ("finished" if summary["finished"] else "stopped early", summary["steps"],
                                          summary["simulated_time_s"]),
    )
    residual = summary["energy_residual"]
    judgement.ask(
        residual is not None and residual < ENERGY_RESIDUAL,
        "the energy residual is %s, allowed %g" % (residual, ENERGY_RESIDUAL),
    )


def judge_borehole(scene, name, judgement):
    depth = scene.run.get("profiles/%s/depth" % name)
    series = scene.run.history("profiles/%s/displacement" % name)[:, 0::2]
    peaks = np.abs(series).max(axis=0)[np.argsort(depth)[::-1]]  # from the sliding surface up
    fall = np.max(np.maximum.accumulate(peaks) - peaks) / peaks.max()
    judgement.ask(
        fall <= ENVELOPE_TOLERANCE,
        "%s: the peak grows from %.3g mm at the sliding surface to %.3g mm at the ground; largest fall on the way "
        "%.1f %% of the largest peak, allowed %g %%"
        % (name, 1e3 * peaks[0], 1e3 * peaks[-1], 100 * fall, 100 * ENVELOPE_TOLERANCE),
    )

    at_end = scene.run.time >= scene.run.time[-1] - REST
    rest = series[at_end].mean(axis=0)
    top, above_slip = np.argmin(depth), np.argsort(depth)[-2]
    largest = np.abs(series[:, top]).max()
    judgement.ask(
        min(abs(rest[top]), abs(rest[top] - rest[above_slip])) <= REST_PART * largest,
        "%s: %.3g mm are left at the ground, %.3g mm of them already just above the sliding surface; peak %.3g mm, "
        "allowed beyond the slip %g %% of it" % (name, 1e3 * rest[top], 1e3 * rest[above_slip], 1e3 * largest,
                                                 100 * REST_PART),
    )


def judge_columns(rows, judgement):
    for row in rows:
        if row.depth == 0.0:
            judgement.ask(
                abs(row.ratio() - 1) <= COLUMN_TOLERANCE,
                "%s: peak relative displacement at the ground %.3g mm, column %.3g mm, ratio %.2f, allowed 1 +- %g"
                % (row.place.split(",")[0], 1e3 * row.run, 1e3 * row.column, row.ratio(), COLUMN_TOLERANCE),
            )


def report(summary):
    joints, settled = summary["joints"], summary["joints"].get("static", {})
    print(
        "joints failed in the earthquake: %d tensile, %d shear (first at %s s); while settling: %d tensile, %d shear"
        % (joints["tensile"], joints["shear"], joints.get("first_failure_time_s"), settled.get("tensile", 0),
           settled.get("shear", 0))
    )
    print(
        "cost: %.1f s, %.1f ms per step, %.1f iterations per step, %d cuts; memory %s"
        % (
            summary["wall_time_s"],
            1e3 * summary["wall_time_s"] / max(summary["steps"], 1),
            summary["iterations"] / max(summary["steps"], 1),
            summary["cuts"],
            "%.0f MB" % (1e-6 * summary["peak_memory_bytes"]) if "peak_memory_bytes" in summary else "not recorded",
        )
    )


def check(directory):
    judgement, summary, scene = Judgement(), read_summary(directory), Scene(directory)
    judge_completion(summary, judgement)
    for name in scene.run.names("profiles"):
        judge_borehole(scene, name, judgement)
    boreholes = compare_boreholes(scene)
    judge_columns(boreholes, judgement)
    report(summary)
    print_table(boreholes + compare_monitors(scene))
    if judgement.failures:
        print("error: %d requirements are not met, first: %s" % (len(judgement.failures), judgement.failures[0]))
    return 1 if judgement.failures else 0


def monitor_peaks(run, name):
    """Horizontal peaks: relative displacement [m], velocity [m/s], filtered acceleration [m/s2]."""
    return [
        peak(run.relative_displacement(name)[:, 0]),
        peak(run.history("monitors/%s/velocity" % name)[:, 0]),
        peak(run.filtered("monitors/%s/acceleration" % name)[1][:, 0]),
    ]


def print_changes(directory, reference):
    runs = RunData(directory), RunData(reference)
    if abs(runs[0].time[-1] - runs[1].time[-1]) > 1e-6 * runs[1].time[-1]:
        print("error: the runs end at different times: %g and %g s" % (runs[0].time[-1], runs[1].time[-1]))
        return 1
    print("%-8s %20s %20s %20s" % ("monitor", "displacement", "velocity", "acceleration"))
    for name in runs[1].names("monitors"):
        if name not in runs[0].names("monitors"):
            continue
        cells = []
        for here, there in zip(*(monitor_peaks(run, name) for run in runs)):
            cells.append("%11.4g %+6.1f %%" % (here, 100 * (here / there - 1)) if there else "%11.4g        -" % here)
        print("%-8s %20s %20s %20s" % (name, *cells))
    return 0


if __name__ == "__main__":
    arguments = sys.argv[1:]
    if len(arguments) == 3 and arguments[0] == "--changes":
        sys.exit(print_changes(*arguments[1:]))
    if len(arguments) == 1:
        sys.exit(check(arguments[0]))
    sys.exit("usage: majiagou_check.py DIR | --changes DIR REFERENCE")
