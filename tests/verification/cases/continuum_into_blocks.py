# SPDX-License-Identifier: GPL-3.0-or-later
"""A pulse from bedrock into blocks of the same material: everywhere the wave of a homogeneous half space."""

import numpy as np
from scene_numbers import Numbers

shown = {}


def peak(time, values):
    """Time and value of the largest value, by a parabola through its neighbours."""
    k = int(values[1:-1].argmax()) + 1
    left, middle, right = values[k - 1 : k + 2]
    part = 0.5 * (left - right) / (left - 2 * middle + right)
    return time[k] + part * (time[1] - time[0]), middle - 0.25 * (left - right) * part


def check(case):
    shear = case.run()
    numbers = Numbers(shear)
    rock = numbers.material("rock")
    faster = rock.speed("P") / rock.speed("S")  # the same wavelength, in units of blocks
    pressure = case.run("P", "Motion/Angle=90", "Motion/Frequency=%.8g" % (faster * numbers.number("Motion/Frequency")),
                        "Time/End time=%.8g" % (numbers.number("Time/End time") / faster))
    for wave, run in (("S", shear), ("P", pressure)):
        compare(case, wave, run)


def compare(case, wave, run):
    numbers, component = Numbers(run), "SP".index(wave)
    c, frequency = numbers.material("rock").speed(wave), numbers.number("Motion/Frequency")
    height = numbers.mesh("Pit depth") + numbers.mesh("Rock below")  # of the surface above the base [m]
    low = height + numbers.point("below")[1]  # of the monitor below the pit
    time, outcrop = run.time, run.history("input/velocity")[:, component]
    below, surface, ground = (run.history("monitors/%s/velocity" % name)[:, component]
                              for name in ("below", "surface", "ground"))

    def delayed(distance):
        return np.interp(time - distance / c, time, outcrop, left=0.0)

    incident, crest = delayed(low) / 2, peak(time, delayed(height))
    # until the surface's reflection comes back: 0.4 periods after its begin it is 1e-5 of its peak
    passed = time < (2 * height - low) / c + 0.4 / frequency
    reflected = np.abs(below - incident)[passed].max() / np.abs(incident).max()
    case.below(wave + ": reflected over incident", reflected, 0.02)
    found, trough = peak(time, surface), peak(time, -surface)
    case.near(wave + ": surface over incident, crest", 2 * found[1] / crest[1], 2.0, 0.02)
    case.near(wave + ": surface over incident, trough", 2 * trough[1] / peak(time, -delayed(height))[1], 2.0, 0.02)
    passes = peak(time, below * passed)
    case.near(wave + ": travel time from monitor to surface", found[0] - passes[0], (height - low) / c, 0.01, "s")
    case.near(wave + ": ground beside the pit over incident", 2 * peak(time, ground)[1] / crest[1], 2.0, 0.02)
    difference = np.abs(surface - delayed(height)).max() / np.abs(outcrop).max()
    print("      %s: surface, largest difference over peak %.3g" % (wave, difference))
    case.true(wave + ": no joint fails", run.summary["joints"]["tensile"] + run.summary["joints"]["shear"] == 0)
    case.below(wave + ": energy residual", run.summary["energy_residual"], 1e-3)
    shown[wave] = time, below, incident + delayed(2 * height - low) / 2, surface, delayed(height)


def draw(case, figure):
    for row, wave in zip(figure.subplots(2, 2, sharey="row"), ("S", "P")):
        time, below, below_exact, surface, surface_exact = shown[wave]
        for axes, found, exact, title in ((row[0], below, below_exact, "rock below the blocks"),
                                          (row[1], surface, surface_exact, "surface of the blocks")):
            axes.plot(time, 1e3 * found, color="#1f5a94", lw=1, label="program")
            axes.plot(time, 1e3 * exact, "k--", lw=0.9, label="closed form")
            axes.set_title("%s wave, %s" % (wave, title), fontsize=9)
            axes.set_xlabel("time [s]")
        row[0].set_ylabel("velocity [mm/s]")
        row[0].legend(fontsize=8)
