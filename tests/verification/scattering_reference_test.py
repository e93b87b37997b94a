#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The reference for canyons (cases/half_space_scattering.py) against what is known in closed form; needs no run.

Green's function: equation of motion and Hooke's law by differences, free ground, reciprocity, Lamb's surface motion. The fit:
its SH form, with the same points and sources, against Trifunac (1973, Bull. Seismol. Soc. Am. 63(5), 1639-1665); more points.
"""

import pathlib
import sys
import unittest

import numpy as np
from scipy.special import h2vp, hankel2, jv, jvp

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent / "cases"))

from half_space_scattering import HalfSpace, Semicircle, scattered  # noqa: E402 (needs the path above)
from lamb_solution import LambSurface  # noqa: E402
from layered_column import fourier  # noqa: E402

POISSON, STEP = 1 / 3, 1e-3
ALONG = np.linspace(-3, 3, 25)


def ground(x):
    """Points on flat ground and canyon."""
    return np.column_stack([x, -np.sqrt(np.maximum(0, 1 - x * x))])


class Green(unittest.TestCase):
    def setUp(self):
        self.rock = HalfSpace(POISSON, np.pi)
        self.source = np.array([[0.1, -0.4]])

    def test_motion_and_hooke(self):
        for place in ((1.1, -0.3), (-0.6, -0.9), (2.5, -0.1), (0.1, -1.1)):
            around = np.array(place) + STEP * np.array([[0, 0], [1, 0], [-1, 0], [0, 1], [0, -1]])
            u, stress = self.rock.green(around, self.source)
            (ux, uy), (sx, sy) = (((f[:, 1] - f[:, 2]) / (2 * STEP), (f[:, 3] - f[:, 4]) / (2 * STEP)) for f in (u, stress))
            volume = self.rock.lame * (ux[0] + uy[1])
            hooke = np.array([volume + 2 * ux[0], volume + 2 * uy[1], uy[0] + ux[1]])
            self.assertLess(abs(hooke - stress[:, 0]).max() / abs(stress[:, 0]).max(), 1e-4)
            inertia = self.rock.k_s**2 * u[:, 0]
            motion = np.array([sx[0] + sy[2], sx[2] + sy[1]]) + inertia
            self.assertLess(abs(motion).max() / abs(inertia).max(), 1e-4)

    def test_ground_is_free(self):
        stress = self.rock.stress(np.array([[x, -1e-9] for x in (0.3, 1, 2, 4.0)]), self.source)
        self.assertLess(abs(stress[1:]).max() / abs(stress[0]).max(), 1e-7)

    def test_reciprocity(self):
        other = np.array([[1.3, -0.7]])
        there, back = (self.rock.displacement(*pair)[:, 0] for pair in ((other, self.source), (self.source, other)))
        self.assertLess(abs(there - back.T).max() / abs(there).max(), 1e-12)

    def test_lamb(self):
        """Vertical motion of the ground under a vertical force on it: the source at two small depths, extrapolated."""
        frequency, distance = 1.0, 1.5
        time = np.arange(0, 14, 0.01)

        def pulse(t):
            return (1 - 2 * (np.pi * (t - 1.5)) ** 2) * np.exp(-((np.pi * (t - 1.5)) ** 2))

        lamb = LambSurface(1.0, 2 * (1 + POISSON), POISSON)  # c_s = mu = 1
        expected = fourier(time, lamb.displacement(distance, time, pulse), frequency) / fourier(time, pulse(time), frequency)
        rock = HalfSpace(POISSON, 2 * np.pi * frequency)
        near, far = (rock.displacement(np.array([[distance, 0.0]]), np.array([[0.0, -d]]))[1, 0, 1] for d in (0.01, 0.02))
        self.assertLess(abs(2 * near - far - expected) / abs(expected), 5e-3)


class Fit(unittest.TestCase):
    def test_sh_canyon_of_trifunac(self):
        for eta in (0.5, 1.0, 2.0):
            k, canyon, receivers = np.pi * eta, Semicircle(), ground(ALONG)

            def field(points, normals=None):
                total = 0
                for sign in (1, -1):  # sources and their images
                    way = points[:, None] - canyon.sources[None] * [1, sign]
                    r = np.linalg.norm(way, axis=2)
                    if normals is None:
                        total = total + hankel2(0, k * r)
                    else:
                        total = total - k * hankel2(1, k * r) * np.einsum("ijk,ik->ij", way / r[..., None], normals)
                return total

            slope = 2 * k * np.sin(k * canyon.points[:, 1]) * canyon.normals[:, 1]
            strength = np.linalg.lstsq(field(canyon.points, canyon.normals), slope, rcond=1e-13)[0]
            found = 2 * np.cos(k * receivers[:, 1]) + field(receivers) @ strength
            self.assertLess(abs(found - trifunac(k, receivers)).max(), 2e-3)

    def test_more_points_change_little(self):
        for eta in (0.5, 1.0, 2.0):
            rock, receivers = HalfSpace(POISSON, np.pi * eta), ground(ALONG)
            few, many = (scattered(rock, canyon, "SP", receivers) for canyon in (Semicircle(), Semicircle(160, 0.25, 0.04)))
            for wave in "SP":
                (some, left), (more, _) = few[wave], many[wave]
                self.assertLess(left, 5e-3)
                self.assertLess(abs(some - more).max(), 6e-3)
                self.assertLess(np.sqrt((abs(some - more) ** 2).mean()), 2e-3)


def trifunac(k, points):
    """Vertically incident SH wave of amplitude 1: sum of cos(2 n theta) (J_2n - H_2n J'_2n(k) / H'_2n(k))."""
    r, angle = np.linalg.norm(points, axis=1), np.arctan2(points[:, 1], points[:, 0])
    total = 0
    for n in range(0, 40, 2):
        scatter = jvp(n, k) / h2vp(n, k) * hankel2(n, k * r)
        total = total + (2 if n == 0 else 4) * np.cos(n * angle) * (jv(n, k * r) - scatter)
    return total


if __name__ == "__main__":
    unittest.main()
