# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the time of a run went: parts of the program, and steps."""

import numpy as np

from hybrid_run import MissingData, timings
from hybrid_tools import style

STATIC, REST = "static stage", "reading, meshing, all else"
CURVE = 200  # points of the curve over time
HEAD = ["part", "wall time [s]", "part of it [%]", "per step [ms]"]


def parts_of(run):
    """{words: wall time [s]}, the largest first, all of them together the whole run; empty where it has not ended."""
    summary = run.summary
    loop = timings.parts(summary)
    if not loop:
        return {}
    found = {**loop, STATIC: float(summary["timings_s"].get("static_stage", 0.0))}
    found = {words: found[words] for words in sorted(found, key=lambda words: -found[words]) if found[words] > 0}
    rest = summary.get("wall_time_s", 0.0) - sum(found.values())
    return {**found, REST: rest} if rest > 1e-3 * summary.get("wall_time_s", 0.0) else found


def rows_of(run):
    """[[part, s, %, ms per step]] as text."""
    parts, steps = parts_of(run), run.summary.get("steps", 0)
    whole = sum(parts.values())
    return [[words, "%.3g" % seconds, "%.2g" % (100 * seconds / whole), "%.3g" % (1e3 * seconds / steps) if steps and words not in (STATIC, REST) else "–"]
            for words, seconds in parts.items()]


def in_words(run):
    """A sentence on the whole: wall and processor time, steps, iterations, cuts, memory."""
    summary = run.summary
    words = "%.3g s of wall time" % summary.get("wall_time_s", 0.0)
    if "processor_time_s" in summary:
        words += ", %.3g s of processor time" % summary["processor_time_s"]
    steps = summary.get("steps", 0)
    words += " for {:,} steps".format(steps)
    if steps and summary.get("iterations"):
        words += " of %.3g iterations" % (summary["iterations"] / steps)
    words += ", %d of them cut" % summary["cuts"] if summary.get("cuts") else ""
    return words + ("; %.0f MB of memory" % summary["peak_memory_mb"] if "peak_memory_mb" in summary else "")


def smoothed(time, values):
    """(time, means over equal pieces)."""
    pieces = np.array_split(np.arange(len(values)), min(CURVE, len(values)))
    return time[[piece[-1] for piece in pieces]], np.array([values[piece].mean() for piece in pieces])


def steps(run):
    """Iterations and wall time per step against time."""
    from .panels import page

    curves = [(path, label, factor) for path, label, factor in (("steps/iterations", "iterations\nper step [-]", 1.0),
                                                                ("steps/wall_time", "wall time per\nstep [ms]", 1e3)) if run.has(path)]
    n = min([run.n] + [len(run.file[path]) for path, _, _ in curves])
    if not curves or n < 2:
        raise MissingData("no steps in run.h5")
    figure, axes = page(1.5 * len(curves) + 0.4, len(curves))
    for axis, (path, label, factor) in zip(axes[:, 0], curves):
        axis.plot(*smoothed(run.time[:n], factor * run.get(path)[:n]), color=style.HORIZONTAL, lw=1.0)
        axis.set_ylabel(label)
        axis.set_ylim(bottom=0)
    figure.align_ylabels()
    axes[-1, 0].set(xlabel="time [s]", xlim=(run.time[0], run.time[n - 1]))
    return figure, "Where steps are dear, means over %d of them: %s." % (max(n // CURVE, 1), in_words(run))
