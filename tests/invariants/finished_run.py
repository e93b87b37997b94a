# SPDX-License-Identifier: GPL-3.0-or-later
"""What the invariants ask of a finished run of a scene: where things are, what they weigh, which forces act."""

import pathlib

import numpy as np
import overlap
from hybrid_run import Run
from scenes import GRAVITY, MASS, WATER
from scipy.spatial import cKDTree
from vtu_file import Picture, picture_files


class FinishedRun:
    def __init__(self, scene, directory):
        self.scene, self.directory = scene, pathlib.Path(directory)
        self.options = scene.options
        self.data = Run(str(directory))
        self.time = self.data.time
        self.block_frames = picture_files(directory, "blocks")
        self.n_mass = len(scene.section.blocks) + len(scene.section.free_blocks)
        offsets = self.data.get("section/blocks_offsets").astype(int)
        points = self.data.get("section/blocks_points")
        self.drawn = [points[a:b] for a, b in zip(offsets[:-1], offsets[1:])]
        self.areas = np.array([abs(overlap.area(p)) for p in self.drawn[: self.n_mass]])
        self.has_continuum = (self.directory / "continuum.pvd").exists()
        self.surface = self._surface_nodes()
        if self.has_continuum:
            self.rock_frames = picture_files(directory, "continuum")
            first = Picture(self.rock_frames[0][1])
            self.rock_at_rest = first.points[:, :2]
            self.rock_first = first.point_fields["displacement [m]"][:, :2]

    # ---- places

    def frames(self, most):
        """Time and number of about `most` pictures, the first and the last among them."""
        n = len(self.block_frames)
        return [(self.block_frames[k][0], k) for k in sorted(set(np.linspace(0, n - 1, min(n, most)).astype(int)))]

    def blocks_at(self, frame):
        picture = Picture(self.block_frames[frame][1])
        return [picture.points[cell, :2] for cell in picture.cells], picture

    def _surface_nodes(self):
        """Of the bedrock where it is drawn, from left to right [m]."""
        if self.has_continuum or self.options["bedrock"] == "rigid":
            nodes = self.data.get("interface/position")
        else:
            section = self.scene.section
            used = {n for name in ("ground", "sliding_surface") for edge in section.lines[name] for n in edge}
            nodes = section.points()[sorted(used)]
        return nodes[np.argsort(nodes[:, 0])]

    def surface_moved(self, time, blocks=None):
        """Displacement of each surface node at a time of a picture [m]."""
        if self.has_continuum:
            file = min(self.rock_frames, key=lambda e: abs(e[0] - time))[1]
            moved = Picture(file).point_fields["displacement [m]"][:, :2] - self.rock_first
            return moved[cKDTree(self.rock_at_rest).query(self.surface)[1]]
        if self.options["bedrock"] == "rigid":
            return np.tile(self.ground_displacement(time), (len(self.surface), 1))
        drawn = np.vstack(self.drawn[self.n_mass :]) if len(self.drawn) > self.n_mass else np.zeros((0, 2))
        if len(drawn) == 0:
            return np.zeros_like(self.surface)
        now = np.vstack(blocks[self.n_mass :])
        gap, nearest = cKDTree(drawn).query(self.surface)
        keep = gap < 1e-6
        moved = np.zeros_like(self.surface)
        moved[keep] = (now - drawn)[nearest[keep]]
        return moved

    def ground_history(self):
        """Displacement of the bare surface beside the mass at the end of each step [m]."""
        return self.data.get("monitors/ground/displacement")

    def ground_displacement(self, time):
        if time <= 0:
            return np.zeros(2)
        return np.array([np.interp(time, self.time, u) for u in self.ground_history().T])

    def under_mass(self):
        """Which surface nodes lie below the mass, as drawn."""
        corners = np.vstack(self.drawn[: self.n_mass])
        x = self.surface[:, 0]
        return (x > corners[:, 0].min() - 1e-6) & (x < corners[:, 0].max() + 1e-6)

    def along(self):
        angle = np.radians(self.options["angle"])
        return np.array([self.scene.mirror * np.cos(angle), np.sin(angle)])

    def mean_displacement(self, blocks):
        """Of the mass since it was drawn [m]."""
        moved = [(now - then).mean(axis=0) for now, then in zip(blocks[: self.n_mass], self.drawn)]
        return np.average(moved, axis=0, weights=self.areas)

    def slip(self, frame=-1):
        """Of the mass against the surface below it since the first picture, uphill [m]."""
        frame = frame % len(self.block_frames)
        time = self.block_frames[frame][0]
        blocks, first = self.blocks_at(frame)[0], self.blocks_at(0)[0]
        below = self.under_mass()
        base = self.surface_moved(time, blocks)[below].mean(axis=0) - self.surface_moved(0.0, first)[below].mean(axis=0)
        return float((self.mean_displacement(blocks) - self.mean_displacement(first) - base) @ self.along())

    # ---- weights and forces

    def mass(self):
        return MASS["density"] * self.scene.factor * self.areas.sum()  # [kg/m]

    def weight(self):
        """Effective, upwards [N/m]."""
        density = MASS["density"] - (WATER if self.options["water"] != "none" else 0.0)
        return np.array([0.0, -density * self.scene.factor * self.areas.sum() * GRAVITY])

    def momentum(self, frame):
        """Of the mass [kg m/s per m]: the velocity is linear in a block."""
        blocks, picture = self.blocks_at(frame)
        velocity = picture.point_fields["velocity [m/s]"][:, :2]
        total = np.zeros(2)
        for block, cell, first_area in zip(blocks[: self.n_mass], picture.cells, self.areas):
            v = velocity[cell]
            parts = [(overlap.area(block[[0, k, k + 1]]), v[[0, k, k + 1]].mean(axis=0)) for k in range(1, len(cell) - 1)]
            mean = sum(a * m for a, m in parts) / sum(a for a, _ in parts)
            total += MASS["density"] * self.scene.factor * first_area * mean
        return total

    def interface_impulses(self):
        """Impulse of the blocks on the bedrock in the whole run [N s/m], by two rules: contacts act with their force at the
        end of a step, joints with that at both ends."""
        force = self.data.get("interface/total_force")
        before = np.vstack([force[:1], force[:-1]])
        dt = self.data.get("steps/dt")[:, None]
        return (dt * force).sum(axis=0), (dt * 0.5 * (force + before)).sum(axis=0)
