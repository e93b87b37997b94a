# SPDX-License-Identifier: GPL-3.0-or-later
"""Slab on a belt whose friction depends on the rate of slip: v' = g (sin t - cos t mu(v))."""

import numpy as np
from scene_numbers import Numbers
from scipy.integrate import solve_ivp
from slope import down, uphill


class Slide:
    """The closed form of a run."""

    def __init__(self, run):
        numbers = Numbers(run)
        self.angle = np.radians(numbers.mesh("Angle"))
        self.friction = np.tan(numbers.material("belt").friction)
        self.coefficient = numbers.number("Materials/belt/Friction rate coefficient")
        self.reference = numbers.number("Materials/belt/Friction reference rate")
        self.gravity = numbers.gravity()

    def mu(self, v):
        effect = self.coefficient * np.log1p(v / self.reference)
        return self.friction * (1 + effect) if self.coefficient >= 0 else self.friction / (1 - effect)

    def terminal_speed(self):
        return self.reference * np.expm1((np.tan(self.angle) / self.friction - 1) / self.coefficient)

    def history(self, time):
        """Speed [m/s] and distance [m]."""
        def rates(_, y):
            return self.gravity * (np.sin(self.angle) - np.cos(self.angle) * self.mu(max(y[0], 0.0))), y[0]

        return solve_ivp(rates, (0, time[-1]), (0.0, 0.0), t_eval=time, rtol=1e-10, atol=1e-12, method="LSODA").y


def check(case):
    case.shown = []
    for name, overrides in (("strengthening", []), ("weakening", ["Materials/belt/Friction rate coefficient=-0.02",
                                                          "Time/End time=2.2"]),  # a farther slide would leave the belt
                            ("creep", ["Materials/belt/Friction angle=19.5", "Materials/belt/Friction rate coefficient=0.01",
                                       "Materials/belt/Friction reference rate=1e-4", "Time/End time=1"])):
        run = case.run(name, *overrides)
        slide = Slide(run)
        speed, distance = slide.history(run.time)
        found = -run.history("monitors/slab/velocity") @ uphill(run)
        late = run.time > 0.2 * run.time[-1]  # the bonds of a held slab are let go over its first step
        slid = down(run, "slab")
        case.near(name + ": distance", slid[-1] - slid[late][0], distance[-1] - distance[late][0], 0.003, "m")
        case.below(name + ": speed, largest difference over the speed", np.abs(found / speed - 1)[late].max(), 0.01)
        if name == "creep":
            case.near("terminal speed of the creep", found[-100:].mean(), slide.terminal_speed(), 0.001, "m/s")
        case.below(name + ": energy residual", run.summary["energy_residual"], 1e-4)
        friction = run.history("energy/friction_loss")
        case.true(name + ": friction never gives energy", np.all(np.diff(friction) >= 0))
        case.shown.append((name, run.time, found, speed))
    check_warning(case)


def check_warning(case):
    """Ends of a soft slab's belt that reach their strength at rest are warned of, if the belt weakens."""
    at_rest = ["Gravity/Static stage=equilibrium", "Materials/rock/Young modulus=1e8", "Time/End time=0.01"]
    for name, friction, coefficient, is_told in (("weak", 21, -0.02, True), ("strong", 45, -0.02, False), ("gains", 21, 0.02, False)):
        case.run(name, *at_rest, "Materials/belt/Friction angle=%g" % friction,
                 "Materials/belt/Friction rate coefficient=%g" % coefficient)
        log = (case.work / name / "log.txt").read_text(encoding="utf-8")
        case.true(name + ": warned of slip at rest" if is_told else name + ": not warned",
                  ("the belt weakens with the rate of slip" in log) == is_told)


def draw(case, figure):
    axes = figure.subplots()
    for name, time, found, speed in case.shown[:2]:
        axes.plot(time, speed, color="0.7", lw=4, label="closed form" if name == "strengthening" else None)
        axes.plot(time, found, lw=1, label="program, " + name)
    axes.set_xlabel("time [s]")
    axes.set_ylabel("speed down the slope [m/s]")
    axes.legend()
