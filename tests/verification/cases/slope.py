# SPDX-License-Identifier: GPL-3.0-or-later
"""What the cases of blocks on a slope share: closed form of a slide, distance down the slope."""

import numpy as np
from scene_numbers import Numbers


def slide(run):
    """Distance [m] that a rigid block has slid from rest at the times of the run."""
    numbers = Numbers(run)
    a, phi = np.radians(numbers.mesh("Angle")), numbers.material(numbers.text("Blocks/Material")).friction
    return 0.5 * numbers.gravity() * max(np.sin(a) - np.cos(a) * np.tan(phi), 0.0) * run.time**2


def uphill(run):
    """Unit vector up the plane, which rises to the right."""
    a = np.radians(Numbers(run).mesh("Angle"))
    return np.array([np.cos(a), np.sin(a)])


def down(run, name):
    """History of a monitor's displacement [m] down the slope."""
    return -run.history("monitors/" + name + "/displacement") @ uphill(run)
