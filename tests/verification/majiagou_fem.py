# SPDX-License-Identifier: GPL-3.0-or-later
"""Independent 2D check of a Majiagou run without failures: the sliding mass on its triangles, in the frequency domain.

Quadratic triangles on the blocks of run.h5, plane strain, damping G (1 + i w beta_K) and lambda alike as in the blocks.
The sliding surface moves as the monitors D1 to D5 in the bedrock (linear in between): the run's coupling, blocks, joints and
time integration are what is checked. A linear run is

    build/release/hybrid parameters/majiagou/badong_long_periods.prm -s "Gravity/Acceleration=0" -s "Motion/Peak=0.05" -s Output/Directory=DIR
    majiagou_fem.py DIR            table of peaks: run, finite elements, ratio (two minutes)
    majiagou_fem.py --slip DIR     table of what is left: run, the same finite elements at rest whose sole has slipped as the
                                   run's belt; they agree where only the belt yields, not the body
"""

import sys

import numpy as np
import scipy.sparse as sparse
import scipy.sparse.linalg

from majiagou_column import Comparison, Scene, peak, print_table

HIGHEST_FREQUENCY = 9.0  # [Hz]; the motion ends at 8 Hz
PADDED = 45.0  # [s]
REST = 2.0  # what is left of a run is the mean over its last seconds [s]

# quadrature of degree 4 on the triangle: weight, two coordinates
QUADRATURE = [
    (0.223381589678011, 0.445948490915965, 0.445948490915965),
    (0.223381589678011, 0.108103018168070, 0.445948490915965),
    (0.223381589678011, 0.445948490915965, 0.108103018168070),
    (0.109951743655322, 0.091576213509771, 0.091576213509771),
    (0.109951743655322, 0.816847572980459, 0.091576213509771),
    (0.109951743655322, 0.091576213509771, 0.816847572980459),
]


def shape(r, s):
    """Shape functions of the quadratic triangle and their derivatives (2 x 6)."""
    t = 1 - r - s
    values = np.array([t * (2 * t - 1), r * (2 * r - 1), s * (2 * s - 1), 4 * t * r, 4 * r * s, 4 * s * t])
    by_r = [1 - 4 * t, 4 * r - 1, 0, 4 * (t - r), 4 * s, -4 * s]
    by_s = [1 - 4 * t, 0, 4 * s - 1, -4 * r, 4 * r, 4 * (t - s)]
    return values, np.array([by_r, by_s])


def element_matrices(x, density, elasticity):
    """Stiffness and mass (12 x 12) of the triangle with nodes x."""
    stiffness, mass = np.zeros((12, 12)), np.zeros((12, 12))
    for weight, r, s in QUADRATURE:
        values, local = shape(r, s)
        jacobian = local @ x
        area = 0.5 * weight * np.linalg.det(jacobian)
        gradient = np.linalg.solve(jacobian, local)
        strain = np.zeros((3, 12))
        strain[0, 0::2] = strain[2, 1::2] = gradient[0]
        strain[1, 1::2] = strain[2, 0::2] = gradient[1]
        stiffness += area * strain.T @ elasticity @ strain
        mass += area * density * np.kron(np.outer(values, values), np.eye(2))
    return stiffness, mass


def soil(scene, key):
    """Density [kg/m3] and plane-strain elasticity [Pa] of a role in the scene."""
    section = "Materials/" + scene.parameters["Blocks/" + key] + "/"
    density, young, nu = (
        float(scene.parameters[section + name]) for name in ("Density", "Young modulus", "Poisson ratio")
    )
    factor = young / ((1 + nu) * (1 - 2 * nu))
    return density, factor * np.array([[1 - nu, nu, 0], [nu, 1 - nu, 0], [0, 0, 0.5 - nu]])


class Mass:
    """Nodes, stiffness and mass matrix of the sliding mass."""

    def __init__(self, scene):
        points = scene.run.get("section/blocks_points")
        offsets = scene.run.get("section/blocks_offsets").astype(int)
        self.number, nodes = {}, []
        triangles = np.array([self.six_nodes(t, nodes) for t in np.split(points, offsets[1:-1])])
        self.nodes = np.array(nodes)
        self.assemble(scene, triangles)
        below = np.array([scene.slip_elevation(x) for x in self.nodes[:, 0]])
        self.on_surface = np.repeat(np.abs(self.nodes[:, 1] - below) < 1e-3, 2)

    def six_nodes(self, corners, nodes):
        (x0, y0), (x1, y1), (x2, y2) = corners
        if (x1 - x0) * (y2 - y0) < (x2 - x0) * (y1 - y0):
            corners = corners[::-1]
        middles = 0.5 * (corners + np.roll(corners, -1, axis=0))
        found = []
        for point in np.vstack([corners, middles]):
            key = tuple(np.round(point, 5))
            if key not in self.number:
                self.number[key] = len(nodes)
                nodes.append(point)
            found.append(self.number[key])
        return found

    def assemble(self, scene, triangles):
        soils = soil(scene, "Material"), soil(scene, "Saturated material")
        rows, columns, stiffness, mass = [], [], [], []
        for triangle in triangles:
            x = self.nodes[triangle]
            k, m = element_matrices(x, *soils[int(x[:3, 1].mean() < scene.water)])
            unknowns = np.ravel(np.column_stack([2 * triangle, 2 * triangle + 1]))
            rows.append(np.repeat(unknowns, 12))
            columns.append(np.tile(unknowns, 12))
            stiffness.append(k.ravel())
            mass.append(m.ravel())
        where = np.concatenate(rows), np.concatenate(columns)
        size = (2 * len(self.nodes),) * 2
        self.stiffness = sparse.csc_matrix((np.concatenate(stiffness), where), size)
        self.mass = sparse.csc_matrix((np.concatenate(mass), where), size)


def spectra(scene, name):
    """Fourier transform of a monitor's acceleration, 2 x frequencies."""
    run, step = scene.run, scene.time[1]
    series = run.history("monitors/%s/acceleration" % name)
    return np.array([np.fft.rfft(np.interp(scene.time, run.time, series[:, c]), int(PADDED / step)) for c in (0, 1)])


def respond(scene, mass, places):
    """Horizontal displacement relative to the base monitor and acceleration at the nodes nearest to the places."""
    deep = [name for name in scene.run.names("monitors") if name.startswith("D")]
    deep_x = [scene.run.attribute("monitors/" + name, "position")[0] for name in deep]
    deep_motion = np.array([spectra(scene, name) for name in deep])
    base = spectra(scene, scene.run.base)[0]
    n, step = int(PADDED / scene.time[1]), scene.time[1]
    omega = 2 * np.pi * np.fft.rfftfreq(n, step)
    held, free = np.flatnonzero(mass.on_surface), np.flatnonzero(~mass.on_surface)
    nearest = [2 * np.argmin(np.hypot(*(mass.nodes - place).T)) for place in places]
    relative, absolute = (np.zeros((len(places), len(omega)), complex) for _ in range(2))
    for k in range(1, np.searchsorted(omega, 2 * np.pi * HIGHEST_FREQUENCY)):
        dynamic = ((1 + 1j * omega[k] * scene.damping_time) * mass.stiffness - omega[k] ** 2 * mass.mass)[free]
        motion = np.zeros(len(mass.on_surface), complex)
        for c in (0, 1):
            chosen = held[held % 2 == c]
            motion[chosen] = np.interp(mass.nodes[chosen // 2, 0], deep_x, deep_motion[:, c, k])
        motion[free] = scipy.sparse.linalg.splu(dynamic[:, free].tocsc()).solve(-dynamic[:, held] @ motion[held])
        absolute[:, k] = motion[nearest]
        relative[:, k] = (motion[nearest] - base[k]) / -(omega[k] ** 2)
    displacement, acceleration = (np.fft.irfft(x, n)[:, : len(scene.time)] for x in (relative, absolute))
    return displacement - displacement[:, :1], acceleration


def compare(scene):
    run, mass = scene.run, Mass(scene)
    monitors = [name for name in run.names("monitors") if name.startswith("S")]
    boreholes = run.names("profiles")
    places = [run.attribute("monitors/" + name, "position") for name in monitors]
    places += [run.attribute("profiles/" + name, "position")[:2] for name in boreholes]
    displacement, acceleration = respond(scene, mass, places)
    rows = []
    for name, u, a in zip(monitors, displacement, acceleration):
        rows.append(Comparison(name, "relative displacement", "m", peak(run.relative_displacement(name)[:, 0]), peak(u)))
        computed = run.filtered("monitors/%s/acceleration" % name)[1][:, 0]
        rows.append(Comparison(name, "acceleration", "m/s2", peak(computed), peak(a)))
    for name, u in zip(boreholes, displacement[len(monitors) :]):
        computed = run.history("profiles/%s/displacement" % name)[:, 0]
        rows.append(Comparison(name, "relative displacement", "m", peak(computed), peak(u)))
    return rows


def carried_by_slip(scene, mass):
    """Displacement [m] of the mass, elastic and at rest, whose sole has slipped as the run's belt has at the end."""
    run, position = scene.run, scene.run.get("slip/position")[:, 0]
    order, held, free = np.argsort(position), np.flatnonzero(mass.on_surface), np.flatnonzero(~mass.on_surface)
    x, half = mass.nodes[held // 2, 0], 0.5  # [m]
    slip = run.downhill * np.interp(x, position[order], run.get("slip/profile")[-1][order])
    rise = np.array([scene.slip_elevation(at + half) - scene.slip_elevation(at - half) for at in x]) / (2 * half)
    displacement = np.zeros(len(mass.on_surface))
    displacement[held] = slip * np.where(held % 2 == 0, 1.0, rise) / np.hypot(1.0, rise)
    stiffness = mass.stiffness[free]
    solver = scipy.sparse.linalg.splu(stiffness[:, free].tocsc())
    displacement[free] = solver.solve(-stiffness[:, held] @ displacement[held])
    return displacement


def compare_left(scene):
    """What is left, horizontally: monitors on the ground, and along the boreholes (depth in the rows)."""
    run, mass, rows = scene.run, Mass(scene), []
    displacement, last = carried_by_slip(scene, mass), run.time >= run.time[-1] - REST

    def add(place, at, series, depth=None):
        nearest = 2 * np.argmin(np.hypot(*(mass.nodes - at).T))
        rows.append(Comparison(place, "left", "m", series[last].mean(), displacement[nearest], depth))

    reach = run.get("slip/position")[np.abs(run.get("slip/profile")[-1]) > 1e-4, 0]  # where the belt has slipped [m]
    for name in (name for name in run.names("monitors") if name.startswith("S")):
        position = run.attribute("monitors/" + name, "position")
        if (reach <= position[0]).any() and (reach >= position[0]).any():
            add(name, position, run.relative_displacement(name)[:, 0])
    for name in run.names("profiles"):
        depth, top = run.get("profiles/%s/depth" % name), run.attribute("profiles/" + name, "position")[:2]
        series = run.history("profiles/%s/displacement" % name)[:, 0::2]
        for k in np.argsort(depth)[:-1:3]:
            add("%s, %.1f m deep" % (name, depth[k]), top - np.array([0, depth[k]]), series[:, k], depth[k])
    return rows


if __name__ == "__main__":
    if len(sys.argv) == 3 and sys.argv[1] == "--slip":
        print_table(compare_left(Scene(sys.argv[2])), "2D elements")
    elif len(sys.argv) == 2 and not sys.argv[1].startswith("-"):
        print_table(compare(Scene(sys.argv[1])), "2D elements")
    else:
        sys.exit("usage: majiagou_fem.py DIR | --slip DIR")
