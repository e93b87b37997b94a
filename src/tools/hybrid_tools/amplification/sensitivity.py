# SPDX-License-Identifier: GPL-3.0-or-later
"""How the amplification of several runs depends on one of their parameters."""

import csv
import json

import matplotlib.pyplot as plt
import numpy as np

from hybrid_run import UserError
from hybrid_tools import style
from hybrid_tools.amplification import table

MARKS = "os^Dv<>P*X"


def values_of(studies, parameter):
    """(values, are they numbers); @raises UserError where a run lacks the parameter, or all have the same."""
    texts = []
    for study in studies:
        known = study.run.parameters
        if parameter not in known:
            raise UserError("--against: '%s' has no parameter '%s'; doc/parameters.md lists them" % (study.run.directory, parameter))
        texts.append(known[parameter])
    if len(set(texts)) == 1:
        raise UserError("--against: '%s' is %s in all runs; it must differ" % (parameter, texts[0]))
    try:
        return np.array([float(text.split()[0]) for text in texts]), True
    except (ValueError, IndexError):
        return texts, False


def rows_of(studies, values):
    """[{value, line, side, largest, mean, upper_tip, lower_tip, ...}]"""
    rows = []
    for study, value in zip(studies, values):
        numbers = table.summary(study)
        jumps = {jump["line"]: jump for jump in numbers["jumps"]}
        for side in numbers["sides"]:
            high = side["largest_spectral_ratio"] or {}
            rows.append({"value": value if isinstance(value, str) else float(value), "run": numbers["run"],
                         "line": side["line"], "side": side["side"],
                         "largest": side["largest"]["ratio"], "largest_s_m": side["largest"]["s_m"], "mean": side["mean"],
                         "upper_tip": side["upper_tip"], "lower_tip": side["lower_tip"], "largest_spectral_ratio": high.get("ratio"),
                         "at_hz": high.get("frequency_hz"), "largest_slip_m": jumps.get(side["line"], {}).get("largest_slip_m"),
                         "peak_acceleration_difference": jumps.get(side["line"], {}).get("peak_acceleration_difference")})
    return rows


def axis_of(study, parameter, is_number):
    """Its name with the unit; that of a value such as 0.3 g is in the value."""
    text = study.run.parameters[parameter]
    unit = (text.split()[1:] or [study.run.unit(parameter)])[0] if is_number else ""
    return parameter + (" [%s]" % unit if unit else "")


def draw(rows, parameter, is_number, letter, directory):
    figure, axes = plt.subplots(1, 3, figsize=(11, 3.8), constrained_layout=True)
    order = {value: k for k, value in enumerate(dict.fromkeys(row["value"] for row in rows))}
    kinds = list(dict.fromkeys((row["line"], row["side"]) for row in rows))
    colours = plt.get_cmap("viridis")(np.linspace(0.0, 0.85, len({line for line, _ in kinds})))
    colour = dict(zip(dict.fromkeys(line for line, _ in kinds), colours))
    parts = (("largest", "largest peak a$_%s$ / outcrop" % letter), ("mean", "mean peak a$_%s$ / outcrop" % letter),
             ("largest_spectral_ratio", "largest spectral ratio"))
    for axis, (key, label) in zip(axes, parts):
        for k, (line, side) in enumerate(kinds):
            chosen = [r for r in rows if (r["line"], r["side"]) == (line, side) and r[key] is not None]
            chosen.sort(key=lambda r: r["value"] if is_number else order[r["value"]])
            x = [r["value"] if is_number else order[r["value"]] for r in chosen]
            axis.plot(x, [r[key] for r in chosen], marker=MARKS[k % len(MARKS)], ms=4, color=colour[line], ls="--" if side == "below" else "-",
                      label=line if side == "on" else "%s, %s" % (line, side))
        axis.set_ylabel(label + " [-]")
        axis.set_xlabel(parameter)
        numbers = [value for value in order if is_number]
        if is_number and min(numbers) > 0 and max(numbers) >= 8 * min(numbers):
            axis.set_xscale("log")
        elif not is_number:
            axis.set_xticks(list(order.values()), list(order))
        axis.set_ylim(0, 1.1 * axis.dataLim.y1)
    figure.legend(*axes[0].get_legend_handles_labels(), loc="upper center", bbox_to_anchor=(0.5, 0.0), ncol=min(len(kinds), 5))
    style.title(figure, "Peak acceleration over that of the outcrop, by " + parameter)
    style.save(figure, directory, "sensitivity")


def main(studies, parameter, directory, with_figure):
    values, is_number = values_of(studies, parameter)
    rows = rows_of(studies, values)
    with open(directory + "/sensitivity.json", "w", encoding="utf-8") as out:
        json.dump({"against": parameter, "component": studies[0].letter, "rows": rows}, out, indent=1)
    with open(directory + "/sensitivity.csv", "w", encoding="utf-8", newline="") as out:
        writer = csv.DictWriter(out, rows[0])
        writer.writeheader()
        writer.writerows(rows)
    print("%s\n%-14s %-12s %-6s %8s %8s %10s %10s %9s %8s" % (
        axis_of(studies[0], parameter, is_number), "value", "line", "side", "largest", "mean", "upper tip", "lower tip", "spectral", "at"))
    for r in rows:
        value = r["value"] if isinstance(r["value"], str) else "%.6g" % r["value"]
        spectral = "%9.2f %5.3g Hz" % (r["largest_spectral_ratio"], r["at_hz"]) if r["at_hz"] else ""
        print("%-14s %-12s %-6s %8.2f %8.2f %10.2f %10.2f %s" % (
            value, r["line"], "-" if r["side"] == "on" else r["side"], r["largest"], r["mean"], r["upper_tip"], r["lower_tip"], spectral))
    if with_figure:
        style.apply()
        draw(rows, axis_of(studies[0], parameter, is_number), is_number, studies[0].letter, directory)
    print("files      %s/: sensitivity.csv, sensitivity.json%s" % (directory, ", sensitivity.png" if with_figure else ""))
    return 0
