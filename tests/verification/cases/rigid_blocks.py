# SPDX-License-Identifier: GPL-3.0-or-later
"""Limit analysis of rigid blocks on dry joints (Livesley 1978): pressures at both ends of each straight joint and one shear along it balance the
weights (density and gravity 1) and a part of them that pushes to the right. A linear programme, if friction dilates (association).

Without dilation (Gilbert, Casapulla & Ahmed 2006) the shear of a joint is bounded by mu times what pressed it in the programme before, as if by
cohesion, and the programme is solved again until nothing changes.
"""

import numpy as np
import scipy.optimize

ALMOST_NONE = 0.01  # of mu: what stays of the slope of the bound, with the other sign
ROUNDS, SHARE = 40, 0.6  # of programmes, and of the new pressures in the next bound
LEAST = 1e-4  # of a block's weight: pressure behind a bound, so that joints that nothing presses may be pressed in the next programme


def area_and_centre(polygon):
    x, y = polygon.T
    cross = x * np.roll(y, -1) - np.roll(x, -1) * y
    area = cross.sum() / 2
    return area, np.array([((x + np.roll(x, -1)) * cross).sum(), ((y + np.roll(y, -1)) * cross).sum()]) / (6 * area)


class Assembly:
    def __init__(self, polygons, joints):
        """joints: (block, other or None for the ground, two ends), the block on the left of the way from the first end to the second."""
        self.count, n = len(joints), len(polygons)
        self.balance, self.push, self.weight = np.zeros((3 * n, 3 * self.count)), np.zeros(3 * n), np.zeros(3 * n)
        for b, polygon in enumerate(polygons):
            area, centre = area_and_centre(polygon)
            self.weight[3 * b + 1], self.weight[3 * b + 2] = area, area * centre[0]
            self.push[3 * b], self.push[3 * b + 2] = area, -area * centre[1]
        for j, (block, other, ends) in enumerate(joints):
            along = (ends[1] - ends[0]) / np.linalg.norm(ends[1] - ends[0])
            into = np.array([-along[1], along[0]])
            for part, (place, force) in enumerate(((ends[0], into), (ends[1], into), (ends[0], along))):
                row = np.array([*force, place[0] * force[1] - place[1] * force[0]])
                for body, sign in ((block, 1), (other, -1)):
                    if body is not None:
                        self.balance[3 * body : 3 * body + 3, 3 * j + part] += sign * row

    def _programme(self, slope, bounds, push=None):
        """The largest push, and the pressure on each joint; None if there is no balance. |T| <= slope N + bound. push: if it is given."""
        rows = np.zeros((2 * self.count, 3 * self.count + 1))
        for j in range(self.count):
            for k, sign in enumerate((1, -1)):
                rows[2 * j + k, 3 * j : 3 * j + 3] = -slope, -slope, sign
        limits = [(0, None), (0, None), (None, None)] * self.count + [(0, None) if push is None else (push, push)]
        goal = np.append(np.zeros(3 * self.count), -1)
        found = scipy.optimize.linprog(goal, rows, np.repeat(bounds, 2), np.column_stack([self.balance, self.push]), self.weight, limits,
                                       method="highs")
        if found.status != 0:
            return None
        return found.x[-1], found.x[0:-1:3] + found.x[1:-1:3]

    def bears(self, mu, push=0.0):
        """Whether there are forces in balance."""
        return self._programme(mu, np.zeros(self.count), push) is not None

    def largest_push(self, mu):
        """Part of the weights, by association: what friction bears is not more."""
        return self._programme(mu, np.zeros(self.count))[0]

    def largest_push_without_dilation(self, mu):
        push, pressure = self._programme(mu, np.zeros(self.count))
        least = LEAST * self.weight[1::3].mean()
        pressure = np.maximum(pressure, least)
        for k in range(ROUNDS):
            push, now = self._programme(-ALMOST_NONE * mu, (1 + ALMOST_NONE) * mu * pressure)
            pressure = np.maximum(now if k == 0 else SHARE * now + (1 - SHARE) * pressure, least)
        return push
