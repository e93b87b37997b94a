# SPDX-License-Identifier: GPL-3.0-or-later
"""The answer as text, JSON and CSV."""

import csv
import json

import numpy as np

from hybrid_run.spectra import FAINT


def summary(study):
    """Numbers of table.json, which the text shows too."""
    rows = []
    for side in study.sides:
        upper, lower = side.tips()
        row = {"line": side.line.name, "side": side.name, "length_m": side.length(), "upper_tip": float(side.ratio[upper]),
               "lower_tip": float(side.ratio[lower]), "mean": side.mean(), "largest": point(side, side.largest(), side.ratio[side.largest()])}
        for name, pick in (("largest_spectral_ratio", np.nanargmax), ("smallest_spectral_ratio", np.nanargmin)):
            extreme = side.spectral_extreme(pick)
            row[name] = None if extreme is None else {**point(side, extreme[2], extreme[0]), "frequency_hz": extreme[1]}
        rows.append(row)
    clear = study.frequency[study.is_clear]
    return {"run": study.run.directory, "component": study.letter, "outcrop_peak_m_s2": study.outcrop_peak,
            "resolved_frequency_hz": study.resolved if np.isfinite(study.resolved) else None, "bandwidth": study.bandwidth,
            "least_outcrop_amplitude": FAINT, "ratios_from_hz": float(clear[0]) if len(clear) else None,
            "ratios_to_hz": float(clear[-1]) if len(clear) else None, "sides": rows, "jumps": study.jumps()}


def point(side, k, ratio):
    return {"ratio": float(ratio), "s_m": float(side.distance[k]), "x_m": float(side.position[k, 0]), "y_m": float(side.position[k, 1])}


def text(numbers):
    """Lines for the terminal."""
    lines = [reference(numbers)]
    heads = ["line", "length", "side", "upper tip", "largest at (s; x, y)", "lower tip", "mean"]
    rows = [heads + ["peak a_%s / outcrop" % numbers["component"]]]
    before = None
    for row in numbers["sides"]:
        at = row["largest"]
        is_new = row["line"] != before
        before = row["line"]
        rows.append([row["line"] if is_new else "", "%.1f m" % row["length_m"] if is_new else "", "-" if row["side"] == "on" else row["side"],
                     "%.2f" % row["upper_tip"], "%.2f (%.4g m; %.5g, %.5g)" % (at["ratio"], at["s_m"], at["x_m"], at["y_m"]),
                     "%.2f" % row["lower_tip"], "%.2f" % row["mean"], ""])
    widths = [max(len(row[c]) for row in rows) for c in range(len(heads))]
    for row in rows:
        cells = [cell.ljust(w) if c in (0, 2) else cell.rjust(w) for c, (cell, w) in enumerate(zip(row, widths))]
        lines.append("  ".join(cells + row[-1:]).rstrip())
    return "\n".join(lines + [jump_text(j) for j in numbers["jumps"]] + spectra_text(numbers))


def reference(numbers):
    resolved = numbers["resolved_frequency_hz"]
    return "reference  outcrop motion, %s, %.3f g; %sspectra smoothed (Konno and Ohmachi 1998, b = %g)" % (
        numbers["component"], numbers["outcrop_peak_m_s2"] / 9.80665, "resolved to %.3g Hz; " % resolved if resolved else "", numbers["bandwidth"])


def jump_text(jump):
    words = "jump across %s: peak a differs by %.2g %% at most" % (jump["line"], 100 * jump["peak_acceleration_difference"])
    if "largest_shear_stress_pa" in jump:
        words += "; largest shear stress %.3g MPa" % (1e-6 * jump["largest_shear_stress_pa"])
    words += "; largest slip %.3g mm" % (1e3 * jump["largest_slip_m"])
    if "largest_plastic_slip_m" in jump:
        plastic = jump["largest_plastic_slip_m"]
        words += " (elastic)" if plastic == 0 else " (%.3g mm of it for good)" % (1e3 * plastic)
    return words + ", opening %.3g mm" % (1e3 * jump["largest_opening_m"])


def spectra_text(numbers):
    if numbers["ratios_from_hz"] is None:
        return ["spectral ratios are not told: the outcrop has less than %g %% of its largest amplitude at all their frequencies" % (
            100 * numbers["least_outcrop_amplitude"])]
    lines = ["spectral ratios are told where the outcrop has over %g %% of its largest amplitude: within %.3g to %.3g Hz" % (
        100 * numbers["least_outcrop_amplitude"], numbers["ratios_from_hz"], numbers["ratios_to_hz"])]
    for row in numbers["sides"]:
        high, low = row["largest_spectral_ratio"], row["smallest_spectral_ratio"]
        if high is None or row["side"] == "below":
            continue
        name = row["line"] if row["side"] == "on" else "%s %s" % (row["line"], row["side"])
        lines.append("spectral ratio, %s: " % name + ", ".join(
            "%.2g at %.3g Hz (s = %.4g m)" % (e["ratio"], e["frequency_hz"], e["s_m"]) for e in (high, low)))
    return lines


def write(study, numbers, directory):
    with open(directory + "/table.json", "w", encoding="utf-8") as out:
        json.dump(numbers, out, indent=1)
        out.write("\n")
    with open(directory + "/table.csv", "w", encoding="utf-8", newline="") as out:
        rows = csv.writer(out)
        rows.writerow(["line", "side", "s [m]", "x [m]", "y [m]", "peak a_%s / outcrop [-]" % study.letter])
        for side in study.sides:
            for k, ratio in enumerate(side.ratio):
                rows.writerow([side.line.name, side.name] + ["%.9g" % v for v in (side.distance[k], *side.position[k], ratio)])
    with open(directory + "/spectral_ratios.csv", "w", encoding="utf-8", newline="") as out:
        rows = csv.writer(out)
        rows.writerow(["line", "side", "s [m]"] + ["%.6g Hz" % f for f in study.frequency])
        for side in study.sides:
            for k, column in enumerate(side.spectral.T):
                rows.writerow([side.line.name, side.name, "%.9g" % side.distance[k]] + ["%.6g" % v if np.isfinite(v) else "" for v in column])
