# SPDX-License-Identifier: GPL-3.0-or-later
"""Pushed block in a rising reservoir: slides from h_c = rho/rho_w H (1 - k / tan phi) on, s'' = g tan phi rho_w / (rho H) (h - h_c)."""

import numpy as np
import water_methods_figure
from scene_numbers import Numbers

HEIGHT = 1.0  # of block_level.csv [m]

shown = {}


class Pushed:
    """Closed form."""

    def __init__(self, run):
        numbers = Numbers(run)
        rock = numbers.material("rock")
        lift = numbers.number("Water/Density") / (rock.density * HEIGHT)  # part of the weight per level [1/m]
        (start, low), (self.end, high) = run.get("section/water_levels")
        self.rate = (high - low) / (self.end - start)
        self.critical = (1 - numbers.number("Gravity/Horizontal coefficient") / np.tan(rock.friction)) / lift
        self.onset = start + (self.critical - low) / self.rate
        self.jerk = numbers.gravity() * np.tan(rock.friction) * lift * self.rate  # [m/s3]

    def slip(self, time):
        sliding = np.clip(time, self.onset, self.end) - self.onset
        after = np.maximum(time - self.end, 0.0)
        last = self.end - self.onset
        return self.jerk * (sliding**3 / 6 + after * last**2 / 2 + after**2 * last / 2)


def onset(time, slip):
    """Where the straight line of the cube root of the slip between 1 and 50 mm begins [s]."""
    k = np.flatnonzero((slip > 1e-3) & (slip < 0.05))
    slope, at_zero = np.polyfit(time[k], np.cbrt(slip[k]), 1)
    return -at_zero / slope


def check(case):
    found = {}
    for method in ("submerged", "pressures"):
        run = case.run(method, "Water/Method=" + method)
        closed = Pushed(run)
        s = run.history("monitors/block/displacement")[:, 0]
        found[method] = s
        before = run.time < closed.onset - 0.01
        case.below(method + ": slip before the onset", np.abs(s[before]).max(), 1e-5, "m")
        case.within(method + ": onset, in s", onset(run.time, s), closed.onset, 0.002)
        at_end = np.searchsorted(run.time, closed.end - 1e-9)
        case.near(method + ": slip when the level stops", s[at_end], closed.slip(run.time[at_end]), 0.003, "m")
        case.near(method + ": slip at the end", s[-1], closed.slip(run.time[-1]), 0.003, "m")
        case.below(method + ": energy residual", run.summary["energy_residual"], 1e-3)
        shown[method] = run.time, s, closed.slip(run.time)
    case.below("submerged less pressures", np.abs(found["submerged"] - found["pressures"]).max(), 1e-6, "m")


def draw(case, figure):
    water_methods_figure.draw(figure, shown, "slip [m]")
