# SPDX-License-Identifier: GPL-3.0-or-later
"""A plane that opens in the path of a P wave: d'Alembert's waves below and above it.

v is positive upwards, s the change of the normal traction since rest (tension positive), N_0 the compression at rest, j the
jump (above - below). Below the plane goes up v_up and down v_up + s/Z; above it f goes up and g comes down, so that
s = Z (g - f) and

    j' = 2 (g - v_up - s/Z),    Z = rho c_p

Closed, s = k_n j. The plane breaks where s - N_0 exceeds the cut-off F_t; from then on it carries no tension: it is open
(s = N_0, opening j - N_0/k_n > 0) or closed. The ground, at the height H above it, sends back g(t) = f(t - 2 H/c_p).
"""

import numpy as np


def cut_off(numbers):
    """Tension at which a plane breaks: F_t, at most c / tan phi [Pa]."""
    cohesion, angle = (numbers.number("Bedding planes/" + name) for name in ("Cohesion", "Friction angle"))
    tensile = numbers.number("Bedding planes/Tensile strength")
    return min(tensile, cohesion / np.tan(np.radians(angle))) if angle > 0 else tensile


class Plane:
    """What a run says of its plane, height [m] below the ground.

    impedance [Pa s/m], stiffness k_n [Pa/m], rest N_0 and cut_off F_t [Pa], delay = 2 H/c_p [s].
    """

    def __init__(self, numbers, height):
        rock, bedding = numbers.material("rock"), lambda name: numbers.number("Bedding planes/" + name)
        self.speed = rock.speed("P")
        self.impedance, self.delay = rock.density * self.speed, 2 * height / self.speed
        self.stiffness, self.cut_off = bedding("Normal stiffness"), cut_off(numbers)
        self.rest = rock.density * numbers.gravity() * height + bedding("Initial normal stress")
        self.loss = self.cut_off**2 / (2 * self.stiffness)  # per area where it breaks [J/m2]


class Motion:
    """Histories at the plane: t [s], s [Pa], opening [m]; up, below, above: v_up and the velocities of both sides [m/s]."""

    def __init__(self, t, s, opening, up, back, impedance):
        self.t, self.s, self.opening, self.up = t, s, opening, up
        self.below, self.above = 2 * up + s / impedance, 2 * back - s / impedance
        self.away = back - s / impedance  # of the wave that leaves upwards


def solve(plane, time, upgoing, refine=50):
    """Motion of the plane for the velocity of the upgoing wave at it, linear between its samples.

    Exact exponential steps of the closed plane; events are found to a step of (time[1] - time[0]) / refine.
    """
    z, k, rest = plane.impedance, plane.stiffness, plane.rest
    t = np.linspace(time[0], time[-1], refine * (len(time) - 1) + 1)
    up = np.interp(t, time, upgoing)
    dt = t[1] - t[0]
    delay = int(round(plane.delay / dt))
    rate = 2 * k / z
    decay = np.exp(-rate * dt)
    lag = (1 - decay) / (rate * dt)
    s, opening, back = np.zeros_like(t), np.zeros_like(t), np.zeros_like(t)
    broken = False
    for i in range(1, len(t)):
        if i >= delay:
            back[i] = back[i - delay] - s[i - delay] / z
        d0, d1 = back[i - 1] - up[i - 1], back[i] - up[i]
        if opening[i - 1] == 0:
            # s' = rate (Z d - s) with d linear over the step
            trial = s[i - 1] * decay + z * (d0 * (lag - decay) + d1 * (1 - lag))
            broken = broken or trial - rest > plane.cut_off
        else:
            trial = rest + k * (opening[i - 1] + dt * (d0 + d1 - 2 * rest / z))
        s[i] = min(trial, rest) if broken else trial
        opening[i] = (trial - s[i]) / k
    return Motion(t, s, opening, up, back, z)


def energy(time, rate, impedance):
    """Energy of a wave of the particle velocity rate [J/m2]."""
    return impedance * np.sum(0.5 * (rate[1:] ** 2 + rate[:-1] ** 2) * np.diff(time))


def flights(time, opening, least):
    """Times at which a plane parts and closes, of the flights that open it by more than the least opening.

    The middle of the step in which it happens; a flight that lasts closes at infinity.
    """
    is_open = opening > 0
    middle = 0.5 * (time[1:] + time[:-1])
    opens, closes = middle[is_open[1:] & ~is_open[:-1]], middle[~is_open[1:] & is_open[:-1]]
    closes = np.append(closes, np.inf)[: len(opens)]
    high = np.array([opening[(time > a) & (time < b)].max() > least for a, b in zip(opens, closes)], dtype=bool)
    return opens[high], closes[high]
