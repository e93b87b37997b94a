# SPDX-License-Identifier: GPL-3.0-or-later
"""Slab of height H on a slope b that begins with (K0, 1) rho g z, z below its surface. Equilibrium asks for sigma_n and tau on planes along
the slope; far from its ends the change strains the slab across and in shear, not along (plane strain):

    sigma_n = rho g z cos2 b      tau = rho g z sin b cos b
    sigma_t = rho g z (K0 cos2 b + sin2 b - nu / (1 - nu) K0 sin2 b)       along the slope
"""

import numpy as np
from initial_stress import ratio_of, stresses
from scene_numbers import Numbers

MIDDLE = 3.0  # of the slab's length, on either side [m]
ELASTIC = "gravity switched on"
STAGED = "placed in lifts"


class Slab:
    """Stress in the middle of the slab, by rows of blocks [Pa], beside the closed form."""

    def __init__(self, case, variant, run):
        numbers = Numbers(run)
        self.soil, b = numbers.material("soil"), np.radians(numbers.mesh("Angle"))
        value, nu = numbers.text("Gravity/Initial stress"), self.soil.poisson
        ratio = nu / (1 - nu) if value in ("elastic", "staged") else ratio_of(value, self.soil.friction)
        height, density = numbers.mesh("Height"), self.soil.density
        if numbers.text("Water/Method") == "submerged":
            density -= numbers.number("Water/Density")
        where, stress = stresses(case, variant, "blocks")
        t = np.array([np.cos(b), np.sin(b)])
        n = np.array([-t[1], t[0]])
        along, depth = where @ t, height - where @ n
        middle = np.abs(along - numbers.mesh("Width") / 2) < MIDDLE
        xx, yy, xy = stress[middle].T
        self.depth = depth[middle]
        found = (-(xx * n[0] ** 2 + yy * n[1] ** 2 + 2 * xy * n[0] * n[1]), -(xx * t[0] ** 2 + yy * t[1] ** 2 + 2 * xy * t[0] * t[1]),
                 -(xx * n[0] * t[0] + yy * n[1] * t[1] + xy * (n[0] * t[1] + n[1] * t[0])))
        vertical = density * numbers.gravity() * self.depth / np.cos(b)
        c2, s2 = np.cos(b) ** 2, np.sin(b) ** 2
        along_slope = ratio * c2 + s2 - nu / (1 - nu) * ratio * s2
        if value in ("elastic", "staged"):  # no strain along the slope from the start
            along_slope = nu / (1 - nu) * c2
        expected = (vertical * c2, vertical * along_slope, vertical * np.sin(b) * np.cos(b))
        self.found = dict(zip(("normal", "along the slope", "shear"), found))
        self.expected = dict(zip(self.found, expected))
        self.largest = vertical.max()
        self.rows = np.floor(self.depth / numbers.mesh("Resolution/h"))


def compare(case, name, slab):
    allowed = 1e-2 if ELASTIC in name or STAGED in name else 1e-3  # the joints' compliance changes the mass's nu a little
    for part, found in slab.found.items():
        off = [(found[slab.rows == r] - slab.expected[part][slab.rows == r]).mean() for r in np.unique(slab.rows)]
        case.below("%s: mean %s stress of each row off, of the largest vertical one" % (name, part), np.abs(off).max() / slab.largest, allowed)


def check(case):
    case.curves = {}
    for name, variant, overrides, mesh in (
            ("K0 = 0.8", "default", (), None),
            ("1 - sin phi", "jaky", ("Gravity/Initial stress=1 - sin phi",), None),
            (ELASTIC, "elastic", ("Gravity/Initial stress=elastic",), None),
            ("level, " + ELASTIC, "level_elastic", ("Gravity/Initial stress=elastic",), {"Angle": 0}),
            ("level, %s" % STAGED, "level_staged", ("Gravity/Initial stress=staged", "Gravity/Lifts=4"), {"Angle": 0}),
            ("level, nu / (1 - nu)", "level", ("Gravity/Initial stress=0.333333333333333",), {"Angle": 0}),
            ("submerged, K0 = 0.8", "submerged", ("Water/Method=submerged", "Water/Level=100"), None)):
        slab = Slab(case, variant, case.run(variant, *overrides, mesh=mesh))
        compare(case, name, slab)
        case.curves[name] = slab


def draw(case, figure):
    axes = figure.subplots(1, 3, sharey=True)
    for axis, part in zip(axes, ("normal", "along the slope", "shear")):
        for name in ("K0 = 0.8", "1 - sin phi", ELASTIC):
            slab = case.curves[name]
            order = np.argsort(slab.depth)
            axis.plot(slab.expected[part][order] / 1e3, slab.depth[order], color="0.7")
            axis.plot(slab.found[part] / 1e3, slab.depth, ".", label=name)
        axis.set(xlabel="%s [kPa]" % ("stress along the slope" if part == "along the slope" else part + " stress"))
    axes[0].set_ylabel("depth below the slope [m]")
    axes[0].invert_yaxis()
    axes[1].legend(loc="upper right")
