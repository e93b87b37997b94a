# SPDX-License-Identifier: GPL-3.0-or-later
"""Submerged block on an incline: a = g (1 - rho_w/rho) (sin th - cos th tan phi)."""

import numpy as np
from scene_numbers import Numbers

INCLINE = np.radians(20)  # of block_incline_20.csv

shown = {}


def slip(run):
    """Closed form at the times of the run [m]."""
    numbers = Numbers(run)
    rock = numbers.material("rock")
    lifted = 0.0 if numbers.text("Water/Method") == "paper" else numbers.number("Water/Density") / rock.density
    acceleration = numbers.gravity() * (1 - lifted) * (np.sin(INCLINE) - np.cos(INCLINE) * np.tan(rock.friction))
    return 0.5 * acceleration * run.time**2


def run_slip(run):
    u = run.history("monitors/block/displacement")
    return run.time, -(u[:, 0] * np.cos(INCLINE) + u[:, 1] * np.sin(INCLINE))


def check(case):
    found = {}
    for method in ("submerged", "pressures", "paper"):
        run = case.run(method, "Water/Method=" + method)
        time, s = run_slip(run)
        found[method] = s
        case.near(method + ": slip after 1 s", s[-1], slip(run)[-1], 0.003, "m")
        case.below(method + ": energy residual", run.summary["energy_residual"], 1e-3)
        shown[method] = time, s, slip(run)
    case.below("submerged less pressures", np.abs(found["submerged"] - found["pressures"]).max(), 1e-6, "m")
    for method in ("submerged", "pressures"):
        for factor, moves in ((1.001, False), (0.999, True)):
            friction = np.arctan(factor * np.tan(INCLINE))
            run = case.run("%s_%g" % (method, factor), "Water/Method=" + method, "Time/Time step=0.002",
                           "Gravity/Static stage=equilibrium or move", "Materials/rock/Friction angle=%.12g" % np.degrees(friction))
            time, s = run_slip(run)
            log = (case.work / ("%s_%g" % (method, factor)) / "log.txt").read_text(encoding="utf-8")
            what = "%s, tan(phi) = %g tan(theta)" % (method, factor)
            case.true(what + (": no static equilibrium" if moves else ": static equilibrium"),
                      ("no static equilibrium" in log) == moves)
            if moves:
                case.near(what + " slides", s[-1], slip(run)[-1], 0.003, "m")
            else:
                case.below(what + " rests", s[-1], 1e-6, "m")


def draw(case, figure):
    axes = figure.subplots()
    for method, (time, s, expected) in shown.items():
        axes.plot(time, s, lw=3 if method == "submerged" else 1.4, alpha=0.6, label="program, " + method)
        axes.plot(time, expected, "k--", lw=0.9, label="closed form" if method == "paper" else None)
    axes.set_xlabel("time [s]")
    axes.set_ylabel("slip [m]")
    axes.legend()
