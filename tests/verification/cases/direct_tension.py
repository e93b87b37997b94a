# SPDX-License-Identifier: GPL-3.0-or-later
"""Direct tension of a bonded joint: the mean tensile stress rises with the inertia of the sample to F_t, then falls to zero."""

import numpy as np
from scene_numbers import Numbers

STRENGTHS = (20e3, 100e3)  # of the variants [Pa]
DAMPING = (0.05, 0.2)  # of variants, of critical at the damping frequency


class Sample:
    def __init__(self, run):
        numbers = Numbers(run)
        self.length = numbers.mesh("Width")
        self.joints = int(np.ceil(self.length / numbers.mesh("Resolution/h") - 1e-9))  # on the base
        self.mass = numbers.material("sample").density * numbers.mesh("Height")  # per area [kg/m2]
        self.strength = numbers.material("joint").tensile_strength
        self.fracture_energy = self.length * numbers.number("Blocks/Fracture energy")  # of the base [J/m]


def stresses(run):
    """Time [s], mean tensile stress [Pa] on the base, and the base's downward acceleration [m/s2]."""
    force, time = run.get("interface/force"), run.get("interface/time").ravel()
    down = -np.interp(time, run.time, run.history("input/acceleration")[:, 1])
    return time, force[:, 1::2].sum(axis=1) / Sample(run).length, down


def check(case):
    first = case.run()
    mass = case.mass = Sample(first).mass
    runs = {Sample(first).strength: first}
    for strength in STRENGTHS:
        runs[strength] = case.run("strength_%g_kPa" % (strength / 1e3), "Materials/joint/Tensile strength=%g" % strength,
                                  "Motion/Peak=%.10g" % (1.1 * strength / mass))
    case.curves = {}
    for strength, run in sorted(runs.items()):
        time, stress, down = case.curves[strength] = stresses(run)
        case.near("peak tensile stress", stress.max(), strength, 0.01, "Pa")
        case.below("tensile stress in the end over F_t", stress[-1] / strength, 1e-6)
        case.true("all joints of the base have failed in tension", run.summary["joints"]["tensile"] == Sample(run).joints)
        case.true("none has failed in shear", run.summary["joints"]["shear"] == 0)
        rising = time < 0.9 * time[np.argmax(stress)]
        inertia = mass * down[rising]
        case.below("stress less inertia, before failure, over F_t", np.abs(stress[rising] - inertia).max() / strength, 0.01)
    check_damped(case)


def check_damped(case):
    """A damped bond bears F_t and takes G_f, however fast it is pulled: what its dashpot takes comes on top."""
    case.damped = {}
    for ratio in DAMPING:
        run = case.run("damped_%g" % ratio, "Blocks/Damping ratio=%g" % ratio)
        sample, name = Sample(run), "damped by %g: " % ratio
        time, stress, _ = case.damped[ratio] = stresses(run)
        case.near(name + "peak tensile stress", stress.max(), sample.strength, 0.01, "Pa")
        case.below(name + "largest stress above F_t, over F_t", max(0.0, stress.max() / sample.strength - 1), 1e-9)
        case.true(name + "all joints of the base have failed in tension", run.summary["joints"]["tensile"] == sample.joints)
        case.near(name + "energy of fracture", run.file["energy/fracture_loss"][-1], sample.fracture_energy, 1e-6, "J/m")
        case.true(name + "the dashpots have taken energy", run.file["energy/blocks_damping_loss"][-1] > 0)
        case.below(name + "residual of the energy audit", run.summary["energy_residual"], 1e-3)


def draw(case, figure):
    axes = figure.subplots()
    for strength, (time, stress, down) in case.curves.items():
        line = axes.plot(time, stress / 1e3, label="hybrid, F_t = %g kPa" % (strength / 1e3))[0]
        before = case.mass * down < strength
        axes.plot(time[before], case.mass * down[before] / 1e3, color="0.7", linewidth=4, zorder=0)
        axes.axhline(strength / 1e3, color=line.get_color(), linestyle=":")
    for (ratio, (time, stress, _)), style in zip(case.damped.items(), ("--", ":")):
        axes.plot(time, stress / 1e3, color="k", linewidth=1, linestyle=style, label="F_t = 50 kPa, damped by %g" % ratio)
    axes.plot([], [], color="0.7", linewidth=4, label="inertia of the sample / area")
    axes.set(xlabel="time [s]", ylabel="mean tensile stress [kPa]")
    axes.legend()
