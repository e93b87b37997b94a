# SPDX-License-Identifier: GPL-3.0-or-later
"""A plane that slips in triangles of bedrock: waves above and below it, after d'Alembert (Miller 1978 with a free surface)."""

import numpy as np
from scene_numbers import Numbers

shown = {}


class Plane:
    def __init__(self, run):
        n = Numbers(run)
        rock = n.material("rock")
        self.speed = rock.speed("S")
        self.impedance = rock.density * self.speed
        self.cell, self.middle = n.mesh("Resolution/h"), n.mesh("Width") / 2  # [m]
        self.below, self.above = n.mesh("Base height"), n.mesh("Middle height") + n.mesh("Top height")  # layers [m]
        self.specific_weight = rock.density * n.gravity()
        self.normal = self.specific_weight * self.above + n.number("Bedding planes/Initial normal stress")
        self.strength = n.number("Bedding planes/Cohesion") + self.normal * np.tan(
            np.radians(n.number("Bedding planes/Friction angle")))
        self.stiffness = n.number("Bedding planes/Shear stiffness")


def closed_form(plane, time, upgoing, refine=20):
    """Times, slip [m] of the lower side against the upper one, velocity of the ground [m/s], for the wave at the base."""
    dt = (time[1] - time[0]) / refine
    t = np.arange(refine * len(time) + 1) * dt
    v_up = np.interp(t - plane.below / plane.speed, np.concatenate([[0.0], time]), np.concatenate([[0.0], upgoing]), left=0.0)
    delay = int(round(2 * plane.above / plane.speed / dt))
    rate = 2 * plane.stiffness / plane.impedance
    decay = np.exp(-rate * dt)
    lag = (1 - decay) / (rate * dt)
    stress, slip, up = np.zeros_like(t), np.zeros_like(t), np.zeros_like(t)  # up: v of the wave that leaves the plane upwards
    back = lambda i: up[i - delay] if i >= delay else 0.0
    for i in range(1, len(t)):
        v0, v1 = v_up[i - 1] - back(i - 1), v_up[i] - back(i)
        trial = stress[i - 1] * decay + plane.impedance * (v0 * (lag - decay) + v1 * (1 - lag))
        stress[i] = np.clip(trial, -plane.strength, plane.strength)
        slip[i] = slip[i - 1]
        if trial != stress[i]:
            jump = dt * (v0 + v1 - (stress[i - 1] + stress[i]) / plane.impedance)
            slip[i] += jump - (stress[i] - stress[i - 1]) / plane.stiffness
        up[i] = stress[i] / plane.impedance + back(i)
    ground = 2 * np.interp(t - plane.above / plane.speed, t, up, left=0.0)
    return t, slip, ground


def check(case):
    run = case.run()
    plane = Plane(run)
    upgoing = 0.5 * run.history("input/velocity")[:, 0]  # half the outcrop motion
    t, slip, ground = closed_form(plane, run.time, upgoing)
    normal = run.file["bedding/bedding_2/normal_stress"][0]
    case.near("normal stress at rest", normal.mean(), plane.normal, 1e-3, "Pa")
    case.below("its scatter over the weight of one row of cells (blocks of constant stress)",
               np.ptp(normal) / (plane.specific_weight * plane.cell), 0.2)
    x = run.file["bedding/bedding_2/position"][:, 0]
    points = np.abs(x - plane.middle) < 2.4 * plane.cell
    found = -run.file["bedding/bedding_2/slip"][:, points].mean(axis=1)
    audits = run.file["bedding/time"][:]
    expected = np.interp(audits, t, slip)
    case.near("range of the slip", np.ptp(found), np.ptp(expected), 0.02, "m")
    case.below("largest error of the slip over its range", np.abs(found - expected).max() / np.ptp(expected), 0.02)
    moved = run.history("monitors/ground/velocity")[:, 0]
    form = np.interp(run.time, t, ground)
    # Corners of the velocity's history, where slip begins and ends, are rounded off by the size of the blocks.
    path = run.history("monitors/ground/displacement")[:, 0]
    way = np.interp(run.time, t, np.cumsum(ground) * (t[1] - t[0]))
    case.near("peak displacement of the ground", np.abs(path).max(), np.abs(way).max(), 0.02, "m")
    case.below("largest error of the ground's displacement over its peak", np.abs(path - way).max() / np.abs(way).max(), 0.02)
    case.below("energy residual", run.summary["energy_residual"], 1e-3)
    shown.update(time=run.time, audits=audits, t=t, slip=slip, found=found, moved=moved, form=form)


def draw(case, figure):
    upper, lower = figure.subplots(2, 1, sharex=True)
    upper.plot(shown["t"], 1000 * shown["slip"], linewidth=4, alpha=0.4, label="closed form")
    upper.plot(shown["audits"], 1000 * shown["found"], "o-", markersize=3, color="C0", label="program")
    upper.set_ylabel("slip [mm]")
    upper.legend(loc="upper right")
    lower.plot(shown["time"], shown["form"], linewidth=4, alpha=0.4)
    lower.plot(shown["time"], shown["moved"], color="C0")
    lower.set_xlabel("time [s]")
    lower.set_ylabel("velocity of the ground [m/s]")
