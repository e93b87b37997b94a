# SPDX-License-Identifier: GPL-3.0-or-later
"""What was measured: of each row the least of its repetitions, of each family how time grows, and both beside an earlier measurement."""

import json
import math

import numpy as np

from hybrid_run import UserError, timings
from hybrid_tools.benchmark import catalogue
from hybrid_tools.benchmark.measure import value
from hybrid_tools.table import Column, Table

COUNTS = ("steps", "iterations_per_step", "most_iterations", "few_body_iterations_per_step", "solver_iterations_per_step", "cuts", "block_steps_per_s", "memory_mb")


def result(row, summaries, values=None):
    """One row from the summaries of its repetitions; values: of a row that does not follow from the summary."""
    values = [value(row, summary) for summary in summaries] if values is None else values
    measured = [number for number in values if number is not None]
    best = None
    if measured:
        best = max(measured) if row.kind == catalogue.RATE else min(measured)
    summary = summaries[values.index(best)] if measured else summaries[-1]
    steps = summary["steps"]
    stepping = summary["processor_times_s"].get("steps", 0.0)
    return {"row": row.name, "family": row.family, "kind": row.kind, "unit": row.unit, "value": best, "goal": row.goal,
            "repetitions": values, "blocks": summary["blocks"], "continuum_unknowns": summary["continuum_unknowns"], "steps": steps,
            "simulated_time_s": summary["simulated_time_s"], "iterations": summary["iterations"],
            "iterations_per_step": summary["iterations"] / steps if steps else None,
            "most_iterations": summary["most_iterations"],
            "few_body_iterations_per_step": per(summary.get("few_body_iterations"), steps),
            "solver_iterations_per_step": per(summary["solver_iterations"], steps), "cuts": summary["cuts"],
            "static_iterations": (summary["static_stage"] or {}).get("iterations"),
            "block_steps_per_s": summary["blocks"] * (steps - 1) / stepping if stepping > 0 and steps > 1 else None,
            "memory_mb": max(s["peak_memory_mb"] for s in summaries), "processor_times_s": summary["processor_times_s"],
            "timings_s": summary["timings_s"], "energy_residual": summary["energy_residual"],
            "stopped_at_limit": summary["stopped"], "other_load": max(s["other_load"] for s in summaries)}


def no_result(row, limit):
    """A row whose run came to nothing within the limit [s]."""
    return {"row": row.name, "family": row.family, "kind": row.kind, "unit": row.unit, "value": None, "goal": row.goal,
            "repetitions": [], "stopped_at_limit": True, "limit_s": limit}


def per(count, steps):
    return count / steps if count is not None and steps else None


def spread(found):
    """Largest over least of the repetitions, less one [-]; None for one."""
    values = [number for number in found["repetitions"] if number]
    return max(values) / min(values) - 1 if len(values) > 1 else None


def over_goal(found):
    """How many times the goal's time a row takes: above 1 the goal is missed. None without a goal or a value."""
    if not found["goal"] or not found["value"]:
        return None
    return found["goal"] / found["value"] if found["kind"] == catalogue.RATE else found["value"] / found["goal"]


def time_ratio(new, old):
    """Time now over time before, of whatever kind; None where either is missing, or the scene, the kind or the limit differ."""
    if not old or not new["value"] or not old["value"] or new["kind"] != old["kind"] or new["blocks"] != old["blocks"]:
        return None
    if new["stopped_at_limit"] or old["stopped_at_limit"] or not math.isclose(new["simulated_time_s"], old["simulated_time_s"]):
        return None
    return old["value"] / new["value"] if new["kind"] == catalogue.RATE else new["value"] / old["value"]


def growth(results):
    """{family: {"exponent", "from", "to"}}: time grows as blocks^exponent (least squares of the logarithms), of families with two rows."""
    found = {}
    for name in dict.fromkeys(r["family"] for r in results if r["family"]):
        rows = [r for r in results if r["family"] == name and r["value"] and r["blocks"]]
        sizes = sorted(r["blocks"] for r in rows)
        if len(rows) < 2 or sizes[0] == sizes[-1]:
            continue
        times = [r["blocks"] / r["value"] if r["kind"] == catalogue.RATE else r["value"] for r in rows]
        exponent = np.polyfit(np.log([r["blocks"] for r in rows]), np.log(times), 1)[0]
        found[name] = {"exponent": float(exponent), "from": sizes[0], "to": sizes[-1]}
    return found


def number_text(number):
    """Three digits; thousands with a comma."""
    return "{:,.0f}".format(float("%.3g" % number)) if abs(number) >= 1000 else "%.3g" % number


def value_text(found):
    if found["value"] is None:
        return "not within the limit"
    text = "%s %s" % (number_text(found["value"]), found["unit"])
    return text + (" (until %.4g s)" % found["simulated_time_s"] if found["stopped_at_limit"] else "")


def table(results, before=None, before_name="before"):
    """For people. before: {row: result} of an earlier measurement, or None."""
    columns = [Column("row"), Column("blocks", show="{:,}".format), Column("time"), Column("goal", show=number_text),
               Column("over goal", show="%.3g"), Column("steps", show="%d"), Column("iterations/step", show="%.3g"),
               Column("most", show="%d"), Column("of few/step", show="%.3g"), Column("solver its/step", show="%.3g"),
               Column("cuts", show="%d"), Column("block-steps/s", show=number_text), Column("memory", "MB", "%.0f"),
               Column("spread", show=lambda part: "%.0f %%" % (100 * part))]
    if before is not None:
        columns += [Column("time over " + before_name, show="%.3g"), Column("its/step " + before_name, show="%.3g")]
    made = Table(columns)
    for r in results:
        line = [r["row"], r.get("blocks"), value_text(r), r["goal"], over_goal(r)] + [r.get(key) for key in COUNTS] + [spread(r)]
        if before is not None:
            old = before.get(r["row"])
            line += [time_ratio(r, old), old.get("iterations_per_step") if old else None]
        made.add(*line)
    return made


def parts_table(results):
    """Where the wall time of each row's time loop went, or of its static stage where that is what it measures."""
    found = {r["row"]: timings.parts_of_static_stage(r) if r["kind"] == catalogue.STATIC else timings.parts(r)
             for r in results if "timings_s" in r}
    labels = list(dict.fromkeys(label for parts in found.values() for label in parts))
    made = Table([Column("row")] + [Column(label, "%", "%.0f") for label in labels])
    for row, parts in found.items():
        total = sum(parts.values())
        if total > 0:
            made.add(row, *[100 * parts[label] / total if label in parts else None for label in labels])
    return made


def growth_text(found, before=None):
    """Of each family a line."""
    lines = []
    for name, g in found.items():
        old = (before or {}).get(name)
        was = ", was n^%.2f" % old["exponent"] if old and (old["from"], old["to"]) == (g["from"], g["to"]) else ""
        lines.append("%s: time grows as n^%.2f, %s to %s blocks%s" % (
            name, g["exponent"], "{:,}".format(g["from"]), "{:,}".format(g["to"]), was))
    return lines


def read(path):
    """An earlier benchmark.json. @raises UserError if it is none."""
    try:
        with open(path, encoding="utf-8") as file:
            found = json.load(file)
        for r in found["rows"]:
            r["row"], r["value"], r["kind"], r["stopped_at_limit"]  # pylint: disable=pointless-statement (KeyError)
        return found
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise UserError("'%s' is no benchmark.json: %s" % (path, error)) from error
