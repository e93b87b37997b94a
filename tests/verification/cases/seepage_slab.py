# SPDX-License-Identifier: GPL-3.0-or-later
"""Block on an incline with seepage: N' = g A (rho cos th - m rho_w / cos th), T = g A rho sin th."""

import numpy as np
from scene_numbers import Numbers

INCLINE = np.radians(20)  # of block_incline_20.csv
HEIGHT = 1.0  # of the block across the incline [m]

shown = {}


class Slab:
    """Closed form, saturated up to the part m of its height."""

    def __init__(self, run, saturated):
        numbers = Numbers(run)
        rock = numbers.material("rock")
        self.gravity, self.friction = numbers.gravity(), rock.friction
        self.lifted = saturated * numbers.number("Water/Density") / rock.density

    def acceleration(self):
        normal = np.cos(INCLINE) - self.lifted / np.cos(INCLINE)
        return self.gravity * (np.sin(INCLINE) - normal * np.tan(self.friction))

    def critical_friction(self):
        """tan(phi) at which it just rests."""
        return np.tan(INCLINE) / (1 - self.lifted / np.cos(INCLINE) ** 2)


def line_at(case, saturated):
    """A phreatic line parallel to the incline."""
    case.work.mkdir(parents=True, exist_ok=True)
    path = case.work.resolve() / ("line_%g.csv" % saturated)
    rows = ["%.15g,%.15g" % (x, x * np.tan(INCLINE) + saturated * HEIGHT / np.cos(INCLINE)) for x in (-40.0, 40.0)]
    path.write_text("x,y\n" + "\n".join(rows) + "\n", encoding="utf-8")
    return "Water/Line file=%s" % path


def run_slip(run):
    u = run.history("monitors/block/displacement")
    return run.time, -(u[:, 0] * np.cos(INCLINE) + u[:, 1] * np.sin(INCLINE))


def check(case):
    found = {}
    for saturated, line in ((1.0, []), (0.8, [line_at(case, 0.8)])):
        for method in ("submerged", "pressures"):
            name = "%s_%g" % (method, saturated)
            run = case.run(name, "Water/Method=" + method, *line)
            time, s = run_slip(run)
            expected = 0.5 * Slab(run, saturated).acceleration() * time**2
            found[name] = s
            case.near("%s, saturated %g: slip after 1 s" % (method, saturated), s[-1], expected[-1], 0.003, "m")
            case.below("%s, saturated %g: energy residual" % (method, saturated), run.summary["energy_residual"], 1e-3)
            shown[name] = time, s, expected
        case.below("saturated %g: submerged less pressures" % saturated,
                   np.abs(found["submerged_%g" % saturated] - found["pressures_%g" % saturated]).max(), 1e-6, "m")
    for method in ("submerged", "pressures"):
        for factor, moves in ((1.001, False), (0.999, True)):
            friction = np.degrees(np.arctan(factor * Slab(run, 0.5).critical_friction()))
            name = "%s_half_%g" % (method, factor)
            edge = case.run(name, "Water/Method=" + method, line_at(case, 0.5), "Time/Time step=0.002",
                            "Gravity/Static stage=equilibrium or move", "Materials/rock/Friction angle=%.12g" % friction)
            time, s = run_slip(edge)
            log = (case.work / name / "log.txt").read_text(encoding="utf-8")
            what = "%s, saturated 0.5, tan(phi) = %g times the critical" % (method, factor)
            case.true(what + (": no static equilibrium" if moves else ": static equilibrium"),
                      ("no static equilibrium" in log) == moves)
            if moves:
                case.near(what + " slides", s[-1], 0.5 * Slab(edge, 0.5).acceleration() * time[-1] ** 2, 0.003, "m")
            else:
                case.below(what + " rests", s[-1], 1e-6, "m")


def draw(case, figure):
    axes = figure.subplots()
    for name, (time, s, expected) in shown.items():
        method, saturated = name.split("_")
        axes.plot(time, s, lw=3 if method == "submerged" else 1.4, alpha=0.6, label="program, %s, saturated %s" % (method, saturated))
        axes.plot(time, expected, "k--", lw=0.9, label="closed form" if name == "pressures_0.8" else None)
    axes.set_xlabel("time [s]")
    axes.set_ylabel("slip [m]")
    axes.legend()
