# SPDX-License-Identifier: GPL-3.0-or-later
"""Release of a brittle joint: the foot of a bar under tension tears, and no bond above it does.

A chain of blocks as those of the program, one behind the other, says how far a release rings (largest_tensions).
"""

import numpy as np
from scene_numbers import Numbers

SIZES = (2.0,)  # of blocks in variants [m]
PENALTY = 40.0  # of the chain's joints, over the stiffness of a block


def largest_tensions(release, blocks=40, inertia=1.0 / 12, step=0.02, end=18.0):
    """Largest tension in each joint of a chain after its foot lets go, over that before.

    Blocks of unit size, density and wave speed with a constant strain; release: time in which the foot lets go, in times that
    a wave needs through a block. inertia: of the strain, 1/12 for an even bar, 1/4 for half of the mass at either end.
    """
    size = 2 * blocks  # place and strain of each block
    mass = np.diag(np.tile([1.0, inertia], blocks))
    stiffness = np.diag(np.tile([0.0, 1 / (1 - 1 / PENALTY)], blocks))
    gaps = np.zeros((blocks - 1, size))
    for joint, gap in enumerate(gaps):
        gap[2 * joint : 2 * joint + 4] = (-1, -0.5, 1, -0.5)
        stiffness += PENALTY * np.outer(gap, gap)
    foot = np.zeros(size)
    foot[:2] = (1, -0.5)
    place, speed, acceleration = np.zeros((3, size))
    inverse = np.linalg.inv(mass + 0.25 * step**2 * stiffness)  # trapezoidal rule
    largest = np.ones(blocks - 1)
    for k in range(1, int(end / step) + 1):
        part = min(1.0, k * step / release) if release > 0 else 1.0
        place, speed = place + step * speed + 0.25 * step**2 * acceleration, speed + 0.5 * step * acceleration
        acceleration = inverse @ (part * foot - stiffness @ place)
        place, speed = place + 0.25 * step**2 * acceleration, speed + 0.5 * step * acceleration
        largest = np.maximum(largest, 1 + PENALTY * gaps @ place)
    return largest


def foot_stress(run):
    """Time [s] and mean tension on the base [Pa]."""
    force, time = run.get("interface/force"), run.get("interface/time").ravel()
    return time, force[:, 1::2].sum(axis=1) / Numbers(run).mesh("Width")


def check(case):
    default = case.run()
    numbers = Numbers(default)
    case.runs = {numbers.mesh("Resolution/h"): default}
    for size in SIZES:
        case.runs[size] = case.run("h_%g" % size, mesh={"Resolution/h": size})
    strength = numbers.material("foot").tensile_strength
    for size, run in case.runs.items():
        name, height = "h = %g m, " % size, run.file["joints/position"][:, 1]
        case.near(name + "tension at which the foot tears", foot_stress(run)[1].max(), strength, 0.03, "Pa")
        case.true(name + "all of the foot tears (%d joints)" % (height < 1e-6).sum(),
                  (height < 1e-6).sum() == round(numbers.mesh("Width") / size))
        case.true(name + "no bond within the bar tears (%d do)" % (height > 1e-6).sum(), (height < 1e-6).all())
        case.below(name + "residual of the energy audit", run.summary["energy_residual"], 1e-4)
    # Why: at once, the chain bears much more in front of the wave; over h/c the neighbour bears a tenth more at most.
    case.below("chain, at once: joint beside the foot, tension over that before, less 1.47", largest_tensions(0)[0] - 1.47, 0.02)
    case.below("chain, over h/c: joint beside the foot, tension over that before, less 1", largest_tensions(1)[0] - 1, 0.1)


def draw(case, figure):
    left, right = figure.subplots(1, 2)
    for release, inertia, label in ((0, 1 / 12, "at once"), (0.5, 1 / 12, "over h / 2c"), (1, 1 / 12, "over h / c, as here"),
                                    (2, 1 / 12, "over 2h / c"), (0, 1 / 4, "at once, mass at the ends of blocks")):
        tension = largest_tensions(release, inertia=inertia)[:15]
        left.plot(np.arange(1, len(tension) + 1), tension, ".-", label=label)
    left.set(xlabel="joint, counted from the one that tears", ylabel="largest tension / tension before",
             title="chain of blocks, undamped", ylim=(0.95, 1.8))
    left.legend(fontsize="small")
    for size, run in case.runs.items():
        time, stress = foot_stress(run)
        right.plot(time, stress / 1e3, label="foot, h = %g m" % size)
    right.axhline(Numbers(run).material("foot").tensile_strength / 1e3, color="k", linestyle=":", label="strength of the foot")
    right.axhline(Numbers(run).material("rock").tensile_strength / 1e3, color="0.5", linestyle="--", label="strength of the bar")
    right.set(xlabel="time [s]", ylabel="mean tension [kPa]", title="program")
    right.legend(fontsize="small")
