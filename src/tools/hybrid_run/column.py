# SPDX-License-Identifier: GPL-3.0-or-later
"""Layered column under a point: its transfer function for waves that travel vertically (Thomson 1950; Haskell 1953; Kramer 1996, 7.2)."""

from dataclasses import dataclass

import numpy as np

from .errors import MissingData


@dataclass
class Layer:
    """thickness [m]; modulus [Pa]: of shear for S waves, M for P waves; damping C = mass_damping M + stiffness_damping K [1/s, s]."""

    thickness: float
    density: float
    modulus: float
    mass_damping: float = 0.0
    stiffness_damping: float = 0.0
    joint: float = np.inf  # stiffness of the joint at its lower face [Pa/m]; infinite: welded. It is damped like the layer
    ratio: float = 0.0  # damping at all frequencies, 1/(2 Q) [-]
    middle: float = 1.0  # frequency whose waves have the speed of the modulus then [Hz]

    def stiffness_factor(self, w):
        """By which modulus and joint are multiplied at w [rad/s]: stiffness damping, and a constant Q (Kjartansson 1979, eq. 20)."""
        g = np.arctan(2 * self.ratio) / np.pi
        constant_q = np.cos(0.5 * np.pi * g)**2 * (1j * w / (2 * np.pi * self.middle))**(2 * g)
        return constant_q + 1j * w * self.stiffness_damping


def transfer_function(layers, frequency, is_rigid=False, half_space=None):
    """Motion at the top of each layer and, last, at the bottom over the outcrop motion: complex, (len(layers) + 1) x f.

    layers: from the top down. Below them is a half-space (a Layer; None: like the lowest one), undamped,
    which takes what comes back; is_rigid: the bottom moves as the outcrop. In each layer u'' = -k^2 u with k^2 = w^2 rho* / G*, rho* = rho (1 - i alpha / w), G* = G Layer.stiffness_factor(w).
    """
    w = 2 * np.pi * np.asarray(frequency, float)
    u, stress = np.ones(len(w), complex), np.zeros(len(w), complex)  # at the free surface
    motions = []
    for layer in layers:
        motions.append(u)
        factor = layer.stiffness_factor(w)
        modulus = layer.modulus * factor
        density = layer.density * (1 - 1j * layer.mass_damping / w)
        k = w * np.sqrt(density / modulus)
        c, s = np.cos(k * layer.thickness), np.sin(k * layer.thickness)
        u, stress = u * c - stress * s / (k * modulus), stress * c + u * k * modulus * s
        if np.isfinite(layer.joint):
            u = u - stress / (layer.joint * factor)
    motions.append(u)
    rock = half_space or layers[-1]
    impedance = np.sqrt(rock.density * rock.modulus)
    outcrop = u if is_rigid else u - stress / (1j * w * impedance)  # twice the upgoing wave
    return np.array(motions) / outcrop


def column_under(run, x, is_pressure=False):
    """(elevation of the top of each layer and of the bottom [m], layers) on the vertical through x, from the run's section."""
    pieces = _pieces(run, x)
    if not pieces:
        raise MissingData("no bedrock of cells or blocks at x = %g m in run.h5" % x)
    numbers = _Materials(run, is_pressure)
    joints = _joints(run, x, is_pressure)
    levels, layers = [], []
    for top, bottom, material, is_block in pieces:
        cuts = [y for y in joints if bottom + 1e-6 < y < top - 1e-6]
        for upper, lower in zip([top] + cuts, cuts + [bottom]):
            at_joint = min(joints, key=lambda y: abs(y - lower), default=np.inf)
            stiffness = joints.get(at_joint, np.inf) if abs(at_joint - lower) < 1e-6 * max(1.0, abs(lower)) + 1e-6 else np.inf
            levels.append(upper)
            layers.append(numbers.layer(upper - lower, material, is_block, stiffness))
    return np.array(levels + [pieces[-1][1]]), layers


def motion_in_column(run, position, frequency, side="on", is_pressure=False):
    """|Transfer function| [-] at a point of the section from the outcrop motion by its 1D column; side: of a joint at the point."""
    levels, layers = column_under(run, position[0], is_pressure)
    is_rigid = run.parameters.get("Continuum/Base", "compliant") != "compliant"
    name = run.parameters.get("Continuum/Half space material", "")
    half_space = _Materials(run, is_pressure).layer_of(name, 0.0, False, np.inf) if name else None
    tolerance = 1e-6 * max(1.0, np.abs(levels).max())
    y = float(np.clip(position[1], levels[-1], levels[0]))
    row = int(np.searchsorted(-levels, -y + tolerance) - 1)  # the layer whose top is at the point or above it
    row = min(max(row, 0), len(layers) - 1)
    depth = levels[row] - y
    if side == "above" and depth <= tolerance and row > 0:
        row, depth = row - 1, levels[row - 1] - y
    if depth <= tolerance:
        return np.abs(transfer_function(layers, frequency, is_rigid, half_space)[row])
    upper = Layer(**{**vars(layers[row]), "thickness": depth, "joint": np.inf})
    lower = Layer(**{**vars(layers[row]), "thickness": max(layers[row].thickness - depth, 0.0)})
    return np.abs(transfer_function(layers[:row] + [upper, lower] + layers[row + 1:], frequency, is_rigid, half_space)[row + 1])


MAXWELL = "Maxwell damping/%s ratio"


class _Materials:
    def __init__(self, run, is_pressure):
        self.values, self.is_pressure = run.parameters, is_pressure
        self.names = run.text(run.attribute("section", "materials", "")).split(", ")

    def number(self, path, default=0.0):
        try:
            return float(self.values.get(path, default))
        except ValueError:
            return default

    def layer(self, thickness, material, is_block, joint):
        return self.layer_of(self.names[material], thickness, is_block, joint)

    def layer_of(self, material, thickness, is_block, joint):
        name = "Materials/%s/" % material
        young, nu = self.number(name + "Young modulus"), self.number(name + "Poisson ratio")
        shear = young / (2 * (1 + nu))
        modulus = shear * (2 - 2 * nu) / (1 - 2 * nu) if self.is_pressure else shear
        if is_block:
            ratio, at = self.number("Blocks/Damping ratio"), self.number("Blocks/Damping frequency", 1.0)
            damping = (0.0, ratio / (np.pi * at) if at > 0 else 0.0)
        else:
            damping = (self.number("Continuum/Rayleigh mass"), self.number("Continuum/Rayleigh stiffness"))
        return Layer(thickness, self.number(name + "Density"), modulus, *damping, joint, self.number(MAXWELL % ("Block" if is_block else "Bedrock")),
                     np.sqrt(self.number("Maxwell damping/Lowest frequency", 0.5) * self.number("Maxwell damping/Highest frequency", 10.0)))


def _pieces(run, x):
    """(top, bottom, material, of a block) on the vertical, from the top down; pieces of one material are one."""
    found = []
    if run.has("section/cells"):
        cells = run.get("section/cells").reshape(-1, 4, 2)
        materials = run.get("section/cells_material").astype(int)
        found += [(*_cut(cell, x), m, False) for cell, m in zip(cells, materials) if cell[:, 0].min() <= x <= cell[:, 0].max()]
    if run.has("section/blocks_points") and run.has("section/blocks_material"):
        materials = run.get("section/blocks_material").astype(int)
        found += [(*_cut(p, x), m, True) for p, m in zip(run.blocks.polygons, materials) if p[:, 0].min() <= x <= p[:, 0].max()]
    size = max([abs(p[0]) for p in found], default=1.0)
    found = sorted((p for p in found if p[0] - p[1] > 1e-9 * max(size, 1.0)), reverse=True)
    merged = []
    for top, bottom, material, is_block in found:
        if merged and top > merged[-1][1] + 1e-6 * max(size, 1.0):  # on an edge that two cells share
            continue
        if merged and merged[-1][2:] == (material, is_block):
            merged[-1] = (merged[-1][0], bottom, material, is_block)
        else:
            merged.append((top, bottom, material, is_block))
    return merged


def _cut(polygon, x):
    """(highest, lowest) point of the polygon on the vertical."""
    y = []
    for a, b in zip(polygon, np.roll(polygon, -1, axis=0)):
        if min(a[0], b[0]) <= x <= max(a[0], b[0]):
            y += [a[1], b[1]] if a[0] == b[0] else [a[1] + (x - a[0]) / (b[0] - a[0]) * (b[1] - a[1])]
    return max(y), min(y)


def _joints(run, x, is_pressure):
    """{elevation: stiffness [Pa/m]} of the bedding planes on the vertical, taken as level ones; from the top down."""
    stiffness = float(run.parameters.get("Bedding planes/%s stiffness" % ("Normal" if is_pressure else "Shear"), "inf"))
    names = [n.strip() for n in run.parameters.get("Bedding planes/Names", "").split(",")]
    levels = set()
    for name in run.names("section/bedding"):
        if name in names:
            for x0, y0, x1, y1 in run.get("section/bedding/" + name):
                if min(x0, x1) <= x <= max(x0, x1) and x0 != x1:
                    levels.add(round(y0 + (x - x0) / (x1 - x0) * (y1 - y0), 9))
    return {y: stiffness for y in sorted(levels, reverse=True)}
