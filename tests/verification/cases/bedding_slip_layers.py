# SPDX-License-Identifier: GPL-3.0-or-later
"""Layers that slip on bedding planes: two sliding blocks with springs, one on the other, and the dashpots of their sides."""

import numpy as np
from matrix_exponential import exponential
from scene_numbers import Numbers

PLANES = ("bedding_2", "bedding_1")

shown = {}


class Layers:
    """Two equal layers; arrays: below the middle, below the top layer."""

    def __init__(self, run):
        n = Numbers(run)
        rock, height, self.width = n.material("rock"), n.mesh("Top height"), n.mesh("Width")
        self.weight = rock.density * n.gravity() * height  # of a layer [Pa]
        self.normal = self.weight * np.array([2.0, 1.0]) + n.number("Bedding planes/Initial normal stress")  # [Pa]
        self.strength = n.number("Bedding planes/Cohesion") + self.normal * np.tan(
            np.radians(n.number("Bedding planes/Friction angle")))
        self.stiffness = n.number("Bedding planes/Shear stiffness")
        self.mass = rock.density * height * self.width
        self.dashpots = 2 * height * rock.density * rock.speed("P")


def closed_form(layers, time, base, refine=10):
    """Slip of both planes [m] and dissipated energy [J/m] for the base's displacement, linear between its samples.

    Each plane sticks (spring) or slips (force at its strength); while both stay as they are the motion is linear and its
    steps are exact.
    """
    mass, dashpots, spring = layers.mass, layers.dashpots, layers.stiffness * layers.width
    limit = layers.strength * layers.width
    dt = (time[1] - time[0]) / refine
    # state: u_1, u_2, v_1, v_2, then known: u_b, its slope, force on layer 1 and 2
    jumps = np.array([[1.0, 0, 0, 0, -1.0, 0], [-1.0, 1.0, 0, 0, 0, 0]])  # of the planes
    rates = np.array([[0, 0, 1.0, 0, 0, -1.0], [0, 0, -1.0, 1.0, 0, 0]])
    onto = np.array([[-1.0, 0], [1.0, -1.0]])  # force of each plane's traction on the layers: rows planes

    def step_of(sticks):
        a = np.zeros((8, 8))
        a[0, 2] = a[1, 3] = a[4, 5] = 1
        a[2, 2] = a[3, 3] = -dashpots / mass
        a[2, 6] = a[3, 7] = 1 / mass
        for plane in range(2):
            if sticks[plane]:
                a[2:4, :6] += spring / mass * np.outer(onto[plane], jumps[plane])
        return exponential(a * dt)

    steps = {}
    x, slip, sign, loss, result = np.zeros(8), np.zeros(2), [0, 0], 0.0, []
    for u0, u1 in zip(np.concatenate([[0.0], base[:-1]]), base):
        x[4:6] = u0, (u1 - u0) / (refine * dt)
        for _ in range(refine):
            sticks = (sign[0] == 0, sign[1] == 0)
            if sticks not in steps:
                steps[sticks] = step_of(sticks)
            # a plane that sticks pulls with spring (jump - slip), one that slips with its strength
            force = np.where(sticks, -spring * slip, np.array(sign) * limit)
            x[6:] = force @ onto
            x = steps[sticks] @ x
            for plane in range(2):
                jump, rate = jumps[plane] @ x[:6], rates[plane] @ x[:6]
                before = slip[plane]
                if sign[plane] == 0 and spring * abs(jump - slip[plane]) > limit[plane]:
                    sign[plane] = int(np.sign(jump - slip[plane]))
                if sign[plane] != 0:
                    slip[plane] = jump - sign[plane] * limit[plane] / spring
                    if rate * sign[plane] < 0:
                        sign[plane] = 0
                loss += limit[plane] * abs(slip[plane] - before)
        result.append(slip.copy())
    return np.array(result), loss


def check(case):
    run = case.run()
    layers = Layers(run)
    base = run.history("input/displacement")[:, 0]
    expected, loss = closed_form(layers, run.time, base)
    audits = run.file["bedding/time"][:]
    shown.update(time=run.time, audits=audits, curves={})
    extent = np.ptp(expected[:, 0])
    for k, (name, layer) in enumerate(zip(PLANES, ("middle", "top"))):
        normal = run.file["bedding/%s/normal_stress" % name][0]
        case.near("normal stress at rest below the %s layer" % layer, normal.mean(), layers.normal[k], 1e-3, "Pa")
        case.below("its scatter over a layer's weight (found with cells of constant stress, one row a layer)",
                   np.ptp(normal) / layers.weight, 0.1)
        found = run.file["bedding/%s/slip" % name][:].mean(axis=1)
        form = np.interp(audits, run.time, expected[:, k])
        if k == 0:
            case.near("range of the slip below the %s layer" % layer, np.ptp(found), np.ptp(form), 0.02, "m")
        case.below("largest error of the slip below the %s layer over the range below the middle one" % layer,
                   np.abs(found - form).max() / extent, 0.02)
        shown["curves"][layer] = (found, expected[:, k])
    case.near("dissipated energy", run.file["energy/bedding_loss"][-1], loss, 0.02, "J/m")
    case.below("energy residual", run.summary["energy_residual"], 1e-3)
    case.true("slip of planes is no failure of joints", run.summary["joints"]["shear"] == run.summary["joints"]["tensile"] == 0)


def draw(case, figure):
    axes = figure.subplots()
    for name, (found, form) in shown["curves"].items():
        line = axes.plot(shown["time"], 1000 * form, linewidth=4, alpha=0.4, label="below the %s layer, closed form" % name)
        axes.plot(shown["audits"], 1000 * found, color=line[0].get_color(), label="program")
    axes.set_xlabel("time [s]")
    axes.set_ylabel("slip [mm]")
    axes.legend()
