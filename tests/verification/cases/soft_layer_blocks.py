# SPDX-License-Identifier: GPL-3.0-or-later
"""Blocks in a shallow soft layer on hard rock: its sharp resonances are those without blocks."""

import numpy as np
from layered_column import fourier
from scene_numbers import Numbers
from soft_layer import RATIOS


def check(case):
    run = case.run()
    numbers = Numbers(run)
    soil, rock = numbers.material("soil"), numbers.material("rock")
    height = numbers.mesh("Pit depth") + numbers.mesh("Rock below")
    first = soil.speed("S") / (4 * height)
    contrast = soil.density * soil.speed("S") / (rock.density * rock.speed("S"))
    outcrop = run.history("input/velocity")[:, 0]
    for place in ("surface", "pit"):
        velocity = run.history("monitors/%s/velocity" % place)[:, 0]
        for ratio in RATIOS:
            phase = np.pi / 2 * ratio
            expected = 1 / (np.cos(phase) + 1j * contrast * np.sin(phase))
            found = fourier(run.time, velocity, ratio * first) / fourier(run.time, outcrop, ratio * first)
            name = "%s, %.4g Hz: " % (place, ratio * first)
            case.near(name + "1/|cos kH + i a sin kH|", abs(found), abs(expected), 0.01)
            case.below(name + "whole ratio, relative difference", abs(found / expected - 1), 0.02)
    case.true("no joint fails", run.summary["joints"]["tensile"] + run.summary["joints"]["shear"] == 0)
    case.below("energy residual", run.summary["energy_residual"], 1e-6)
