# SPDX-License-Identifier: GPL-3.0-or-later
"""Acceptance of a Majiagou run.

    majiagou_check.py DIR ELASTIC BELT         print and judge a run; exit code 1 and a sentence if it fails
    majiagou_check.py --changes DIR REFERENCE  changes of every monitor's peaks against another run (dt or h halved) in %

ELASTIC is the same scene with strengths that nothing reaches: what differs is what slip does. BELT has such strengths in the
body alone: the belt slips as in the run, the mass above it stays elastic.
Asked of all runs: they finished, and their energy balance closes to ENERGY_RESIDUAL.
Asked of the elastic run, which must be right to tell slip from error:
  - at each borehole the peak displacement relative to the base grows from the sliding surface to the ground;
  - the profile falls nowhere on the way up by more than ENVELOPE_TOLERANCE of the largest peak;
  - the peaks at the ground agree with an independent 2D solution (majiagou_fem.py) within FEM_TOLERANCE; where the
    1D column (majiagou_column.py) differs by more than COLUMN_TOLERANCE, the difference is thereby two-dimensional;
  - what is left at the end (mean over the last REST seconds) is below REST_PART of the peak.
Asked of the run whose belt alone yields: what is left along each borehole is what an elastic mass does whose sole slips like
the belt (majiagou_fem.py --slip), within SLIP_TOLERANCE of the largest. Where the belt slips under a part of the mass only, its
neighbours hold the ground back: a profile then falls from the sliding surface to the ground, and must. So nothing
is asked of how the profiles of a run that slips grow.
Asked of the run: peaks at the ground within COLUMN_TOLERANCE of the 1D column, or a column that would not slip by itself under
its own weight and shaking: what slips there is then driven by its neighbours along the sliding surface, in two dimensions.
What is left in the run itself is therefore due to slip on the belt and to joints of the body that yield: friction loss, slip
under the boreholes, what the body adds to BELT and the joints that failed are reported, with cost and accelerations.
"""

import json
import os
import sys

import numpy as np

import majiagou_fem
from majiagou_fem import REST
from majiagou_column import Belt, Scene, compare_boreholes, compare_monitors, peak, print_table
from hybrid_run import Run

ENERGY_RESIDUAL = 0.01
ENVELOPE_TOLERANCE = 0.05
COLUMN_TOLERANCE = 0.25
FEM_TOLERANCE = 0.1
SLIP_TOLERANCE = 0.1
REST_PART = 0.1


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


class Profile:
    """A borehole: peaks and what is left, from the sliding surface up."""

    def __init__(self, run, name):
        depth = run.get("profiles/%s/depth" % name)
        upwards = np.argsort(depth)[::-1]
        series = run.history("profiles/%s/displacement" % name)[:, 0::2][:, upwards]
        self.name, self.depth = name, depth[upwards]
        self.peaks = np.abs(series).max(axis=0)
        self.rest = series[run.time >= run.time[-1] - REST].mean(axis=0)

    def fall(self):
        """Largest fall of the peaks on the way up over the largest peak, and the depth [m] where it ends."""
        falls = np.maximum.accumulate(self.peaks) - self.peaks
        worst = np.argmax(falls)
        return falls[worst] / self.peaks.max(), self.depth[worst]


def profiles_of(run):
    return [Profile(run, name) for name in run.names("profiles")]


def describe_peaks(profile):
    fall, depth = profile.fall()
    return "peak %.3g mm at the sliding surface, %.3g mm at the ground; largest fall on the way %.1f %% of the largest peak, %.1f m deep" % (
        1e3 * profile.peaks[0], 1e3 * profile.peaks[-1], 100 * fall, depth)


def judge_elastic(scene, judgement):
    for profile in profiles_of(scene.run):
        judgement.ask(profile.peaks[-1] > profile.peaks[0], "elastic, %s: %s" % (profile.name, describe_peaks(profile)))
        judgement.ask(
            profile.fall()[0] <= ENVELOPE_TOLERANCE,
            "elastic, %s: the fall is at most %g %%" % (profile.name, 100 * ENVELOPE_TOLERANCE),
        )
        judgement.ask(
            abs(profile.rest[-1]) <= REST_PART * profile.peaks[-1],
            "elastic, %s: %.3g mm are left at the ground, peak %.3g mm, allowed %g %% of it"
            % (profile.name, 1e3 * profile.rest[-1], 1e3 * profile.peaks[-1], 100 * REST_PART),
        )
    columns = [row for row in compare_boreholes(scene) if row.depth == 0.0]
    elements = majiagou_fem.compare(scene)
    for row in columns:
        place = row.place.split(",")[0]
        independent = [r for r in elements if r.place == place][0]
        judgement.ask(
            abs(independent.ratio() - 1) <= FEM_TOLERANCE,
            "elastic, %s: peak at the ground %.3g mm, 2D elements %.3g mm, ratio %.2f, allowed 1 +- %g; ratio to the 1D column "
            "%.2f%s"
            % (place, 1e3 * abs(row.run), 1e3 * abs(independent.column), independent.ratio(), FEM_TOLERANCE, row.ratio(),
               "" if abs(row.ratio() - 1) <= COLUMN_TOLERANCE else ": the difference is two-dimensional"),
        )
    print_table(elements, "2D elements")


def judge_slip(scene, judgement):
    """What is left above a belt that slips is elastic."""
    rows = majiagou_fem.compare_left(scene)
    for name in scene.run.names("profiles"):
        along = [row for row in rows if row.place.startswith(name + ",")]
        largest, error = max(abs(row.column) for row in along), max(abs(row.run - row.column) for row in along)
        judgement.ask(
            error <= SLIP_TOLERANCE * largest,
            "belt alone, %s: %.3g mm are left at the ground, elastic mass over the same slip %.3g mm; along the borehole they "
            "differ by at most %.2g mm, allowed %g %% of %.3g mm"
            % (name, 1e3 * along[0].run, 1e3 * along[0].column, 1e3 * error, 100 * SLIP_TOLERANCE, 1e3 * largest),
        )
    print_table(rows, "2D elements")


def judge_columns(scene, judgement):
    """Peaks at the ground against the 1D column, or why the difference is two-dimensional."""
    for row in compare_boreholes(scene):
        if row.depth != 0.0:
            continue
        place = row.place.split(",")[0]
        belt = Belt(scene, *scene.run.attribute("profiles/" + place, "position")[:2])
        judgement.ask(
            abs(row.ratio() - 1) <= COLUMN_TOLERANCE or not belt.slips_by_itself(),
            "run, %s: peak at the ground %.3g mm, 1D column %.3g mm, ratio %.2f; %s"
            % (place, 1e3 * abs(row.run), 1e3 * abs(row.column), row.ratio(), belt),
        )


def report_slip(run, belt):
    print("slip: friction took %.4g J/m" % run.get("energy/friction_loss")[-1])
    for profile, without in zip(profiles_of(run), profiles_of(belt)):
        print("run, %s: %s" % (profile.name, describe_peaks(profile)))
        print(
            "slip, %s: %.3g mm are left at the ground, %.3g mm just above the sliding surface; if the body cannot yield %.3g and %.3g mm"
            % (profile.name, *(1e3 * rest for p in (profile, without) for rest in (p.rest[-1], p.rest[1])))
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
            "%.0f MB" % summary["peak_memory_mb"],
        )
    )


def check(directory, elastic, belt):
    judgement, scene, belt_scene = Judgement(), Scene(directory), Scene(belt)
    for place in (elastic, belt, directory):
        judge_completion(read_summary(place), judgement)
    judge_elastic(Scene(elastic), judgement)
    judge_slip(belt_scene, judgement)
    judge_columns(scene, judgement)
    report_slip(scene.run, belt_scene.run)
    report(read_summary(directory))
    print_table(compare_boreholes(scene) + compare_monitors(scene))
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
    runs = Run(directory), Run(reference)
    if abs(runs[0].time[-1] - runs[1].time[-1]) > 1e-6 * runs[1].time[-1]:
        print("error: the runs end at different times: %g and %g s" % (runs[0].time[-1], runs[1].time[-1]))
        return 1
    print("%-8s %20s %20s %20s" % ("monitor", "displacement", "velocity", "acceleration"))
    for name in runs[1].names("monitors"):
        if name not in runs[0].names("monitors"):
            continue
        cells = []
        for here, there in zip(*(monitor_peaks(run, name) for run in runs)):
            cells.append("%11.4g %+6.1f %%" % (here, 100 * (abs(here / there) - 1)) if there else "%11.4g        -" % here)
        print("%-8s %20s %20s %20s" % (name, *cells))
    return 0


if __name__ == "__main__":
    arguments = sys.argv[1:]
    if len(arguments) == 3 and arguments[0] == "--changes":
        sys.exit(print_changes(*arguments[1:]))
    if len(arguments) == 3 and not arguments[0].startswith("-"):
        sys.exit(check(*arguments))
    sys.exit("usage: majiagou_check.py DIR ELASTIC BELT | --changes DIR REFERENCE")
