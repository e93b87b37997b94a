# SPDX-License-Identifier: GPL-3.0-or-later
"""The section of a scene: mesh, materials, groups, monitors, boreholes, water, artificial boundaries."""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from hybrid_run.geometry import chains, joint_edges
from hybrid_tools import style
from hybrid_tools.plot import water

ARTIFICIAL = "#1f7a5c"
GROUND = "#4a4a4a"
MASS = "#9a9a9a"


class Scene:
    """What the program understood: from run.h5 of a run that never began."""

    def __init__(self, run):
        self.run, self.parameters = run, run.parameters
        self.materials = run.text(run.attribute("section", "materials", "")).split(", ")
        self.blocks, self.block_material = [], self.numbers("section/blocks_material")
        if run.has("section/blocks_points"):
            self.blocks = np.split(run.get("section/blocks_points"), run.get("section/blocks_offsets").astype(int)[1:-1])
        self.cell_material = self.numbers("section/cells_material")
        self.cells = run.get("section/cells").reshape(-1, 4, 2) if len(self.cell_material) else np.zeros((0, 4, 2))
        self.lines = {name: run.get("section/lines/" + name).reshape(-1, 2, 2) for name in run.names("section/lines")}
        if run.has("section/surface") and "sliding_surface" not in self.lines:  # polygons on a polyline
            self.lines["sliding_surface"] = np.concatenate([np.stack([line[:-1], line[1:]], axis=1) for line in run.surface])
        self.belt, self.belt_material = self.lines.get("sliding_surface"), self.numbers("section/belt_material")
        if len(self.belt_material):
            self.belt = run.get("section/belt").reshape(-1, 2, 2)
        self.planes = [name.strip() for name in self.parameters.get("Bedding planes/Names", "").split(",") if name.strip()]
        self.water = water.Water(run)
        self.monitors = {name: monitor.position for name, monitor in run.monitors.items()}
        self.boreholes = {n: np.reshape(run.attribute("profiles/" + n, "position"), (2, 2)) for n in run.names("profiles")}
        self.has_bedrock = self.parameters.get("Model/Bedrock", "continuum") != "rigid"

    def numbers(self, path):
        return self.run.get(path).astype(int) if self.run.has(path) else np.zeros(0, int)

    @property
    def extent(self):
        """Lower left and upper right corner of all there is [m]."""
        points = [self.cells.reshape(-1, 2)] + list(self.blocks) + [line.reshape(-1, 2) for line in self.shown_lines().values()]
        points = np.vstack([p for p in points if len(p)])
        return points.min(axis=0), points.max(axis=0)

    def shown_lines(self):
        """A rigid bedrock has the lines that blocks stand on alone."""
        on_rigid = ("sliding_surface", "ground", "mass_surface")
        return {n: e for n, e in self.lines.items() if self.has_bedrock or n in on_rigid or n.startswith("joint_")}


def draw_areas(scene, axes, edge):
    entries = []
    for k, number in enumerate(np.unique(np.concatenate([scene.block_material, scene.cell_material]))):
        colour = style.MATERIALS[k % len(style.MATERIALS)]
        for areas, material, line in ((scene.cells, scene.cell_material, "#b9b9b0"), (scene.blocks, scene.block_material, "#7d6a50")):
            chosen = [area for area, m in zip(areas, material) if m == number]
            axes.add_collection(PolyCollection(chosen, facecolors=colour, edgecolors=line, lw=edge, zorder=1))
        entries.append(Patch(facecolor=colour, edgecolor="#8a8a8a", lw=0.4, label=scene.materials[number]))
    return entries


def draw_lines(scene, axes):
    """Named lines of the mesh, and what each of them is."""
    entries = []

    def add(edges, label, **looks):
        axes.add_collection(LineCollection(chains(edges), zorder=4, **looks))
        entries.append(Line2D([], [], color=looks["colors"], lw=looks["lw"], ls=looks.get("linestyles", "-"), label=label))

    lines, parameters = scene.shown_lines(), scene.parameters
    if "ground" in lines:
        add(lines["ground"], "ground" if scene.has_bedrock else "ground (rigid)", colors=GROUND, lw=1.6)
    if "mass_surface" in lines:
        add(lines["mass_surface"], "surface of the mass", colors=MASS, lw=1.4)
    for name, words in (("elastic joint" if parameters.get("Bedding planes/Strength") == "elastic" else "slips and opens", True), ("welded", False)):
        edges = [e for n, e in lines.items() if n.startswith("bedding_") and (n in scene.planes) == words]
        if edges:
            add(np.vstack(edges), "bedding plane: " + name, colors=style.BEDDING, lw=1.3 if words else 0.8, linestyles="--" if words else ":")
    if len(joints := joint_edges(scene.run)):
        add(joints, "joints with a material of their own", colors=style.JOINTS, lw=1.3)
    if len(scene.belt_material):
        for k, number in enumerate(np.unique(scene.belt_material)):
            add(scene.belt[scene.belt_material == number], "sliding surface, belt: " + scene.materials[number],
                colors=style.BELTS[k % len(style.BELTS)], lw=2.2)
    elif "sliding_surface" in lines:
        add(lines["sliding_surface"], "sliding surface", colors=style.SLIP, lw=2.2)
    if not scene.has_bedrock:
        return entries
    for names, what in ((("base",), "Base"), (("left", "right"), "Sides")):
        edges = [lines[n] for n in names if n in lines]
        if edges:
            add(np.vstack(edges), "%s: %s" % (what.lower(), parameters.get("Continuum/" + what, "")), colors=ARTIFICIAL, lw=2.4,
                linestyles="-" if what == "Base" else (0, (3, 1)))
    return entries


def draw_water(scene, axes):
    """Level and phreatic line at the start. @return entries of the legend."""
    if scene.water.line is not None:
        water.draw_phreatic_line(scene.water.line, axes)
    return water.entries(scene.water, bool(water.draw_level(scene.water, axes)))


def is_within(p, corners):
    (left, bottom), (right, top) = corners
    return left <= p[0] <= right and bottom <= p[1] <= top


def draw_points(scene, axes, within, elsewhere):
    """elsewhere: corners of a larger view that has the names of what lies in it, or None."""
    def inside(p):
        return is_within(p, within)

    def is_named(p):
        return elsewhere is None or not is_within(p, elsewhere)

    entries = []
    for name, (head, foot) in scene.boreholes.items():
        if inside(head) or inside(foot):
            axes.plot([head[0], foot[0]], [head[1], foot[1]], color=style.TEXT, lw=1.3, zorder=6)
            if is_named(0.5 * (head + foot)):
                axes.annotate(name, foot, (0, -9), textcoords="offset points", ha="center", fontsize=7, fontweight="bold", path_effects=style.HALO, zorder=8)
    if scene.boreholes:
        entries.append(Line2D([], [], color=style.TEXT, lw=1.3, label="borehole"))
    for name, p in scene.monitors.items():
        if inside(p):
            axes.plot(*p, "o", ms=4, color="white", mec=style.TEXT, mew=0.9, zorder=9, clip_on=False)
            side = scene.run.downhill if name[0] not in "DB" else -scene.run.downhill  # names on the ground stand in the air
            if is_named(p):
                axes.annotate(name, p, (4 * side, 4) if name[0] != "D" else (5 * side, 0), textcoords="offset points", fontsize=7, zorder=8,
                              ha="left" if side > 0 else "right", va="bottom" if name[0] != "D" else "center", path_effects=style.HALO)
    if scene.monitors:
        entries.append(Line2D([], [], ls="", marker="o", ms=4, color="white", mec=style.TEXT, label="monitor"))
    return entries


def draw_view(scene, axes, low, high, edge, elsewhere=None):
    """The part of the section between two corners. @return entries of the legend."""
    size = np.maximum(high - low, 1e-9)
    margin = 0.04 * size.max()
    axes.set_xlim(low[0] - margin, high[0] + margin)
    axes.set_ylim(low[1] - margin, high[1] + margin)
    axes.set_aspect("equal")
    axes.grid(False)
    axes.set_ylabel("elevation [m]")
    entries = draw_areas(scene, axes, edge) + draw_lines(scene, axes) + draw_water(scene, axes)
    return entries + draw_points(scene, axes, (low - margin, high + margin), elsewhere)


def views(scene):
    """[(title, low, high)]: all of it, and the mass if it is a part of it."""
    low, high = scene.extent
    found = [("section", low, high)]
    surface = scene.belt if scene.belt is not None else None
    if scene.blocks and surface is not None and len(surface):
        mass = np.vstack([surface.reshape(-1, 2)] + [b for b in scene.blocks if scene.has_bedrock is False])
        if "mass_surface" in scene.lines:
            mass = np.vstack([mass, scene.lines["mass_surface"].reshape(-1, 2)])
        feet = [end for line in scene.boreholes.values() for end in line if mass[:, 0].min() <= end[0] <= mass[:, 0].max()]
        mass = np.vstack([mass] + [np.reshape(feet, (-1, 2))])
        if np.ptp(mass[:, 0]) < 0.7 * (high - low)[0]:
            found.append(("sliding mass", mass.min(axis=0), mass.max(axis=0)))
    elif len(recorded := recorded_points(scene)) > 1:
        size = np.ptp(recorded, axis=0)
        if 0 < size[0] < 0.5 * (high - low)[0]:
            found.append(("monitors", recorded.min(axis=0) - 0.05 * size.max(), recorded.max(axis=0) + 0.05 * size.max()))
    return found


def recorded_points(scene):
    """Monitors but the base, and ends of boreholes."""
    return np.array([p for name, p in scene.monitors.items() if name != scene.run.base] + [e for line in scene.boreholes.values() for e in line])


def draw(scene, title, path):
    style.apply()
    parts = views(scene)
    heights = [np.clip(8.5 * (high - low)[1] / (high - low)[0], 1.6, 6.0) for _, low, high in parts]
    figure, axes = plt.subplots(len(parts), 1, figsize=(11.5, sum(heights) + 0.6 * len(parts) + 0.5), squeeze=False,
                                gridspec_kw={"height_ratios": heights}, constrained_layout=True)
    for k, (axis, (name, low, high)) in enumerate(zip(axes[:, 0], parts)):
        elsewhere = parts[1][1:] if k == 0 and len(parts) > 1 else None
        entries = draw_view(scene, axis, low, high, 0.25 if k == 0 else 0.4, elsewhere)
        axis.set_title(name)
        if k == 0:
            axis.legend(handles=entries, loc="center left", bbox_to_anchor=(1.0, 0.5), borderaxespad=0.5)
    axes[-1, 0].set_xlabel("x [m]")
    style.title(figure, "Section: " + title)
    figure.savefig(path, facecolor="white", bbox_inches="tight", pad_inches=0.1)
    plt.close(figure)
