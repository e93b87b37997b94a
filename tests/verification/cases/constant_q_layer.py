# SPDX-License-Identifier: GPL-3.0-or-later
"""Soft layer over a half space with the same Q over a decade."""

import numpy as np
from constant_q_law import ConstantQ, FittedBody
from layered_column import Layer, fourier, surface_over_outcrop
from scene_numbers import Numbers

FILTERED = ("Time/Scheme=filtered", "Time/Time step=0.0005")
RATIOS = (1.0, 2.0, 3.0, 5.0, 7.0)  # frequency over the layer's first, c / (4 H)


class DampedLayer(Layer):
    """A layer with a modulus that depends on frequency."""

    def __init__(self, thickness, material, wave, law):
        super().__init__(thickness, material, wave)
        self.elastic, self.law = self.modulus, law

    def wave_number(self, omega, alpha=0.0, beta=0.0):
        self.modulus = self.elastic * self.law.modulus(omega)
        return omega * np.sqrt(self.density / self.modulus)


def closed_form(numbers, wave, frequency, law):
    soft = numbers.mesh("Layer height")
    soil = DampedLayer(soft, numbers.material("soil"), wave, law)
    rock = DampedLayer(numbers.mesh("Height") - soft, numbers.material("rock"), wave, law)
    below = Layer(1.0, numbers.material("rock"), wave)
    return surface_over_outcrop((soil, rock), below, 2 * np.pi * frequency)


def check(case):
    case.shown = []
    for wave, ratio, more in (("S", 0.05, ()), ("S", 0.02, ()), ("P", 0.05, ("Motion/Angle=90", "Motion/Frequency=5")),
                              ("S", 0.05, FILTERED)):
        run = case.run("%s_%g_%d" % (wave, ratio, len(case.shown)), "Maxwell damping/Bedrock ratio=%g" % ratio, *more)
        numbers, component = Numbers(run), "SP".index(wave)
        soil = numbers.material("soil")
        first = soil.speed(wave) / (4 * numbers.mesh("Layer height"))
        surface = run.history("monitors/surface/velocity")[:, component]
        outcrop = run.history("input/velocity")[:, component]
        name = "%s, %g %%%s: " % (wave, 100 * ratio, ", filtered" if more == FILTERED else "")
        points, law, body = [], ConstantQ(numbers, ratio), FittedBody(numbers, ratio)
        for times in RATIOS:
            f = times * first
            if f > numbers.number("Maxwell damping/Highest frequency"):
                continue
            found = fourier(run.time, surface, f) / fourier(run.time, outcrop, f)
            case.near(name + "amplification at %.4g Hz" % f, abs(found), abs(closed_form(numbers, wave, f, law)), 0.02)
            exact = closed_form(numbers, wave, f, body)
            case.below(name + "whole ratio against that of the branches, relative difference", abs(found / exact - 1), 0.005)
            points.append((f, abs(found)))
        case.below(name + "energy residual", run.summary["energy_residual"], 1e-9)
        # The inertia of `fourth order` shows at boundaries with (w dt)^2/6, with damping or without.
        allowed = 1e-9 if more == FILTERED else 1e-4
        for one, other in (("surface", "left"), ("middle", "beside")):
            a, b = (run.history("monitors/%s/velocity" % point)[:, component] for point in (one, other))
            case.below(name + "%s beside %s, of the peak" % (one, other), np.abs(a - b).max() / np.abs(a).max(), allowed)
        case.shown.append((wave, ratio, more, numbers, points))


def draw(case, figure):
    axes = dict(zip("SP", figure.subplots(1, 2, sharey=True)))
    for wave, ratio, more, numbers, points in case.shown:
        if more == FILTERED:
            continue
        law = ConstantQ(numbers, ratio)
        colour = {0.05: "#1f5a94", 0.02: "#d98b2b"}[ratio]
        f = np.geomspace(0.5, 15, 600)
        axes[wave].semilogx(f, [abs(closed_form(numbers, wave, x, law)) for x in f], color=colour, lw=1,
                            label="constant Q, %g %%" % (100 * ratio))
        axes[wave].semilogx(*np.transpose(points), "o", color=colour, ms=5, label="program")
        axes[wave].set_xlabel("frequency [Hz]")
        axes[wave].set_title(wave + " wave")
    axes["S"].set_ylabel("surface over outcrop [-]")
    axes["S"].legend(fontsize=8)
