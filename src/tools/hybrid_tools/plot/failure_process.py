# SPDX-License-Identifier: GPL-3.0-or-later
"""How the mass fails: the section at six times, with the joints that have failed by then.

The first is when a tenth of the joints that fail in the motion has failed. From there on the times part what happens into equal shares:
half of the share counts joints that fail, half the slip on the sliding surface.
"""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colors import Normalize
from matplotlib.lines import Line2D

from hybrid_run import MissingData, NotInScene
from hybrid_tools import style
from hybrid_tools.animate.film import KINDS, view
from hybrid_tools.animate.motion import Extent, Motion

from .section_view import Section, draw_rock
from .water import draw_water

FRAMES = 6
FIRST = 0.1  # of the failures
WIDTH = 12.0  # [inches]


def motion_failures(run):
    """Times at which joints failed after the static stage [s], in order. @raises NotInScene if none did."""
    times = run.file["joints/failure_time"][:] if run.has("joints/failure_time") else np.zeros(0)
    failures = np.sort(times[np.isfinite(times) & (times >= 0)])
    if not len(failures):
        raise NotInScene("no joint failed in the motion")
    return failures


def progress(run, failures, times):
    """Share of what happens in the run that has happened by each time, 0 to 1."""
    share = np.searchsorted(failures, times, side="right") / len(failures)
    if run.has("slip/mean"):
        slip = np.maximum.accumulate(np.abs(run.history("slip/mean")))
        if slip[-1] > 0:
            share = 0.5 * (share + np.interp(times, run.time, slip / slip[-1], left=0.0))
    return share


def frames(run, failures, times):
    """Numbers of the pictures that are drawn: the first by which a tenth of the failures has happened, the last of the run, and between
    them those that part what happens into equal shares."""
    failed = np.searchsorted(failures, times, side="right")
    first = min(int(np.searchsorted(failed, FIRST * len(failures))), len(times) - 1)
    share = progress(run, failures, times)
    chosen = [first]
    for wanted in np.linspace(share[first], share[-1], FRAMES)[1:-1]:
        chosen.append(max(int(np.searchsorted(share, wanted)), chosen[-1] + 1))
    return np.unique(np.append(np.minimum(chosen, len(times) - 1), len(times) - 1))


def draw_frame(axes, motion, k, section, scale):
    factor, norm = scale
    time, picture = motion.times[k], motion.blocks[k]
    draw_rock(section, axes)
    blocks = PolyCollection(motion.polygons(picture, motion.drawn(picture, time)), cmap=style.DISPLACEMENT_MAP, norm=norm,
                            array=factor * motion.values(picture, time, "displacement"), edgecolors="#5b4a3a", lw=0.1, zorder=3)
    axes.add_collection(blocks)
    count = 0
    colours = {kind: colour for kind, colour, _ in KINDS}
    for kind, ends in motion.failed(k):
        axes.add_collection(LineCollection(ends, colors=colours[kind], lw=1.4 if len(ends) < 100 else 0.6, zorder=5, capstyle="round"))
        count += len(ends)
    axes.set_title("t = %s s, %d %s failed" % (np.format_float_positional(time, precision=2, trim="-"), count, "joint" if count == 1 else "joints"))
    return blocks


def draw(run, directory):
    failures = motion_failures(run)
    try:
        motion = Motion(run)
    except MissingData as error:  # switched off, most likely
        raise NotInScene(str(error)) from error
    chosen = frames(run, failures, motion.times)
    section, extent = Section(run), Extent(motion, "displacement", chosen)
    low, high = view(extent, section, False)
    factor, unit = style.length_unit(extent.top)
    shape = (high[1] - low[1]) / (high[0] - low[0])
    columns = min(2 if shape < 0.6 else 3, len(chosen))
    rows = -(-len(chosen) // columns)
    height = rows * (0.92 * WIDTH / columns * np.clip(shape, 0.15, 1.5) + 0.35) + 0.9
    figure, axes = plt.subplots(rows, columns, figsize=(WIDTH, height), sharex=True, sharey=True, squeeze=False, constrained_layout=True)
    for axis in axes.flat[len(chosen):]:
        axis.set_visible(False)
    for axis, k in zip(axes.flat, chosen):
        blocks = draw_frame(axis, motion, k, section, (factor, Normalize(0, factor * extent.top)))
        axis.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]))
        axis.set_aspect("equal")
        axis.grid(False)
        draw_water(section.water, axis, motion.times[k])
    for axis in axes[:, 0]:
        axis.set_ylabel("elevation [m]")
    for axis in axes[-1]:
        axis.set_xlabel("x [m]")
    bar = figure.colorbar(blocks, ax=list(axes.flat), extend="max", shrink=0.6, aspect=30, pad=0.01)
    bar.set_label("displacement [%s]" % unit)
    figure.legend(handles=[Line2D([], [], color=colour, lw=1.6, label=label) for _, colour, label in KINDS], title="failed joints:",
                  ncol=2, loc="upper right", alignment="left", borderaxespad=0.3, title_fontsize=8)
    style.title(figure, "How the mass fails: " + run.title(), beside=2.2)
    style.save(figure, directory, "failure_process")
