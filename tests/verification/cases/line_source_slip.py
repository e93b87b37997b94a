# SPDX-License-Identifier: GPL-3.0-or-later
"""Slip of a frictionless plane beside line forces, from the motion of a half space's surface under buried forces."""

import numpy as np
from buried_force import BuriedForce
from scene_numbers import Numbers

DISTANCES = (50, 100, 200, 300)  # along the plane from the source [m]; the nearest point of the plane is judged
ARM = 10.0  # of the explosion's forces from its middle [m]


def forces(numbers):
    """(x, y, horizontal, vertical) of each."""
    entries = [entry.split(":")[1] for entry in numbers.text("Point loads/Forces").split(";")]
    return [tuple(float(v) for v in entry.split(",")) for entry in entries]


def variants(numbers):
    x, y, size, _ = forces(numbers)[0]
    across = "source: %.15g, %.15g, 0, %.15g" % (x, y, size)
    arms = ((1, 0), (-1, 0), (0, 1), (0, -1))
    explosion = "; ".join("f%d: %.15g, %.15g, %.15g, %.15g" % (k, x + ARM * i, y + ARM * j, size * i, size * j)
                          for k, (i, j) in enumerate(arms))
    return {"along": None, "across": across, "explosion": explosion}


def closed_form(numbers, place, time):
    """Slip [m] of a place of the plane, upper side against lower: the surface of the lower half space goes the other way."""
    rock, frequency = numbers.material("rock"), numbers.number("Point loads/Frequency")
    half_space, plane = BuriedForce(rock.density, rock.young, rock.poisson), numbers.mesh("First plane")

    def wavelet(t):
        s = (np.pi * (frequency * t - 1.5)) ** 2
        return (1 - 2 * s) * np.exp(-s)

    slip = np.zeros(len(time))
    for x, y, horizontal, vertical in forces(numbers):
        for along, size in ((0, horizontal), (1, -vertical)):
            if size:
                slip -= size * half_space.surface(x - place, plane - y, along, time, wavelet)
    return slip


def check(case):
    first = case.run()
    case.curves = {}
    for name, loads in variants(Numbers(first)).items():
        run = first if loads is None else case.run(name, "Point loads/Forces=" + loads)
        numbers = Numbers(run)
        middle = np.mean([x for x, _, _, _ in forces(numbers)])
        time, places, slips = (run.get("bedding/" + what) for what in ("time", "bedding_1/position", "bedding_1/slip"))
        for distance in DISTANCES:
            point = np.argmin(np.abs(places[:, 0] - middle - distance))
            found, expected = slips[:, point], closed_form(numbers, places[point, 0], time)
            case.curves[name, distance] = time, found, expected
            what = "%s, %.0f m: " % (name, places[point, 0] - middle)
            case.near(what + "peak slip", np.abs(found).max(), np.abs(expected).max(), 0.02, "m")
            case.below(what + "relative L2 norm of the difference", np.linalg.norm(found - expected) / np.linalg.norm(expected), 0.02)
        case.true(name + ": the plane never opens", run.get("bedding/bedding_1/condition").max() <= 1)
        case.below(name + ": energy residual", run.summary["energy_residual"], 1e-6)


def draw(case, figure):
    names = list(dict.fromkeys(name for name, _ in case.curves))
    for axes, name in zip(figure.subplots(len(names), 1, sharex=True), names):
        for distance, colour in zip((DISTANCES[0], DISTANCES[-2]), ("C0", "C1")):
            time, found, expected = case.curves[name, distance]
            axes.plot(time, 1e3 * found, colour, label="hybrid, %d m" % distance)
            axes.plot(time, 1e3 * expected, "k--", linewidth=0.8)
        axes.set(ylabel="slip [mm]", title={"along": "force along the plane", "across": "force across the plane"}.get(name, name))
        axes.legend(fontsize=8, loc="upper right")
    axes.set_xlabel("time [s]   (dashed: closed form)")
