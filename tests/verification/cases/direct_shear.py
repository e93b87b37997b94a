# SPDX-License-Identifier: GPL-3.0-or-later
"""Direct shear of a bonded joint: mean shear stress at failure and during slip tau = c + sigma tan phi (Mohr-Coulomb)."""

import numpy as np

GRAVITY, DENSITY, LENGTH, HEIGHT, COHESION, PHI = 9.81, 2500.0, 20.0, 2.0, 20e3, np.radians(30.0)  # SI
NORMAL = (10e3, 50e3, 100e3, 200e3)  # Pa


def strength(sigma):
    return COHESION + sigma * np.tan(PHI)


def stresses(run):
    """Slip [m] of the sample, mean shear and normal stress [Pa] on the base at the times of the pictures."""
    force, time = run.get("interface/force"), run.get("interface/time").ravel()
    slip = -np.interp(time, run.time, run.relative_displacement("sample")[:, 0])
    return slip, -force[:, 0::2].sum(axis=1) / LENGTH, -force[:, 1::2].sum(axis=1) / LENGTH


def check(case):
    case.curves = {}
    for sigma in NORMAL:
        peak = 1.125 * strength(sigma) / (DENSITY * HEIGHT)
        run = case.run() if sigma == 50e3 else case.run(
            "sigma_%g_kPa" % (sigma / 1e3), "Materials/sample/Weight density=%.10g" % (sigma / (GRAVITY * HEIGHT)),
            "Motion/Peak=%.10g" % peak)
        slip, tau, normal = case.curves[sigma] = stresses(run)
        case.near("normal stress", normal[0], sigma, 0.001, "Pa")
        case.near("peak shear stress at %g kPa" % (sigma / 1e3), tau.max(), strength(sigma), 0.01, "Pa")
        case.true("it slips: %.3g m" % slip[-1], slip[-1] > 1e-3)
        case.near("shear stress while it slips", tau[slip > 1e-3].mean(), strength(sigma), 0.01, "Pa")


def draw(case, figure):
    path, envelope = figure.subplots(1, 2)
    for sigma, (slip, tau, _) in case.curves.items():
        path.plot(1e3 * slip, tau / 1e3, label="normal stress %g kPa" % (sigma / 1e3))
    path.set(xlabel="slip [mm]", ylabel="mean shear stress [kPa]")
    path.legend()
    line = np.array([0.0, 210e3])
    envelope.plot(line / 1e3, strength(line) / 1e3, color="0.6", linewidth=4, label="c + sigma tan phi")
    envelope.plot(np.array(NORMAL) / 1e3, [case.curves[s][1].max() / 1e3 for s in NORMAL], "o", label="hybrid, peak")
    envelope.set(xlabel="normal stress [kPa]", ylabel="shear stress [kPa]")
    envelope.legend()
