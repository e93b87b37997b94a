# SPDX-License-Identifier: GPL-3.0-or-later
"""Columns of one modulus E and the heights H_i under a stiff cap of the weight W, one width w, placed in lifts. A lift without the cap
shortens each column by itself. The last one brings the cap and the weight g rho w of the columns' upper parts; with s_i the shortening
of column i under its part of that, and d that of all (the cap is stiff),

    N_i = E w/H_i (d - s_i)      sum N_i = W      sigma_i(z) = rho g (H_i - z) + N_i/w

With one lift s_i = rho g H_i^2/(2 E): gravity switched on. If the last lift is the cap alone, s_i = 0. What a block has moved since it was
placed is the sum of the shortenings below its centroid in its own lift and those after it. All sums over rows of blocks are exact.
"""

import numpy as np
from initial_stress import stresses
from scene_numbers import Numbers

shown = {}


class Columns:
    """The closed form, and the columns of a run beside it."""

    def __init__(self, case, variant, run):
        numbers, soil = Numbers(run), Numbers(run).material("soil")
        self.staged = numbers.text("Gravity/Initial stress") == "staged"
        self.w, gap, self.cap = (numbers.mesh(name) for name in ("Width", "Gap", "Cap height"))
        self.rows = [int(numbers.mesh(name)) for name in ("Outer blocks", "Middle blocks", "Outer blocks")]
        self.weight, self.young = soil.density * numbers.gravity(), soil.young
        self.top = max(self.rows) * self.w
        self.cap_weight = self.weight * self.cap * (3 * self.w + 2 * gap)
        self.lifts = int(numbers.number("Gravity/Lifts")) if self.staged else 1
        self.stress, self.moved = self.closed_form()
        where, stress = stresses(case, variant, "blocks")
        self.found = []
        for i, rows in enumerate(self.rows):
            inside = (np.abs(where[:, 0] - i * (self.w + gap) - self.w / 2) < self.w / 2) & (where[:, 1] < self.top)
            order = np.argsort(where[inside, 1])
            self.found.append(-stress[inside][order])
            assert len(order) == rows

    def bottom(self, column):
        return self.top - self.rows[column] * self.w

    def closed_form(self):
        """Vertical stress of each block of the columns from below, compression positive [Pa]; the largest displacement since placement [m]."""
        w, last, height = self.w, self.lifts - 1, self.top + self.cap
        centre = [self.bottom(i) + w * (np.arange(rows) + 0.5) for i, rows in enumerate(self.rows)]
        lift = [np.floor(c / height * self.lifts).astype(int) for c in centre]
        stress, largest = [np.zeros(rows) for rows in self.rows], 0.0
        moved = [np.zeros(rows) for rows in self.rows]
        for m in range(self.lifts):
            added = [self.of_weight(lift[i] == m) for i in range(3)]
            if m == last:
                stiffness = [self.young * w / (rows * w) for rows in self.rows]
                short = [sum(a) * w / self.young for a in added]
                together = (self.cap_weight + np.dot(stiffness, short)) / sum(stiffness)
                added = [a + k * (together - s) / w for a, k, s in zip(added, stiffness, short)]
                largest = together
            for i in range(3):
                stress[i] += added[i]
                below = (np.cumsum(added[i]) - 0.5 * added[i]) * w / self.young
                moved[i] += np.where(lift[i] <= m, below, 0)
        return stress, max(largest, max(np.abs(u).max() for u in moved))

    def of_weight(self, brought):
        """Stress of a column's blocks under the weight of those that a lift brings."""
        above = np.cumsum(brought[::-1])[::-1] - brought
        return self.weight * self.w * (above + 0.5 * brought)


def check(case):
    for name, variant, overrides in (("10 lifts", "default", ()), ("5 lifts", "five", ("Gravity/Lifts=5",)), ("2 lifts", "two", ("Gravity/Lifts=2",)),
                                     ("1 lift", "one", ("Gravity/Lifts=1",)), ("gravity switched on", "elastic", ("Gravity/Initial stress=elastic",))):
        run = case.run(variant, *overrides)
        columns = Columns(case, variant, run)
        shown[name] = columns
        largest = max(np.abs(s).max() for s in columns.stress)
        for i, place in ((0, "outer column"), (1, "middle column")):
            off = np.abs(columns.found[i][:, 1] - columns.stress[i]).max()
            case.below("%s, %s: vertical stress off, of the largest" % (name, place), off / largest, 1e-3)
        case.below("%s: outer columns differ, of the largest stress" % name, np.abs(columns.found[0] - columns.found[2])[:, :2].max() / largest, 1e-6)
        stage = run.summary["static_stage"]
        if columns.staged:
            case.near("%s: largest displacement since placement" % name, stage["largest_displacement_of_lifts_m"], columns.moved, 1e-3, "m")
            case.below("%s: what the static stage moves, over that" % name, stage["largest_displacement_m"] / columns.moved, 1e-3)
        else:
            case.near("%s: largest settlement" % name, stage["largest_displacement_m"], columns.moved, 1e-3, "m")


def draw(case, figure):
    axes = figure.subplots(1, 2, sharey=True)
    for axis, column, title in zip(axes, (0, 1), ("outer columns", "middle column")):
        for name in ("10 lifts", "5 lifts", "gravity switched on"):
            columns = shown[name]
            height = columns.bottom(column) + columns.w * (np.arange(columns.rows[column]) + 0.5)
            axis.plot(columns.stress[column] / 1e3, height, color="0.7", zorder=0)
            axis.plot(columns.found[column][:, 1] / 1e3, height, ".", label=name)
        axis.set(xlabel="vertical stress [kPa]", title=title)
    axes[0].set_ylabel("height [m]")
    axes[1].legend()
