# SPDX-License-Identifier: GPL-3.0-or-later
"""Newmark's (1965) rigid block on a moving surface: exact for an acceleration that is linear between its samples.

The driving acceleration a(t) is that of the ground, positive where it drives the block downhill (a ground that accelerates uphill).
While the block slides downhill its relative acceleration is s'' = rate (a - critical), uphill s'' = rate (a + uphill); it sticks
where neither limit is passed. Rate is 1 for a block on a level surface and cos(b - phi) / cos(phi) for one on a slope b.
"""

import numpy as np

PHASES = 8  # stops and starts within a step; more than four cannot be


def rate_on_slope(slope, friction):
    """Acceleration of a slide along a slope over that of the ground above the critical one [-]; angles [rad]."""
    return np.cos(slope) + np.sin(slope) * np.tan(friction)


def _first_root(speed, excess, growth, limit):
    """Smallest time > 0 at which speed + excess t + growth t^2 / 2 vanishes, inf if none within the limit. Arrays, speed >= 0."""
    with np.errstate(divide="ignore", invalid="ignore"):
        root = np.sqrt(np.maximum(excess**2 - 2 * growth * speed, 0.0))
        solvable = excess**2 >= 2 * growth * speed
        # the stable pair: q / growth and 2 speed / q (over 2)
        q = -(excess + np.where(excess < 0, -root, root))
        first, second = q / growth, 2 * speed / q
    tiny = 1e-14 * limit  # the start itself is no stop
    times = np.stack([np.where(solvable & np.isfinite(t) & (t > tiny), t, np.inf) for t in (first, second)])
    nearest = times.min(axis=0)
    return np.where(nearest <= limit, nearest, np.inf)


class _Blocks:
    """Blocks with different limits, driven by one acceleration."""

    def __init__(self, critical, uphill, rate):
        self.critical, self.uphill, self.rate = np.broadcast_arrays(*(np.asarray(v, float) for v in (critical, uphill, rate)))
        self.speed, self.slip = np.zeros(self.critical.shape), np.zeros(self.critical.shape)

    def rest_through(self, low, high):
        """Whether nothing moves while the acceleration stays between two values."""
        return not self.speed.any() and high <= self.critical.min() and -low <= self.uphill.min()

    def step(self, start, end, dt):
        """From one sample to the next [m/s2], [s]."""
        slope = (end - start) / dt
        left = np.full(self.speed.shape, float(dt))
        for _ in range(PHASES):
            now = end - slope * left  # at the beginning of what is left
            down = (self.speed > 0) | ((self.speed == 0) & ((now > self.critical) | ((now == self.critical) & (slope > 0))))
            up = (self.speed < 0) | ((self.speed == 0) & ((now < -self.uphill) | ((now == -self.uphill) & (slope < 0))))
            sign = np.where(down, 1.0, np.where(up, -1.0, 0.0))
            limit = np.where(down, self.critical, self.uphill)
            excess = np.where(sign != 0, self.rate * (sign * now - limit), 0.0)
            growth = self.rate * sign * slope
            moving = _first_root(sign * self.speed, excess, growth, left)
            with np.errstate(divide="ignore", invalid="ignore"):
                falling = np.where(slope < 0, (-self.uphill - now) / slope, np.inf)
                starts = np.where(slope > 0, (self.critical - now) / slope, falling)
            until = np.where(sign != 0, moving, np.where(starts > 0, starts, np.inf))
            time = np.minimum(until, left)
            self.slip = self.slip + sign * (sign * self.speed * time + excess * time**2 / 2 + growth * time**3 / 6)
            stopped = (sign != 0) & (until <= left)
            speed = np.where(sign != 0, np.where(stopped, 0.0, sign * self.speed + excess * time + growth * time**2 / 2), 0.0)
            self.speed = sign * np.maximum(speed, 0.0)
            # At an event the time is that of the limit to the last digit: what is left starts at it.
            left = np.where(until <= left, left - time, 0.0)
            if not (left > 1e-14 * dt).any():
                return
            left = np.maximum(left, 0.0)


def rigid_block(time, acceleration, critical, uphill=np.inf, rate=1.0):
    """Slip [m] at every time, downhill positive: n, or n x blocks if critical (or another limit) is an array.

    time: [s]. acceleration: driving, [m/s2]; linear between the samples, block at rest at the first. critical, uphill: accelerations
    [m/s2] at which it begins to slide downhill and uphill (inf: one-way). rate: see above.
    """
    time, acceleration = np.asarray(time, float), np.asarray(acceleration, float)
    blocks = _Blocks(critical, uphill, rate)
    slip = np.zeros((len(time),) + blocks.critical.shape)
    for i in range(1, len(time)):
        low, high = sorted(acceleration[i - 1 : i + 1])
        if not blocks.rest_through(low, high):
            blocks.step(acceleration[i - 1], acceleration[i], time[i] - time[i - 1])
        slip[i] = blocks.slip
    return slip


def driving_accelerations(run, towards=None):
    """Horizontal accelerations of a run that drive its mass downhill, or towards this sign of x [m/s2]: (outcrop motion, mean of the mass).

    The second is what the base shear makes of the mass: (force at rest - force) / mass, the horizontal equivalent acceleration of a run in
    which nothing slides (Seed and Martin 1966; Makdisi and Seed 1978).
    """
    sign = -(run.downhill if towards is None else towards)
    mass = float(np.ravel(run.attribute("base_shear", "mass"))[0])
    rest = np.ravel(run.attribute("base_shear", "force_at_rest"))
    force = run.history("base_shear/force")
    return sign * run.history("input/acceleration")[:, 0], -sign * (force[:, 0] - rest[0]) / mass
