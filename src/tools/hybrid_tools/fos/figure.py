# SPDX-License-Identifier: GPL-3.0-or-later
"""The mechanism of failure, and how displacement grows with the strength reduction factor or the horizontal coefficient."""

import os

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection, PolyCollection
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from hybrid_run import MissingData
from hybrid_run.geometry import joint_edges
from hybrid_tools import style

NAMES = {"fos": ("strength reduction factor", "Factor of safety %.3f"),
         "yield": ("horizontal coefficient k", "Yield coefficient $k_y$ = %.4f")}
MOST_ARROWS = 400
SMALL_PART, STAYS = 0.05, 0.5  # of the mass, and of the largest motion: what moves less and is no more stays behind, as a thin tip does


def moved(trial):
    """(vertices as drawn, displacements at the end of the static stage) of all blocks, vertices of block i."""
    run = trial.run()
    first, last = run.get("section/blocks_points"), run.get("section/blocks_points_final")
    return first, last - first, run.get("section/blocks_offsets").astype(int)


def mechanism(bracket):
    """What moves between the trial that still stands and the one that fails: displacements over the largest."""
    points, failing, offsets = moved(bracket.fails)
    _, standing, _ = moved(bracket.stands)
    motion = failing - standing
    largest = np.linalg.norm(motion, axis=1).max()
    return points, motion / largest if largest > 0 else motion, offsets


def corners_in_one_piece(run, points, offsets):
    """A number for each corner of a block of the mass: the same for corners in one place whose blocks share edges there, of one material and
    not on a joint with a material of its own."""
    n_blocks = run.blocks.mass.stop
    count = np.diff(offsets)[:n_blocks]
    first = np.arange(offsets[n_blocks])
    last = np.roll(first, -1)
    last[np.cumsum(count) - 1] = offsets[:n_blocks]
    material = np.repeat(run.get("section/blocks_material")[:n_blocks], count)
    joints = joint_edges(run)
    _, place = np.unique(np.round(np.vstack([points[:len(first)], joints.reshape(-1, 2)]), 6), axis=0, return_inverse=True)
    place, ends = np.split(np.ravel(place), [len(first)])
    of_joints = {tuple(sorted(pair)) for pair in ends.reshape(-1, 2)}
    beside, links = {}, []
    for a, b in zip(first, last):
        edge = tuple(sorted((place[a], place[b])))
        other = beside.setdefault(edge, (a, b))
        if other != (a, b) and material[a] == material[other[0]] and edge not in of_joints:
            links += [(a, other[1]), (b, other[0])]
    rows, columns = np.array(links, int).reshape(-1, 2).T
    return connected_components(coo_array((np.ones(len(rows)), (rows, columns)), shape=(len(first), len(first))), directed=False)[1]


def parting(bracket):
    """Largest difference of the motions of blocks at a corner where the mass is one piece, over the largest motion [-]: 0 if they move as one.
    Where two materials meet, or on joints of their own, the mass may have a plane to fail along. A small part that stays behind does not count."""
    points, motion, offsets = mechanism(bracket)
    corner = corners_in_one_piece(bracket.fails.run(), points, offsets)
    motion = motion[:len(corner)]
    counts = ~stays_behind(points[:len(corner)], motion, offsets)
    if not counts.any():
        return 0.0
    corner, motion = np.unique(corner[counts], return_inverse=True)[1], motion[counts]
    low, high = np.full((corner.max() + 1, 2), np.inf), np.full((corner.max() + 1, 2), -np.inf)
    np.minimum.at(low, corner, motion)
    np.maximum.at(high, corner, motion)
    return float(np.linalg.norm(high - low, axis=1).max())


def stays_behind(points, motion, offsets):
    """For each corner of the mass: it is of a block that stays while nearly all of the mass moves."""
    n_blocks = int(np.searchsorted(offsets, len(points)))
    count = np.diff(offsets)[:n_blocks]
    parts = [np.split(values, offsets[1:n_blocks]) for values in (points, motion)]
    area = np.array([polygon_area(p) for p in parts[0]])
    stays = np.array([np.linalg.norm(m.mean(axis=0)) < STAYS for m in parts[1]])
    return np.repeat(stays & (area[stays].sum() <= SMALL_PART * area.sum()), count)


def polygon_area(polygon):
    x, y = (polygon - polygon[0]).T
    return 0.5 * abs(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1)))


def plastic_strain(bracket):
    """Plastic shear strain of each block added between the trial that stands and the one that fails [-]; None: blocks do not yield."""
    path = "section/blocks_plastic_strain"
    if not (bracket.fails.run().has(path) and bracket.stands.run().has(path)):
        return None
    return np.maximum(bracket.fails.run().get(path) - bracket.stands.run().get(path), 0.0)


def draw_mechanism(bracket, axes):
    """Colours: plastic shear strain where blocks yield, else displacement. Arrows: displacement."""
    points, motion, offsets = mechanism(bracket)
    run = bracket.fails.run()
    polygons = np.split(points, offsets[1:-1])
    of_block = np.array([m.mean(axis=0) for m in np.split(motion, offsets[1:-1])])
    centres = np.array([p.mean(axis=0) for p in polygons])
    size = np.linalg.norm(of_block, axis=1)
    strain = plastic_strain(bracket)
    shown = PolyCollection(polygons, array=size if strain is None else 100 * strain, cmap=style.DISPLACEMENT_MAP, edgecolors="#5b4a3a",
                           lw=0.15, zorder=2)
    shown.set_clim(0, 1 if strain is None else max(100 * np.percentile(strain, 99), 1e-9))
    axes.add_collection(shown)
    if run.has("section/outline"):
        axes.add_collection(LineCollection(run.get("section/outline").reshape(-1, 2, 2), colors=style.ROCK_EDGE, lw=1.1, zorder=3))
    if run.has("section/surface"):
        axes.add_collection(LineCollection(run.surface, colors=style.SLIP, lw=1.6, zorder=4))
    some = np.unique(np.linspace(0, len(centres) - 1, MOST_ARROWS).astype(int))
    some = some[size[some] > 0.03]
    extent = np.ptp(points, axis=0).max()
    axes.quiver(*centres[some].T, *of_block[some].T, angles="xy", scale_units="xy", scale=1 / (0.06 * extent), width=0.0016,
                color=style.TEXT, zorder=5)
    low, high = points.min(axis=0), points.max(axis=0)
    margin = 0.06 * extent
    axes.set_xlim(low[0] - margin, high[0] + margin)
    axes.set_ylim(low[1] - margin, high[1] + margin)
    axes.set_aspect("equal")
    axes.set_xlabel("x [m]")
    axes.set_ylabel("y [m]")
    bar = axes.figure.colorbar(shown, cax=axes.inset_axes([1.012, 0.0, 0.014, 1.0]))
    bar.set_label("displacement / largest [-]" if strain is None else "plastic shear strain [%]")
    bar.outline.set_linewidth(0.5)
    axes.set_title("Mechanism: from the trial that stands to the one that fails")


def draw_curve(bracket, trials, axes, label):
    trials = sorted(trials, key=lambda trial: trial.value)
    for stands, marker, words in ((True, "o", "stands"), (False, "x", "fails (where the stage ended)")):
        chosen = [t for t in trials if t.stands == stands and t.displacement > 0]
        axes.semilogy([t.value for t in chosen], [1e3 * t.displacement for t in chosen], marker, ms=5, mfc="none",
                      color=style.HORIZONTAL if stands else style.TENSILE, label=words, zorder=3)
    joined = [t for t in trials if t.stands] + [bracket.fails]
    axes.semilogy([t.value for t in joined], [1e3 * t.displacement for t in joined], color="#8a8a8a", lw=0.8, zorder=2)
    axes.axvspan(bracket.stands.value, bracket.fails.value, color=style.VERTICAL, alpha=0.4, lw=0)
    axes.set_xlabel(label + " [-]")
    axes.set_ylabel("largest displacement [mm]")
    axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncol=2)


def title_of(run, directory):
    """The scene's; where it has none, its name by where results go, not that of the trial."""
    title = run.title()
    is_own = title != os.path.basename(os.path.abspath(run.directory))
    return title if is_own else os.path.basename(os.path.abspath(directory)).removesuffix("_fos")


def draw(bracket, trials, directory, name):
    label, words = NAMES[name]
    try:
        wide = np.ptp(bracket.fails.run().get("section/blocks_points"), axis=0)
    except MissingData:
        return
    height = 9 * np.clip(wide[1] / wide[0], 0.25, 1.0) * 0.8
    figure, axes = plt.subplots(2, 1, figsize=(9, height + 3.6), height_ratios=[height, 2.4], constrained_layout=True)
    draw_mechanism(bracket, axes[0])
    draw_curve(bracket, trials, axes[1], label)
    style.title(figure, words % bracket.value + ": " + title_of(bracket.fails.run(), directory))
    style.save(figure, directory, name)
