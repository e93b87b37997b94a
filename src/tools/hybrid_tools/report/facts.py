# SPDX-License-Identifier: GPL-3.0-or-later
"""What happened, in words and numbers: from summary.json, log.txt and params.used.prm."""

import os
import re
from dataclasses import dataclass

import numpy as np

from hybrid_run import MissingData
from hybrid_run.parameters import changed_parameters

GRAVITY = 9.80665  # m/s2
MUCH_MORE = 3.0  # times the slip: a mass that leans or yields, of which slip is no measure


@dataclass
class Fact:
    """One number of the first screen."""

    name: str
    value: str
    unit: str
    more: str = ""


def length(value):
    """(number, unit) of a length [m]."""
    size = abs(value)
    factor, unit = (1.0, "m") if size >= 1 else (1e3, "mm") if size >= 1e-5 or size == 0 else (1e6, "µm")
    return "%.3g" % (factor * value) if size < 1000 else "%.0f" % value, unit


def duration(seconds):
    if seconds < 60:
        return "%.3g s" % seconds
    minutes, rest = divmod(int(round(seconds)), 60)
    return "%d min %d s" % (minutes, rest) if minutes < 60 else "%d h %d min" % divmod(minutes, 60)


def state(run):
    """(sentence, is it good): did the run end as it should."""
    summary = run.summary
    if not summary:
        return "The run goes on, or was killed: %.3g s are simulated so far." % (run.time[-1] if run.n else 0), False
    if not summary.get("finished"):
        return "The run stopped early, at %.4g s; what is shown is complete up to there." % summary.get("simulated_time_s", 0), False
    return "Finished: %.4g s in %s steps, computed in %s." % (
        summary.get("simulated_time_s", 0), "{:,}".format(summary.get("steps", 0)), duration(summary.get("wall_time_s", 0))), True


def farthest(run):
    """(monitor, peak [m], left [m]) of the monitor that moved farthest relative to the base, None without monitors."""
    best = None
    for name, monitor in run.monitors.items():
        if name == run.base or run.n < 2:
            continue
        moved = np.hypot(*monitor.displacement.T)
        if best is None or moved.max() > best[1]:
            best = name, moved.max(), moved[-1]
    return best


def leaning(run):
    """(monitor, mean displacement over the end of the run [m]) of the one that stays farthest from its place; None without monitors."""
    if run.n < 2:
        return None
    end = run.time >= run.time[-1] - min(2.0, 0.1 * run.time[-1])
    left = {name: float(np.hypot(*monitor.displacement[end].mean(axis=0))) for name, monitor in run.monitors.items() if name != run.base}
    return max(left.items(), key=lambda item: item[1], default=None)


def strongest(run):
    """(monitor, peak acceleration [m/s2] of both components): the largest, below the low-pass; the base counts if it is alone."""
    peaks = {name: monitor.peak() for name, monitor in run.monitors.items() if run.n >= 2}
    if len(peaks) > 1:
        peaks.pop(run.base, None)
    return max(peaks.items(), key=lambda item: item[1].max()) if peaks else None


def outcrop_peaks(run):
    """Of both components of the outcrop motion [m/s2]."""
    return np.abs(run.history("input/acceleration")).max(axis=0) if run.has("input/acceleration") and run.n >= 2 else np.zeros(2)


def times_outcrop(run, peaks):
    """Peaks of both components over those of the outcrop motion, the component in which it is largest; None if nothing shakes."""
    outcrop = outcrop_peaks(run)
    return peaks[outcrop.argmax()] / outcrop.max() if outcrop.max() > 0 else None


def slip(run):
    """(mean, largest) left at the end [m], or None."""
    return (run.get("slip/mean")[-1], run.get("slip/largest")[-1]) if run.has("slip/mean") and run.n else None


def is_bonded(run):
    try:
        return run.parameters.get("Model/Blocks") == "bonded"
    except MissingData:
        return False


def failed_joints(run):
    """(tensile, shear, of them in the static stage), None without joints."""
    joints = run.summary.get("joints")
    if joints is None:
        return None
    static = joints.get("static", {})
    return joints.get("tensile", 0), joints.get("shear", 0), static.get("tensile", 0) + static.get("shear", 0)


def listed(words):
    return words[0] if len(words) == 1 else ", ".join(words[:-1]) + ", and " + words[-1]


def headline(run):
    """One or two sentences: what the earthquake did."""
    peak, words = outcrop_peaks(run).max(), []
    subject = "Nothing shook the ground"
    if peak > 0:
        subject = "The ground shook with up to %.3g m/s² (%.2g g) of outcrop motion" % (peak, peak / GRAVITY)
    found = slip(run)
    if found is not None:
        mean = "" if not run.slips_downhill else ", by %s %s on average" % length(found[0])  # on level ground left and right cancel
        way = " uphill" if found[1] < 0 and run.slips_downhill else ""
        words.append("the mass has slipped for good by up to %s %s%s%s" % (length(abs(found[1])) + (way, mean)))
        leans = leaning(run)
        if leans and leans[1] > MUCH_MORE * abs(found[1]):
            words.append("%s stays %s %s from where it was" % (leans[0], *length(leans[1])))
    elif run.has("section/blocks_displacement"):
        words.append("blocks lie up to %s %s from where they were" % length(np.hypot(*run.blocks.displacement[run.blocks.mass].T).max(initial=0)))
    joints = failed_joints(run)
    if joints is not None and is_bonded(run):
        n = joints[0] + joints[1]
        words.append("%s failed" % ("no joint has" if n == 0 else "one joint has" if n == 1 else "%d joints have" % n))
    return subject + ("; " + listed(words) if words else "") + "."


def most_of_blocks(run):
    """The same of all blocks, where it is known."""
    if not run.has("section/blocks_peak_displacement") or not len(run.blocks.peak_displacement[run.blocks.mass]):
        return ""
    return "; of all blocks up to %s %s" % length(run.blocks.peak_displacement[run.blocks.mass].max())


def facts(run):
    """Numbers of the first screen, the most important first."""
    found = []
    moved = farthest(run)
    if moved:
        against = ", relative to " + run.base if run.base else ""
        found.append(Fact("Peak displacement", *length(moved[1]), "of %s, the monitor that moves most%s, at any time%s" % (
            moved[0], against, most_of_blocks(run))))
        found.append(Fact("Displacement left", *length(moved[2]), "of %s, at the end" % moved[0]))
    elif run.has("section/blocks_peak_displacement"):
        most = run.blocks.peak_displacement[run.blocks.mass].max(initial=0)
        found.append(Fact("Peak displacement", *length(most), "of the block that moves most, at any time"))
    hardest = strongest(run)
    if hardest:
        name, peaks = hardest
        ratio = times_outcrop(run, peaks)
        times = ", %.2f × outcrop in its direction" % ratio if ratio is not None else ""
        found.append(Fact("Peak acceleration", "%.3g" % peaks.max(), "m/s²", "%.2g g, at monitor %s%s" % (peaks.max() / GRAVITY, name, times)))
    slipped = slip(run)
    if slipped:
        mean = "" if not run.slips_downhill else "; mean over all of it %s %s" % length(slipped[0])
        found.append(Fact("Slip left", *length(slipped[1]), "at the end, where the mass has slid farthest on its surface" + mean))
    joints = failed_joints(run)
    if joints and (is_bonded(run) or sum(joints)):
        more = "%d tensile, %d shear%s" % (joints[:2] + ("; %d before the motion" % joints[2] if joints[2] else "",))
        found.append(Fact("Failed joints", str(joints[0] + joints[1]), "", more if joints[0] + joints[1] else "all bonds hold"))
    off_base = run.summary.get("blocks_off_base", 0)
    if off_base:
        found.append(Fact("Blocks off the base", str(off_base), "", "beyond its end, where nothing is below them"))
    residual = run.summary.get("energy_residual")
    if isinstance(residual, float):
        found.append(Fact("Energy missing", "%.2g" % (100 * abs(residual)), "%", "of the energy exchanged"))
    return found


def log_lines(run):
    path = os.path.join(run.directory, "log.txt")
    if not os.path.exists(path):
        return []
    with open(path, encoding="utf-8", errors="replace") as text:
        return [line.rstrip("\n") for line in text]


def warnings(run):
    return [line.partition(": ")[2] for line in log_lines(run) if line.startswith(("warning: ", "error: "))]


def card(run):
    """[(heading, [[words]])] of what the program understood: groups with rows of two or three columns."""
    groups, plain = [], []
    for line in log_lines(run)[1:]:
        if line.startswith(("Finished", "Stopped", "Error")):
            break  # how the run ended is told elsewhere
        if line.startswith(("warning: ", "error: ")) or not line.strip():
            continue
        words = re.split(r" {2,}", line.strip())
        if line.startswith(" ") and groups:
            on = re.match(r"(.*?) +(on|off)\b *(.*)", line.strip())
            line_of_mesh = re.match(r"(.*?) +(\S+ m)  +(.*)", line.strip())
            found = on or line_of_mesh
            groups[-1][1].append([part.strip() for part in found.groups()] if found else [words[0], " ".join(words[1:])])
        elif len(words) == 1 and ":" not in line:
            groups.append((line.strip(), []))
        else:
            head, _, rest = line.partition("  ") if "  " in line else line.partition(": ")
            plain.append([head.strip(), rest.strip()])
    return ([("Model", plain)] if plain else []) + [(head, rows) for head, rows in groups if rows]


def resolved_frequency(run):
    """Up to which the run resolves waves [Hz], None if it does not say."""
    return run.summary.get("resolved_frequency_hz")


def monitor_rows(run):
    """(unit of displacements, [[name, peak displacement, left, peak acceleration of the larger component, that of the
    outcrop's component over its peak, peak velocity, x, y]] as text)."""
    rows = []
    largest = max([np.abs(m.displacement).max() for m in run.monitors.values()] or [0]) if run.n >= 2 else 0
    factor, unit = (1.0, "m") if largest >= 2 else (1e3, "mm")
    for name, monitor in run.monitors.items():
        if run.n < 2:
            continue
        moved = np.hypot(*monitor.displacement.T)
        peaks = monitor.peak()
        ratio = times_outcrop(run, peaks)
        position = monitor.position if monitor.position is not None else (np.nan, np.nan)
        rows.append([name + (" (absolute)" if name == run.base else ""), "%.3g" % (factor * moved.max()), "%.3g" % (factor * moved[-1]),
                     "%.3g" % peaks.max(), "–" if ratio is None else "%.2f" % ratio,
                     "%.3g" % monitor.peak("velocity").max(), "%.1f" % position[0], "%.1f" % position[1]])
    return unit, rows


def parameters(run):
    """(changed [[name, value, default]], all [[name, value]]); empty if the run has no params.used.prm."""
    try:
        everything = run.parameters
    except MissingData:
        return [], []
    changed = changed_parameters(os.path.join(run.directory, "params.used.prm"))
    return ([[name, value, default or "–"] for name, (value, default) in changed.items()],
            [[name, value or "–"] for name, value in everything.items()])
