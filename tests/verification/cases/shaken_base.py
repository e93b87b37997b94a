# SPDX-License-Identifier: GPL-3.0-or-later
"""Rigid block on a plane that shakes horizontally (Newmark 1965), integrated from event to event.

With the ground's acceleration a_g (positive to the right, where the plane rises at the angle b) the block's acceleration
relative to the plane, down the slope, is

    while it slips down   g (sin b - cos b tan phi) + a_g (cos b + sin b tan phi)
    while it slips up     g (sin b + cos b tan phi) + a_g (cos b - sin b tan phi)

Down slip begins when the first becomes positive, and ends when the velocity is zero; up slip likewise when the second is negative.
"""

import os

import numpy as np
from scene_numbers import Numbers
from slope import uphill

SUBSTEPS = 20  # per step of the run


def newmark_slip(time, acceleration, numbers, surface="Blocks/Material"):
    """Slip [m] down the slope at the given times; the acceleration [m/s2] is linear between them. surface: whose friction acts."""
    g, b = numbers.gravity(), np.radians(numbers.mesh("Angle"))
    mu = np.tan(numbers.material(numbers.text(surface)).friction)
    fine = np.concatenate([np.linspace(t0, t1, SUBSTEPS, endpoint=False) for t0, t1 in zip(time, time[1:])] + [time[-1:]])
    ground = np.interp(fine, time, acceleration)
    down = g * (np.sin(b) - np.cos(b) * mu) + ground * (np.cos(b) + np.sin(b) * mu)
    up = g * (np.sin(b) + np.cos(b) * mu) + ground * (np.cos(b) - np.sin(b) * mu)
    slip, v, s = np.zeros_like(fine), 0.0, 0.0
    for k in range(len(fine) - 1):
        s, v = advance(s, v, fine[k + 1] - fine[k], (down[k], down[k + 1]), (up[k], up[k + 1]))
        slip[k + 1] = s
    return slip[::SUBSTEPS]


def advance(s, v, h, down, up):
    """Slip and velocity after a substep h, split where the block starts or stops."""
    for _ in range(8):
        sign = np.sign(v) or (1.0 if down[0] > 0 else -1.0 if up[0] < 0 else 0.0)
        if sign == 0.0:
            start = [r[0] / (r[0] - r[1]) for r, toward in ((down, 1), (up, -1)) if toward * r[1] > 0]
            if not start:
                return s, 0.0
            fraction = min(start)
        else:
            a0, a1 = down if sign > 0 else up
            end = v + 0.5 * h * (a0 + a1)
            if sign * end >= 0.0:
                return s + h * v + h * h * (2 * a0 + a1) / 6, end
            roots = np.roots([0.5 * h * (a1 - a0), h * a0, v])  # v + h (a0 x + (a1 - a0) x^2 / 2) = 0
            fraction = min(x.real for x in roots if abs(x.imag) < 1e-12 and -1e-12 < x.real <= 1 + 1e-12 and x.real > 1e-15)
            x = fraction * h
            s, v = s + x * v + x * x * (2 * a0 + a0 + fraction * (a1 - a0)) / 6, 0.0
        h *= 1.0 - fraction
        down, up = [(r[0] + fraction * (r[1] - r[0]), r[1]) for r in (down, up)]
        if h <= 0.0:
            break
    return s, v


def sine_record(path, duration=8.0, frequency=1.5, peak=5.0):
    """Ten cycles that grow and fade smoothly, as a text record of time and acceleration."""
    t = np.arange(0, duration + 1e-9, 0.001)
    np.savetxt(path, np.column_stack([t, peak * np.sin(np.pi * t / duration) ** 2 * np.sin(2 * np.pi * frequency * t)]),
               fmt="%.17g")


def slips(case, run):
    """Time, slip of the run and of the closed form down the slope [m]."""
    relative = -run.relative_displacement("block") @ uphill(run)
    time = np.concatenate([[0.0], run.time])
    ground = np.concatenate([[0.0], run.history("input/acceleration")[:, 0]])
    return run.time, relative, newmark_slip(time, ground, Numbers(run))[1:]


def check(case):
    case.curves = {}
    record = case.work / "sine.txt"
    case.work.mkdir(parents=True, exist_ok=True)
    sine_record(record)
    variants = {"earthquake": [], "sine": ["Motion/Type=text", "Motion/File=%s" % record, "Motion/Peak=as recorded"]}
    if "HYBRID_RECORD" in os.environ:  # a real record (.at2), scaled to the same peak
        variants["record"] = ["Motion/Type=at2", "Motion/File=" + os.environ["HYBRID_RECORD"], "Time/End time=35"]
    for name, overrides in variants.items():
        run = case.run("default" if not overrides else name, *overrides)
        time, found, expected = slips(case, run)
        case.curves[name] = time, found, expected
        case.near("final slip, " + name, found[-1], expected[-1], 0.01, "m")
        case.below("largest difference over final slip, " + name, np.abs(found - expected).max() / expected[-1], 0.01)


def draw(case, figure):
    for axes, (name, (time, found, expected)) in zip(figure.subplots(1, len(case.curves)), case.curves.items()):
        axes.plot(time, expected, color="0.6", linewidth=4, label="rigid block (Newmark)")
        axes.plot(time, found, color="C0", label="hybrid")
        axes.set(xlabel="time [s]", ylabel="slip down the slope [m]", title=name)
        axes.legend(loc="lower right", fontsize=7)
