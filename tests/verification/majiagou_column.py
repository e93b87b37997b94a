# SPDX-License-Identifier: GPL-3.0-or-later
"""Independent check of a Majiagou run: horizontally layered columns in the frequency domain.

A column stands at each borehole and at each monitor on the ground of the sliding mass: soil of the scene's materials
from the ground to the sliding surface (saturated below the water level, the belt left out), rock down to the base of
the model with the bedding planes as elastic joints, a half space of the same rock below. A vertical plane wave with the
run's outcrop motion (run.h5, input/acceleration) comes up. Damping is that of the run's blocks: proportional to the
stiffness, G (1 + i w beta_K) with beta_K = damping ratio / (pi f).

    majiagou_column.py DIR     table of peaks: 2D run, column, ratio
"""

import csv
import os
import sys

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "../../src/tools"), os.path.join(HERE, "cases")]

from hybrid_run import Run  # noqa: E402
from zero_phase import low_pass  # noqa: E402

SECTION = os.path.join(HERE, "../../meshes/majiagou_section.csv")


class Belt:
    """Would a column slip by itself? An infinite slope of the ground above it, inclined as the sliding surface there.

    Stresses on the belt [Pa]: static = W sin(b) cos(b), strength = c + W cos(b)^2 tan(phi), W the effective weight of the
    column over its area; dynamic = largest shear stress of the elastic column. reserve = strength - static: a column with
    dynamic < reserve does not slip; one with reserve < 0 does not stand without its neighbours.
    """

    def __init__(self, scene, x, ground):
        column, slip = scene.column(x, ground), scene.slip_elevation(x)
        half = 10.0  # [m]
        incline = np.arctan((scene.slip_elevation(x + half) - scene.slip_elevation(x - half)) / (2 * half))
        gravity = float(scene.parameters["Gravity/Acceleration"])
        weight = sum(l.soil.weight_density * gravity * (l.top - l.bottom) for l in column.layers[:-1])
        section = "Materials/%s/" % scene.parameters[
            "Blocks/" + ("Saturated belt material" if slip < scene.water else "Belt material")]
        friction = np.radians(float(scene.parameters[section + "Friction angle"]))
        self.static = weight * np.sin(incline) * np.cos(incline)
        self.strength = float(scene.parameters[section + "Cohesion"]) + weight * np.cos(incline) ** 2 * np.tan(friction)
        self.dynamic = np.abs(column.shear_stress(slip, scene.acceleration, scene.time[1])).max()
        self.reserve = self.strength - self.static

    def slips_by_itself(self):
        return 0 <= self.reserve <= self.dynamic

    def __str__(self):
        return "belt of the column: static %.0f kPa, strength %.0f kPa, earthquake %.1f kPa: %s" % (
            1e-3 * self.static,
            1e-3 * self.strength,
            1e-3 * self.dynamic,
            "cannot stand without its neighbours"
            if self.reserve < 0
            else ("slips" if self.slips_by_itself() else "does not slip"),
        )


class Soil:
    """Density and effective density that gravity acts on [kg/m3], shear modulus [Pa] of a material of the scene."""

    def __init__(self, parameters, name, is_below_water=False):
        section = "Materials/" + name + "/"
        self.density = float(parameters[section + "Density"])
        given = parameters[section + "Weight density"]
        self.weight_density = self.density if given == "same" else float(given)
        if is_below_water and parameters["Water/Method"] != "paper":
            self.weight_density -= float(parameters["Water/Density"])
        young, poisson = (float(parameters[section + key]) for key in ("Young modulus", "Poisson ratio"))
        self.shear_modulus = young / (2 * (1 + poisson))

    def impedance(self):
        return np.sqrt(self.density * self.shear_modulus)


class Layer:
    """From elevation top to bottom [m]; beta_K = damping_time [s]."""

    def __init__(self, top, bottom, soil, damping_time):
        self.top, self.bottom, self.soil, self.damping_time = top, bottom, soil, damping_time

    def transfer(self, state, omega, depth):
        """(u, tau) [m, Pa] at depth [m] below the layer's top from those at its top; tau = G du/dz, z downwards."""
        u, tau = state
        modulus = self.soil.shear_modulus * (1 + 1j * omega * self.damping_time)
        k = omega * np.sqrt(self.soil.density / modulus)
        c, s = np.cos(k * depth), np.sin(k * depth)
        return u * c + tau / (modulus * k) * s, tau * c - u * modulus * k * s


def transform(acceleration, dt):
    """(omega [rad/s], padded length, spectrum) of a motion."""
    quiet = 60.0  # the column rings on; what is left after so many seconds may wrap around [s]
    padded = 1 << int(np.ceil(np.log2(len(acceleration) + quiet / dt)))
    omega = 2 * np.pi * np.fft.rfftfreq(padded, dt)
    omega[0] = 1e-3 * omega[1]  # relative displacement and stress have a finite static limit
    return omega, padded, np.fft.rfft(acceleration, padded)


class Column:
    """Layers from the ground down; joints are (elevation [m], shear stiffness [Pa/m])."""

    def __init__(self, layers, joints=()):
        self.layers = layers
        self.pieces = []  # (layer, thickness, shear stiffness of the joint at the bottom or None)
        for layer in layers:
            cuts = sorted((j for j in joints if layer.bottom < j[0] < layer.top), reverse=True)
            tops = [layer.top] + [z for z, _ in cuts]
            bottoms = [z for z, _ in cuts] + [layer.bottom]
            for top, bottom, stiffness in zip(tops, bottoms, [k for _, k in cuts] + [None]):
                self.pieces.append((layer, top, top - bottom, stiffness))

    def states(self, omega):
        """(piece, (u, tau) at its top) from the ground down, last (None, those at the foot); omega > 0 [rad/s]. The motion
        of the ground is 1."""
        state = (np.ones_like(omega, dtype=complex), np.zeros_like(omega, dtype=complex))
        for piece in self.pieces:
            yield piece, state
            layer, _, thickness, stiffness = piece
            u, tau = layer.transfer(state, omega, thickness)
            state = (u + (tau / stiffness if stiffness else 0), tau)
        yield None, state

    def motion(self, elevations, omega):
        """Displacement over the outcrop's at these elevations and, last, at the foot; omega > 0 [rad/s]."""
        found = {}
        for piece, state in self.states(omega):
            if piece is None:
                break
            layer, top, thickness, _ = piece
            for z in elevations:
                if z not in found and top - thickness - 1e-9 <= z <= top + 1e-9:
                    found[z] = layer.transfer(state, omega, top - z)[0]
        outcrop = self.outcrop(state, omega)
        return [found[z] / outcrop for z in elevations] + [state[0] / outcrop]

    def outcrop(self, foot, omega):
        """The outcrop's motion from (u, tau) at the foot: u + tau / (i w Z) = 2 u_up, u_up the wave that comes up."""
        return foot[0] + foot[1] / (1j * omega * self.layers[-1].soil.impedance())

    def shear_stress(self, boundary, acceleration, dt):
        """History [Pa] of tau where one layer ends, at the elevation boundary [m]."""
        omega, padded, spectrum = transform(acceleration, dt)
        for piece, state in self.states(omega):
            if piece is not None and abs(piece[1] - boundary) < 1e-6:
                tau = state[1]
        ratio = tau / self.outcrop(state, omega)
        return np.fft.irfft(ratio * spectrum / -(omega**2), padded)[: len(acceleration)]

    def histories(self, elevations, acceleration, dt):
        """Per elevation (displacement relative to the foot, relative velocity, absolute acceleration)."""
        omega, padded, spectrum = transform(acceleration, dt)
        n = len(acceleration)
        *points, foot = self.motion(elevations, omega)
        result = []
        for point in points:
            relative = (point - foot) * spectrum
            result.append(
                [
                    np.fft.irfft(x, padded)[:n]
                    for x in (relative / -(omega**2), relative / (1j * omega), point * spectrum)
                ]
            )
        return result


class Scene:
    """What the columns need to know of a run."""

    def __init__(self, directory):
        self.run = Run(directory)
        self.parameters = self.run.parameters
        p = self.parameters
        self.soils = {key: Soil(p, p["Blocks/" + key], key == "Saturated material")
                      for key in ("Material", "Saturated material")}
        self.rock = Soil(p, p["Continuum/Materials"])
        level = p["Water/Level"]
        self.water = -np.inf if level == "none" else float(level)
        self.damping_time = float(p["Blocks/Damping ratio"]) / (np.pi * float(p["Blocks/Damping frequency"]))
        self.rock_damping_time = float(p["Continuum/Rayleigh stiffness"])
        self.surface = self.run.get("section/surface")
        self.base = self.run.get("section/outline")[:, [1, 3]].min()
        self.time = np.arange(0, self.run.time[-1], float(p["Time/Time step"]))
        motion = self.run.history("input/acceleration")[:, 0]
        self.acceleration = np.interp(self.time, np.append(0, self.run.time), np.append(0, motion))

    def slip_elevation(self, x):
        order = np.argsort(self.surface[:, 0])
        return np.interp(x, self.surface[order, 0], self.surface[order, 1])

    def joints(self, x):
        names = [name.strip() for name in self.parameters["Bedding planes/Names"].split(",") if name.strip()]
        planes = {name: [] for name in names}
        with open(SECTION, encoding="utf-8") as text:
            for row in csv.reader(line for line in text if not line.startswith("#")):
                if row[0] in planes:
                    planes[row[0]].append((float(row[1]), float(row[2])))
        stiffness = float(self.parameters["Bedding planes/Shear stiffness"])
        return [(np.interp(x, *zip(*line)), stiffness) for line in planes.values()]

    def column(self, x, ground):
        slip = self.slip_elevation(x)
        water = min(max(self.water, slip), ground)
        layers = []
        if water < ground:
            layers.append(Layer(ground, water, self.soils["Material"], self.damping_time))
        if slip < water:
            layers.append(Layer(water, slip, self.soils["Saturated material"], self.damping_time))
        layers.append(Layer(slip, self.base, self.rock, self.rock_damping_time))
        return Column(layers, self.joints(x))


def peak(series):
    """The value of largest magnitude, with its sign."""
    return series[np.argmax(np.abs(series))]


class Comparison:
    """One row of the table: the same place in the run and in the column."""

    def __init__(self, place, quantity, unit, run, column, depth=None):
        self.place, self.quantity, self.unit = place, quantity, unit
        self.run, self.column, self.depth = run, column, depth

    def ratio(self):
        return abs(self.run / self.column)

    def __str__(self):
        return "%-18s %-24s %11.4g %11.4g %-5s %6.2f" % (
            self.place,
            self.quantity,
            self.run,
            self.column,
            self.unit,
            self.ratio(),
        )


def compare_boreholes(scene):
    """Horizontal displacement along the boreholes relative to the base, and of the ground relative to the lowest point
    above the sliding surface."""
    rows = []
    for name in scene.run.names("profiles"):
        depth = scene.run.get("profiles/%s/depth" % name)
        top = scene.run.attribute("profiles/" + name, "position")
        computed = scene.run.history("profiles/%s/displacement" % name)[:, 0::2]
        chosen = np.unique(np.linspace(0, len(depth) - 1, 5).round().astype(int))
        column = scene.column(top[0], top[1]).histories(top[1] - depth[chosen], scene.acceleration, scene.time[1])
        for k, history in zip(chosen, column):
            place = "%s, %.1f m deep" % (name, depth[k])
            peaks = peak(computed[:, k]), peak(history[0])
            rows.append(Comparison(place, "relative displacement", "m", *peaks, depth=depth[k]))
        above_slip = np.argsort(depth)[-2]
        strain = computed[:, np.argmin(depth)] - computed[:, above_slip]
        heads = scene.column(top[0], top[1]).histories(
            [top[1], top[1] - depth[above_slip]], scene.acceleration, scene.time[1]
        )
        peaks = peak(strain), peak(heads[0][0] - heads[1][0])
        rows.append(Comparison(name + ", without slip", "ground to %.1f m deep" % depth[above_slip], "m", *peaks))
    return rows


def compare_monitors(scene):
    """Displacement and velocity relative to the base, filtered acceleration, at monitors on the mass."""
    run, rows = scene.run, []
    base_velocity = run.history("monitors/%s/velocity" % run.base)[:, 0] if run.base else 0.0
    for name in run.names("monitors"):
        x, y = run.attribute("monitors/" + name, "position")
        inside = scene.surface[:, 0].min() < x < scene.surface[:, 0].max()
        if not inside or y < scene.slip_elevation(x) + 1.0:
            continue
        (displacement, velocity, acceleration), *_ = scene.column(x, y).histories(
            [y], scene.acceleration, scene.time[1]
        )
        filtered = low_pass(acceleration, scene.time[1], run.corner)
        run_velocity = run.history("monitors/%s/velocity" % name)[:, 0] - base_velocity
        for quantity, unit, computed, expected in (
            ("relative displacement", "m", run.relative_displacement(name)[:, 0], displacement),
            ("relative velocity", "m/s", run_velocity, velocity),
            ("acceleration", "m/s2", run.filtered("monitors/%s/acceleration" % name)[1][:, 0], filtered),
        ):
            place = "%s, %.1f m thick" % (name, y - scene.slip_elevation(x))
            rows.append(Comparison(place, quantity, unit, peak(computed), peak(expected)))
    return rows


def print_table(rows, other="1D column"):
    print("%-18s %-24s %11s %11s %-5s %6s" % ("horizontal peak", "", "2D run", other, "", "ratio"))
    for row in rows:
        print(row)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: majiagou_column.py DIR")
    read_scene = Scene(sys.argv[1])
    print_table(compare_boreholes(read_scene) + compare_monitors(read_scene))
