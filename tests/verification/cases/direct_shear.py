# SPDX-License-Identifier: GPL-3.0-or-later
"""Direct shear of a bonded joint: mean shear stress at failure and during slip tau = c + sigma tan phi (Mohr-Coulomb)."""

import numpy as np
from scene_numbers import Numbers

NORMAL = (10e3, 100e3, 200e3)  # of the variants [Pa]


class Sample:
    def __init__(self, run):
        numbers = Numbers(run)
        self.length, self.height = numbers.mesh("Width"), numbers.mesh("Height")
        self.density = numbers.material("sample").density
        self.joint, self.gravity = numbers.material("joint"), numbers.gravity()
        self.flexibility = self.height / (2 * numbers.material("sample").shear_modulus)  # of its middle [m/Pa]
        self.normal = numbers.material("sample").weight_density * self.gravity * self.height  # [Pa]

    def strength(self, sigma):
        return self.joint.cohesion + sigma * np.tan(self.joint.friction)


def stresses(run):
    """Slip [m] of the sample, mean shear and normal stress [Pa] on the base at the times of the pictures."""
    length = Sample(run).length
    force, time = run.get("interface/force"), run.get("interface/time").ravel()
    slip = -np.interp(time, run.time, run.relative_displacement("sample")[:, 0])
    return slip, -force[:, 0::2].sum(axis=1) / length, -force[:, 1::2].sum(axis=1) / length


def check(case):
    first = case.run()
    sample = case.sample = Sample(first)
    runs = {sample.normal: first}
    for sigma in NORMAL:
        runs[sigma] = case.run(
            "sigma_%g_kPa" % (sigma / 1e3),
            "Materials/sample/Weight density=%.10g" % (sigma / (sample.gravity * sample.height)),
            "Motion/Peak=%.10g" % (1.125 * sample.strength(sigma) / (sample.density * sample.height)))
    case.curves = {}
    for sigma, run in sorted(runs.items()):
        slip, tau, normal = case.curves[sigma] = stresses(run)
        case.near("normal stress", normal[0], sigma, 0.001, "Pa")
        case.near("peak shear stress at %g kPa" % (sigma / 1e3), tau.max(), sample.strength(sigma), 0.01, "Pa")
        elastic = sample.flexibility * sample.strength(sigma)
        case.true("it slips: %.3g m" % slip[-1], slip[-1] > 3 * elastic)
        case.near("shear stress while it slips", tau[slip > 3 * elastic].mean(), sample.strength(sigma), 0.01, "Pa")


def draw(case, figure):
    path, envelope = figure.subplots(1, 2)
    for sigma, (slip, tau, _) in case.curves.items():
        path.plot(1e3 * slip, tau / 1e3, label="normal stress %g kPa" % (sigma / 1e3))
    path.set(xlabel="slip [mm]", ylabel="mean shear stress [kPa]")
    path.legend()
    line = np.array([0.0, 210e3])
    envelope.plot(line / 1e3, case.sample.strength(line) / 1e3, color="0.6", linewidth=4, label="c + sigma tan phi")
    envelope.plot([s / 1e3 for s in case.curves], [tau.max() / 1e3 for _, tau, _ in case.curves.values()], "o", label="hybrid, peak")
    envelope.set(xlabel="normal stress [kPa]", ylabel="shear stress [kPa]")
    envelope.legend()
