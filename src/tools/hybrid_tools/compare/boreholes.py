# SPDX-License-Identifier: GPL-3.0-or-later
"""Displacement along the boreholes at the end of the common time, beside what was measured."""

import numpy as np
from matplotlib.lines import Line2D

from hybrid_run import MissingData
from hybrid_tools import style
from hybrid_tools.plot.boreholes import depth_of_slip, draw_measured, with_jump

from . import curves


def profile(comparison, i, name):
    """(depth [m], horizontal displacement relative to the base [m]) of run i at the end, from the top down."""
    run = comparison.runs[i]
    depth = run.get("profiles/%s/depth" % name)
    x = comparison.on_axis(i, "profiles/%s/displacement" % name)[-1, 0::2]
    order = np.argsort(depth)
    return with_jump(depth[order], comparison.downhill * x[order], depth_of_slip(run, "profiles/" + name))


def shared(comparison):
    def has_rows(run, name):
        path = "profiles/%s/displacement" % name
        return run.has(path) and len(run.file[path]) > 0

    return [name for name in comparison.reference.names("profiles") if all(has_rows(run, name) for run in comparison.runs)]


def draw(comparison, directory):
    names = shared(comparison)
    if not names:
        raise MissingData("no boreholes")
    figure, axes = curves.panels(1, len(names), (max(3.2, 5.4 / len(names)), 5.0))
    has_measured = has_surface = False
    for axis, name in zip(axes[0], names):
        profiles = [profile(comparison, i, name) for i in range(len(comparison.runs))]
        factor, unit = style.length_unit(max(np.nanmax(np.abs(x), initial=0) for _, x in profiles))
        for i, (depth, x) in enumerate(profiles):
            axis.plot(factor * x, depth, **curves.look(i))
        has_measured |= any(draw_measured(run, axis, name, 1e-3 * factor) for run in comparison.runs)
        axis.axvline(0, color="#8a8a8a", lw=0.7, zorder=1)
        axis.set_ylim(max(depth.max() for depth, _ in profiles), 0)
        axis.margins(x=0.1)
        slip_depth = depth_of_slip(comparison.reference, "profiles/" + name)
        if slip_depth is not None:
            has_surface = True
            axis.axhline(slip_depth, color=style.SLIP, lw=1.0, zorder=1)
        axis.set_xlabel("%s displacement [%s]" % (comparison.reference.along("horizontal"), unit))
        axis.set_title(name)
    axes[0, 0].set_ylabel("depth [m]")
    handles = [Line2D([], [], label=label, **curves.look(i)) for i, label in enumerate(comparison.labels)]
    if has_surface:
        handles.append(Line2D([], [], color=style.SLIP, lw=1.0, label="sliding surface"))
    if has_measured:
        handles.append(Line2D([], [], marker="D", color=style.TENSILE, ls="none", ms=6, mec="white", label="measured"))
    curves.finish(figure, comparison, "Boreholes at %.4g s" % comparison.end, directory, "boreholes", handles)
