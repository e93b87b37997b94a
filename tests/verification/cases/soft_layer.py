# SPDX-License-Identifier: GPL-3.0-or-later
"""Soft layer over a half space: surface over outcrop = 1 / (cos kH + i a sin kH), k complex with damping."""

import numpy as np
from layered_column import Layer, fourier, surface_over_outcrop

HEIGHT = 40.0
RATIOS = (0.5, 1.0, 2.0, 3.0, 4.0, 5.0)  # frequency over the layer's first, c / (4 H)
DAMPING = {"undamped": (0.0, 0.0), "damped": (0.4, 0.002)}  # alpha_M [1/s], beta_K [s]

shown = {}


def layers(wave):
    return Layer(HEIGHT, 1800.0, 180e6, 0.25, wave), Layer(20.0, 2400.0, 6e9, 0.25, wave)


def closed_form(wave, frequency, damping):
    soil, rock = layers(wave)
    omega = 2 * np.pi * frequency
    return surface_over_outcrop((soil, rock), rock, omega, *DAMPING[damping])


def check(case):
    for wave, component in (("S", 0), ("P", 1)):
        soil, rock = layers(wave)
        first = soil.speed / (4 * HEIGHT)
        for damping, (alpha, beta) in DAMPING.items():
            run = case.run(
                wave + "_" + damping,
                "Motion/Angle=%g" % (90 * component),
                "Motion/Frequency=%.6g" % (2.5 * first),
                "Continuum/Rayleigh mass=%g" % alpha,
                "Continuum/Rayleigh stiffness=%g" % beta,
            )
            surface = run.history("monitors/surface/velocity")[:, component]
            outcrop = run.history("input/velocity")[:, component]
            for ratio in RATIOS:
                f = ratio * first
                expected = closed_form(wave, f, damping)
                found = fourier(run.time, surface, f) / fourier(run.time, outcrop, f)
                case.near("%s, %s, %.4g Hz: amplification" % (wave, damping, f), abs(found), abs(expected), 0.01)
                case.below("%s, %s, %.4g Hz: whole ratio, relative difference" % (wave, damping, f),
                           abs(found / expected - 1), 0.02)
                if damping == "undamped":
                    angle, a = np.pi / 2 * ratio, soil.impedance / rock.impedance
                    simple = 1 / abs(np.cos(angle) + 1j * a * np.sin(angle))
                    case.near("%s, %.4g Hz: 1/|cos kH + i a sin kH|" % (wave, f), abs(found), simple, 0.01)
                shown.setdefault((wave, damping), []).append((f, abs(found)))
            case.below(wave + ", " + damping + ": energy residual", run.summary["energy_residual"], 1e-3)


def draw(case, figure):
    for axes, wave in zip(figure.subplots(1, 2, sharey=True), ("S", "P")):
        first = layers(wave)[0].speed / (4 * HEIGHT)
        f = np.linspace(0.2 * first, 5.5 * first, 600)
        for damping, colour in (("undamped", "#1f5a94"), ("damped", "#d98b2b")):
            axes.plot(f, [abs(closed_form(wave, x, damping)) for x in f], color=colour, lw=1, label=damping + ", closed form")
            axes.plot(*np.transpose(shown[wave, damping]), "o", color=colour, ms=5, label=damping + ", program")
        axes.set_xlabel("frequency [Hz]")
        axes.set_title(wave + " wave")
    figure.axes[0].set_ylabel("surface over outcrop [-]")
    figure.axes[0].set_ylim(0, 9)
    figure.axes[0].legend(ncol=2, loc="upper left", fontsize=8)
