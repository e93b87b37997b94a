# SPDX-License-Identifier: GPL-3.0-or-later
"""Toppling columns on a stepped base: limit equilibrium from the crest to the foot (Goodman & Bray 1976, Wyllie & Mah 2004).

Column n, counted from the foot, of height y, width dx and weight W on a base that dips by psi out of the slope passes on to the next one below the larger of

    topples:  P' = (P (M - dx mu) + W/2 (y sin psi - dx cos psi)) / L          slides:  P' = P - W (mu cos psi - sin psi) / (1 - mu^2)

mu = tan phi on all surfaces, M and L the heights above the base at which P comes in and P' goes out (top corners of the lower neighbour's side).
Nothing passes where a column without a push stands. The slope is at its limit where the foot needs no support.
"""

import numpy as np
from scene_numbers import Numbers

MARGIN = 0.02  # of tan(phi), on either side of the limit
CUTS = 7  # bisections of the bracket, for the page
PUBLISHED = 0.7855  # tan(phi) at the limit (Wyllie & Mah 2004, chapter 9)
WEAK = 0.95  # of the limit: the columns move for a second
TURNED = np.radians(0.05)  # more is toppling


class Columns:
    """Heights from foot to crest and steps of the base, of the polygons of a run."""

    def __init__(self, run):
        numbers = Numbers(run)
        polygons = run.blocks.polygons
        self.height = np.array([np.ptp(p[:, 1]) for p in polygons])
        self.width = np.ptp(polygons[0][:, 0])
        foot = np.array([p[:, 1].min() for p in polygons])
        self.top, self.foot = foot + self.height, foot
        self.psi = np.arctan(-numbers.number("Gravity/Horizontal coefficient"))
        gravity = numbers.gravity() / np.cos(self.psi)
        self.weight = numbers.material("rock").density * gravity * self.width * self.height

    def forces(self, mu):
        """Forces on each column's lower side [N/m], and how it moves."""
        push, forces, modes = 0.0, np.zeros(len(self.height)), [""] * len(self.height)
        for n in reversed(range(len(self.height))):
            forces[n], modes[n] = self._column(n, push, mu)
            push = forces[n]
        return forces, modes

    def _column(self, n, push, mu):
        s, c, y, w = np.sin(self.psi), np.cos(self.psi), self.height[n], self.weight[n]
        if push == 0 and y * s < self.width * c and mu > s / c:
            return 0.0, "stands"
        above = self.top[n + 1] if n + 1 < len(self.top) else self.top[n]
        below = self.top[n - 1] if n > 0 else self.foot[n]
        into, out = min(above, self.top[n]) - self.foot[n], min(below, self.top[n]) - self.foot[n]
        moment = push * (into - self.width * mu) + w / 2 * (y * s - self.width * c)
        topples = moment / out if out > 0 else (np.inf if moment > 0 else -np.inf)
        slides = push - w * (mu * c - s) / (1 - mu * mu)
        best = max(topples, slides, 0.0)
        return best, "stands" if best == 0 and max(topples, slides) < 0 else "topples" if topples > slides else "slides"

    def limit(self):
        """tan(phi) at which the foot needs no support."""
        low, high = 0.6, 0.95
        for _ in range(60):
            middle = 0.5 * (low + high)
            low, high = (middle, high) if self.forces(middle)[0][0] > 0 else (low, middle)
        return high


def with_friction(mu):
    return "Materials/rock/Friction angle=%.12g" % np.degrees(np.arctan(mu))


def stands(case, mu):
    """Whether the static stage finds equilibrium."""
    run = case.run("mu_%.6f" % mu, with_friction(mu), "Gravity/Static stage=equilibrium or move")
    return run.summary["static_stage"]["equilibrium"]


def turns(run):
    """By how much each column has turned to the left [rad]."""
    angle = lambda p: np.arctan2(p[1, 1] - p[0, 1], p[1, 0] - p[0, 0])
    return np.array([angle(now) - angle(first) for first, now in zip(run.blocks.polygons, run.blocks.final_polygons)])


def check(case):
    columns = case.columns = Columns(case.run())
    limit = case.limit = columns.limit()
    case.near("tan(phi) of limit equilibrium as published", limit, PUBLISHED, 1e-3)
    low, high = (1 - MARGIN) * limit, (1 + MARGIN) * limit
    case.true("tan(phi) = %.4f, %g %% above limit equilibrium: it stands" % (high, 100 * MARGIN), stands(case, high))
    case.true("tan(phi) = %.4f, %g %% below: it does not" % (low, 100 * MARGIN), not stands(case, low))
    for _ in range(CUTS):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if stands(case, middle) else (middle, high)
    case.near("tan(phi) at the limit, within %.2g" % (high - low), 0.5 * (low + high), limit, MARGIN)
    run = case.moved = case.run("moves", with_friction(WEAK * limit), "Gravity/Static stage=none", "Time/End time=1")
    modes = np.array(columns.forces(limit)[1])
    turned, moved = np.abs(turns(run)) > TURNED, np.abs(run.blocks.displacement).max(axis=1) > 1e-2
    case.true("columns that turn: %s" % (np.flatnonzero(turned) + 1), np.array_equal(turned, modes == "topples"))
    case.true("columns that slide without turning: %s" % (np.flatnonzero(moved & ~turned) + 1),
              np.array_equal(moved & ~turned, modes == "slides"))


def draw(case, figure):
    from matplotlib.patches import Polygon

    left, right = figure.subplots(1, 2, width_ratios=(1.6, 1))
    psi, colours = case.columns.psi, {"stands": "0.8", "slides": "C1", "topples": "C0"}
    turn = np.array([[np.cos(psi), np.sin(psi)], [-np.sin(psi), np.cos(psi)]])  # the section as it is in the ground
    forces, modes = case.columns.forces(case.limit)
    for first, now, mode in zip(case.moved.blocks.polygons, case.moved.blocks.final_polygons, modes):
        left.add_patch(Polygon((first + 20 * (now - first)) @ turn, facecolor=colours[mode], edgecolor="k", linewidth=0.6))
    for mode, colour in colours.items():
        left.fill([], [], color=colour, label=mode + " (limit equilibrium)")
    left.set(aspect="equal", xlabel="x [m]", ylabel="y [m]", title="5 % too weak, after 1 s, 20 times as large")
    left.autoscale()
    left.legend(fontsize=8)
    right.barh(np.arange(1, len(forces) + 1), 1e-6 * forces, color=[colours[mode] for mode in modes])
    right.set(ylabel="column, from the foot", xlabel="push on the next one [MN/m]", title="limit equilibrium")
