# SPDX-License-Identifier: GPL-3.0-or-later
"""Block that rocks about a corner: th'' = -p^2 sin(alpha - th), p^2 = 3 g / (4 R), R half the diagonal, until th = 0.

Small angles: quarter period (1/p) acosh(1 / (1 - th0/alpha)) (Housner 1963). Large angles: integrated (Runge-Kutta).
"""

import numpy as np

GRAVITY = 9.81  # m/s2


class Block:
    def __init__(self, width, height, part):
        self.width, self.height = width, height
        self.alpha = np.arctan2(width, height)
        self.p = np.sqrt(3 * GRAVITY / (4 * 0.5 * np.hypot(width, height)))
        self.tilt = part * self.alpha  # rad

    def housner(self):
        return np.arccosh(1 / (1 - self.tilt / self.alpha)) / self.p

    def fall(self, step=1e-4):
        """Times [s] and tilts [rad] until the block has come down."""
        rate = lambda y: np.array([y[1], -self.p**2 * np.sin(self.alpha - y[0])])
        y, t = [np.array([self.tilt, 0.0])], [0.0]
        while y[-1][0] > 0:
            a = rate(y[-1])
            b = rate(y[-1] + 0.5 * step * a)
            c = rate(y[-1] + 0.5 * step * b)
            d = rate(y[-1] + step * c)
            y.append(y[-1] + step / 6 * (a + 2 * b + 2 * c + d))
            t.append(t[-1] + step)
        return np.array(t), np.array(y)[:, 0]

    def overrides(self):
        c, s = self.width * np.cos(self.tilt), self.width * np.sin(self.tilt)
        return ["Mesh/Numbers=Block width = %.15g; Block height = %.15g; Tilt = %.15g"
                % (self.width, self.height, np.degrees(self.tilt)), "Monitors/Points=heel: 0, 0; toe: %.15g, %.15g" % (c, s)]


def crossing(t, y):
    """First time at which y falls to zero."""
    k = np.argmax(y <= 0)
    return t[k - 1] + (t[k] - t[k - 1]) * y[k - 1] / (y[k - 1] - y[k])


def tilt(run, block):
    """History of the angle [rad]."""
    across = run.history("monitors/toe/displacement") - run.history("monitors/heel/displacement")
    across = across + block.width * np.array([np.cos(block.tilt), np.sin(block.tilt)])
    return np.arctan2(across[:, 1], across[:, 0])


def check(case):
    case.curves = {}
    for name, block in (("default", Block(1, 6, 0.5)), ("slightly", Block(1, 6, 0.1)), ("stout", Block(2, 4, 0.8)),
                        ("far", Block(1, 6, 0.95))):
        time, expected = block.fall()
        length = "Time/End time=%.3f" % (1.05 * time[-1])
        run = case.run(name, *([] if name == "default" else block.overrides() + [length]))
        found = tilt(run, block)
        case.curves[name] = block, time, expected, run.time, found
        case.near("quarter period, %s" % name, crossing(run.time, found), crossing(time, expected), 0.01, "s")
        if name in ("default", "slightly"):
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
