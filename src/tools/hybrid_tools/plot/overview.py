# SPDX-License-Identifier: GPL-3.0-or-later
"""One page that says what happened: figures of the run, section, motion, displacements, boreholes, energy."""

import matplotlib.pyplot as plt
from matplotlib.lines import Line2D

from hybrid_run import MissingData
from hybrid_tools import style

from . import boreholes, energy_balance, input_motion, monitor_histories, section_view

MOST_PROFILES = 2  # boreholes


def facts(run):
    s = run.summary
    if not s:
        return "still running or killed: %.3f s simulated so far" % (run.time[-1] if run.n else 0)
    joints = s.get("joints", {})
    static = joints.get("static", {})
    lines = ["%s: %g s simulated in %.0f s, %s steps, %s cuts" % (
        "finished" if s.get("finished") else "not finished", s.get("simulated_time_s", 0), s.get("wall_time_s", 0),
        s.get("steps", "?"), s.get("cuts", "?"))]
    lines.append("%s block%s, %s unknowns of the continuum; joints failed: %s tensile, %s shear (static stage: %s, %s)" % (
        s.get("blocks", 0), "" if s.get("blocks") == 1 else "s", s.get("continuum_unknowns", 0), joints.get("tensile", 0), joints.get("shear", 0),
        static.get("tensile", 0), static.get("shear", 0)))
    if isinstance(s.get("energy_residual"), float):
        lines[-1] += "; energy residual %.2g %%" % (100 * s["energy_residual"])
    return "\n".join(lines)


def shrink_legend(axes):
    """The legend at the right takes its room from the axes."""
    box = axes.get_position()
    axes.set_position([box.x0, box.y0, 0.82 * box.width, box.height])
    axes.legend(loc="center left", bbox_to_anchor=(1.0, 0.5), fontsize=7, handlelength=1.2, borderaxespad=0.3)


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
    names = groups.get("S") or groups.get("D") or groups.get("other")
    if not names or run.n < 2:
        raise MissingData("no monitors in run.h5")
    monitor_histories.draw_overlay(run, axes, names)
    shrink_legend(axes)
    axes.set_title("monitors" + (" relative to " + run.base if run.base else ""))


def draw_energy(run, axes):
    energy_balance.draw_terms(axes, *energy_balance.read_terms(run))
    shrink_legend(axes)
    axes.set_xlabel("time [s]")
    axes.set_title("energy")


class Profile:
    """The panel of one borehole."""

    def __init__(self, name):
        self.name = name

    def __call__(self, run, axes):
        boreholes.draw_profile(run, axes, self.name, with_legend=False)
        axes.set_ylabel("depth [m]")


def choose_profiles(run):
    """(boreholes that are drawn, others): those that move most, in the order of their names."""
    names = [n for n in run.names("profiles") if run.has("profiles/%s/displacement" % n) and len(run.file["profiles/%s/displacement" % n])]
    most = sorted(names, key=lambda name: -boreholes.largest_of(run, name))[:MOST_PROFILES]
    return [n for n in names if n in most], [n for n in names if n not in most]


def explain_profiles(part, axes, others):
    """One legend for the boreholes of a row, below them; it names those that are not drawn."""
    handles, labels = axes.get_legend_handles_labels()
    if others:
        handles.append(Line2D([], [], linestyle="none"))
        names = ", ".join(others) if len(others) <= 3 else "%d others" % len(others)
        labels.append("without %s, which move%s less" % (names, "s" * (len(others) == 1)))
    part.legend(handles, labels, loc="lower right", bbox_to_anchor=(0.97, -0.03), ncol=len(labels), fontsize=7, handlelength=1.4,
                columnspacing=1.2)


def is_profile(function):
    return isinstance(function, Profile)


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
    holes, others = choose_profiles(run)
    small = [f for f in (draw_motion, draw_displacements, draw_energy) if possible(run, f)]
    for name in holes:
        small.append(Profile(name))
    with_section = possible(run, draw_section)
    if not small and not with_section:
        raise MissingData("nothing recorded yet")
    draw_page(run, small, with_section, directory, others)


def rows_of(small):
    """Histories two in a row, boreholes beside the energy."""
    if len(small) <= 3:
        return [small] if small else []
    return [small[:2], small[2:]]


def draw_page(run, small, with_section, directory, others=()):
    rows = rows_of(small)
    heights = ([4.1] if with_section else []) + [3.0] * len(rows)
    figure = plt.figure(figsize=(13, sum(heights) + 0.75))
    head, *parts = figure.subfigures(len(heights) + 1, 1, height_ratios=[0.75] + heights, squeeze=False)[:, 0]
    head.text(0.012, 0.9, run.title(), ha="left", va="top", fontsize=13, fontweight="bold")
    head.text(0.012, 0.52, facts(run), ha="left", va="top", fontsize=9, color="#444444")
    if with_section:
        axes = parts[0].add_axes([0.06, 0.13, 0.86, 0.79])
        draw_section(run, axes)
    for part, row in zip(parts[len(parts) - len(rows) :], rows):
        ratios = [1.0 if is_profile(function) else 2.0 for function in row]
        grid = part.add_gridspec(1, len(row), width_ratios=ratios, left=0.06, right=0.955, bottom=0.2, top=0.9, wspace=0.3)
        for i, function in enumerate(row):
            axes = part.add_subplot(grid[i])
            function(run, axes)
        if is_profile(row[-1]):
            explain_profiles(part, axes, others)
    style.save(figure, directory, "overview")
