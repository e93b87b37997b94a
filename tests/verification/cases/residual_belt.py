# SPDX-License-Identifier: GPL-3.0-or-later
"""Slab on a belt that softens from its peak to its residual strength with slip.

A rigid slab of the mass m per area has m s'' = m g sin t - tau(s) - the ground's motion, with tau falling linearly from the peak to the residual
over the softening slip d. Without motion and from rest this is a0/b (cosh(sqrt(b) t) - 1) up to d, and a parabola from there on.
"""

import numpy as np
from scene_numbers import Numbers
from scipy.integrate import solve_ivp
from slope import uphill


class Belt:
    """Strengths and loads of a run."""

    def __init__(self, run):
        numbers = Numbers(run)
        angle = np.radians(numbers.mesh("Angle"))
        self.sin, self.cos, self.gravity = np.sin(angle), np.cos(angle), numbers.gravity()
        rock, belt = numbers.material("rock"), numbers.material("belt")
        self.mass = rock.density * numbers.mesh("Height")  # per area of the belt [kg/m2]
        self.softening_slip = numbers.number("Blocks/Softening slip")
        self.tan = [np.tan(belt.friction), self.residual(numbers, "Residual friction angle", np.tan(belt.friction),
                                                         lambda value: np.tan(np.radians(value)))]
        self.cohesion = [belt.cohesion, self.residual(numbers, "Residual cohesion", belt.cohesion, lambda value: value)]

    @staticmethod
    def residual(numbers, name, peak, meaning):
        text = numbers.text("Materials/belt/" + name)
        return peak if text in ("same", "automatic") else meaning(float(text))

    def deceleration(self, slip, normal):
        """Strength over mass [m/s2] after some slip, under normal stress over mass [m/s2]."""
        part = np.clip(slip / self.softening_slip, 0.0, 1.0)
        tan, cohesion = ((1 - part) * peak + part * rest for peak, rest in (self.tan, self.cohesion))
        return cohesion / self.mass + tan * normal

    def closed_form(self, time):
        """Speed [m/s] and distance [m] from rest at t = 0, without motion of the ground, and when the residual is reached [s]."""
        drive, normal, d = self.gravity * self.sin, self.gravity * self.cos, self.softening_slip
        first, last = (drive - self.deceleration(slip, normal) for slip in (0.0, d))
        rate = np.sqrt((last - first) / d)
        end = np.arccosh(1 + rate**2 * d / first) / rate
        speed = first / rate * np.sinh(rate * end)
        early, since = np.minimum(time, end), np.maximum(time - end, 0.0)
        return (first / rate * np.sinh(rate * early) + last * since,
                first / rate**2 * (np.cosh(rate * early) - 1) + speed * since + 0.5 * last * since**2, end)

    def shaken(self, time, ground):
        """Speed and distance under a horizontal acceleration of the ground [m/s2], of a slab that stands at first, slides down and stops for good."""
        def net(t, slip):
            a = np.interp(t, time, ground)
            normal = self.gravity * self.cos - a * self.sin
            return self.gravity * self.sin + a * self.cos - self.deceleration(slip, normal)

        def rates(t, y):
            return net(t, y[1]), y[0]

        def stops(t, y):
            return y[0] if t > time[begin] + 0.05 else 1.0

        stops.terminal = True
        begin = int(np.argmax([net(t, 0.0) > 0 for t in time]))
        found = solve_ivp(rates, (time[begin], time[-1]), (0.0, 0.0), t_eval=time[begin:], rtol=1e-9, atol=1e-11, max_step=1e-3,
                          events=stops)
        speed, distance = np.zeros_like(time), np.full_like(time, found.y[1, -1])
        rest = begin + len(found.t)
        distance[:begin] = 0.0
        speed[begin:rest], distance[begin:rest] = found.y
        return speed, distance


def slid(run):
    """Speed [m/s] and distance [m] of the slab down the plane, relative to it."""
    ground = [run.history("monitors/ground/" + what) for what in ("velocity", "displacement")]
    return [-(run.history("monitors/slab/" + what) - of) @ uphill(run) for what, of in zip(("velocity", "displacement"), ground)]


def released(case):
    for name, overrides in (("friction and cohesion", []),
                            ("friction alone", ["Materials/belt/Cohesion=0", "Materials/belt/Residual cohesion=0"]),
                            ("cohesion alone", ["Materials/belt/Cohesion=3.5e3", "Materials/belt/Residual cohesion=1e3",
                                                "Materials/belt/Residual friction angle=same"])):
        run = case.run(name.replace(" ", "_"), *overrides)
        speed, distance, end = Belt(run).closed_form(run.time)
        found, way = slid(run)
        late = run.time > 0.2 * run.time[-1]  # the bonds of a held slab are let go over its first step
        case.near(name + ": distance", way[-1], distance[-1], 0.003, "m")
        case.below(name + ": speed, largest difference over the speed", np.abs(found / speed - 1)[late].max(), 0.003)
        case.below(name + ": energy residual", run.summary["energy_residual"], 1e-4)
        case.true(name + ": it reaches the residual at %.3f s, of %.3g s" % (end, run.time[-1]), end < 0.8 * run.time[-1])
        case.shown.append((name, run.time, found, speed))


def pushed(case):
    push = ["Gravity/Static stage=equilibrium", "Materials/belt/Friction angle=22", "Materials/belt/Cohesion=0",
            "Materials/belt/Residual cohesion=0", "Motion/Type=ricker", "Motion/Frequency=1", "Motion/Peak=3", "Time/End time=3.5"]  # a farther slide would leave the belt
    for name, residual in (("softens", "18"), ("stays", "same")):
        run = case.run("pushed_" + name, *push, "Materials/belt/Residual friction angle=" + residual)
        found, way = slid(run)
        speed, distance = Belt(run).shaken(run.time, run.history("input/acceleration")[:, 0])
        case.near("pushed, residual %s: distance" % residual, way[-1], distance[-1], 0.003, "m")
        case.below("pushed, residual %s: speed, largest difference over the largest" % residual,
                   np.abs(found - speed).max() / speed.max(), 0.003)
        case.true("pushed, residual %s: at last its speed is %.3g m/s" % (residual, found[-1]),
                  found[-1] > 1 if residual == "18" else abs(found[-1]) < 1e-6)
        case.shown.append(("pushed, residual " + residual, run.time, found, speed))


def begun_with_stress(case):
    """A belt without friction that has slid bears its cohesion and no more, whatever stress the slab began with."""
    shaken = ["Gravity/Static stage=equilibrium", "Mesh/Numbers=Angle = 20; Width = 20; Height = 10; Resolution/h = 5", "Materials/rock/Young modulus=1e9",
              "Materials/rock/Friction angle=0", "Materials/belt/Friction angle=0", "Materials/belt/Residual friction angle=same",
              "Materials/belt/Cohesion=90e3", "Materials/belt/Residual cohesion=automatic", "Blocks/Softening slip=0.02", "Monitors/Points=", "Monitors/Base=",
              "Motion/Type=sine", "Motion/Frequency=2", "Motion/Cycles=8", "Motion/Peak=3", "Time/Time step=0.004", "Time/End time=4.5"]
    slips = []
    for name in ("elastic", "0.3", "staged"):
        run = case.run("stress_" + name, *shaken, "Gravity/Initial stress=" + name)
        length = run.get("slip/length").sum()
        case.near("initial stress %s: strength per length at the end" % name, run.get("base_shear/strength")[-1] / length, 90e3, 1e-3, "Pa")
        slips.append(run.get("slip/mean")[-1])
        case.true("initial stress %s: all joints of the belt failed" % name, run.summary["joints"]["shear"] == 4)
    case.near("slip with initial stress 0.3 and with that of gravity", slips[1], slips[0], 0.01, "m")
    case.near("slip of lifts and with that of gravity", slips[2], slips[0], 0.01, "m")


def taken_over_by_contacts(case):
    """The slab slides by a third of its joints' length, from a tenth of it on held by contacts: the cohesion stays, whatever stress it began with.

    The toe leaves the belt by the slip, and bears no cohesion there.
    """
    shaken = ["Gravity/Static stage=equilibrium", "Mesh/Numbers=Angle = 16; Width = 12; Height = 2; Resolution/h = 1", "Materials/rock/Young modulus=1e9",
              "Materials/rock/Friction angle=12", "Materials/belt/Friction angle=12", "Materials/belt/Residual friction angle=same",
              "Materials/belt/Cohesion=6e3", "Materials/belt/Residual cohesion=automatic", "Materials/belt/Tensile strength=0",
              "Monitors/Points=slab: 6.11, 2.72; ground: -5, -1.8199", "Motion/Type=ricker", "Motion/Frequency=1", "Motion/Peak=4",
              "Time/Time step=0.002", "Time/End time=3.5"]
    for name in ("elastic", "0.8", "staged"):
        run = case.run("contacts_" + name, *shaken, "Gravity/Initial stress=" + name)
        _, way = slid(run)
        _, distance = Belt(run).shaken(run.time, run.history("input/acceleration")[:, 0])
        length, friction = run.get("slip/length").sum(), run.get("base_shear/normal")[-1] * np.tan(np.radians(12))
        case.near("contacts, initial stress %s: distance" % name, way[-1], distance[-1], 0.05, "m")
        case.near("contacts, initial stress %s: cohesion" % name, (run.get("base_shear/strength")[-1] - friction) / (length - way[-1]), 6e3, 0.03, "Pa")
        case.true("contacts, initial stress %s: all joints of the belt failed" % name, run.summary["joints"]["shear"] == 12)


def check(case):
    case.shown = []
    released(case)
    pushed(case)
    begun_with_stress(case)
    taken_over_by_contacts(case)


def draw(case, figure):
    for axes, chosen in zip(figure.subplots(1, 2), (case.shown[:3], case.shown[3:])):
        for name, time, found, speed in chosen:
            axes.plot(time, speed, color="0.7", lw=4)
            axes.plot(time, found, lw=1, label=name)
        axes.set_xlabel("time [s]")
        axes.set_ylabel("speed down the slope [m/s]")
        axes.legend()
