# SPDX-License-Identifier: GPL-3.0-or-later
"""Materials of a new scene: typical values to be replaced, with strengths that let the slope stand."""

import numpy as np

GRAVITY = 9.81  # [m/s2]
SAFETY = 1.5  # of the mass on its belt at rest, that the belt's cohesion is chosen for


class Material:
    """density [kg/m3], young_modulus [Pa], poisson_ratio, friction_angle [deg], cohesion [Pa], tensile_strength [Pa]."""

    def __init__(self, density, young_modulus, poisson_ratio, friction_angle=None, cohesion=None):
        self.density, self.young_modulus, self.poisson_ratio = density, young_modulus, poisson_ratio
        self.friction_angle, self.cohesion = friction_angle, cohesion

    @property
    def s_wave_speed(self):
        return np.sqrt(self.young_modulus / (2 * (1 + self.poisson_ratio)) / self.density)

    @property
    def tensile_strength(self):
        return rounded(0.5 * self.cohesion, 2)


def rock():
    """Jointed sedimentary rock: S waves of 1265 m/s, ground type A of Eurocode 8 (above 800 m/s)."""
    return Material(2500, 10e9, 0.25)


def body(mass):
    """Dense debris: S waves of 302 m/s, ground type C of Eurocode 8 (180 to 360 m/s).

    Its cohesion holds the slope: a tenth of the weight of its height, where it is steep twice what Culmann's wedge asks for.
    """
    found = Material(2100, 0.5e9, 0.30, 32.0)
    _, low, _, high = mass.polygon.bounds
    share = max(0.1, 2 * culmann(mass.steepest, found.friction_angle))
    found.cohesion = rounded(max(20e3, share * found.density * GRAVITY * (high - low)), 2)
    return found


def culmann(slope_angle, friction_angle):
    """Cohesion over weight of the height that a slope of this angle [deg] just stands with, on a plane through its foot (Culmann 1875; Taylor 1937)."""
    slope, phi = np.radians(slope_angle), np.radians(friction_angle)
    return (1 - np.cos(slope - phi)) / (4 * np.sin(slope) * np.cos(phi)) if slope > phi else 0.0


def belt(mass, body_material):
    """Friction of a clayey shear zone; cohesion so that the mass has the factor of safety SAFETY at rest."""
    found = Material(body_material.density, body_material.young_modulus, body_material.poisson_ratio, 25.0)
    slices = Slices(mass, body_material.density)
    found.cohesion = 5e3
    if slices.safety(25.0, found.cohesion) < SAFETY:
        from scipy.optimize import brentq  # a third of a second, which few need

        found.cohesion = rounded(brentq(lambda c: slices.safety(25.0, c) - SAFETY, found.cohesion, 1e9, rtol=1e-3), 2, up=True)
    found.safety = slices.safety(25.0, found.cohesion)
    if found.cohesion > body_material.cohesion:
        body_material.cohesion = found.cohesion
    return found


class Slices:
    """Simplified method of slices (Janbu 1954, without its correction) for any sliding surface: forces are horizontal between slices."""

    def __init__(self, mass, density, count=100):
        slip = mass.slip
        s = np.r_[0, np.cumsum(np.hypot(*np.diff(slip, axis=0).T))]
        at = np.unique(np.r_[s, np.linspace(0, s[-1], count + 1)])
        points = np.column_stack([np.interp(at, s, slip[:, k]) for k in (0, 1)])
        chord = np.diff(points, axis=0)
        run = chord[:, 0] > 1e-6 * np.abs(chord).sum(axis=1)  # vertical parts carry nothing
        chord, middle = chord[run], (0.5 * (points[1:] + points[:-1]))[run]
        self.width = chord[:, 0]
        self.angle = np.arctan2(chord[:, 1], chord[:, 0]) * (1 if mass.falls_left else -1)
        self.weight = density * GRAVITY * self.width * np.array([height_above(mass, *m) for m in middle])

    def safety(self, friction_angle, cohesion):
        """Factor of safety; infinite where nothing drives."""
        tan_phi, tan_a = np.tan(np.radians(friction_angle)), np.tan(self.angle)
        drive = (self.weight * tan_a).sum()
        if drive <= 0:
            return np.inf
        factor = 1.0
        for _ in range(200):
            m = np.cos(self.angle) ** 2 * np.maximum(1 + tan_a * tan_phi / factor, 0.2)
            new = ((cohesion * self.width + self.weight * tan_phi) / m).sum() / drive
            if abs(new - factor) < 1e-6 * new:
                return new
            factor = new
        return factor


def height_above(mass, x, y):
    from shapely.geometry import LineString
    top = mass.polygon.bounds[3] + 1
    return mass.polygon.intersection(LineString([(x, y), (x, top)])).length


def rounded(value, digits, up=False):
    """Two digits; rounded up, so that a strength that must hold still does."""
    power = 10.0 ** (np.floor(np.log10(value)) - digits + 1)
    return float((np.ceil if up else np.round)(value / power) * power)
