# SPDX-License-Identifier: GPL-3.0-or-later
"""Block on an incline, rapid drawdown: T = g (rho A - rho_w A_1) sin th, N' = g (rho A - rho_w A_1) cos th - g rho_w A_2 / cos th."""

import numpy as np
import water_methods_figure
from scene_numbers import Numbers

INCLINE = np.radians(20)  # of block_incline_20.csv
LENGTH, HEIGHT = 2.0, 1.0  # of the block along and across the incline [m]
ALONG = np.array([np.cos(INCLINE), np.sin(INCLINE)])
ACROSS = np.array([-np.sin(INCLINE), np.cos(INCLINE)])

shown = {}


def area_left_of(x):
    """A_1 of the block at its first place [m2]: of a rectangle, by the widths at its corners' x."""
    corners = np.sort([(a * ALONG + b * ACROSS)[0] for a in (-LENGTH / 2, LENGTH / 2) for b in (0, HEIGHT)])
    width = min(LENGTH / np.sin(INCLINE), HEIGHT / np.cos(INCLINE))  # vertical, between the middle corners
    rising, even = corners[1] - corners[0], corners[2] - corners[1]
    r = np.clip(x - corners[0], 0, rising)
    e = np.clip(x - corners[1], 0, even)
    f = np.clip(x - corners[2], 0, rising)
    return width * (r**2 / (2 * rising) + e + f - f**2 / (2 * rising))


class Drawdown:
    """Closed form of the onset; from there a quadrature in time."""

    def __init__(self, run):
        numbers = Numbers(run)
        rock = numbers.material("rock")
        self.gravity, self.friction = numbers.gravity(), np.tan(rock.friction)
        self.ratio = numbers.number("Water/Density") / rock.density
        self.history = run.get("section/water_levels")
        self.area = LENGTH * HEIGHT

    def level(self, time):
        return np.interp(time, self.history[:, 0], self.history[:, 1])

    def area_below_level(self, time, slip):
        """A_1: left of where the level meets the line."""
        return area_left_of((self.level(time) - HEIGHT / np.cos(INCLINE)) / np.tan(INCLINE) + slip * np.cos(INCLINE))

    def acceleration(self, time, slip):
        left = self.area_below_level(time, slip) / self.area
        weight = 1 - self.ratio * left
        normal = weight * np.cos(INCLINE) - self.ratio * (1 - left) / np.cos(INCLINE)
        return self.gravity * (weight * np.sin(INCLINE) - normal * self.friction)

    def onset_area(self):
        """A_1 at which T = N' tan(phi), linear in A_1 [m2]."""
        s, c, f, r = np.sin(INCLINE), np.cos(INCLINE), self.friction, self.ratio
        return self.area * (s - f * c + r * f / c) / (r * (s - f * c + f / c))

    def onset(self):
        times = np.linspace(self.history[0, 0], self.history[-1, 0], 200001)
        return times[np.argmax(self.area_below_level(times, 0.0) < self.onset_area())]

    def slip(self, time):
        """At the times of a run, by steps of a twentieth of its (Verlet)."""
        result, s, v, t = np.zeros_like(time), 0.0, 0.0, self.onset()
        for i in range(np.searchsorted(time, t), len(time)):
            dt = (time[i] - t) / 20
            for _ in range(20):
                v += dt / 2 * self.acceleration(t, s)
                s, t = s + dt * v, t + dt
                v += dt / 2 * self.acceleration(t, s)
            result[i], t = s, time[i]
        return result


def first_beyond(time, slip, limit):
    k = np.argmax(slip > limit)
    return time[k - 1] + (limit - slip[k - 1]) / (slip[k] - slip[k - 1]) * (time[k] - time[k - 1])


def check(case):
    found = {}
    for method in ("submerged", "pressures"):
        run = case.run(method, "Water/Method=" + method)
        closed = Drawdown(run)
        u = run.history("monitors/block/displacement")
        s = -(u @ ALONG)
        found[method], expected = s, closed.slip(run.time)
        print("      onset at %.4f s, at the level %.4f m" % (closed.onset(), closed.level(closed.onset())))
        case.below(method + ": slip before the onset", np.abs(s[run.time < closed.onset() - 0.01]).max(), 1e-5, "m")
        case.within(method + ": time of 1 mm of slip", first_beyond(run.time, s, 1e-3), first_beyond(run.time, expected, 1e-3), 0.002)
        case.near(method + ": slip at the end", s[-1], expected[-1], 0.005, "m")
        late = run.time > run.time[-1] - 0.5
        a = 2 * np.polyfit(run.time[late], s[late], 2)[0]
        case.near(method + ": acceleration at last", a, closed.acceleration(1e9, s[-1]), 0.003, "m/s2")
        case.below(method + ": energy residual", run.summary["energy_residual"], 1e-3)
        shown[method] = run.time, s, expected
    case.below("submerged less pressures", np.abs(found["submerged"] - found["pressures"]).max(), 1e-6, "m")


def draw(case, figure):
    water_methods_figure.draw(figure, shown, "slip [m]")
