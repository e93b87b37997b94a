# SPDX-License-Identifier: GPL-3.0-or-later
"""Submerged block on an incline: a = g (1 - rho_w/rho) (sin th - cos th tan phi)."""

import numpy as np

GRAVITY, DENSITY, WATER, INCLINE = 9.81, 2320.0, 1000.0, np.radians(20)

shown = {}


def slip(time, friction, buoyant):
    acceleration = GRAVITY * buoyant / DENSITY * (np.sin(INCLINE) - np.cos(INCLINE) * np.tan(friction))
    return 0.5 * acceleration * time**2


def run_slip(run):
    u = run.history("monitors/block/displacement")
    return run.time, -(u[:, 0] * np.cos(INCLINE) + u[:, 1] * np.sin(INCLINE))


def check(case):
    found = {}
    for method, buoyant in (("submerged", DENSITY - WATER), ("pressures", DENSITY - WATER), ("paper", DENSITY)):
        run = case.run(method, "Water/Method=" + method)
        time, s = run_slip(run)
        found[method] = s
        case.near(method + ": slip after 1 s", s[-1], slip(time[-1], np.radians(10), buoyant), 0.003, "m")
        case.below(method + ": energy residual", run.summary["energy_residual"], 1e-3)
        shown[method] = time, s, slip(time, np.radians(10), buoyant)
    case.below("submerged less pressures", np.abs(found["submerged"] - found["pressures"]).max(), 1e-6, "m")
    for method in ("submerged", "pressures"):
        for factor, moves in ((1.001, False), (0.999, True)):
            friction = np.arctan(factor * np.tan(INCLINE))
            run = case.run("%s_%g" % (method, factor), "Water/Method=" + method, "Time/Time step=0.002",
                           "Gravity/Static stage=equilibrium", "Materials/rock/Friction angle=%.12g" % np.degrees(friction))
            time, s = run_slip(run)
            log = (case.work / ("%s_%g" % (method, factor)) / "log.txt").read_text(encoding="utf-8")
            what = "%s, tan(phi) = %g tan(theta)" % (method, factor)
            case.true(what + (": no static equilibrium" if moves else ": static equilibrium"),
                      ("no static equilibrium" in log) == moves)
            if moves:
                case.near(what + " slides", s[-1], slip(time[-1], friction, DENSITY - WATER), 0.003, "m")
            else:
                case.below(what + " rests", s[-1], 1e-6, "m")


def draw(case, figure):
    axes = figure.subplots()
    for method, (time, s, expected) in shown.items():
        axes.plot(time, s, lw=3 if method == "submerged" else 1.4, alpha=0.6, label="program, " + method)
        axes.plot(time, expected, "k--", lw=0.9)
    axes.set_xlabel("time [s]")
    axes.set_ylabel("slip [m]")
    axes.legend()
