# SPDX-License-Identifier: GPL-3.0-or-later
"""Deformable column on a plane with friction: slip against a modal solution of the same, and by the decoupled method."""

import os

import numpy as np
from hybrid_run.newmark import rigid_block
from scene_numbers import Numbers
from sliding_solution import SlidingColumn, block_modes, column_modes
from slope import uphill

RATIOS = (0.2, 0.5, 1.5, 2.0)  # of variants: period of the column over that of the motion
SENSITIVE = 0.02  # of the period, for ratios at which slip changes by more than twice as much as the period
MODES = 20
EARTHQUAKE = ("Motion/Type=synthetic", "Motion/Frequency=2", "Motion/Duration=12", "Time/End time=12")
LOCKED = "Materials/rock/Friction angle=80"  # more than the column asks for
PART = 0.25  # of the motion's peak that shakes the locked column, which is linear while its foot does not lift


class Scene:
    """What a run was asked for, and the independent solution for the motion that it recorded."""

    def __init__(self, run):
        numbers = Numbers(run)
        rock, rows = numbers.material("rock"), int(numbers.mesh("Rows"))
        self.gravity, self.slope, self.density = numbers.gravity(), np.radians(numbers.mesh("Angle")), rock.density
        self.height, self.width = rows * numbers.mesh("Block height"), numbers.mesh("Block width")
        self.period = 4 * self.height / rock.speed("S")
        self.damping, self.frequency = numbers.number("Blocks/Damping ratio"), numbers.number("Blocks/Damping frequency")
        self.friction, self.one_block = rock.friction, rows == 1
        self.column = self.of_period(self.period)
        self.time = np.concatenate([[0.0], run.time])
        self.uphill = np.concatenate([[0.0], run.history("input/acceleration") @ uphill(run)])

    def of_period(self, period, frequency=None):
        """The column with another period [s]; frequency [Hz]: at which it has its damping ratio."""
        speed = 4 * self.height / period
        modes = (block_modes(self.height, self.density, speed) if self.one_block
                 else column_modes(self.height, self.density, speed, MODES))
        return SlidingColumn(modes, self.damping / (np.pi * (frequency or self.frequency)), np.tan(self.friction), self.gravity, self.slope)

    def slip(self, column=None):
        return (column or self.column).response(self.time, self.uphill)[0][1:]

    def rigid(self, driving, friction):
        """Slip [m] of Newmark's block of this friction under an acceleration [m/s2] that is positive downhill."""
        limit = np.tan(friction) * self.gravity * np.cos(self.slope)
        return rigid_block(self.time, driving, limit, uphill=limit)[1:]


def compare(case, name, run):
    scene = Scene(run)
    found, expected = run.file["slip/mean"][:], scene.slip()
    case.curves[name] = run.time, found, expected
    others = [scene.slip(scene.of_period(scene.period * (1 + part)))[-1] for part in (-SENSITIVE, SENSITIVE)]
    if expected[-1] == 0:
        case.below("slip in the end where it never slips, " + name, found[-1], 1e-4, "m")
    elif abs(others[1] - others[0]) > 4 * SENSITIVE * expected[-1]:
        case.true("slip in the end, %s: %.5f m, between %.5f and %.5f, modes %.5f" % (name, found[-1], *others, expected[-1]),
                  min(others) <= found[-1] <= max(others))
    else:
        case.near("slip in the end, " + name, found[-1], expected[-1], 0.02, "m")
        case.below("largest difference over final slip, " + name, np.abs(found - expected).max() / expected[-1], 0.02)
    case.below("residual of the energy audit, " + name, run.summary["energy_residual"], 1e-3)
    return scene, found[-1], expected[-1]


def decoupled(case, name, friction, *overrides):
    """The column that does not slip, and Newmark's block under its mean acceleration: base shear over mass."""
    peak = float(Numbers(case.first).text("Motion/Peak").split()[0])
    run = case.run("locked_" + name, LOCKED, "Motion/Peak=%.10g" % (PART * peak), *overrides)
    scene = Scene(run)
    static = scene.column.static
    mean = np.concatenate([[static], run.file["base_shear/shear"][:] / scene.column.modes.mass / scene.width])
    mean = static + (mean - static) / PART
    _, expected = scene.column.response(scene.time, scene.uphill / PART, locked=True)
    case.near("largest mean acceleration, " + name, np.abs(mean).max(), np.abs(expected).max(), 0.02, "m/s2")
    slips = [scene.rigid(driving, friction)[-1] for driving in (mean, expected)]
    if slips[1] > 0:
        case.near("slip by the decoupled method, " + name, *slips, 0.05, "m")
    else:
        case.true("no slip by the decoupled method, " + name, slips[0] == 0)
    return slips[0]


def of_ratio(numbers, ratio):
    """Overrides for a column of another period."""
    period = ratio / numbers.number("Motion/Frequency")
    speed = 4 * numbers.mesh("Rows") * numbers.mesh("Block height") / period
    return ("Materials/rock/Young modulus=%.10g" % (2 * numbers.material("rock").density * speed**2),
            "Blocks/Damping frequency=%.10g" % (1 / period))


def check(case):
    case.curves, case.ratios = {}, {}
    first = case.first = case.run()
    numbers = Numbers(first)
    friction = numbers.material("rock").friction
    for ratio in sorted((1.0, *RATIOS)):
        name, overrides = "Ts/Tm = %g" % ratio, of_ratio(numbers, ratio)
        scene, found, _ = compare(case, name, first if ratio == 1.0 else case.run("ratio_%g" % ratio, *overrides))
        case.ratios[ratio] = found, decoupled(case, name, friction, *overrides), scene.rigid(
            scene.column.static + scene.uphill, friction)[-1]
    compare(case, "one block", case.run("block", mesh={"Rows": 1, "Block height": numbers.mesh("Rows") * numbers.mesh("Block height")}))
    compare(case, "earthquake", case.run("earthquake", *EARTHQUAKE))
    if "HYBRID_RECORD" in os.environ:  # a real record (.at2), scaled to the same peak
        compare(case, "record", case.run("record", "Motion/Type=at2", "Motion/File=" + os.environ["HYBRID_RECORD"], "Time/End time=35"))


def draw(case, figure):
    left, right = figure.subplots(1, 2)
    for name in ("Ts/Tm = 0.2", "Ts/Tm = 1", "one block"):
        time, found, expected = case.curves[name]
        left.plot(time, expected, color="0.6", linewidth=4)
        left.plot(time, found, label="hybrid, " + name)
    left.plot([], [], color="0.6", linewidth=4, label="modes")
    left.set(xlabel="time [s]", ylabel="slip down the plane [m]")
    left.legend(fontsize=8)
    draw_spectrum(case, Scene(case.first), right)


def draw_spectrum(case, scene, axes):
    """Slip over the period of the column, under the motion of a scene whose column has the motion's period."""
    ratios, coupled, apart = np.geomspace(0.1, 2.5, 60), [], []
    for ratio in ratios:
        period = ratio * scene.period
        column = scene.of_period(period, 1 / period)
        coupled.append(scene.slip(column)[-1])
        mean = column.response(scene.time, scene.uphill, locked=True)[1]
        apart.append(scene.rigid(mean, scene.friction)[-1])
    axes.semilogy(ratios, coupled, "C0", label="coupled, modes")
    axes.semilogy(ratios, apart, "C1", label="decoupled, modes")
    axes.axhline(case.ratios[1.0][2], color="0.6", linestyle=":", label="rigid block")
    for k, name in ((0, "coupled, hybrid"), (1, "decoupled, hybrid")):
        axes.semilogy(list(case.ratios), [values[k] for values in case.ratios.values()], "C%do" % k, label=name)
    axes.set(xlabel="period of the column over that of the motion", ylabel="slip in the end [m]", ylim=(1e-3, None))
    axes.legend(fontsize=8)
