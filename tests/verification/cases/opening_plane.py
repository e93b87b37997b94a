# SPDX-License-Identifier: GPL-3.0-or-later
"""A bedding plane that opens in a P wave, between two half spaces and below the ground (opening_solution.py)."""

import numpy as np
from opening_solution import Plane, energy, flights, solve
from scene_numbers import Numbers

shown = {}


def rms(values):
    return np.sqrt(np.mean(values**2))


class Solution:
    """The closed form of a run, at the run's times and at heights above the plane."""

    def __init__(self, run):
        n = Numbers(run)
        self.level, self.width = n.mesh("First plane"), n.mesh("Width")
        self.height = n.mesh("Length") - self.level
        self.plane = Plane(n, self.height)
        self.time, self.arrival = run.time, self.level / self.plane.speed
        self.height_of = lambda monitor: n.point(monitor)[1] - self.level
        upgoing = 0.5 * run.history("input/velocity")[:, 1]  # half the outcrop motion
        # its times count from the wave's arrival at the plane
        self.form = solve(self.plane, np.concatenate([[0.0], run.time]), np.concatenate([[0.0], upgoing]))

    def at(self, values, distance, time=None):
        """Values at the plane that travel the distance, at the times of the run's steps."""
        time = self.time if time is None else time
        return np.interp(time - self.arrival - distance / self.plane.speed, self.form.t, values, left=0.0)


def compare(case, name, *overrides, **mesh):
    """The run, its closed form and the opening at the audits: what all variants have in common."""
    run = case.run(name, *overrides, **mesh)
    solution = Solution(run)
    plane, form, arrival = solution.plane, solution.form, solution.arrival
    audits = run.file["bedding/time"][:]
    opening = run.file["bedding/bedding_1/opening"][:].mean(axis=1)
    expected = solution.at(form.opening, 0.0, audits)
    peak = expected.max()
    stretch = (plane.rest + plane.cut_off) / plane.stiffness
    case.true(name + ": peak opening is %.0f times the elastic stretch" % (peak / stretch), peak > 5 * stretch)
    found, times = flights(audits, opening, 0.02 * peak), flights(form.t + arrival, form.opening, 0.02 * peak)
    case.true(name + ": opens %d times, closed form %d" % (len(found[0]), len(times[0])), len(found[0]) == len(times[0]) > 0)
    for k in range(len(times[0])):
        for what, mine, its in (("opens", found[0][k], times[0][k]), ("closes", found[1][k], times[1][k])):
            case.below(name + ": %s the %d. time at %.4f s, closed form %.4f s: difference" % (what, k + 1, mine, its),
                       mine - its, run.time[1] - run.time[0], "s")
        there = (audits > times[0][k]) & (audits < times[1][k])
        case.near(name + ": peak of opening %d" % (k + 1), opening[there].max(), expected[there].max(), 0.02, "m")
    case.below(name + ": largest error of the opening over its peak", np.abs(opening - expected).max() / peak, 0.02)
    normal = run.file["bedding/bedding_1/normal_stress"][:]
    case.near(name + ": normal stress at rest", normal[0].mean(), plane.rest, 1e-3, "Pa")
    case.below(name + ": largest tension after the plane opened, over N_0",
               max(0.0, -normal[audits > times[0][0] + 2e-3].min()) / plane.rest, 1e-6)
    case.near(name + ": loss", run.file["energy/bedding_loss"][-1] / solution.width, plane.loss, 0.02, "J/m2")
    static = run.file["energy/bedding_static_stress"][:] / solution.width
    released = plane.rest * solution.at(form.opening, 0.0, run.file["energy/time"][:])
    case.below(name + ": N_0 times the opening as released static stress, error over its peak",
               np.abs(static - released).max() / released.max(), 0.02)
    case.below(name + ": energy residual", run.summary["energy_residual"], 1e-6)
    return run, solution, (audits, opening, expected)


def half_spaces(case, name, *overrides):
    """The bar is so long that nothing comes back from its end before the run ends."""
    run, solution, opening = compare(case, name, *overrides)
    form, z = solution.form, solution.plane.impedance
    high, low = solution.height_of("above"), -solution.height_of("below")
    above, above_form = run.history("monitors/above/velocity")[:, 1], solution.at(form.above, high)
    reflected = run.history("monitors/below/velocity")[:, 1] - solution.at(form.up, -low)
    reflected_form = solution.at(form.below - form.up, low)
    for side, found, expected in (("transmitted", above, above_form), ("reflected", reflected, reflected_form)):
        case.near(name + ": energy " + side, energy(run.time, found, z), energy(run.time, expected, z), 0.02, "J/m2")
        case.below(name + ": error of the velocity %s over its size (root mean square)" % side,
                   rms(found - expected) / rms(expected), 0.02)
    # the closed form itself: what comes in goes out but for the loss
    case.near(name + ": closed form, energy transmitted and reflected and lost over the incident",
              energy(form.t, form.above, z) + energy(form.t, form.below - form.up, z) + solution.plane.loss,
              energy(form.t, form.up, z), 1e-3, "J/m2")
    return run, solution, opening, (above, above_form), (reflected, reflected_form)


def spall(case):
    """The plane 30 m below the ground: the slab above it is thrown up, and falls back."""
    run, solution, opening = compare(
        case, "spall", "Gravity/Acceleration=9.81", "Bedding planes/Initial normal stress=0", "Motion/Peak=20",
        "Monitors/Points=below: 5, 290; ground: 5, 330", mesh={"Length": 330})
    away, height = solution.form.away, solution.height
    # Fronts of the velocity, which run to and fro in the slab after it landed, are as wide as the cells: its path is compared.
    moved = run.history("monitors/ground/displacement")[:, 1]
    path = 2 * solution.at(np.cumsum(away) * (solution.form.t[1] - solution.form.t[0]), height)
    case.below("spall: largest error of the ground's displacement over its peak",
               np.abs(moved - path).max() / np.abs(path).max(), 0.02)
    return run, opening, (run.history("monitors/ground/velocity")[:, 1], 2 * solution.at(away, height))


def check(case):
    shown["default"] = half_spaces(case, "default")
    half_spaces(case, "soft", "Bedding planes/Normal stiffness=5e7")
    shown["spall"] = spall(case)


def draw(case, figure):
    (upper, slab), (lower, ground) = figure.subplots(2, 2, sharex="col")
    run, solution, opening, above, reflected = shown["default"]
    for axes, (audits, found, expected) in ((upper, opening), (slab, shown["spall"][1])):
        axes.plot(audits, 1000 * expected, linewidth=4, alpha=0.4, label="closed form")
        axes.plot(audits, 1000 * found, color="C0", label="program")
        axes.set_ylabel("opening [mm]")
        axes.legend(fontsize=8)
    upper.set_title("between half spaces")
    slab.set_title("30 m below the ground")
    lower.plot(run.time, solution.at(solution.form.up, 0.0), color="0.7", label="incident")
    for name, (found, expected) in (("above", above), ("reflected", reflected)):
        line = lower.plot(run.time, expected, linewidth=4, alpha=0.4)
        lower.plot(run.time, found, color=line[0].get_color(), label=name)
    lower.set_ylabel("velocity [m/s]")
    lower.legend(fontsize=8)
    run, _, (found, expected) = shown["spall"]
    ground.plot(run.time, expected, linewidth=4, alpha=0.4, color="C2")
    ground.plot(run.time, found, color="C2", label="ground")
    ground.legend(fontsize=8)
    for axes in (lower, ground):
        axes.set_xlabel("time [s]")
