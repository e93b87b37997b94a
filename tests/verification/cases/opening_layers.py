# SPDX-License-Identifier: GPL-3.0-or-later
"""Layers thrown up from their bedding planes: masses on springs that carry no tension once they broke."""

import numpy as np
from matrix_exponential import exponential
from opening_solution import cut_off, flights
from scene_numbers import Numbers

shown = {}


class Layers:
    """The n layers between the run's planes, plane i below layer i (from below); the base moves linearly between the samples.

    Each plane is closed (spring, rest included at u = 0) or open; while all stay as they are the motion is linear and its
    steps are exact.
    """

    def __init__(self, run, refine=10):
        numbers = Numbers(run)
        rock, width = numbers.material("rock"), numbers.mesh("Width")
        heights = np.array([numbers.mesh("Middle height"), numbers.mesh("Top height")])
        self.names = [name for name in ("bedding_2", "bedding_1") if name in numbers.text("Bedding planes/Names")]
        if len(self.names) == 1:  # the other plane is welded
            heights = heights.sum(keepdims=True)
        self.n, self.refine = len(self.names), refine
        self.rest = rock.density * numbers.gravity() * np.cumsum(heights[::-1])[::-1]
        self.stiffness = numbers.number("Bedding planes/Normal stiffness")
        self.cut_off = np.full(self.n, cut_off(numbers))
        self.loss = width * np.sum(self.cut_off**2) / (2 * self.stiffness)  # when all have broken [J/m]
        self.mass = rock.density * heights
        self.dashpots = 2 * heights * rock.density * rock.speed("S") / width
        self.steps = {}

    def jumps(self, x):
        """Of the planes, from the state u_1 ... u_n, v_1 ... v_n, u_b, u_b', and the pull of each open plane."""
        return np.diff(np.concatenate([[x[2 * self.n]], x[: self.n]]))

    def step(self, is_open, dt):
        n = self.n
        if is_open not in self.steps:
            a = np.zeros((3 * n + 2, 3 * n + 2))
            a[:n, n : 2 * n] = np.eye(n)
            a[n : 2 * n, n : 2 * n] = -np.diag(self.dashpots / self.mass)
            a[2 * n, 2 * n + 1] = 1
            for i in range(n):
                pull = np.zeros(3 * n + 2)  # traction of plane i, of the state
                if is_open[i]:
                    pull[2 * n + 2 + i] = 1
                else:
                    pull[i] = self.stiffness
                    pull[i - 1 if i > 0 else 2 * n] = -self.stiffness
                a[n + i] -= pull / self.mass[i]
                if i > 0:
                    a[n + i - 1] += pull / self.mass[i - 1]
            self.steps[is_open] = exponential(a * dt)
        return self.steps[is_open]

    def history(self, time, base):
        """Times of the substeps, openings [m] and tractions (tension positive) [Pa] of the planes at them."""
        n, dt = self.n, (time[1] - time[0]) / self.refine
        x, is_open, result = np.zeros(3 * n + 2), (False,) * n, []
        x[2 * n + 2 :] = self.rest
        for u0, u1 in zip(np.concatenate([[0.0], base[:-1]]), base):
            x[2 * n : 2 * n + 2] = u0, (u1 - u0) / (self.refine * dt)
            for _ in range(self.refine):
                x = self.step(is_open, dt) @ x
                traction = self.stiffness * self.jumps(x) - self.rest
                self.cut_off[traction > self.cut_off] = 0.0  # broken
                is_open = tuple((traction > 0) & (self.cut_off == 0))
                result.append((traction * is_open / self.stiffness, traction * np.logical_not(is_open)))
        openings, tractions = (np.array(part) for part in zip(*result))
        return time[0] + dt * np.arange(1 - self.refine, len(result) + 1 - self.refine), openings, tractions


def compare(case, name, count, *overrides, **mesh):
    """A run and its closed form: the first flights of each plane, count of them."""
    run = case.run(name, *overrides, **mesh)
    audits = run.file["bedding/time"][:]
    step = audits[1] - audits[0]
    layers = Layers(run)
    time, openings, tractions = layers.history(run.time, run.history("input/displacement")[:, 1])
    shown[name] = []
    for i, plane in enumerate(layers.names):
        label = "%s, %s" % (name, plane)
        at = lambda values: np.interp(audits, time, values)
        normal = run.file["bedding/%s/normal_stress" % plane][:].mean(axis=1)
        case.near(label + ": normal stress at rest", normal[0], layers.rest[i], 1e-3, "Pa")
        # the weight on the points of the plane varies a little: half of them are open
        found = np.median(run.file["bedding/%s/opening" % plane][:], axis=1)
        form = openings[:, i]
        shown[name].append((plane, audits, found, time, form))
        least = 0.02 * form.max()
        mine, its = flights(audits, found, least), flights(time, form, least)
        case.true(label + ": flies %d times or more, closed form %d times" % (min(len(mine[0]), len(its[0])), len(its[0])),
                  min(len(mine[0]), len(its[0])) >= count)
        expected = at(form)
        for k in range(count):
            for what, a, b in (("parts", mine[0][k], its[0][k]), ("lands", mine[1][k], its[1][k])):
                case.below(label + ": flight %d %s at %.4f s, closed form %.4f s: difference" % (k + 1, what, a, b), a - b, step,
                           "s")
            there = (audits > its[0][k]) & (audits < its[1][k])
            case.near(label + ": peak opening of flight %d" % (k + 1), found[there].max(), expected[there].max(), 0.02, "m")
        landed = its[1][count - 1]
        until = audits < landed
        case.below(label + ": largest error of the opening over its peak",
                   np.abs(found - expected)[until].max() / form.max(), 0.02)
        for k in range(count if count > 1 else 0):
            after = (audits > its[1][k]) & (audits < its[1][k] + 0.06)
            case.near(label + ": largest stress of landing %d" % (k + 1), normal[after].max(),
                      -at(tractions[:, i])[after].min(), 0.02, "Pa")
    # over all that is exchanged in the run: in its first steps the terms are round-off of the static load
    terms = [np.abs(data[:]) for key, data in run.file["energy"].items() if key not in ("time", "residual")]
    total = np.maximum.accumulate(sum(terms))
    case.below(name + ": energy that is missing over the energy exchanged",
               (run.file["energy/residual"][:] * total).max() / total[-1], 1e-3)
    case.near(name + ": loss", run.file["energy/bedding_loss"][-1], layers.loss, 0.02, "J/m")


def check(case):
    compare(case, "default", 1)
    compare(case, "steps of 0.1 ms", 2, "Time/Time step=1e-4", "Time/End time=1.8")
    compare(case, "two layers", 1, "Bedding planes/Names=bedding_1, bedding_2", mesh={"Middle height": 5, "Top height": 5})


def draw(case, figure):
    for axes, (name, planes) in zip(figure.subplots(3, 1, sharex=True), shown.items()):
        for k, (plane, audits, found, time, form) in enumerate(planes):
            axes.plot(time, 1000 * form, linewidth=4, alpha=0.4, color="C%d" % k, label="%s, closed form" % plane)
            axes.plot(audits, 1000 * found, color="C%d" % k, label="program")
        axes.set_title(name, fontsize=9)
        axes.set_ylabel("opening [mm]")
        axes.legend(fontsize=7)
    axes.set_xlabel("time [s]")
