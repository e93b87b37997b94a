# SPDX-License-Identifier: GPL-3.0-or-later
"""Direct tension of a bonded joint: the mean tensile stress rises with the inertia of the sample to F_t, then falls to zero."""

import numpy as np
from scene_numbers import Numbers

STRENGTHS = (20e3, 100e3)  # of the variants [Pa]


class Sample:
    def __init__(self, run):
        numbers = Numbers(run)
        self.length = numbers.mesh("Width")
        self.joints = int(np.ceil(self.length / numbers.mesh("Resolution/h") - 1e-9))  # on the base
        self.mass = numbers.material("sample").density * numbers.mesh("Height")  # per area [kg/m2]
        self.strength = numbers.material("joint").tensile_strength


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


def draw(case, figure):
    axes = figure.subplots()
    for strength, (time, stress, down) in case.curves.items():
        line = axes.plot(time, stress / 1e3, label="hybrid, F_t = %g kPa" % (strength / 1e3))[0]
        before = case.mass * down < strength
        axes.plot(time[before], case.mass * down[before] / 1e3, color="0.7", linewidth=4, zorder=0)
        axes.axhline(strength / 1e3, color=line.get_color(), linestyle=":")
    axes.plot([], [], color="0.7", linewidth=4, label="inertia of the sample / area")
    axes.set(xlabel="time [s]", ylabel="mean tensile stress [kPa]")
    axes.legend()
