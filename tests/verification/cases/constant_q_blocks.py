# SPDX-License-Identifier: GPL-3.0-or-later
"""Free vibration of bonded blocks with the same Q over a decade."""

import numpy as np
from constant_q_law import ConstantQ, frequency_and_ratio
from free_decay import Decay, draw_decay
from scene_numbers import Numbers

FREQUENCIES = (1.0, 2.0, 4.5, 9.0)  # of the first mode, about [Hz]

shown = {}


def column(case, name, factor, ratio, component, *more):
    """Decay of a column whose first mode is so much faster than in the scene."""
    numbers = Numbers(case.basis)
    young = numbers.material("soil").young * factor**2
    first = 1.22 * factor * (1.0 if component == 0 else 2.9)
    run = case.run(name, "Maxwell damping/Block ratio=%g" % ratio, "Materials/soil/Young modulus=%.12g" % young,
                   "Motion/Frequency=%.10g" % (0.65 * first), "Motion/Angle=%g" % (90 * component),
                   "Time/Time step=%.10g" % (0.005 / first), "Time/End time=%.10g" % (15 / first), *more)
    return run, Decay(run.time, run.history("monitors/top/displacement")[:, component], 5.0 / first, 1 / first)


def check(case):
    case.basis = case.run()
    for component, wave in ((0, "shear"), (1, "stretch")):
        _, free = column(case, wave + "_0", 1.0, 0.0, component)
        case.below(wave + ": damping ratio of the undamped column", free.ratio, 1e-5)
        for frequency in FREQUENCIES if component == 0 else FREQUENCIES[1:2]:
            for ratio in (0.05, 0.02):
                factor = frequency / free.frequency
                run, decay = column(case, "%s_%g_%g" % (wave, frequency, ratio), factor, ratio, component)
                mode, expected = frequency_and_ratio(
                    ConstantQ(Numbers(run), ratio).free_vibration(2 * np.pi * factor * free.frequency))
                name = "%s, %g %%, %g Hz: " % (wave, 100 * ratio, frequency)
                case.near(name + "damping ratio", decay.ratio, expected, 0.02)
                case.near(name + "frequency", decay.frequency, mode, 0.002, "Hz")
                case.below(name + "energy residual", run.summary["energy_residual"], 1e-3)
                case.true(name + "damping never gives energy", np.all(np.diff(run.history("energy/blocks_damping_loss")) >= 0))
                if name == "shear, 5 %, 2 Hz: ":
                    shown.update(time=run.time, u=run.history("monitors/top/displacement")[:, 0], decay=decay, ratio=expected,
                                 omega=2 * np.pi * mode)


def draw(case, figure):
    axes = figure.subplots()
    period = 2 * np.pi / shown["omega"]
    draw_decay(axes, shown["time"], shown["u"], 5 * period, shown["omega"], shown["ratio"], "constant Q")
    axes.set_xlabel("time [s]")
    axes.set_title("bonded blocks, 5 % of critical from 1 to 10 Hz")
