# SPDX-License-Identifier: GPL-3.0-or-later
"""Block that one cycle of a sine overturns (Housner 1963, Makris & Roussos 2000, Zhang & Makris 2001).

About its corners, th > 0 against the ground's acceleration a of the first half cycle, R half the diagonal, p^2 = 3 g / (4 R):

    th'' = -p^2 (sin(s alpha - th) - (a/g) cos(s alpha - th)),   s = sign(th);    lifts off at |a| > g tan(alpha)

At th = 0 it hits the ground and keeps the part r = 1 - (3/2) sin^2(alpha) of its angular velocity (Housner: moment of momentum about
the corner it then turns about). It overturns without an impact (mode 2), which asks nothing of r, or after one (mode 1).
"""

import numpy as np
from rocking import block_of, tilt
from scene_numbers import Numbers

FREQUENCIES = (1.0, 2.0, 3.0, 4.0)  # of the pulse over p
AFTER = 6.0  # time after the pulse until all is decided, of 1 / p
SAMPLES = 2000  # of the record's cycle
STANDS, MODE_1, MODE_2 = 0, 1, 2
NAMES = ("stands", "overturned after an impact", "overturned without an impact")
MARGIN = 0.01  # of the limit, on either side
FALLEN = np.pi / 3
TILTS = 2.0  # frequency whose tilts are compared, of p


class Rocking:
    """Blocks of one shape under pulses of one frequency and different amplitudes."""

    def __init__(self, block, gravity, frequency):
        self.alpha, self.p, self.gravity, self.frequency = block.alpha, block.p, gravity, frequency * block.p
        self.restitution = 1 - 1.5 * np.sin(block.alpha) ** 2
        self.duration = 2 * np.pi / self.frequency
        self.end = self.duration + AFTER / block.p

    def _rate(self, t, y, amplitude):
        ground = amplitude * np.sin(self.frequency * t) if t < self.duration else 0.0 * amplitude
        side = np.where(y[0] != 0, np.sign(y[0]), np.sign(ground))
        turn = -self.p**2 * (np.sin(side * self.alpha - y[0]) - ground / self.gravity * np.cos(side * self.alpha - y[0]))
        rests = (y[0] == 0) & (y[1] == 0) & (np.abs(ground) <= self.gravity * np.tan(self.alpha))
        return np.array([y[1], np.where(rests, 0.0, turn)])

    def response(self, amplitudes, step=1e-3):
        """Times, tilts (times x amplitudes) and numbers of impacts until th = pi / 2, by Runge and Kutta's method."""
        a = np.asarray(amplitudes, float)
        y, t, impacts = np.zeros((2, len(a))), 0.0, np.zeros(len(a), int)
        times, tilts = [0.0], [y[0]]
        while t < self.end:
            k1 = self._rate(t, y, a)
            k2 = self._rate(t + step / 2, y + step / 2 * k1, a)
            k3 = self._rate(t + step / 2, y + step / 2 * k2, a)
            k4 = self._rate(t + step, y + step * k3, a)
            new = y + step / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
            hit = (y[0] != 0) & (y[0] * new[0] <= 0)
            part = np.where(hit, y[0] / np.where(hit, y[0] - new[0], 1), 0)  # of the step until then
            speed = self.restitution * (y[1] + part * (new[1] - y[1]))
            new = np.where(hit, np.array([speed * (1 - part) * step, speed]), new)
            y = np.where(np.abs(y[0]) >= np.pi / 2, y, new)
            impacts, t = impacts + hit, t + step
            times.append(t)
            tilts.append(y[0])
        return np.array(times), np.array(tilts), impacts

    def outcomes(self, amplitudes):
        _, tilts, impacts = self.response(amplitudes)
        return np.where(np.abs(tilts[-1]) < self.alpha, STANDS, np.where(impacts == 0, MODE_2, MODE_1))

    def limits(self):
        """Amplitudes [m/s2] at which it begins to overturn (None: not before mode 2) after an impact, and without one."""
        low, high = self.gravity * np.tan(self.alpha), 30 * self.gravity * np.tan(self.alpha)
        grid = np.geomspace(low, high, 120)
        found = self.outcomes(grid)
        limits = []
        for mode in (MODE_1, MODE_2):
            first = np.argmax(found == mode)
            if found[first] != mode:
                limits.append(None)
                continue
            fine = grid
            for _ in range(2):
                fine = np.linspace(fine[first - 1], fine[first], 100)
                first = np.argmax(self.outcomes(fine) == mode)
            limits.append(fine[first])
        return limits


def write_pulse(path, rocking, amplitude):
    t = np.linspace(0, rocking.duration, SAMPLES + 1)
    np.savetxt(path, np.column_stack([t, amplitude * np.sin(2 * np.pi * np.arange(SAMPLES + 1) / SAMPLES)]), fmt="%.17g")


def shaken(case, rocking, amplitude, *overrides):
    """Times and tilts [rad] of a run, positive against the first half cycle."""
    name = "w_%.3g_a_%.5g" % (rocking.frequency / rocking.p, amplitude)
    case.work.mkdir(parents=True, exist_ok=True)
    record = case.work / (name + ".txt")
    write_pulse(record, rocking, amplitude)
    run = case.run(name, "Motion/Type=text", "Motion/File=%s" % record, "Motion/Peak=as recorded", "Motion/Baseline correction=false",
                   "Time/End time=%.6g" % rocking.end, *overrides)
    return run, run.time, tilt(run, block_of(run))


def outcome(rocking, angle):
    """What became of a run, and whether it came down before it fell."""
    beyond = np.abs(angle) > rocking.alpha
    if not beyond[-1]:
        return STANDS
    until = angle[: len(angle) - np.argmax(~beyond[::-1])] if (~beyond).any() else angle
    return MODE_2 if until.max() <= 1e-3 * rocking.alpha or until.min() >= -1e-3 * rocking.alpha else MODE_1


def check(case):
    first = case.run()
    block, gravity = block_of(first), Numbers(first).gravity()
    case.unit, case.limits = gravity * np.tan(block.alpha), {}
    for frequency in FREQUENCIES:
        rocking = Rocking(block, gravity, frequency)
        limits = case.limits[frequency] = rocking.limits()
        for mode, limit in zip((MODE_1, MODE_2), limits):
            for part in (-MARGIN, MARGIN):
                found = outcome(rocking, shaken(case, rocking, (1 + part) * limit)[2])
                wanted = found == mode if part > 0 else found != mode
                case.true("w = %g p, %g %% %s the limit of mode %d (%.4f g tan alpha): %s" % (
                    frequency, 100 * MARGIN, "above" if part > 0 else "below", mode, limit / case.unit, NAMES[found]), wanted)
    check_tilts(case, Rocking(block, gravity, TILTS))


def check_tilts(case, rocking):
    case.curves, limits = {}, case.limits[TILTS]
    for name, amplitude in (("stands", 0.97 * limits[0]), ("mode 1", 1.1 * limits[0]), ("mode 2", 1.1 * limits[1])):
        run, time, found = shaken(case, rocking, amplitude)
        times, tilts, _ = rocking.response([amplitude])
        expected = np.interp(time, times, tilts[:, 0])
        case.curves[name] = time, found, expected
        if name == "stands":
            impact = np.argmax((np.maximum.accumulate(expected) > 0.1 * rocking.alpha) & (expected <= 0))
            until = slice(0, impact)
            case.near("largest tilt before the impact", found[:impact].max(), expected[:impact].max(), 0.02, "rad")
            case.near("largest tilt after the impact, to the other side", -found.min(), -expected.min(), 0.03, "rad")
        else:
            until = slice(0, np.argmax(np.abs(expected) >= rocking.alpha))
            fallen = [time[np.argmax(np.abs(y) >= FALLEN)] for y in (found, expected)]
            case.near("time until it passes 60 degrees, " + name, *fallen, 0.01, "s")
        case.below("tilt, %s: largest difference over alpha" % name, np.abs(found - expected)[until].max() / rocking.alpha, 0.02)


def draw(case, figure):
    left, right = figure.subplots(1, 2)
    for name, (time, found, expected) in case.curves.items():
        left.plot(time, np.degrees(expected), color="0.6", linewidth=4)
        left.plot(time, np.degrees(found), label="hybrid, " + name)
    left.plot([], [], color="0.6", linewidth=4, label="integrated")
    left.set(xlabel="time [s]", ylabel="tilt [deg]", title="pulses of %g p" % TILTS)
    left.legend(fontsize=8)
    first = case.run()
    curves = dict(case.limits)
    for frequency in (0.7, 1.5, 2.5, 3.5, 4.5, 5.0):
        curves[frequency] = Rocking(block_of(first), Numbers(first).gravity(), frequency).limits()
    frequencies = sorted(curves)
    for k, colour in ((0, "C0"), (1, "C1")):
        right.plot(frequencies, [curves[w][k] / case.unit for w in frequencies], colour, label="mode %d, integrated" % (k + 1))
        for part, marker, name in ((-MARGIN, "v", "hybrid, not yet"), (MARGIN, "^", "hybrid, overturned")):
            right.plot(list(case.limits), [(1 + part) * v[k] / case.unit for v in case.limits.values()], colour + marker, ms=4,
                       label=name if k == 0 else None)
    right.set(xlabel="frequency of the pulse over p", ylabel="peak acceleration over g tan(alpha)")
    right.legend(fontsize=8)
