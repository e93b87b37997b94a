# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies that touch nothing: the parabola, the turn of a spinning triangle, the pair of bonded squares.

Newmark's pair (beta = gamma / 2, gamma) takes from a body of masses m_i at distances r_i from its axis, held by springs alone,
the power (gamma - 1/2) dt w^4 sum m_i r_i^2: the centripetal forces at both ends of a step, weighted by 1 - gamma and gamma,
are no longer square to the chord. So w' = -b w^3 with b = (gamma - 1/2) dt sum(m_i r_i^2) / I, to first order in dt, and
1/w^2 grows by 2 b dt in a step.
"""

import numpy as np
from scene_numbers import Numbers
from vtu_file import pictures

GAMMA = {"filtered": 0.5, "dissipative": 0.6, "trapezoidal": 0.5, "shi": 1.0}  # that of what a steady turn is damped by

shown = {}


class Body:
    """What a row of Blocks/Initial velocities says."""

    def __init__(self, numbers, name):
        for entry in numbers.text("Blocks/Initial velocities").split(";"):
            key, row = entry.split(":")
            if key.strip() == name:
                values = [float(x) for x in row.split(",")]
                self.velocity, self.spin = np.array(values[4:6]), values[6]


def place(run, numbers, monitor):
    return numbers.point(monitor) + run.history("monitors/%s/displacement" % monitor)


def turn(start, arm):
    """Angle of an arm since the start [rad]; start: its first direction."""
    turned = np.unwrap(np.arctan2(arm[:, 1], arm[:, 0]))
    first = np.arctan2(start[1], start[0])
    return turned - first - 2 * np.pi * np.round((turned[0] - first) / (2 * np.pi))


def parabola(run, numbers, body, start):
    path = start + np.outer(run.time, body.velocity)
    path[:, 1] -= 0.5 * numbers.gravity() * run.time**2
    return path


def areas(run):
    """Of all blocks, per picture."""
    rows = []
    for _, picture in pictures(run.directory, "blocks"):
        outlines = [picture.points[cell] for cell in picture.cells]
        rows.append([0.5 * np.sum(p[:, 0] * np.roll(p[:, 1], -1) - np.roll(p[:, 0], -1) * p[:, 1]) for p in outlines])
    return np.array(rows)


def pair_turn(run, numbers, body, scheme):
    """Of the pair by Newmark's braking, over the steps that were taken; sums per unit square."""
    distance = 0.5 * np.linalg.norm(numbers.point("second") - numbers.point("first"))
    radial, inertia = distance**2, distance**2 + 1 / 6
    dt = run.get("steps/dt").ravel()
    slowness = 1 / body.spin**2 + 2 * (GAMMA[scheme] - 0.5) * radial / inertia * np.concatenate([[0], np.cumsum(dt**2)])
    spin = np.sign(body.spin) / np.sqrt(slowness)
    return np.cumsum(0.5 * (spin[1:] + spin[:-1]) * dt)


def check_flight(case, scheme):
    run = case.run("flight_" + scheme, "Time/Scheme=" + scheme)
    numbers = Numbers(run)
    names = scheme + ": "
    for name in ("thrown", "spinning"):
        body = Body(numbers, name)
        expected = parabola(run, numbers, body, numbers.point(name))
        found = place(run, numbers, name)
        case.below(names + name + ", off the parabola", np.abs(found - expected).max(), 1e-9, "m")
        shown[scheme, name] = found, expected
    corner = place(run, numbers, "corner") - place(run, numbers, "spinning")
    spin = Body(numbers, "spinning").spin
    angle = turn(numbers.point("corner") - numbers.point("spinning"), corner)
    case.below(names + "turn of the triangle less w t", np.abs(angle - spin * run.time).max(), 1e-6, "rad")

    body = Body(numbers, "pair")
    ends = [place(run, numbers, name) for name in ("first", "second")]
    middle = 0.5 * (numbers.point("first") + numbers.point("second"))
    case.below(names + "pair, off the parabola", np.abs(np.mean(ends, axis=0) - parabola(run, numbers, body, middle)).max(),
               1e-7, "m")
    arm = ends[1] - ends[0]
    angle = turn(numbers.point("second") - numbers.point("first"), arm)
    expected = pair_turn(run, numbers, body, scheme)
    lag = np.abs(expected - body.spin * run.time).max()
    case.below(names + "pair, turn less closed form", np.abs(angle - expected).max(), 1e-3 + 0.05 * lag, "rad")
    case.below(names + "pair, stretch", np.abs(np.linalg.norm(arm, axis=1) - np.linalg.norm(arm[0])).max(), 1e-4, "m")
    case.below(names + "energy residual", run.summary["energy_residual"], 1e-4)
    if scheme in ("filtered", "trapezoidal"):
        check_spin(case, names, run.time, angle)
    shown[scheme, "pair"] = np.mean(ends, axis=0), parabola(run, numbers, body, middle)
    shown[scheme, "pair turn"] = run.time, angle - body.spin * run.time, expected - body.spin * run.time


def check_spin(case, names, time, angle):
    """Mean spin over a tenth of a second, a thousand steps later, once the pair no longer stretches."""
    width, first = 100, 500
    spin = (angle[width:] - angle[:-width]) / (time[width:] - time[:-width])
    lost = 1 - spin[first + 1000] / spin[first]
    case.below(names + "pair, part of the spin lost in 1,000 steps", lost, 1e-6)


def check_turns(case, scheme):
    """A hundred turns of the triangle, without weight."""
    spin, time = 10 * np.pi, 20.0
    run = case.run("turns_" + scheme, "Time/Scheme=" + scheme, "Time/End time=%g" % time, "Gravity/Acceleration=0",
                   "Blocks/Initial velocities=spinning: 5, 6.2, 0, 0.9, 0, 0, %.15g" % spin)
    numbers = Numbers(run)
    corner = place(run, numbers, "corner") - place(run, numbers, "spinning")
    angle = turn(numbers.point("corner") - numbers.point("spinning"), corner)
    names = scheme + ", 100 turns: "
    case.near(names + "turn", angle[-1] / (2 * np.pi), spin * run.time[-1] / (2 * np.pi), 1e-5, "turns")
    area = areas(run)
    case.below(names + "change of area, relative", np.abs(area / area[0] - 1).max(), 1e-10)


def check(case):
    for scheme in GAMMA:
        check_flight(case, scheme)
        check_turns(case, scheme)


def draw(case, figure):
    paths, turns = figure.subplots(1, 2)
    for name, colour in (("thrown", "#1f5a94"), ("spinning", "#b5482a"), ("pair", "#3a7d44")):
        found, expected = shown["dissipative", name]
        paths.plot(found[:, 0], found[:, 1], color=colour, lw=2.5, alpha=0.6, label=name)
        paths.plot(expected[:, 0], expected[:, 1], "k--", lw=0.9)
    paths.set_title("centres, closed form dashed")
    paths.set_xlabel("x [m]")
    paths.set_ylabel("y [m]")
    paths.set_aspect("equal")
    paths.legend(fontsize=8)
    for scheme, colour in (("trapezoidal", "#3a7d44"), ("filtered", "#7a4f9a"), ("dissipative", "#1f5a94"), ("shi", "#b5482a")):
        time, found, expected = shown[scheme, "pair turn"]
        turns.plot(time, found, color=colour, lw=2.5, alpha=0.6, label=scheme)
        turns.plot(time, expected, "k--", lw=0.9)
    turns.set_title("bonded pair: turn less w t [rad]")
    turns.set_xlabel("time [s]")
    turns.legend(fontsize=8)
