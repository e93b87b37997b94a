# SPDX-License-Identifier: GPL-3.0-or-later
"""Oblique P and SV packets through elastic joints: displacement at points, as the sum over the packet's plane waves.

A plane wave exp(i (k_x x + k_y y - w t)) is taken over joints and rock by the vector (u_x, u_y, sigma_xy, sigma_yy).
"""

import numpy as np
from scene_numbers import Numbers

JOINTS = {1: "bedding_2", 2: "bedding_1, bedding_2"}
CASES = (("SV", 20, 1), ("SV", 20, 2), ("P", 30, 2))  # wave, angle from the vertical [deg], joints
CHANGED = {"SV": (), "P": ("Initial wave/Frequency=14", "Time/End time=0.66", "Time/Time step=0.002")}  # of the scene
COMPONENTS = ("horizontal", "vertical")

shown = {}


class Rock:
    def __init__(self, material):
        self.density, self.mu, self.modulus = material.density, material.shear_modulus, material.oedometer
        self.c_p, self.c_s = material.speed("P"), material.speed("S")

    def upward(self, wave, k_x, omega):
        """k_y of the wave that goes up, or decays upwards."""
        return np.sqrt((omega / (self.c_p if wave == "P" else self.c_s)) ** 2 - k_x**2 + 0j)

    def vector(self, wave, k_x, k_y):
        """(u_x, u_y, sigma_xy, sigma_yy), n x 4, of a unit wave; SV: displacement to the left of the way."""
        k = np.sqrt(k_x**2 + k_y**2)
        u_x, u_y = (k_x / k, k_y / k) if wave == "P" else (-k_y / k, k_x / k)
        shear = 1j * self.mu * (k_y * u_x + k_x * u_y)
        normal = 1j * (self.modulus * k_y * u_y + (self.modulus - 2 * self.mu) * k_x * u_x)
        return np.stack([u_x + 0j, u_y + 0j, shear, normal], axis=-1)


class Joints:
    """Joints at equal distances; plane waves come from below. Amplitudes refer to the lowest joint's height, and to the highest's."""

    def __init__(self, rock, stiffness, count, spacing):
        self.rock, self.stiffness, self.count, self.spacing = rock, stiffness, count, spacing

    def scatter(self, wave, k_x, omega):
        """Reflected and transmitted (P, SV) amplitudes for incident ones of 1: two arrays n x 2."""
        rock = self.rock
        up = {w: rock.upward(w, k_x, omega) for w in ("P", "SV")}
        ways = [(w, sign * up[w]) for sign in (1, -1) for w in ("P", "SV")]
        waves = np.stack([rock.vector(w, k_x, k_y) for w, k_y in ways], axis=-1)  # columns: up P, up SV, down P, down SV
        phases = np.exp(1j * self.spacing * np.stack([k_y for _, k_y in ways], axis=-1))
        through = np.einsum("nij,nj,njk->nik", waves, phases, np.linalg.inv(waves))
        jump = np.eye(4)
        jump[0, 2], jump[1, 3] = 1 / self.stiffness["shear"], 1 / self.stiffness["normal"]
        whole = np.broadcast_to(jump, through.shape)
        for _ in range(self.count - 1):
            whole = jump @ through @ whole
        system = np.concatenate([whole @ waves[:, :, 2:], -waves[:, :, :2]], axis=2)
        found = np.linalg.solve(system, -(whole @ waves[:, :, [("P", "SV").index(wave)]]))[..., 0]
        return found[:, :2], found[:, 2:]


class Packet:
    """Plane waves of the scene's Initial wave (theory: initial wave); those that go backwards (0.2 %) are left out."""

    def __init__(self, numbers, rock, samples=81, reach=4.5):
        wave, self.centre = numbers.text("Initial wave/Type"), np.array(
            [float(x) for x in numbers.text("Initial wave/Centre").split(",")])
        speed = rock.c_p if wave == "P" else rock.c_s
        angle, frequency = np.radians(numbers.number("Initial wave/Direction")), numbers.number("Initial wave/Frequency")
        middle = 2 * np.pi * frequency / speed
        a, step = np.linspace(-reach, reach, samples, retstep=True)
        a, b = (x.ravel() for x in np.meshgrid(a, a))
        length, width = (numbers.number("Initial wave/" + name) * speed / frequency for name in ("Length", "Width"))
        along, across = middle + a / length, b / width
        k = np.hypot(along, across)
        self.wave, self.omega = wave, speed * k
        self.k_x = along * np.cos(angle) - across * np.sin(angle)
        self.k_y = along * np.sin(angle) + across * np.cos(angle)
        self.amplitude = (numbers.number("Initial wave/Amplitude") * k / middle * (1 + along / k) / 2
                          * np.exp(-0.5 * (a * a + b * b)) * step**2 / (2 * np.pi))

    def displacement(self, joints, lowest, place, time):
        """u (2, times) at a place, the lowest joint at the height given."""
        rock, (x, y) = joints.rock, place
        at_joint = self.amplitude * np.exp(1j * (self.k_x * (x - self.centre[0]) + self.k_y * (lowest - self.centre[1])))
        back, through = joints.scatter(self.wave, self.k_x, self.omega)
        highest, total = lowest + (joints.count - 1) * joints.spacing, 0
        for kind, wave in enumerate(("P", "SV")):
            k_y = rock.upward(wave, self.k_x, self.omega)
            if y > highest:
                total = total + (through[:, kind] * np.exp(1j * k_y * (y - highest)))[:, None] * rock.vector(wave, self.k_x, k_y)[:, :2]
            else:
                total = total + (back[:, kind] * np.exp(1j * k_y * (lowest - y)))[:, None] * rock.vector(wave, self.k_x, -k_y)[:, :2]
        if y <= highest:
            total = total + np.exp(1j * self.k_y * (y - lowest))[:, None] * rock.vector(self.wave, self.k_x, self.k_y)[:, :2]
        return ((at_joint[:, None] * total).T @ np.exp(-1j * np.outer(self.omega, time))).real


def check(case):
    for wave, angle, count in CASES:
        run = case.run("%s_%d" % (wave, count), "Initial wave/Type=" + wave, "Initial wave/Direction=%g" % (90 - angle),
                       "Bedding planes/Names=" + JOINTS[count], *CHANGED[wave])
        numbers = Numbers(run)
        rock = Rock(numbers.material("rock"))
        stiffness = {kind: numbers.number("Bedding planes/%s stiffness" % kind.capitalize()) for kind in ("normal", "shear")}
        joints = Joints(rock, stiffness, count, numbers.mesh("Middle height"))
        packet = Packet(numbers, rock)
        for name in run.names("monitors"):
            found = run.history("monitors/%s/displacement" % name).T
            expected = packet.displacement(joints, numbers.mesh("Base height"), numbers.point(name), run.time)
            what = "%s %g deg, %d joints, %s: " % (wave, angle, count, name)
            case.below(what + "relative L2 norm of the difference", np.linalg.norm(found - expected) / np.linalg.norm(expected), 0.02)
            shown[wave, count, name] = run.time, found, expected
        case.below("%s, %d joints: energy residual" % (wave, count), run.summary["energy_residual"], 1e-3)


def draw(case, figure):
    panels = figure.subplots(len(CASES), 2, sharex="row", sharey="row")
    for row, (wave, angle, count) in zip(panels, CASES):
        for axes, name in zip(row, ("above", "below")):
            time, found, expected = shown[wave, count, name]
            for component, colour in enumerate(("#1f5a94", "#c8202f")):
                axes.plot(time, 1e3 * found[component], color=colour, lw=1.4, label=COMPONENTS[component] + ", program")
                axes.plot(time, 1e3 * expected[component], "k--", lw=0.8, label="formula" if component else None)
            axes.set_title("%s, %g deg, %d joint%s: %s" % (wave, angle, count, "" if count == 1 else "s", name), fontsize=9)
        row[0].set_ylabel("displacement [mm]", fontsize=8)
    panels[0, 0].set_ylim(-0.75, 1.1)
    panels[0, 0].legend(fontsize=7, loc="upper center", ncol=3)
    for axes in panels[-1]:
        axes.set_xlabel("time [s]")
