# SPDX-License-Identifier: GPL-3.0-or-later
"""Level ground of rock and bonded blocks that begins with K0 does not move: in every block and cell

    sigma_v = rho g z      sigma_h = K0 sigma_v      no shear

whatever K0 is, as this is in equilibrium. The joints' stretch is finite: what moves is of second order in stress over modulus.
"""

import math

import numpy as np
from scene_numbers import Numbers
from vtu_file import picture_at

PARTS = {"blocks": "stress xx, yy, xy [Pa]", "continuum": "static stress xx, yy, xy [Pa]"}
shown = {}


def ratio_of(text, friction):
    """K0 that a value of the option stands for."""
    return 1 - math.sin(friction) if text == "1 - sin phi" else float(text)


def stresses(case, variant, part):
    """Centroids [m] and stress (xx, yy, xy) [Pa] of the first picture."""
    picture, _ = picture_at(case.work / variant, part, 0.0)
    return picture.centroids(), picture.cell_fields[PARTS[part]].astype(float)


def compare(case, variant, run, settlement):
    numbers = Numbers(run)
    weight = numbers.material("soil").density * numbers.gravity()
    ratio = ratio_of(numbers.text("Gravity/Initial stress"), numbers.material("soil").friction)
    for part in PARTS:
        where, stress = stresses(case, variant, part)
        # The points of the picture have single precision.
        vertical = -weight * where[:, 1]
        expected = np.column_stack((-ratio * vertical, -vertical, 0 * vertical))
        shown[variant, part] = -where[:, 1], -stress[:, :2], ratio
        for k, name in enumerate(("horizontal", "vertical", "shear")):
            case.below("K0 = %.3g, %s: %s stress off, of the largest" % (ratio, part, name),
                       np.abs(stress[:, k] - expected[:, k]).max() / vertical.max(), 1e-4)
    moved = run.summary["static_stage"]["largest_displacement_m"]
    case.below("K0 = %.3g: settlement over that of gravity switched on" % ratio, moved / settlement, 1e-4)


def check(case):
    settlement = case.run("elastic", "Gravity/Initial stress=elastic").summary["static_stage"]["largest_displacement_m"]
    for variant, value in (("default", "0.8"), ("jaky", "1 - sin phi"), ("one", "1")):
        compare(case, variant, case.run(variant, "Gravity/Initial stress=" + value), settlement)


def draw(case, figure):
    axes = figure.subplots(1, 2, sharey=True)
    for (variant, part), (depth, stress, ratio) in shown.items():
        axis = axes[list(PARTS).index(part)]
        axis.plot(stress[:, 0] / 1e3, depth, ".", label="K0 = %.3g" % ratio)
        axis.plot([0, ratio * stress[:, 1].max() / 1e3], [0, depth.max()], color="0.7", zorder=0)
        axis.set(xlabel="horizontal stress [kPa]", title=part)
    axes[0].set_ylabel("depth [m]")
    axes[0].invert_yaxis()
    axes[0].legend()
