# SPDX-License-Identifier: GPL-3.0-or-later
"""Vertically incident wave in layered ground with sides close by, against the 1D solution by transfer matrices."""

from layered_column import Layer, surface_motion
from scene_numbers import Numbers

POINTS = "ABCDEF"

shown = {}


def closed_form(run, wave, outcrop):
    """Velocity of the surface [m/s]."""
    n = Numbers(run)
    soft = n.mesh("Layer height")
    layers = Layer(soft, n.material("soil"), wave), Layer(n.mesh("Height") - soft, n.material("rock"), wave)
    damping = n.number("Continuum/Rayleigh mass"), n.number("Continuum/Rayleigh stiffness")
    return surface_motion(run.time, outcrop, layers, Layer(1.0, n.material("basement"), wave), *damping)


def check(case):
    for wave, component in (("S", 0), ("P", 1)):
        for sides in ("free field", "viscous"):
            run = case.run(wave + "_" + sides.replace(" ", "_"), "Continuum/Sides=" + sides,
                           "Motion/Angle=%g" % (90 * component))
            outcrop = run.history("input/velocity")[:, component]
            expected = closed_form(run, wave, outcrop)
            peak = abs(expected).max()
            errors = []
            for point in POINTS:
                surface = run.history("monitors/%s/velocity" % point)
                errors.append(abs(surface[:, component] - expected).max() / peak)
                across = abs(surface[:, 1 - component]).max() / peak
                if sides == "free field":
                    case.below("%s, point %s: largest difference over peak" % (wave, point), errors[-1], 0.01)
                    case.below("%s, point %s: motion across the wave over peak" % (wave, point), across, 0.001)
                shown.setdefault((wave, sides), []).append(surface[:, component])
            if sides == "viscous":
                case.true("%s: plain dashpots differ by %.3g of the peak (at least 0.1)" % (wave, max(errors)),
                          max(errors) > 0.1)
            case.below("%s, %s: energy residual" % (wave, sides), run.summary["energy_residual"], 1e-3)
            shown["time"], shown[wave] = run.time, expected
    automatic = case.run("S_automatic", "Continuum/Sides=automatic", "Motion/Angle=0")
    same = all((automatic.history("monitors/%s/velocity" % point)[:, 0] == of_point).all()
               for point, of_point in zip(POINTS, shown["S", "free field"]))
    case.true("automatic sides are free field, to the bit", same)


def draw(case, figure):
    for row, wave in zip(figure.subplots(2, 2, sharex=True, sharey="row"), ("S", "P")):
        for axes, sides in zip(row, ("free field", "viscous")):
            for n, history in enumerate(shown[wave, sides]):
                axes.plot(shown["time"], 1e3 * history, color="#1f5a94", lw=0.8, label=None if n else "program, six points")
            axes.plot(shown["time"], 1e3 * shown[wave], "k--", lw=0.9, label="closed form")
            axes.set_title("%s, %s" % (wave, sides))
        row[0].set_ylabel("velocity [mm/s]")
        row[0].legend(fontsize=8)
    for axes in figure.axes[2:]:
        axes.set_xlabel("time [s]")
