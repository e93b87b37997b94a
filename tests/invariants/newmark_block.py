# SPDX-License-Identifier: GPL-3.0-or-later
"""Newmark's sliding block on a plane that moves: Coulomb friction, both ways, with the normal acceleration of the plane."""

import math

import numpy as np

REFERENCE_RATE = 0.01  # of the belt's friction [m/s]


def newmark_slip(time, along, away, slope, friction, gravity, rate=0.0):
    """Slip at the last time [m], uphill positive, of a block at rest at t = 0.

    time [s] and displacement of the plane along (uphill) and away from the slope [m] at the end of each step;
    slope and friction angle [rad]; gravity: of the effective weight [m/s2]; rate: coefficient of a belt's friction [-].
    """
    steps = np.diff(np.concatenate([[0.0], time]))
    push, lift = -accelerations(steps, along), accelerations(steps, away)
    velocity = slip = 0.0
    for dt, a, n in zip(steps, push, lift):
        pressed = max(gravity * math.cos(slope) + n, 0.0) * math.tan(friction) * rate_factor(rate, velocity)
        driving = a - gravity * math.sin(slope)
        if velocity == 0.0 and abs(driving) <= pressed:
            continue
        direction = math.copysign(1.0, velocity if velocity != 0.0 else driving)
        after = velocity + dt * (driving - direction * pressed)
        if velocity != 0.0 and after * velocity <= 0.0:
            after = 0.0  # it stops; what moves it the other way does so from the next step on
        slip += 0.5 * dt * (velocity + after)
        velocity = after
    return slip


def rate_factor(coefficient, velocity):
    """Of friction at a velocity over that at rest [-]."""
    effect = coefficient * math.log1p(abs(velocity) / REFERENCE_RATE)
    return 1.0 + effect if coefficient >= 0 else 1.0 / (1.0 - effect)


def accelerations(steps, displacement):
    """Of the plane in each step [m/s2], smoothed over five steps."""
    velocity = np.diff(np.concatenate([[0.0], displacement])) / steps
    raw = np.diff(np.concatenate([[0.0], velocity])) / steps
    return np.convolve(np.pad(raw, 2, mode="edge"), np.ones(5) / 5, mode="valid")
