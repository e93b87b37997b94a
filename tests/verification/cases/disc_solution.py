# SPDX-License-Identifier: GPL-3.0-or-later
"""Elastic disc under two opposite even vertical tractions on arcs (plane problem, no weight).

Two equal and opposite forces dP along a chord make the radial stresses -2 dP cos(theta) / (pi r) from both ends and an even
tension 2 dP cos(phi) / (pi D), which frees the rim (Michell 1900; Timoshenko and Goodier, art. 41); phi is the angle of the
chord's ends from the vertical. The tractions are the integral over phi. On the axis this is Hondros (1959) but for the
direction of the traction, there radial: the same up to phi^2.
"""

import numpy as np


def stress(x, y, radius, half_angle, traction, points=400):
    """sigma_xx, sigma_yy, sigma_xy [Pa], tension positive, of the compressive traction [Pa] on arcs of +-half_angle [rad]."""
    nodes, weights = np.polynomial.legendre.leggauss(points)
    x, y = np.asarray(x, float), np.asarray(y, float)
    xx, yy, xy = (np.zeros_like(x) for _ in range(3))
    for phi, weight in zip(nodes * half_angle, weights * half_angle):
        force = traction * radius * weight
        even = force * np.cos(phi) / (np.pi * radius)
        xx, yy = xx + even, yy + even
        for sign in (1, -1):
            rx, ry = x - radius * np.sin(phi), y - sign * radius * np.cos(phi)
            r2 = rx**2 + ry**2
            radial = -2 * force / np.pi * (-sign * ry) / r2
            xx, yy, xy = xx + radial * rx**2 / r2, yy + radial * ry**2 / r2, xy + radial * rx * ry / r2
    return xx, yy, xy
