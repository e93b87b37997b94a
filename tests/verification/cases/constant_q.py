# SPDX-License-Identifier: GPL-3.0-or-later
"""Free vibration of a continuum column with the same Q over a decade."""

import numpy as np
from constant_q_law import ConstantQ, FittedBody, frequency_and_ratio
from free_decay import Decay, draw_decay
from scene_numbers import Numbers

FREQUENCIES = (1.07, 1.5, 2.2, 3.2, 4.6, 6.7, 9.3)  # of the elastic column [Hz]; with damping they lie in the band
RATIOS = (0.05, 0.02)

shown = {}


def column(case, numbers, frequency, ratio, *more):
    """A run of a column as stiff as its first mode asks for, and its decay."""
    height, rock = numbers.mesh("Height"), numbers.material("rock")
    stiffer = (4 * height * frequency / rock.speed("P")) ** 2
    run = case.run("f%g_%g%s" % (frequency, ratio, "_" + more[0].split("=")[-1] if more else ""),
                   "Maxwell damping/Bedrock ratio=%g" % ratio, "Motion/Frequency=%.10g" % (0.65 * frequency),
                   "Materials/rock/Young modulus=%.12g" % (rock.young * stiffer), "Time/Time step=%.10g" % (0.005 / frequency),
                   "Time/End time=%.10g" % (15 / frequency), *more)
    begin = 5.0 / frequency  # the pulse lasts 3 periods of its own
    return run, Decay(run.time, run.history("monitors/top/displacement")[:, 1], begin, 1 / frequency)


def check(case):
    shown["points"] = []
    numbers = Numbers(case.run())
    for ratio in RATIOS:
        for frequency in FREQUENCIES:
            run, decay = column(case, numbers, frequency, ratio)
            law = ConstantQ(Numbers(run), ratio)
            mode, expected = frequency_and_ratio(law.free_vibration(2 * np.pi * frequency))
            name = "%g %%, %g Hz: " % (100 * ratio, frequency)
            case.near(name + "damping ratio", decay.ratio, expected, 0.02)
            case.near(name + "frequency", decay.frequency, mode, 0.004, "Hz")
            exact, own = frequency_and_ratio(FittedBody(Numbers(run), ratio).free_vibration(2 * np.pi * frequency))
            case.near(name + "frequency by the branches themselves", decay.frequency, exact, 0.0005, "Hz")
            case.near(name + "damping ratio by the branches themselves", decay.ratio, own, 0.005)
            case.below(name + "energy residual", run.summary["energy_residual"], 1e-9)
            losses = run.history("energy/bedrock_damping_loss")
            case.true(name + "damping never gives energy", np.all(np.diff(losses) >= 0))
            shown["points"].append((ratio, frequency, decay.frequency, decay.ratio, mode, expected))
    for scheme in ("filtered", "trapezoidal", "dissipative"):
        run, decay = column(case, numbers, 2.2, 0.05, "Time/Scheme=" + scheme)
        case.below(scheme + ": energy residual", run.summary["energy_residual"], 1e-9)
        if scheme != "dissipative":  # it damps by itself, 0.05 w dt
            mode, expected = frequency_and_ratio(ConstantQ(Numbers(run), 0.05).free_vibration(2 * np.pi * 2.2))
            case.near(scheme + ": damping ratio", decay.ratio, expected, 0.02)


def draw(case, figure):
    left, right = figure.subplots(1, 2)
    f = np.geomspace(0.3, 33, 200)
    for ratio, colour in zip(RATIOS, ("#1f5a94", "#d98b2b")):
        rows = np.array([row[1:] for row in shown["points"] if row[0] == ratio])
        left.semilogx(rows[:, 0], 100 * rows[:, 4], "--", color=colour, lw=1, label="constant Q, %g %%" % (100 * ratio))
        left.semilogx(rows[:, 0], 100 * rows[:, 2], "o", color=colour, ms=4, label="program")
        right.semilogx(rows[:, 0], rows[:, 3] / rows[:, 0], "--", color=colour, lw=1)
        right.semilogx(rows[:, 0], rows[:, 1] / rows[:, 0], "o", color=colour, ms=4)
    left.set_ylim(0, 7)
    left.set_ylabel("damping ratio [%]")
    left.legend(fontsize=8)
    right.set_ylabel("frequency over that of the elastic column [-]")
    for axes in (left, right):
        axes.set_xlabel("frequency of the elastic column [Hz]")
