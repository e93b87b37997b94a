# SPDX-License-Identifier: GPL-3.0-or-later
"""A packet of P waves runs past a monitor: d'Alembert's solution from the scene's initial wave; the order in h."""

import pathlib

import numpy as np
from scene_numbers import Numbers

SCENES = pathlib.Path(__file__).resolve().parents[3] / "parameters/verification"
COARSER = 2.0

shown = {}


def packet(numbers, y, t):
    """Vertical displacement [m] at height y [m]."""
    c = numbers.material("rock").speed("P")
    k = 2 * np.pi * numbers.number("Initial wave/Frequency") / c
    length = numbers.number("Initial wave/Length") * 2 * np.pi / k
    s = y - float(numbers.text("Initial wave/Centre").split(",")[1]) - c * t
    wave = (1 + 1j * s / (k * length**2)) * np.exp(1j * k * s - s**2 / (2 * length**2))
    return (numbers.number("Initial wave/Amplitude") * wave).real


def misfit(run, numbers):
    """L2 norm of the difference over that of the closed form."""
    u = run.history("monitors/here/displacement")
    exact = packet(numbers, numbers.point("here")[1], run.time)
    return np.linalg.norm(u[:, 1] - exact) / np.linalg.norm(exact), u, exact


def check(case):
    run = case.run("default")
    numbers = Numbers(run)
    error, u, exact = misfit(run, numbers)
    h = numbers.mesh("Resolution/h")
    coarse = case.run("coarse", "Mesh/Numbers=Width = %g; Height = %g; Resolution/h = %g" % (numbers.mesh("Width"), numbers.mesh("Height"), COARSER * h))
    coarse_error, u_coarse, _ = misfit(coarse, numbers)
    case.below("L2 norm of the difference", error, 0.002)
    case.near("order in h", np.log(coarse_error / error) / np.log(COARSER), 4.0, 0.1)
    case.below("horizontal displacement over the amplitude", np.abs(u[:, 0]).max() / np.abs(exact).max(), 1e-6)
    stated = np.loadtxt(SCENES / "wave_packet.csv", delimiter=",")
    difference = np.abs(stated[:, 2] - packet(numbers, 600.0, stated[:, 0])).max()
    case.below("the file that hybrid study takes, against the formula, over the amplitude", difference / np.abs(exact).max(), 1e-6)
    shown.update(time=run.time, u=u[:, 1], exact=exact, coarse=u_coarse[:, 1], coarse_time=coarse.time, h=h)


def draw(case, figure):
    axes = figure.subplots()
    axes.plot(shown["time"], 1e3 * shown["exact"], color="#262626", lw=2.4, label="closed form")
    axes.plot(shown["coarse_time"], 1e3 * shown["coarse"], color="#e69f00", lw=1.0, ls="--", label="h = %g m" % (COARSER * shown["h"]))
    axes.plot(shown["time"], 1e3 * shown["u"], color="#0072b2", lw=1.0, ls=":", label="h = %g m" % shown["h"])
    axes.set_xlabel("time [s]")
    axes.set_ylabel("vertical displacement [mm]")
    axes.set_xlim(0.05, 0.25)
    axes.legend(loc="upper left")
    axes.set_title("packet of P waves, 300 m on its way")
