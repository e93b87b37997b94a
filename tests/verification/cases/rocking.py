# SPDX-License-Identifier: GPL-3.0-or-later
"""Block that rocks about a corner: th'' = -p^2 sin(alpha - th), p^2 = 3 g / (4 R), R half the diagonal, until th = 0.

Small angles: quarter period (1/p) acosh(1 / (1 - th0/alpha)) (Housner 1963). Large angles: integrated (Runge-Kutta).
"""

import numpy as np
from scene_numbers import Numbers

# Variants of the scene: width and height [m], tilt over the angle of instability.
VARIANTS = {"slightly": (1, 6, 0.1), "stout": (2, 4, 0.8), "far": (1, 6, 0.95)}


class Block:
    def __init__(self, width, height, tilt, gravity):
        self.width, self.height, self.tilt = width, height, tilt  # m, m, rad
        self.alpha = np.arctan2(width, height)
        self.p = np.sqrt(3 * gravity / (4 * 0.5 * np.hypot(width, height)))

    def housner(self):
        return np.arccosh(1 / (1 - self.tilt / self.alpha)) / self.p

    def fall(self, step=1e-4):
        """Times [s] and tilts [rad] until the block has come down."""
        rate = lambda y: np.array([y[1], -self.p**2 * np.sin(self.alpha - y[0])])
        y, t = [np.array([self.tilt, 0.0])], [0.0]
        while y[-1][0] > 0 and t[-1] < 100:
            a = rate(y[-1])
            b = rate(y[-1] + 0.5 * step * a)
            c = rate(y[-1] + 0.5 * step * b)
            d = rate(y[-1] + step * c)
            y.append(y[-1] + step / 6 * (a + 2 * b + 2 * c + d))
            t.append(t[-1] + step)
        return np.array(t), np.array(y)[:, 0]

    def slender(self):
        """Housner's linearization holds within half a per cent."""
        return self.alpha < 0.2 and self.tilt < 0.6 * self.alpha


def crossing(t, y):
    """First time at which y falls to zero."""
    k = np.argmax(y <= 0)
    return t[k - 1] + (t[k] - t[k - 1]) * y[k - 1] / (y[k - 1] - y[k])


def tilt(run, block):
    """History of the angle [rad]."""
    across = run.history("monitors/toe/displacement") - run.history("monitors/heel/displacement")
    across = across + block.width * np.array([np.cos(block.tilt), np.sin(block.tilt)])
    return np.arctan2(across[:, 1], across[:, 0])


def block_of(run):
    n = Numbers(run)
    return Block(n.mesh("Block width"), n.mesh("Block height"), np.radians(n.mesh("Tilt")), n.gravity())


def variant(case, name, gravity):
    width, height, part = VARIANTS[name]
    block = Block(width, height, part * np.arctan2(width, height), gravity)
    corner = width * np.array([np.cos(block.tilt), np.sin(block.tilt)])
    return case.run(name, "Monitors/Points=heel: 0, 0; toe: %.15g, %.15g" % tuple(corner),
                    "Time/End time=%.3f" % (1.05 * block.fall()[0][-1]),
                    mesh={"Block width": width, "Block height": height, "Tilt": np.degrees(block.tilt)})


def check(case):
    first = case.run()
    gravity = Numbers(first).gravity()
    case.curves = {}
    for name in ("default", *VARIANTS):
        run = first if name == "default" else variant(case, name, gravity)
        block = block_of(run)
        time, expected = block.fall()
        found = tilt(run, block)
        case.curves[name] = block, time, expected, run.time, found
        case.near("quarter period, %s" % name, crossing(run.time, found), crossing(time, expected), 0.01, "s")
        if block.slender():
            case.near("quarter period of Housner, %s" % name, crossing(run.time, found), block.housner(), 0.01, "s")


def draw(case, figure):
    axes = figure.subplots()
    for block, time, expected, found_time, found in case.curves.values():
        axes.plot(time, np.degrees(expected), color="0.6", linewidth=4)
        axes.plot(found_time, np.degrees(found), label="hybrid, %g x %g m from %.2g alpha"
                  % (block.width, block.height, block.tilt / block.alpha))
    axes.plot([], [], color="0.6", linewidth=4, label="p^2 sin(alpha - th), integrated")
    axes.set(xlabel="time [s]", ylabel="tilt [deg]")
    axes.legend()
