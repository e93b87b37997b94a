# SPDX-License-Identifier: GPL-3.0-or-later
"""How far off the run is, as it says itself: of its step, and of its mesh."""

import math

QUANTITIES = ("displacement", "velocity", "acceleration")
HEAD = ["error", "displacement [%]", "velocity [%]", "acceleration [%]", "slip left [%]", "told by"]


def percent(part):
    """As the run says it."""
    if part is None or not math.isfinite(part):
        return "–"
    return "below 0.05" if part < 5e-4 else "%.2g" % (100 * part) if part < 0.995 else "over 100"


def cells(found):
    """Largest errors over the peaks, with the monitors."""
    rows = []
    for quantity in QUANTITIES:
        of = found.get(quantity, {})
        part = of.get("part_of_peak")
        rows.append("–" if part is None else "%s (%s)" % (percent(part), of.get("monitor", "")))
    return rows + [percent(found.get("slip_left", {}).get("part"))]


def until(found):
    """What is later is not known."""
    if found.get("until_s") is None:
        return ""
    text = ", until a joint failed at %.4g s" % found["until_s"]
    if found.get("measured_from_time_step_s") is None or "failed_in_both_by_s" not in found:
        return text
    both = found["failed_in_both_by_s"]
    if both == found["until_s"]:
        return text
    return text + (" (not yet in one of both runs)" if both is None else " (by %.4g s in both runs)" % both)


def watched(found):
    """Without monitors a run looks at points of its own."""
    return ", at " + found["watched"] if found.get("watched") else ""


def row(what, found, part, by):
    if not found.get("estimated"):
        return [what] + ["–"] * 4 + ["not known: " + found.get("reason", "")]
    return [what] + cells(found.get(part, {})) + [by + until(found)]


def halved(found, part, half):
    """What is left with half of it."""
    as_much = all(found[part].get(q) == found[half].get(q) for q in QUANTITIES)
    notes = ["as much"] if as_much else []
    if found.get("blocks_strike"):
        notes.append("blocks strike each other, runs in other steps may go another way")
    if found.get("blocks_may_flutter"):
        notes.append("at least, as blocks with little damping slide, and may flutter in yet shorter steps")
    if found.get("acceleration_peaks_at_an_end"):
        notes.append("the acceleration of %s is largest at an end of the record, where nothing is filtered nor told" % found["acceleration_peaks_at_an_end"])
    if found.get("order_is_seen") is False:
        notes.append("roughly: no order is seen in these meshes")
    what = "with half of it and half the step" if found.get("half_the_step_too") else "with half of it"
    return [what] + cells(found[half]) + ["; ".join(notes)]


def rows_of(run):
    """[[error, displacement, velocity, acceleration, slip, how it is known]] as text; empty of a run that is not over."""
    step, mesh = run.summary.get("probable_error"), run.summary.get("mesh_error")
    found = []
    if step:
        other = step.get("measured_from_time_step_s")
        by = "the run itself" if other is None else "a run in steps of %.4g s" % other
        found.append(row("of the time step", step, "time_step", by + watched(step)))
        if step.get("estimated"):
            found.append(halved(step, "time_step", "half_the_step"))
            bedrock = step.get("bedrock_mesh", {})
            if bedrock.get("velocity", {}).get("part_of_peak") is not None:
                found.append(row("of the bedrock's mesh", step, "bedrock_mesh", "the run itself"))
    if mesh and (mesh.get("estimated") or run.summary.get("blocks")):
        by = "meshes twice and four times as coarse" if mesh.get("coarser_meshes", 1) > 1 else "a mesh twice as coarse"
        by += ", smaller cells at inward corners" if mesh.get("smaller_cells_at_corners") else ""
        found.append(row("of the mesh", mesh, "mesh", by))
        if mesh.get("estimated"):
            found.append(halved(mesh, "mesh", "half_the_size"))
    return found
