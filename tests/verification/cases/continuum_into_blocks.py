# SPDX-License-Identifier: GPL-3.0-or-later
"""A pulse from bedrock into blocks of the same material: everywhere the wave of a homogeneous half space."""

import numpy as np

DENSITY, YOUNG, POISSON, FREQUENCY = 2000.0, 200e6, 0.25, 4.0
BELOW, HEIGHT = 37.5, 125.0  # monitor and surface above the base [m]
SHEAR = YOUNG / (2 * (1 + POISSON))
SPEED = {"S": np.sqrt(SHEAR / DENSITY), "P": np.sqrt(2 * SHEAR * (1 - POISSON) / (1 - 2 * POISSON) / DENSITY)}

shown = {}


def peak(time, values):
    """Time and value of the largest value, by a parabola through its neighbours."""
    k = int(values[1:-1].argmax()) + 1
    left, middle, right = values[k - 1 : k + 2]
    part = 0.5 * (left - right) / (left - 2 * middle + right)
    return time[k] + part * (time[1] - time[0]), middle - 0.25 * (left - right) * part


def check(case):
    for wave, component in (("S", 0), ("P", 1)):
        c = SPEED[wave]
        frequency = FREQUENCY * c / SPEED["S"]  # the same wavelength, in units of blocks
        run = case.run(wave, "Motion/Angle=%g" % (90 * component), "Motion/Frequency=%.8g" % frequency,
                       "Time/Time step=%.8g" % (1e-3 * FREQUENCY / frequency),
                       "Time/End time=%.8g" % (1.25 * FREQUENCY / frequency))
        time, outcrop = run.time, run.history("input/velocity")[:, component]
        below, surface, ground = (run.history("monitors/%s/velocity" % name)[:, component]
                                  for name in ("below", "surface", "ground"))

        def delayed(distance):
            return np.interp(time - distance / c, time, outcrop, left=0.0)

        incident, crest = delayed(BELOW) / 2, peak(time, delayed(HEIGHT))
        height = np.abs(incident).max()
        # until the surface's reflection comes back: 0.4 periods after its begin it is 1e-5 of its peak
        passed = time < (2 * HEIGHT - BELOW) / c + 0.4 / frequency
        reflected = np.abs(below - incident)[passed].max() / height
        case.below(wave + ": reflected over incident", reflected, 0.02)
        found, trough = peak(time, surface), peak(time, -surface)
        case.near(wave + ": surface over incident, crest", 2 * found[1] / crest[1], 2.0, 0.02)
        case.near(wave + ": surface over incident, trough", 2 * trough[1] / peak(time, -delayed(HEIGHT))[1], 2.0, 0.02)
        travel = (HEIGHT - BELOW) / c
        passes = peak(time, below * passed)
        case.near(wave + ": travel time from monitor to surface", found[0] - passes[0], travel, 0.01, "s")
        case.near(wave + ": ground beside the pit over incident", 2 * peak(time, ground)[1] / crest[1], 2.0, 0.02)
        difference = np.abs(surface - delayed(HEIGHT)).max() / np.abs(outcrop).max()
        print("      %s: surface, largest difference over peak %.3g" % (wave, difference))
        case.true(wave + ": no joint fails", run.summary["joints"]["tensile"] + run.summary["joints"]["shear"] == 0)
        case.below(wave + ": energy residual", run.summary["energy_residual"], 1e-3)
        shown[wave] = time, below, incident + delayed(2 * HEIGHT - BELOW) / 2, surface, delayed(HEIGHT)


def draw(case, figure):
    for row, wave in zip(figure.subplots(2, 2, sharey="row"), ("S", "P")):
        time, below, below_exact, surface, surface_exact = shown[wave]
        for axes, found, exact, title in ((row[0], below, below_exact, "rock, 37.5 m below the blocks"),
                                          (row[1], surface, surface_exact, "surface of the blocks")):
            axes.plot(time, 1e3 * found, color="#1f5a94", lw=1, label="program")
            axes.plot(time, 1e3 * exact, "k--", lw=0.9, label="closed form")
            axes.set_title("%s wave, %s" % (wave, title), fontsize=9)
            axes.set_xlabel("time [s]")
        row[0].set_ylabel("velocity [mm/s]")
        row[0].legend(fontsize=8)
