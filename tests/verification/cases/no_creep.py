# SPDX-License-Identifier: GPL-3.0-or-later
"""Blocks at rest on bedrock with viscous boundaries: nothing moves, and the rock carries exactly their weight."""

import numpy as np
from scene_numbers import Numbers

shown = {}


def weight(run):
    """Of the blocks [N/m]."""
    n = Numbers(run)
    return n.material("rock").density * n.gravity() * n.mesh("Width") * n.mesh("Block height")


def check(case):
    for variant, overrides in (("bonded", []), ("loose", ["Model/Blocks=loose", "Blocks/Belt material="])):
        run = case.run(variant, *overrides)
        largest = np.zeros(run.n)
        for name in run.names("monitors"):
            moved = np.linalg.norm(run.history("monitors/" + name + "/displacement"), axis=1)
            case.below("%s: motion of '%s' in %g s" % (variant, name, run.time[-1]), moved.max(), 1e-6, "m")
            largest = np.maximum(largest, moved)
        force = run.get("interface/force")[-1].reshape(-1, 2).sum(axis=0)
        case.near(variant + ": force of the blocks on the rock", -force[1], weight(run), 1e-8, "N/m")
        case.below(variant + ": its horizontal part over the weight", force[0] / weight(run), 1e-8)
        case.true(variant + ": ran to the end", run.summary["finished"] and abs(run.time[-1] - Numbers(run).number("Time/End time")) < 1e-9)
        case.true(variant + ": no joint fails while shaking nothing",
                  run.summary["joints"]["tensile"] + run.summary["joints"]["shear"] == 0)
        shown[variant] = run.time, largest


def draw(case, figure):
    axes = figure.subplots()
    for variant, (time, largest) in shown.items():
        axes.semilogy(time, np.maximum(largest, 1e-18), lw=1, label="program, " + variant)
    axes.axhline(1e-6, color="k", ls="--", lw=1, label="allowed (closed form: 0)")
    axes.set_ylim(1e-18, 1e-4)
    axes.set_xlabel("time [s]")
    axes.set_ylabel("largest motion of any monitor [m]")
    axes.legend(fontsize=8)
