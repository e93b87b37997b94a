#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The error that a run says it has (summary.json, probable_error) beside the true one, from the same scene with a quarter of its step,
in the table a twelfth where it slips (SLIPS): accelerations at the begin of slip are off by as much in a quarter of the step.

True error: largest size of the difference of two histories at any time over the peak, of the monitor where that is largest; displacement
relative to the base, all below the filter's corner; accelerations but for a period of it at both ends, where nothing is filtered (filter_reach.h). What the quarter of the step has left itself (a sixteenth; a quarter with a scheme
of first order) is added.

Usage: probable_error_test.py HYBRID_BINARY SOURCE_DIR WORK_DIR [--write doc/accuracy.md | --left-out doc/accuracy.md]
The first form runs the scenes of SHORT and asks for a factor of 3. --write runs all and writes the table of the page (minutes, and
Badong another ten); runs that are in WORK_DIR already are kept. --left-out writes the table of scenes without a row only (minutes).
"""
import json
import pathlib
import re
import shutil
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from run_hybrid import must_run  # noqa: E402 (needs the path above)

FACTOR = 3.0
FLOOR = 5e-4  # smaller errors are told as "below 0.05 %"
QUANTITIES = ("displacement", "velocity", "acceleration")
REST = 1e-3  # of the largest peak: what moves less is left out, as in the program
SCHEME = {"trapezoidal": ["Time/Scheme=trapezoidal"], "dissipative": ["Time/Scheme=dissipative"]}
BADONG = ["Mesh/Numbers=Resolution/h = 8"]
ONE_MESH = "Mesh/Error estimate=one run"
ONE_RUN = ["Time/Error estimate=one run", ONE_MESH]


# Runs that end within the motion, or as it begins: a burst of so many cycles.
BURST = ["Motion/Type=sine", "Motion/Peak=1", "Motion/Taper=0.5"]
WITHIN = {"time_order within": BURST + ["Motion/Frequency=4", "Motion/Cycles=8", "Time/End time=1"],
          "coupled_column within": BURST + ["Motion/Frequency=6", "Motion/Cycles=6", "Continuum/Base=rigid", "Time/End time=0.8"],
          "bonded_bar within": BURST + ["Motion/Frequency=3", "Motion/Cycles=6", "Time/End time=1.6"],
          "free_field within": ["Motion/Type=synthetic", "Motion/Frequency=4", "Motion/Highest frequency=10", "Motion/Duration=4",
                                "Motion/Peak=1", "Time/End time=2"],
          "coupled_column begins": ["Time/End time=0.2"]}

# A stiff mass that a rigid base carries, and nothing else.
HELD = ["Materials/belt/Cohesion=1e9", "Materials/belt/Tensile strength=1e9"]

# name: steps in units of the scene's own, and what is set besides
SHORT = {"time_order": ((4, 1), []), "bedrock_triangles": ((4,), []), "block_decrement": ((1,), []), "lasting_load": ((4,), []),
         "canyon": ((4,), []), "rayleigh_decrement": ((4,), []), "shaken_base": ((2,), []), "floating_block": ((2,), []),
         "rate_belt": ((4,), []), "coupled_column within": ((2,), WITHIN["coupled_column within"]),
         "coupled_column begins": ((2,), WITHIN["coupled_column begins"]), "bonded_bar within": ((1,), WITHIN["bonded_bar within"]), "bonded_slab held": ((8,), HELD),
         "direct_tension": ((4,), [])}  # steps are cut to half from 1.35 s on: those of the second run, too
LONG = {"bonded_bar": ((4, 1), []), "bedrock_triangles": ((4, 1), []), "bedrock_layers": ((4, 1), []),
        "block_decrement": ((4, 1), []), "continuum_into_blocks": ((4, 1), []), "coupled_column": ((4, 1), []),
        "coupled_column trapezoidal": ((4, 1), SCHEME["trapezoidal"]), "coupled_column dissipative": ((4, 1), SCHEME["dissipative"]),
        "time_order": ((4, 1), []), "time_order dissipative": ((4, 1), SCHEME["dissipative"]), "lasting_load": ((4, 1), []),
        "free_field": ((4, 1), []), "rayleigh_decrement": ((4, 1), []), "elastic_joints": ((4, 1), []), "joint_bands": ((4, 1), []),
        "canyon": ((4, 1), []), "step": ((4, 1), []), "lamb": ((4, 1), []), "wave_packet": ((4, 1), []),
        "oblique_joints": ((4, 1), []), "soft_layer": ((16, 4), []), "soft_layer_blocks": ((4, 1), []), "bonded_mass": ((4, 1), []),
        "constant_q": ((4, 1), []), "constant_q_layer": ((4, 1), []), "constant_q_blocks": ((4, 1), []), "spectrum_motion": ((4, 1), []),
        "badong": ((4, 2, 1), BADONG), "badong_long_periods": ((4, 2, 1), BADONG), "strong-175": ((4, 2, 1), BADONG + ["Time/End time=2.85"]),
        "shaken_base": ((4, 1), []), "incline": ((4, 1), []), "rocking": ((4, 1), []), "free_flight": ((4, 1), []),
        "brittle_release": ((4, 1), []), "direct_shear": ((4, 1), []), "infinite_slope": ((4, 1), []), "coulomb_joint": ((4, 1), []),
        "opening_plane": ((4, 1), []), "opening_blocks": ((4, 1), []), "bedding_slip_layers": ((4, 1), []),
        "restart_coupled": ((4, 1), []), "floating_block": ((4, 1), []), "sliding_column": ((4, 1), []), "unit_squares": ((4,), []),
        "bonded_slab held": ((8,), HELD), "dynamic_coefficient": ((4,), []), "shakedown": ((1,), []), "column_planes": ((4, 1), [])}
LONG.update({name: ((4,), []) for name in (
    "drawdown", "flutter", "rising_reservoir", "seams", "seepage_slab", "submerged_incline", "toppling_squares",
    "bonded_slab", "direct_tension", "rate_belt", "residual_belt", "softening_reset", "brazilian_disc", "notched_beam",
    "unconfined_strength", "bedding_slip_blocks", "opening_layers")})

LONG.update({name: ((4, 1), settings) for name, settings in WITHIN.items()})

# Scenes that slip, bounce or tear and are cheap: the reference of the table has a twelfth of the scene's own step.
SLIPS = ("bedding_slip_layers", "column_planes", "coulomb_joint", "direct_tension", "drawdown", "incline", "infinite_slope", "opening_plane", "rate_belt", "restart_coupled",
         "rocking", "seams", "seepage_slab", "shaken_base", "sliding_column", "toppling_squares", "unit_squares")

# Mesh of the bedrock: numbers of the mesh, sizes of its cells [m] and the reference's
MESH = {"wave_packet": ("Width = 12.5; Height = 1000;", (12.5, 6.25), 3.125),
        "soft_layer": ("Width = 40; Height = 500; Layer height = 400;", (80, 40), 20),
        "free_field": ("Width = 100; Height = 100; Layer height = 40;", (20, 10), 5),
        "rayleigh_decrement": ("Width = 10; Height = 50;", (25, 10), 2.5)}

# The other scenes of parameters/verification: why they have no row, the start of the reason that each gives (None: it does estimate), names.
LEFT_OUT = [
    ("the static stage only", "", ("arch", "cantilever", "goodman_bray", "pushed_wall", "voussoir")),
    ("a state of rest in a few steps", "the run is too short",
     ("acads", "griffiths_lane", "heterogeneous_column", "initial_stress", "initial_stress_slope", "planes_below_water", "staged_columns",
      "submerged_column")),
    ("planes that slip under a point source: a profile is looked at", "the run ends as the motion begins", ("line_source_slip",)),
    ("no monitors: a line or a profile is looked at", None, ("grain_column", "oblique_waves")),
    ("a state of rest", "nothing moves", ("no_creep",)),
    ("loose blocks at rest", "all monitors are on blocks that no joint holds", ("friction", "rest", "rocking_pulse")),
    ("a scene of the table with a finer mesh", None, ("canyon_fine", "lamb_80x60")),
    ("the motion alone is looked at", None, ("clough_penzien", "stochastic_motion"))]

SAID = {None: "its error", "": "no line"}

LABELS = {"badong": "Badong, h = 8 m", "badong_long_periods": "Badong, long periods, h = 8 m",
          "strong-175": "Majiagou, 1 g, h = 8 m, until joints fail",
          **{name: name.split()[0] + (", ends within the motion" if name.endswith("within") else ", ends as the motion begins") for name in WITHIN}}


def scene_file(source, name):
    place = "majiagou" if name.startswith(("badong", "strong")) else "verification"
    return source / "parameters" / place / (name.split()[0] + ".prm")


def own_step(file):
    text = file.read_text()
    found = re.search(r"set Time step\s*=\s*([0-9.e-]+)", text)
    if found:
        return float(found.group(1))
    included = re.search(r"^include (.+)$", text, re.MULTILINE)
    return own_step(file.parent / included.group(1)) if included else 1e-3  # the default


def compute(binary, source, work, name, factor, settings):
    """The run with this step, if it is not there yet. @return its directory."""
    place = work / ("%s-%g" % (name.replace(" ", "_"), factor))
    if not (place / "summary.json").exists():
        words = [scene_file(source, name), "-s", "Output/Directory=%s" % place, "-s", "Output/Picture interval=0", "-s", ONE_MESH,
                 "-s", "Time/Time step=%.10g" % (factor * own_step(scene_file(source, name)))]
        for setting in settings:
            words += ["-s", setting]
        must_run(binary, words, source)
    return place


def histories(place, axis=None):
    """(times, by monitor: displacement relative to the base, velocity, acceleration, filtered), sampled at the times of an axis."""
    from hybrid_run import Run
    from hybrid_run.low_pass import low_pass

    run = Run(place)
    step = float(np.median(np.diff(run.time)))
    time = step * np.arange(1, round(run.time[-1] / step) + 1)
    corner = float(run.parameters["Monitors/Filter frequency"].split()[0])
    result = {}
    for name, monitor in run.monitors.items():
        values = [monitor.displacement, monitor.velocity, monitor.acceleration]
        values = [np.column_stack([np.interp(time, run.time, v[:, c]) for c in (0, 1)]) for v in values]
        result[name] = [low_pass(v, step, corner) for v in values]
    if axis is not None:
        result = {name: [np.column_stack([np.interp(axis, time, v[:, c]) for c in (0, 1)]) for v in values]
                  for name, values in result.items()}
    return time, result, run.base, corner


def filter_reach(corner, length):
    """How far from the ends filtered accelerations are not compared [s], as in the program."""
    return min(1 / corner, 0.25 * length) if corner > 0 else 0.0


def size(pairs):
    return np.sqrt((pairs**2).sum(axis=1))


def true_errors(coarse, fine, ratio, order, until):
    """Largest error over the peak, of the worst monitor: displacement, velocity, acceleration."""
    time, found, base, corner = histories(coarse)
    _, reference, _, _ = histories(fine, time)
    end = json.loads((fine / "summary.json").read_text())["simulated_time_s"]  # the last step of the other may be beyond
    last = min(time[-1], end)
    reach = filter_reach(corner, last - time[0])
    whole = time <= min(until or end, end) + 1e-9
    correction = 1 / (1 - ratio**-order)
    result = []
    for q in range(3):
        keep = whole & (time >= time[0] + reach - 1e-9) & (time <= last - reach + 1e-9) if q == 2 else whole
        peaks = {name: size(values[q][keep]).max() for name, values in reference.items() if q > 0 or name != base}
        parts = [correction * size(found[name][q][keep] - reference[name][q][keep]).max() / peak
                 for name, peak in peaks.items() if peak > REST * max(peaks.values())]
        result.append(max(parts) if parts else float("nan"))
    return result


def compare(binary, source, work, name, factors, settings, finest=None):
    """For each step: what the run says, and the true errors. The reference has this step, or a quarter of the finest one."""
    finest = finest or min(factors) / 4
    reference = compute(binary, source, work, name, finest, settings + ONE_RUN)
    for factor in factors:
        place = compute(binary, source, work, name, factor, settings)
        said = json.loads((place / "summary.json").read_text())["probable_error"]
        order = 1 if "dissipative" in name else 2
        until = min((s for s in (said.get("until_s"), failure_time(reference)) if s), default=None)
        if until:
            until -= factor * own_step(scene_file(source, name))  # no step resolves how a joint breaks
        true = true_errors(place, reference, factor / finest, order, until)
        estimated = parts_of(said) if said["estimated"] else None
        yield factor * own_step(scene_file(source, name)), true, estimated, said


def failure_time(place):
    """Of the first joint that loses strength by it [s]; None: none has."""
    return json.loads((place / "summary.json").read_text())["joints"]["first_loss_time_s"]


def parts_of(said):
    """NaN: nothing is told."""
    return [float("nan") if said["time_step"][q]["part_of_peak"] is None else said["time_step"][q]["part_of_peak"] for q in QUANTITIES]


def compare_meshes(binary, source, work, name, part=0.25):
    """For each size of cells: what the run says of its mesh, and the true errors. All with this part of the scene's own step."""
    numbers, sizes, finest = MESH[name]

    def run(size_of_cells):
        return compute(binary, source, work, "%s cells %g" % (name, size_of_cells), part,
                       ["Mesh/Numbers=%s Resolution/h = %g" % (numbers, size_of_cells)])

    for cells in sizes:
        said = json.loads((run(cells) / "summary.json").read_text())["probable_error"]["bedrock_mesh"]
        yield cells, true_errors(run(cells), run(finest), cells / finest, 4, None), [said[q]["part_of_peak"] for q in QUANTITIES]


def judge(name, what, true, estimated):
    ratios = [e / t for e, t in zip(estimated, true)]
    good = all(1 / FACTOR < r < FACTOR for r in ratios)
    print("%-20s %s: true %s, estimated over true %s%s" % (name, what, " ".join("%.2g" % t for t in true),
          " ".join("%.2f" % r for r in ratios), "" if good else "  <-- not within %g" % FACTOR))
    return good


def unlisted(source):
    """Scenes that have neither a row nor a reason, or both."""
    rows = {name.split()[0] for table in (LONG, MESH) for name in table}
    reasons = {name for _, _, names in LEFT_OUT for name in names}
    scenes = {file.stem for file in (source / "parameters/verification").glob("*.prm")}
    return sorted((scenes - rows - reasons) | (rows & reasons) | (reasons - scenes))


def left_out(binary, source, work):
    """Lines of the table of scenes without a row; each is run, but those that do estimate, and must give its reason."""
    lines = []
    for why, reason, names in LEFT_OUT:
        for name in names if reason is not None else ():
            place = compute(binary, source, work, name + " alone", 1, ONE_RUN)
            said = json.loads((place / "summary.json").read_text())["probable_error"]
            if said["estimated"] or not said["reason"].startswith(reason):
                sys.exit("%s: not \"%s\" but %s" % (name, reason, said.get("reason", "estimated")))
        lines.append("| %s | %s | %s |" % (why, SAID.get(reason, reason), ", ".join(names)))
    return lines


def short(binary, source, work):
    if unlisted(source):
        sys.exit("neither a row nor a reason, or both: " + ", ".join(unlisted(source)))
    bad = 0
    for name, part in (("wave_packet", 0.25), ("soft_layer", 1)):  # what the step leaves is of all meshes
        for cells, true, estimated in compare_meshes(binary, source, work, name, part):
            bad += not judge(name, "%g m" % cells, true, estimated)
    for name, (factors, settings) in SHORT.items():
        for step, true, estimated, said in compare(binary, source, work, name, factors, settings):
            if estimated is None:
                sys.exit("%s: not estimated: %s" % (name, said["reason"]))
            bad += not judge(name, "%g s" % step, true, estimated)
    sys.exit(1 if bad else 0)


def percent(values):
    return ", ".join("-" if np.isnan(value) else "%.2g" % (100 * value) for value in values)


def row(label, size_of_it, true, estimated):
    ratios = []
    for e, t in zip(estimated, true):
        ratio = "%.2g" % (e / t) if t > 1e-8 and not np.isnan(e) else "-"  # less is round-off; NaN: it has none
        within = np.isnan(e) or 1 / FACTOR <= max(e, FLOOR) / max(t, FLOOR) <= FACTOR
        ratios.append(ratio if within else "**%s**" % ratio)
    return "| %s | %g | %s | %s | %s |" % (label, size_of_it, percent(true), percent(estimated), ", ".join(ratios))


def write(binary, source, work, page):
    rows, mesh_rows = [], []
    for name, (factors, settings) in LONG.items():
        for step, true, estimated, said in compare(binary, source, work, name, factors, settings, 1 / 12 if name in SLIPS else None):
            label = LABELS.get(name, name)
            if said.get("measured_from_time_step_s") is not None:
                label += ", two runs"
            if said.get("blocks_may_flutter"):
                label += ", at least"
            if estimated is None:
                rows.append("| %s | %g | %s | %s | |" % (label, 1e3 * step, percent(true), "not estimated: " + said["reason"]))
            else:
                rows.append(row(label, 1e3 * step, true, estimated))
    for name in MESH:
        for cells, true, estimated in compare_meshes(binary, source, work, name):
            mesh_rows.append(row(name, cells, true, estimated))
    put(page, ((rows, "steps"), (mesh_rows, "meshes"), (left_out(binary, source, work), "left out")))


def put(page, tables):
    """Lines into the tables of a page that begin with <!-- mark -->."""
    text = page.read_text()
    for lines, mark in tables:
        begin, end = "<!-- %s -->\n" % mark, "\n<!-- end -->"
        first = text.index(begin)
        head = re.compile(r"(\|---)+\|\n").search(text, first).end()
        text = text[:head] + "\n".join(lines) + "\n" + text[text.index(end, head - 1):]
    page.write_text(text)


def main():
    binary, source, work = sys.argv[1], pathlib.Path(sys.argv[2]).resolve(), pathlib.Path(sys.argv[3]).resolve()
    sys.path.insert(0, str(source / "src/tools"))
    if "--write" not in sys.argv and "--left-out" not in sys.argv:
        shutil.rmtree(work, ignore_errors=True)  # of an earlier program
    work.mkdir(parents=True, exist_ok=True)
    if "--left-out" in sys.argv:
        put(pathlib.Path(sys.argv[sys.argv.index("--left-out") + 1]), ((left_out(binary, source, work), "left out"),))
    elif "--write" in sys.argv:
        write(binary, source, work, pathlib.Path(sys.argv[sys.argv.index("--write") + 1]))
    else:
        short(binary, source, work)


if __name__ == "__main__":
    main()
