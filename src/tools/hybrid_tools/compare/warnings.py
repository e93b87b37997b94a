# SPDX-License-Identifier: GPL-3.0-or-later
"""What a reader of a comparison has to know before he believes it."""

import numpy as np

from hybrid_run import MissingData

SHORT = 0.95  # of the motion's energy up to the common end
SWINGS = 0.5  # range over the last part, of what is left
QUIET = 0.01  # of the largest u: a mass that moves by less has come to rest
LAST = 0.1  # of the common time
LEAKS = 0.01  # energy residual


def warnings_of(comparison, rows):
    """Sentences, the gravest first."""
    found = []
    for judge in (unfinished, not_finite, other_places, other_monitors, other_bases, other_axes, other_steps, other_corners, other_schemes,
                  not_resolved, motion_goes_on, still_swinging):
        found += judge(comparison)
    return found + energy_leaks(comparison, rows)


def unfinished(comparison):
    return ["'%s' %s" % (label, comparison.status(i)) for i, label in enumerate(comparison.labels) if comparison.status(i)]


def not_finite(comparison):
    """Where a history stops being numbers."""
    found = []
    for i, (run, label) in enumerate(zip(comparison.runs, comparison.labels)):
        for name in comparison.monitors:
            for quantity in ("displacement", "acceleration"):
                values = run.history("monitors/%s/%s" % (name, quantity))
                broken = np.flatnonzero(~np.isfinite(values).all(axis=1))
                if len(broken):
                    found.append("'%s': the %s of %s is not a number in %d of %d steps, first at %.4g s" % (
                        label, quantity, name, len(broken), len(values), run.time[broken[0]]))
    return found


def other_places(comparison):
    """Monitors of one name that lie in different places."""
    found = []
    for name in comparison.monitors:
        places = [run.attribute("monitors/" + name, "position") for run in comparison.runs]
        for i, label in comparison.others:
            if places[0] is None or places[i] is None:
                continue
            if np.abs(np.subtract(places[i], places[0])).max() > 1e-6 * max(1.0, np.abs(places[0]).max()):
                found.append("monitor %s lies at (%.6g, %.6g) in '%s' and at (%.6g, %.6g) in '%s'" % (
                    name, *places[0], comparison.labels[0], *places[i], label))
    return found


def other_monitors(comparison):
    found = []
    for run, label in zip(comparison.runs, comparison.labels):
        more = [name for name in run.names("monitors") if name not in comparison.monitors]
        if more:
            found.append("only compared is what all runs have; '%s' also has the monitors %s" % (label, ", ".join(more)))
    return found


def other_bases(comparison):
    """Displacements of all are taken relative to one base."""
    bases = [run.base for run in comparison.runs]
    if len(set(bases)) == 1:
        return []
    taken = "relative to '%s' in all runs" % comparison.base if comparison.base else "absolute"
    return ["the base monitors differ (%s): displacements are %s here" % (" | ".join(base or "-" for base in bases), taken)]


def other_axes(comparison):
    downhill = ["both ways" if run.is_on_both_flanks else 0.0 if run.is_level else run.downhill for run in comparison.runs]
    words = {"both ways": "both ways", 0.0: "level", 1.0: "towards +x", -1.0: "towards -x"}
    if len(set(downhill)) == 1:
        return []
    return ["downhill differs (%s): u is positive %s here" % (" | ".join(words.get(sign, "?") for sign in downhill),
                                                              "towards +x" if comparison.downhill > 0 else "towards -x")]


def other_steps(comparison):
    steps = [float(np.median(np.diff(run.time))) for run in comparison.runs]
    if max(steps) - min(steps) <= 1e-6 * max(steps):
        return []
    return ["the steps differ (%s ms): all histories are sampled every %.4g ms, accelerations with finer steps below %.4g Hz" % (
        " | ".join("%.4g" % (1e3 * step) for step in steps), 1e3 * comparison.dt, 0.4 / comparison.dt)]


def other_corners(comparison):
    if max(comparison.corners) - min(comparison.corners) <= 1e-6 * max(comparison.corners):
        return []
    return ["the filters differ (%s Hz): peak accelerations are below %g Hz here, not as in summary.json" % (
        " | ".join("%g" % corner if corner else "none" for corner in comparison.corners), comparison.corner)]


def other_schemes(comparison):
    """The automatic scheme depends on what is in the scene."""
    kinds = []
    for run in comparison.runs:
        try:
            p = run.parameters
        except MissingData:
            return []
        automatic = p.get("Time/Scheme") == "automatic"
        slips = p.get("Bedding planes/Names") and p.get("Bedding planes/Strength", "elastic") != "elastic"
        alone = p.get("Model/Blocks") == "none" and p.get("Model/Bedrock") == "continuum" and not slips
        kinds.append(("fourth order" if alone else "filtered") if automatic else p.get("Time/Scheme"))
    if len(set(kinds)) == 1:
        return []
    return ["the time integration differs (%s), which alone makes a difference: give all runs the same Time/Scheme" % (
        " | ".join(map(str, kinds)))]


def not_resolved(comparison):
    """Runs with one limit are named together."""
    limits = {}
    for run, label in zip(comparison.runs, comparison.labels):
        resolved, wanted = run.summary.get("resolved_frequency_hz"), run.summary.get("motion_frequency_hz")
        if resolved and wanted and resolved < wanted:
            parts = run.summary.get("resolved_by_part_hz", {})
            limits.setdefault((resolved, wanted, min(parts, key=parts.get, default="the mesh")), []).append("'%s'" % label)
    return ["above %.3g Hz %s of %s does not resolve the motion, which has energy up to %.3g Hz" % (
        resolved, part, ", ".join(labels), wanted) for (resolved, wanted, part), labels in limits.items()]


def motion_goes_on(comparison):
    """How much of the motion (its Arias intensity) lies within the common time, of the longest record."""
    records = [run for run in comparison.runs if run.has("input/acceleration") and run.n > 1]
    if not records:
        return []
    longest = max(records, key=lambda run: run.time[-1])
    power = np.sum(longest.history("input/acceleration") ** 2, axis=1) * np.diff(longest.time, prepend=0.0)
    share = power[longest.time <= comparison.end * (1 + 1e-9)].sum() / power.sum() if power.sum() > 0 else 1.0
    if share >= SHORT:
        return []
    return ["the first %.4g s hold %.2g %% of the motion's energy (Arias intensity) that the longest run has got" % (
        comparison.end, 100 * share)]


def still_swinging(comparison):
    """What is left is what it happens to be when the mass still swings."""
    tail = slice(int((1 - LAST) * len(comparison.axis)), None)
    swinging = []
    for name in comparison.monitors:
        if name == comparison.base:
            continue
        ranges, left, largest = [], [], []
        for i in range(len(comparison.runs)):
            u = comparison.displacement(i, name)[:, 0]
            ranges.append(np.ptp(u[tail]))
            left.append(abs(u[-1]))
            largest.append(np.abs(u).max())
        if max(ranges) > QUIET * max(largest) and max(ranges) > SWINGS * max(left):
            swinging.append(name)
    if not swinging:
        return []
    return ["%s still move%s: u in the last %.2g s changes by more than half of what is left" % (
        ", ".join(swinging), "" if len(swinging) > 1 else "s", comparison.axis[-1] - comparison.axis[tail][0])]


def energy_leaks(comparison, rows):
    found = []
    for row in rows:
        if row.place == "energy residual":
            found += ["the energy residual of '%s' reaches %.2g %%" % (label, 100 * value)
                      for label, value in zip(comparison.labels, row.values) if value is not None and not value <= LEAKS]
    return found
