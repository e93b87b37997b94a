# SPDX-License-Identifier: GPL-3.0-or-later
"""Semicircular canyon under a vertically incident S or P wave: motion over that of the wave, against scattered line forces.

eta is the canyon's diameter over the S wave length. The run ends before what the base and the sides send back is on the ground.
"""

import numpy as np
from half_space_scattering import HalfSpace, Semicircle, scattered
from layered_column import fourier
from scene_numbers import Numbers

COLOURS = {0.5: "#1f5a94", 1.0: "#d98b2b", 2.0: "#c8202f"}

shown = {}


def fourier_ratios(run, wave, frequency, points, depth, speed):
    """Complex motion of the points (2, n) over that of the upgoing wave (half the outcrop) at y = 0, for exp(i w t)."""
    incident = 0.5 * fourier(run.time, run.history("input/velocity")[:, "SP".index(wave)], frequency)
    at_ground = incident * np.exp(-2j * np.pi * frequency * depth / speed)
    motions = [run.history("monitors/%s/velocity" % name) for name in points]
    return np.array([[fourier(run.time, motion[:, k], frequency) for motion in motions] for k in (0, 1)]) / at_ground


def check(case, limits=None):
    """limits: by eta, of the root of the mean square and of the largest difference along the ground."""
    limits = limits or {0.5: (0.02, 0.03), 1.0: (0.02, 0.03), 2.0: (0.05, 0.08)}
    runs = {"S": case.run("S")}
    numbers = Numbers(runs["S"])
    rock, radius, depth = numbers.material("rock"), numbers.mesh("Radius"), numbers.mesh("Depth")
    later = depth / rock.speed("P") - depth / rock.speed("S")  # when the P wave is at the ground
    runs["P"] = case.run("P", "Motion/Angle=90", "Time/End time=%.6g" % (numbers.number("Time/End time") + later))
    names = runs["S"].names("monitors")
    points = np.array([numbers.point(name) for name in names]) / radius
    reference = {eta: scattered(HalfSpace(rock.poisson, np.pi * eta), Semicircle(), "SP", points) for eta in limits}
    for wave, run in runs.items():
        for eta, (mean, largest) in limits.items():
            expected, left = reference[eta][wave]
            found = fourier_ratios(run, wave, eta * rock.speed("S") / (2 * radius), names, depth, rock.speed(wave))
            what = "%s, eta = %g: " % (wave, eta)
            case.below(what + "traction left on the canyon of the reference", left, 0.005)
            case.below(what + "difference, root of the mean square of 25 points", np.sqrt((abs(found - expected) ** 2).mean()), mean)
            case.below(what + "largest difference of the amplitudes", abs(abs(found) - abs(expected)).max(), largest)
            mirrored = abs(abs(found) - abs(found[:, ::-1])).max()
            case.below(what + "left against right side", mirrored, 1e-6)
            shown[wave, eta] = points, found
            shown[wave] = rock.poisson
        case.below(wave + ": energy residual", run.summary["energy_residual"], 1e-3)


def draw(case, figure):
    axes = figure.subplots(2, 2, sharex=True, sharey=True)
    angle = np.linspace(0, np.pi, 121)
    x = np.concatenate([np.linspace(-3, -1, 60), -np.cos(angle), np.linspace(1, 3, 60)])
    ground = np.column_stack([x, -np.sqrt(np.maximum(0, 1 - x * x))])
    reference = {eta: scattered(HalfSpace(shown["S"], np.pi * eta), Semicircle(), "SP", ground) for eta in COLOURS}
    for column, wave in enumerate("SP"):
        for eta, colour in COLOURS.items():
            expected, _ = reference[eta][wave]
            points, found = shown[wave, eta]
            for row in (0, 1):
                axes[row, column].plot(x, abs(expected[row]), color=colour, lw=1, label=r"$\eta$ = %g, reference" % eta)
                axes[row, column].plot(points[:, 0], abs(found[row]), "o", color=colour, ms=3.5, label="program")
        axes[0, column].set_title("%s wave from below: horizontal motion" % wave, fontsize=9)
        axes[1, column].set_title("%s wave from below: vertical motion" % wave, fontsize=9)
        axes[1, column].set_xlabel("x / radius [-]")
    for row in axes:
        row[0].set_ylabel("over the wave's [-]")
    axes[0, 0].set_ylim(0, 3.2)
    axes[0, 1].legend(ncol=3, fontsize=7, loc="upper center", columnspacing=0.8, handlelength=1)
