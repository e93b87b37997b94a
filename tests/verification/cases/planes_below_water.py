# SPDX-License-Identifier: GPL-3.0-or-later
"""A level plane with strength bears the effective stress: total weight above it less pore pressure,

    sigma_n' = g (rho_soil d + rho_rock t) + rho_w g (depth of the water on the ground) - rho_w g (h - y)

d, t: thickness of the blocks and of the rock above the plane, h: level. In the middle of a wide section, however the water acts on blocks.

An upright plane in the lower layer bears K0 times that stress at each height: K0 is of effective stress, nu/(1 - nu) of gravity switched on.
"""

import numpy as np

PLANE, ROCK, GROUND = 20.0, 30.0, 35.0  # elevations [m]
LEVELS = {"dry": None, "in the rock": 27.0, "in the blocks": 33.0, "above ground": 45.0}
LATERAL = {"elastic": 0.25 / 0.75, "0.6": 0.6}  # Gravity/Initial stress: horizontal over vertical effective stress
UPRIGHT = ["Bedding planes/Names=bedding_2", "Bedding planes/Normal stiffness=1e12", "Monitors/Points=ground: 60, 30.5", "Mesh/Numbers=Width = 120; Lower height = 20; Upper height = 10; Block height = 0.5; Inset = 1; "
           "Resolution/h = 2.5"]
shown = []


def expected(level, height=PLANE, ground=GROUND):
    """Vertical effective stress [Pa]."""
    weight = 9.81 * (2500 * (ROCK - height) + 2000 * (ground - ROCK))
    if level is None:
        return weight
    return weight + 9810 * np.maximum(0.0, level - ground) - 9810 * np.maximum(0.0, level - height)


def normal_stress(run):
    """Mean over the middle third of the plane at rest [Pa]."""
    x, stress = run.get("bedding/bedding_1/position")[:, 0], run.get("bedding/bedding_1/normal_stress")[0]
    return stress[(x > 40) & (x < 80)].mean()


def check_upright(case):
    for bedrock in ("continuum", "triangles"):
        for lateral, ratio in LATERAL.items():
            for name, level in LEVELS.items():
                run = case.run("upright_%s_%s_%s" % (bedrock, lateral, name.replace(" ", "_")), "Model/Bedrock=" + bedrock,
                               "Water/Level=%s" % ("none" if level is None else "%g" % level), "Gravity/Initial stress=" + lateral, *UPRIGHT)
                y, stress = run.get("bedding/bedding_2/position")[:, 1], run.get("bedding/bedding_2/normal_stress")[0]
                inside = (y > 3) & (y < 17)
                case.near("%s, K0 %s, water %s: normal stress of the upright plane" % (bedrock, lateral, name), stress[inside].mean(),
                          ratio * expected(level, y[inside], ROCK + 0.5).mean(), 1e-2, "Pa")


def check(case):
    check_upright(case)
    for bedrock in ("continuum", "triangles"):
        for name, level in LEVELS.items():
            found = []
            for method in ("pressures", "submerged") if level is not None else ("paper",):
                run = case.run("%s_%s_%s" % (bedrock, name.replace(" ", "_"), method), "Model/Bedrock=" + bedrock,
                               "Water/Level=%s" % ("none" if level is None else "%g" % level), "Water/Method=" + method)
                found.append(normal_stress(run))
            case.near("%s, water %s: normal stress" % (bedrock, name), found[0], expected(level), 2e-3, "Pa")
            if len(found) > 1:
                case.below("%s, water %s: submerged less pressures, of it" % (bedrock, name), abs(found[1] / found[0] - 1), 1e-6)
            shown.append((bedrock, level, found[0]))


def draw(case, figure):
    axes = figure.subplots()
    levels = np.linspace(15, 50, 200)
    axes.plot(levels, [expected(level) / 1e3 for level in levels], color="0.6", label="closed form")
    for bedrock, mark in (("continuum", "o"), ("triangles", "x")):
        axes.plot([15 if level is None else level for b, level, _ in shown if b == bedrock],
                  [stress / 1e3 for b, _, stress in shown if b == bedrock], mark, label=bedrock)
    axes.set(xlabel="level of the water [m] (15: none)", ylabel="effective normal stress of the plane [kPa]")
    axes.legend()
