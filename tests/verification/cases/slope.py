# SPDX-License-Identifier: GPL-3.0-or-later
"""What the cases of blocks on a slope share: closed form of a slide, distance down the slope."""

import numpy as np

GRAVITY = 9.81  # m/s2


def slide(t, angle, friction):
    """Distance [m] that a rigid block slides from rest in the time t [s]; angles in degrees."""
    a, phi = np.radians(angle), np.radians(friction)
    return 0.5 * GRAVITY * max(np.sin(a) - np.cos(a) * np.tan(phi), 0.0) * t**2


def down(run, name, angle):
    """History of a monitor's displacement [m] down a slope of the given angle [deg] that rises to the right."""
    a = np.radians(angle)
    displacement = run.history("monitors/" + name + "/displacement")
    return -displacement @ np.array([np.cos(a), np.sin(a)])
