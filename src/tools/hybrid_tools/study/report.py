# SPDX-License-Identifier: GPL-3.0-or-later
"""What a study says in the terminal and in files."""

import json
import os

import numpy as np

from hybrid_tools.study import tables
from hybrid_tools.study.axes import label_text
from hybrid_tools.study.run_directory import clipped

KINDS = {"closed form": "the closed form", "Richardson": "Richardson's value", "finest run": "the finest run"}
TABLES = ("runs", "values", "options", "samples", "scatter", "errors_", "verdict")  # files of write()
NOISE = 0.1  # of a processor time, on a machine that does nothing else
MOST_ROWS = 30  # of a table in the terminal; files have all
SEED = "seeds: the finest run again with Young's moduli larger by millionths"


def head(analysis):
    """What was studied, how much of it is done, and on what its errors rest."""
    study = analysis.study
    states = [result.run.state for result in analysis.results.values()]
    counts = ", ".join("%d %s" % (states.count(state), state) for state in ("done", "failed", "running", "planned") if state in states)
    title = study.base.get("Title") or os.path.basename(study.scene)
    lines = ["hybrid study  %s: %d %s, %s" % (title, len(states), "run" if len(states) == 1 else "runs", counts)]
    for axis in study.axes:
        labels = [label_text(label) for label in axis.labels]
        what = {"ladder": "coarse to fine", "samples": "samples", "options": "errors against %s" % labels[axis.reference],
                "models": "problems of their own; changes against %s are no errors" % labels[axis.reference]}[axis.kind]
        lines.append("varied    %s: %s (%s)" % (axis.short, " | ".join(labels), what))
    times = sorted({tables.times_of(result.run.manifest) for result in analysis.done})
    hint = " (--repeat 3 takes the least of three)" if any("beside" in words and "least" not in words for words in times) else ""
    lines.append("times     processor time of all threads with the start of the program, taken %s%s" % ("; ".join(times) or "in no run yet", hint))
    programs = sorted({result.run.manifest.get("program", {}).get("commit", "") for result in analysis.done})
    if len(programs) > 1:
        lines.append("warning   runs of %d versions of the program: %s" % (len(programs), ", ".join(programs)))
    if analysis.small:
        lines.append("left out  what is below a thousandth of the largest of its kind: " + shorten(analysis.small))
    return lines


def shorten(names):
    return ", ".join(names[:6]) + (" and %d more" % (len(names) - 6) if len(names) > 6 else "")


def sentence(analysis):
    """The cheapest setting of each problem within the tolerance, or that there is none."""
    if analysis.study.tolerance is None:
        return ""
    found = tables.problems(analysis) or {"": []}
    return " ".join(("%s: " % name if name else "") + sentence_on(analysis, entries) for name, entries in found.items())


def sentence_on(analysis, found):
    study, tolerance = analysis.study, analysis.study.tolerance
    within = [entry for entry in found if entry.error <= tolerance]
    wanted = "an error below %.3g %%" % (100 * tolerance)
    if not found:
        why = "nothing that is judged converges" if tables.scattered(analysis) else "no run has both an error and a time"
        return "No setting of this study has %s: %s." % (wanted, why)
    if not within:
        best = min(found, key=lambda entry: entry.error)
        return "No setting of this study has %s; the smallest known error is %s, of %s." % (wanted, tables.part(best.error), best.name(study))
    cheapest = min(within, key=lambda entry: entry.cost)
    finest, share = analysis.finest(analysis.reference_levels(cheapest.setting.levels)), ""
    if finest and finest not in cheapest.results and finest.cost:
        share = ", %.2g %% of the finest run" % (100 * cheapest.cost / finest.cost)
    return "The cheapest setting with %s is %s; it costs %.3g s of processor time%s. Its largest error is %s, of %s, against %s.%s" % (
        wanted, cheapest.name(study), cheapest.cost, share, tables.part(cheapest.error), tables.in_words(cheapest.worst), KINDS[cheapest.kind],
        as_cheap(study, cheapest, within))


def as_cheap(study, cheapest, within):
    """A sentence on settings whose times do not tell them from the cheapest one."""
    others = [entry for entry in within if entry is not cheapest and entry.cost <= (1 + NOISE) * cheapest.cost]
    named = ["%s (%.3g s, %s)" % (entry.name(study), entry.cost, tables.part(entry.error)) for entry in others]
    return " Times within %.0f %% of it, which runs scatter by: %s." % (100 * NOISE, "; ".join(named)) if named else ""


def chaos(analysis):
    """A sentence for each ladder along which something does not converge."""
    found = {}
    for ladder, row in tables.scattered(analysis):
        found.setdefault(id(ladder), (ladder, []))[1].append(row)
    lines = []
    for ladder, rows in found.values():
        worst = max(rows, key=lambda row: row.convergence.fine)
        seeds = "--seeds 4 shows how far they scatter" if worst.scatter is None else "seeds differ by %s" % tables.part(worst.scatter)
        lines.append("%d of %d quantities do not converge along %s, most of all %s: the two finest runs differ by %s, the coarsest by %s; %s"
                     % (len(rows), len(ladder.rows), tables.ladder_title(analysis, ladder), tables.in_words(worst.quantity),
                        tables.part(worst.convergence.fine), tables.part(worst.convergence.coarse), seeds))
    return lines


def shown_rows(table):
    """At most so many rows, the worst ones; the last one, the times, always."""
    if len(table.rows) <= MOST_ROWS:
        return table, ""
    def worst(row):
        return max((value for value in row[2:-2] if isinstance(value, float)), default=0.0)

    kept = sorted(sorted(range(len(table.rows) - 1), key=lambda k: -worst(table.rows[k]))[: MOST_ROWS - 1])
    rows = [table.rows[k] for k in kept] + table.rows[-1:]
    return tables.Table(table.columns, rows), "%d more rows with smaller errors are in the files" % (len(table.rows) - len(rows))


def text(analysis):
    """Everything for the terminal."""
    lines = head(analysis)
    for ladder in tables.ladders(analysis):
        table, more = shown_rows(tables.errors(ladder))
        lines += ["", "error along " + tables.ladder_title(analysis, ladder), table.text()] + [more] * bool(more)
    for title, table in (("cost of options and effects, against the finest run", tables.options(analysis)),
                         ("over samples", tables.samples(analysis))):
        if table.rows:
            lines += ["", title, table.text()]
    if tables.scattered(analysis):
        lines += ["", "what does not converge (%s)" % SEED, tables.scatter(analysis).text()]
    for name, found in tables.problems(analysis).items():
        front = tables.front_of(found)
        if len(front) > 1:
            lines += ["", "Pareto front%s: time and largest error" % (", " + name if name else "")]
            lines += ["  %8s s  %8s  %-28s %s" % (tables.seconds(entry.cost), tables.part(entry.error), entry.name(analysis.study),
                                                  tables.in_words(entry.worst)) for entry in front]
            finest = analysis.finest(analysis.reference_levels(front[-1].setting.levels))
            lines[-1] += ", estimated from itself" if finest in front[-1].results and front[-1].kind == "Richardson" else ""
    failed = [result for result in analysis.results.values() if result.run.state == "failed"]
    lines += [""] * bool(failed)
    lines += ["failed    %s: %s" % (analysis.study.describe(r.setting), clipped(r.run.manifest.get("reason", ""))) for r in failed]
    lines += [""] + ["verdict   " + line for line in chaos(analysis)] + ["verdict   " + sentence(analysis)] * bool(sentence(analysis))
    return "\n".join(lines).rstrip()


def write(analysis):
    """All tables, in tables/ of the study. @return the folder."""
    folder = os.path.join(analysis.study.directory, "tables")
    tables.runs(analysis).write(folder, "runs")
    for name, table in (("values", tables.values(analysis)), ("options", tables.options(analysis)), ("samples", tables.samples(analysis)),
                        ("scatter", tables.scatter(analysis))):
        if table.rows:
            table.write(folder, name)
    ladders = tables.ladders(analysis)
    for k, ladder in enumerate(ladders, 1):
        tables.errors(ladder).write(folder, "errors_%d" % k, {"along": tables.ladder_title(analysis, ladder)})
    orders = [{"along": tables.ladder_title(analysis, ladder), "quantity": row.quantity, "reference": row.kind,
               "order": row.order if np.isfinite(row.order) else None, "verdict": row.convergence.verdict}
              for ladder in ladders for row in ladder.rows.values()]
    verdict = {"tolerance": analysis.study.tolerance, "sentence": sentence(analysis), "does_not_converge": chaos(analysis),
               "compared_until_s": analysis.end, "pareto_front": [entry.name(analysis.study) for entry in tables.pareto(analysis)],
               "left_out": analysis.small, "orders": orders}
    with open(os.path.join(folder, "verdict.json"), "w", encoding="utf-8") as file:
        json.dump(verdict, file, indent=2)
    return folder
