# SPDX-License-Identifier: GPL-3.0-or-later
"""Loose blocks in a stable stack do not move: Coulomb friction and unilateral contact in static equilibrium."""

import numpy as np

STEPS = (1e-3, 2e-3, 2e-4)  # s


def check(case):
    case.data = {}
    for step in STEPS:
        run = case.run() if step == 1e-3 else case.run("step_%g" % step, "Time/Time step=%g" % step)
        case.data[step] = run
        case.below("largest movement of a block at dt = %g s" % step, largest(run), 1e-6, "m")
    slope = ["Mesh/Numbers=Angle = 15; Columns = 3; Rows = 1", "Monitors/Points=foot: 1.32, 0.871"]
    case.below("largest movement of a row on 15 deg", largest(case.run("slope", *slope)), 1e-6, "m")
    slides = case.run("slides", "Materials/rock/Friction angle=14", "Gravity/Static stage=held", *slope)
    case.true("with 14 deg of friction the row slides: %.3g m" % largest(slides), largest(slides) > 0.1)


def largest(run):
    return run.get("section/blocks_peak_displacement").max()


def draw(case, figure):
    axes = figure.subplots()
    for step, run in case.data.items():
        top = np.linalg.norm(run.history("monitors/top/displacement"), axis=1)
        axes.plot(run.time, 1e9 * top, label="dt = %g s" % step)
    axes.axhline(1e3, color="0.6", label="allowed")
    axes.set(xlabel="time [s]", ylabel="displacement of the top block [nm]", yscale="symlog")
    axes.legend()
