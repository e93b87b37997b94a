# SPDX-License-Identifier: GPL-3.0-or-later
"""One page that says what happened: figures of the run, section, motion, displacements, boreholes, energy."""

import boreholes
import energy_balance
import input_motion
import matplotlib.pyplot as plt
import monitor_histories
import section_view
import style
from run_data import MissingData


def facts(run):
    s = run.summary
    if not s:
        return "still running or killed: %.3f s simulated so far" % (run.time[-1] if run.n else 0)
    joints = s.get("joints", {})
    static = joints.get("static", {})
    lines = ["%s: %g s simulated in %.0f s, %s steps, %s cuts" % (
        "finished" if s.get("finished") else "not finished", s.get("simulated_time_s", 0), s.get("wall_time_s", 0),
        s.get("steps", "?"), s.get("cuts", "?"))]
    lines.append("%s blocks, %s unknowns of the continuum; joints failed: %s tensile, %s shear (static stage: %s, %s)" % (
        s.get("blocks", 0), s.get("continuum_unknowns", 0), joints.get("tensile", 0), joints.get("shear", 0),
        static.get("tensile", 0), static.get("shear", 0)))
    if isinstance(s.get("energy_residual"), float):
        lines[-1] += "; energy residual %.2g %%" % (100 * s["energy_residual"])
    return "\n".join(lines)


def draw_section(run, axes):
    section_view.draw_main(section_view.Section(run), axes)
    axes.set_xlabel("x [m]")


def draw_motion(run, axes):
    time, acceleration = run.equal_steps(run.history("input/acceleration"))
    input_motion.draw_history(axes, time, acceleration, "acceleration", "m/s²")
    axes.set_xlabel("time [s]")
    axes.set_title("outcrop motion")


def draw_displacements(run, axes):
    groups = run.monitor_groups()
    if not groups or run.n < 2:
        raise MissingData("no monitors in run.h5")
    names = groups.get("S") or groups.get("D") or groups["other"]
    monitor_histories.draw_overlay(run, axes, names)
    axes.set_title("monitors" + (" relative to " + run.base if run.base else ""))


def draw_energy(run, axes):
    energy_balance.draw_terms(axes, *energy_balance.read_terms(run))
    axes.set_xlabel("time [s]")
    axes.set_title("energy")


def possible(run, function):
    """Whether a panel can be drawn: it is tried on axes that are thrown away."""
    figure = plt.figure()
    try:
        function(run, figure.add_subplot())
        return True
    except MissingData:
        return False
    finally:
        plt.close(figure)


def draw(run, directory):
    holes = [n for n in run.names("profiles") if run.has("profiles/%s/displacement" % n) and len(run.file["profiles/%s/displacement" % n])][:2]
    small = [f for f in (draw_motion, draw_displacements, draw_energy) if possible(run, f)]
    for name in holes:
        small.append(lambda r, axes, n=name: (boreholes.draw_profile(r, axes, n, False), axes.set_ylabel("depth [m]")))
    with_section = possible(run, draw_section)
    if not small and not with_section:
        raise MissingData("nothing recorded yet")
    rows = (len(small) + 2) // 3 if holes else (len(small) + 1) // 2
    columns = 6
    heights = ([1.55] if with_section else []) + [1.0] * rows
    figure = plt.figure(figsize=(13, 2.9 * sum(heights) + 0.8), constrained_layout=True)
    figure.set_constrained_layout_pads(h_pad=0.08, w_pad=0.08)
    grid = figure.add_gridspec(len(heights), columns, height_ratios=heights)
    if with_section:
        draw_section(run, figure.add_subplot(grid[0, :]))
    first = 1 if with_section else 0
    for row in range(rows):
        here = small[row * len(small) // rows : (row + 1) * len(small) // rows]
        width = columns // len(here)
        for i, function in enumerate(here):
            function(run, figure.add_subplot(grid[first + row, i * width : (i + 1) * width]))
    figure.suptitle(run.title() + "\n" + facts(run), x=0.01, ha="left", fontsize=10)
    style.save(figure, directory, "overview")
