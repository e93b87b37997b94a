# SPDX-License-Identifier: GPL-3.0-or-later
"""Soft layer over a half space: surface over outcrop = 1 / (cos kH + i a sin kH), k complex with damping."""

import numpy as np
from layered_column import Layer, fourier, surface_over_outcrop
from scene_numbers import Numbers
from zero_phase import low_pass

RATIOS = (0.5, 1.0, 2.0, 3.0, 4.0, 5.0)  # frequency over the layer's first, c / (4 H)
# A tenth of the height and a greater contrast: its resonances want the scheme that damps nothing of its own.
SHALLOW = ("Materials/rock/Young modulus=6e9", "Materials/rock/Density=2400",
           "Time/End time=12", "Motion/Frequency=3", "Monitors/Points=surface: 5, 60")
SHALLOW_MESH = {"Height": 60, "Layer height": 40, "Width": 10, "Resolution/h": 4}


def damping(numbers):
    return numbers.number("Continuum/Rayleigh mass"), numbers.number("Continuum/Rayleigh stiffness")


def layers(numbers, wave):
    soft = numbers.mesh("Layer height")
    return (Layer(soft, numbers.material("soil"), wave),
            Layer(numbers.mesh("Height") - soft, numbers.material("rock"), wave))


def closed_form(numbers, wave, frequency):
    soil, rock = layers(numbers, wave)
    return surface_over_outcrop((soil, rock), rock, 2 * np.pi * frequency, *damping(numbers))


def compare(case, what, run, wave):
    """Asks for the amplification at six frequencies; returns those and what was found."""
    component, numbers = "SP".index(wave), Numbers(run)
    soil, rock = layers(numbers, wave)
    first = soil.speed / (4 * soil.thickness)
    surface = run.history("monitors/surface/velocity")[:, component]
    outcrop = run.history("input/velocity")[:, component]
    shown = []
    for ratio in RATIOS:
        f = ratio * first
        expected = closed_form(numbers, wave, f)
        found = fourier(run.time, surface, f) / fourier(run.time, outcrop, f)
        name = "%s, %.4g Hz: " % (what, f)
        case.near(name + "amplification", abs(found), abs(expected), 0.01)
        case.below(name + "whole ratio, relative difference", abs(found / expected - 1), 0.02)
        if damping(numbers) == (0, 0):
            angle, a = np.pi / 2 * ratio, soil.impedance / rock.impedance
            case.near(name + "1/|cos kH + i a sin kH|", abs(found), 1 / abs(np.cos(angle) + 1j * a * np.sin(angle)), 0.01)
        shown.append((f, abs(found)))
    case.below(what + ": energy residual", run.summary["energy_residual"], 1e-3)
    return shown


def check_filter(case, run):
    """The filtered histories of a run are what scipy makes of the raw ones."""
    for quantity in ("velocity", "acceleration"):
        time, filtered = run.filtered("monitors/surface/" + quantity)
        raw = run.history("monitors/surface/" + quantity)
        case.true(quantity + " is filtered below 25 Hz at equal steps", run.corner == 25 and np.array_equal(time, run.time))
        case.below(quantity + ": filtered against scipy's filter, relative difference",
                   np.abs(filtered - low_pass(raw, time[1] - time[0], run.corner)).max() / np.abs(filtered).max(), 1e-6)


def check(case):
    case.curves = []
    damped = case.run()
    check_filter(case, damped)
    numbers = Numbers(damped)
    soil = numbers.material("soil")
    faster = soil.speed("P") / soil.speed("S")
    pressure = ["Motion/Angle=90", "Motion/Frequency=%.10g" % (faster * numbers.number("Motion/Frequency")),
                "Time/End time=%.6g" % (numbers.number("Time/End time") / faster)]
    undamped = ["Continuum/Rayleigh mass=0", "Continuum/Rayleigh stiffness=0"]
    for wave, overrides in (("S", []), ("P", pressure)):
        for name, more in (("damped", []), ("undamped", undamped)):
            run = damped if not overrides + more else case.run(wave + "_" + name, *overrides, *more)
            case.curves.append((wave, name, run, compare(case, wave + ", " + name, run, wave)))
    shallow = case.run("shallow", *SHALLOW, *undamped, mesh=SHALLOW_MESH)
    compare(case, "S, shallow layer", shallow, "S")
    beside = case.run("shallow_filtered", *SHALLOW, *undamped, "Time/Scheme=filtered", mesh=SHALLOW_MESH)
    compare(case, "S, shallow layer, scheme of scenes with blocks", beside, "S")


def draw(case, figure):
    axes = dict(zip("SP", figure.subplots(1, 2, sharey=True)))
    for wave, name, run, shown in case.curves:
        numbers = Numbers(run)
        soil = layers(numbers, wave)[0]
        first, colour = soil.speed / (4 * soil.thickness), {"undamped": "#1f5a94", "damped": "#d98b2b"}[name]
        f = np.linspace(0.2 * first, 5.5 * first, 600)
        axes[wave].plot(f, [abs(closed_form(numbers, wave, x)) for x in f], color=colour, lw=1, label=name + ", closed form")
        axes[wave].plot(*np.transpose(shown), "o", color=colour, ms=5, label=name + ", program")
        axes[wave].set_xlabel("frequency [Hz]")
        axes[wave].set_title(wave + " wave")
    axes["S"].set_ylabel("surface over outcrop [-]")
    axes["S"].set_ylim(0, 3)  # room for the legend
    axes["S"].legend(ncol=2, loc="upper right", fontsize=8)
