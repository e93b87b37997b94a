# SPDX-License-Identifier: GPL-3.0-or-later
"""A slab of rock on a Coulomb joint with stiffness over a half space of the same rock, in an S wave from below.

With the upgoing wave v_up below the joint, the wave d that comes back from the free top above it (d = u a way up and down ago,
u the upgoing one there) and Z = rho c: the slab moves with 2 d - tau/Z at the joint, the half space with 2 v_up + tau/Z. The
jump's rate, 2 (d - v_up - tau/Z), is (d tau/dt)/k_s plus the slip rate; tau stays within the strength sigma tan(phi) + c.
"""

import numpy as np
from scene_numbers import Numbers

shown = {}


class Slab:
    def __init__(self, run):
        n = Numbers(run)
        rock, plane = n.material("rock"), "Bedding planes/"
        self.speed = rock.speed("S")
        self.impedance = rock.density * self.speed
        self.stiffness = n.number(plane + "Shear stiffness")
        self.below, self.thickness = n.mesh("First plane"), n.mesh("Length") - n.mesh("First plane")
        self.normal = n.number(plane + "Initial normal stress") + rock.density * n.gravity() * self.thickness
        self.strength = n.number(plane + "Cohesion") + self.normal * np.tan(np.radians(n.number(plane + "Friction angle")))

    def response(self, time, velocity, refine=20):
        """Slip and the motion of the top for the upgoing velocity at the base; exact exponential steps of the spring."""
        t = np.linspace(time[0], time[-1], refine * (len(time) - 1) + 1)
        dt, z = t[1] - t[0], self.impedance
        upgoing = np.interp(t - self.below / self.speed, time, velocity, left=0.0)
        rate = 2 * self.stiffness / z
        decay = np.exp(-rate * dt)
        lag = (1 - decay) / (rate * dt)
        stress, slip, within, back = (np.zeros_like(t) for _ in range(4))  # within, back: u and d
        way = 2 * self.thickness / self.speed / dt
        for i in range(1, len(t)):
            whole = int(np.floor(i - way))
            if whole >= 0:
                part = i - way - whole
                back[i] = (1 - part) * within[whole] + part * within[whole + 1]
            v0, v1 = back[i - 1] - upgoing[i - 1], back[i] - upgoing[i]
            trial = stress[i - 1] * decay + z * (v0 * (lag - decay) + v1 * (1 - lag))
            stress[i] = np.clip(trial, -self.strength, self.strength)
            slip[i] = slip[i - 1]
            if trial != stress[i]:
                jump = dt * (v0 + v1 - (stress[i - 1] + stress[i]) / z)
                slip[i] += jump - (stress[i] - stress[i - 1]) / self.stiffness
            within[i] = back[i] - stress[i] / z
        top = 2 * np.interp(t - self.thickness / self.speed, t, within, left=0.0)
        return t, slip, top


def measured(run, component):
    """Histories of the plane's slip (all points) and of the top."""
    return run.file["bedding/bedding_1/slip"][:], run.history("monitors/top/velocity")[:, component]


def check_triangles(case):
    """Bedrock of triangles: slip, and elastic planes (a strength that nothing reaches)."""
    elastic = ["Bedding planes/Strength=elastic", "Bedding planes/Shear stiffness=1.5e8"]
    for name, variant, settings in (("triangles", "triangles", []), ("triangles, elastic plane of 1.5e8 Pa/m", "elastic_triangles", elastic)):
        run = case.run(variant, "Model/Bedrock=triangles", *settings, mesh={"Resolution/h": 5.0})
        expected = Slab(run)
        if settings:
            expected.strength = np.inf
        t, slip, top = expected.response(run.time, upgoing_of(run))
        closed, found = np.interp(run.time, t, top), run.history("monitors/top/velocity")[:, 0]
        case.below(name + ": velocity of the top: root mean square of the error over that of the history",
                   np.sqrt(np.mean((found - closed) ** 2) / np.mean(closed**2)), 0.002 if settings else 0.015)
        if not settings:
            found_slip = measured(run, 0)[0]
            largest = np.abs(slip).max()
            case.near(name + ": slip that is left", found_slip[-1].mean(), slip[-1], 0.005, "m")
            case.below(name + ": history of slip: largest error over the peak",
                       np.abs(found_slip.mean(axis=1) - np.interp(run.file["bedding/time"][:], t, slip)).max() / largest, 0.01)


def check_monitors_on_the_plane(case):
    """A monitor on the plane moves with the rock above it, a millimetre above, not with that below."""
    for bedrock in ("continuum", "triangles"):
        run = case.run("monitors_" + bedrock, "Model/Bedrock=" + bedrock, "Time/End time=0.6",
                       "Monitors/Points=top: 0, 150; on: 15, 100; above: 15, 100.001; below: 15, 99.999")
        on, above, below = (run.history("monitors/%s/displacement" % name)[:, 0] for name in ("on", "above", "below"))
        apart = np.abs(above - below).max()
        case.true("%s: both sides of the plane part, by %.2g m" % (bedrock, apart), apart > 1e-5)
        case.below("%s: monitor on the plane, difference to the rock above over that" % bedrock, np.abs(on - above).max() / apart, 0.01)


def upgoing_of(run):
    return 0.5 * run.file["input/velocity"][: len(run.time), 0]  # half the outcrop motion


def check(case):
    run = case.run("default")
    slab = Slab(run)
    slip, top = measured(run, 0)
    t, expected_slip, expected_top = slab.response(run.time, upgoing_of(run))
    slip_time = run.file["bedding/time"][:]
    mean = slip.mean(axis=1)
    largest = expected_slip[np.argmax(np.abs(expected_slip))]
    case.near("slip that is left", mean[-1], expected_slip[-1], 0.005, "m")
    case.near("largest slip", mean[np.argmax(np.abs(mean))], largest, 0.005, "m")
    case.below("history of slip: largest error over the peak",
               np.abs(mean - np.interp(slip_time, t, expected_slip)).max() / abs(largest), 0.01)
    closed = np.interp(run.time, t, expected_top)
    case.below("velocity of the top: root mean square of the error over that of the history",
               np.sqrt(np.mean((top - closed) ** 2) / np.mean(closed**2)), 0.015)
    case.below("the plane's points: largest difference over the slip", np.ptp(slip, axis=1).max() / abs(largest), 1e-6)
    case.below("energy residual", run.summary["energy_residual"], 1e-6)
    shown.update(t=t, slip=expected_slip, top=expected_top, slip_time=slip_time, mean=mean, time=run.time, found=top)

    def like(name, other, component, sign=1.0):
        other_slip, other_top = measured(other, component)
        case.below(name + ": slip, largest difference over the peak",
                   np.abs(other_slip.mean(axis=1) - sign * mean).max() / abs(largest), 1e-6)
        case.below(name + ": velocity of the top, likewise", np.abs(other_top - sign * top).max() / np.abs(top).max(), 1e-6)

    like("box of 400 m", case.run("wide", mesh={"Width": 400.0}), 0)
    like("mirrored", case.run("mirrored", "Motion/Angle=180"), 0, -1.0)
    # The bar's tangent runs up, along the motion, and the half space is to its left: the slip's sign turns.
    bar = case.run("bar", "Continuum/Sides=roller", "Motion/Angle=90", "Gravity/Acceleration=0",
                   "Bedding planes/Initial normal stress=%.15g" % slab.normal, "Monitors/Points=top: 150, 0", mesh={"Lying": 1.0})
    bar_slip, bar_top = measured(bar, 1)
    case.below("bar between rollers: slip", np.abs(bar_slip.mean(axis=1) + mean).max() / abs(largest), 1e-6)
    case.below("bar between rollers: velocity of the top", np.abs(bar_top - top).max() / np.abs(top).max(), 1e-6)
    check_triangles(case)
    check_monitors_on_the_plane(case)


def draw(case, figure):
    upper, lower = figure.subplots(2, 1, sharex=True)
    upper.plot(shown["time"], shown["found"], label="program, box of 20 m")
    upper.plot(shown["t"], shown["top"], "k--", lw=0.8, label="closed form")
    upper.set_ylabel("velocity of the top [m/s]")
    upper.legend(loc="upper right")
    lower.plot(shown["slip_time"], 1e3 * shown["mean"], label="program, box of 20 m")
    lower.plot(shown["t"], 1e3 * shown["slip"], "k--", lw=0.8, label="closed form")
    lower.set_xlabel("time [s]")
    lower.set_ylabel("slip [mm]")
    lower.legend(loc="lower right")
    figure.suptitle("Level ground slides on a bedding plane")
