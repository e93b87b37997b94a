# SPDX-License-Identifier: GPL-3.0-or-later
"""Waves scattered by a cut (canyon, valley) in the flat ground of an elastic half space, at one frequency; plane strain.

The scattered field is that of line forces inside the cut, each with the half space's own Green's function, so that the flat
ground is free of traction whatever their strengths; these make the traction on the cut as small as possible (method of
fundamental solutions; Wong 1982, Bull. Seismol. Soc. Am. 72(4), 1167-1183). Half space: y < 0, y up. Time factor exp(i w t).

Green's function: full space, G_ij = [d_ij g_s + (g_s - g_p),ij / k_s^2] / mu with g = -(i/4) H_0^(2)(k r), plus what the free
surface sends back, an integral over the horizontal wave number k (Lamb 1904) of potentials, u = (phi,x + psi,y; phi,y - psi,x).
"""

import numpy as np
from scipy.special import hankel2, jv, jvp


class HalfSpace:
    """c_s = 1 and mu = 1: lengths in any unit, k_s is the frequency."""

    def __init__(self, poisson, k_s):
        self.k_s, self.k_p = k_s, k_s * np.sqrt((1 - 2 * poisson) / (2 * (1 - poisson)))
        self.lame = 2 * poisson / (1 - 2 * poisson)  # lambda over mu

    def incident(self, wave, points):
        """Displacement (2, n) and stress (xx, yy, xy; n) of the flat ground; the wave comes from below, amplitude 1."""
        y, zero = points[:, 1], np.zeros(len(points))
        if wave == "S":
            return np.array([2 * np.cos(self.k_s * y), zero]), np.array([zero, zero, -2 * self.k_s * np.sin(self.k_s * y)])
        strain = -2 * self.k_p * np.sin(self.k_p * y)
        return np.array([zero, 2 * np.cos(self.k_p * y)]), np.array([self.lame * strain, (self.lame + 2) * strain, zero])

    def displacement(self, points, sources):
        """(2, points, 2 sources) of forces along x (first half) and y."""
        return self._full_space(points, sources)[0] + self._reflected(points, sources, slice(0, 2))

    def stress(self, points, sources):
        """xx, yy, xy (3, points, 2 sources) of forces along x (first half) and y."""
        return self._full_space(points, sources)[1] + self._reflected(points, sources, slice(2, 5))

    def green(self, points, sources):
        return self.displacement(points, sources), self.stress(points, sources)

    def _full_space(self, points, sources):
        way = points[:, None, :] - sources[None, :, :]
        r = np.linalg.norm(way, axis=2)
        n = np.moveaxis(way / r[..., None], 2, 0)
        g = {k: radial(k, r) for k in (self.k_s, self.k_p)}
        shear, pressure = g[self.k_s], g[self.k_p]
        difference = [s - p for s, p in zip(shear, pressure)]
        unit = np.eye(2)
        u, stress = np.empty((2, len(r), 2, r.shape[1]), complex), np.empty((3, len(r), 2, r.shape[1]), complex)
        for j in (0, 1):
            gradient = np.empty((2, 2) + r.shape, complex)  # of u_i along k
            for i in (0, 1):
                u[i, :, j] = unit[i, j] * shear[0] + second(difference, n, i, j) / self.k_s**2
                for k in (0, 1):
                    gradient[i, k] = unit[i, j] * shear[1] * n[k] + third(difference, n, r, i, j, k) / self.k_s**2
            volume = self.lame * (gradient[0, 0] + gradient[1, 1])
            stress[:, :, j] = volume + 2 * gradient[0, 0], volume + 2 * gradient[1, 1], gradient[0, 1] + gradient[1, 0]
        return u.reshape(2, len(r), -1), stress.reshape(3, len(r), -1)

    def _wave_numbers(self, points, sources):
        """A path past the branch points and the Rayleigh pole (0.85 to 1.15 k_s), and its weights."""
        depth = -sources[:, 1].max()
        reach = 2 * max(abs(points[:, 0]).max(), abs(sources[:, 0]).max()) + 1 / self.k_s
        lift = min(0.3 * self.k_s, 2 / reach)
        highest, step = 32 / depth + 3 * self.k_s, 0.25 * min(lift, 2 / reach)
        s = step * (np.arange(-np.ceil(highest / step), np.ceil(highest / step)) + 0.5)
        bell = np.exp(-((s / (1.5 * self.k_s)) ** 4))
        k = s + 1j * lift * np.tanh(2 * s / self.k_s) * bell
        slope = lift * (2 / self.k_s / np.cosh(np.minimum(abs(2 * s / self.k_s), 300)) ** 2 * bell
                        - np.tanh(2 * s / self.k_s) * bell * 4 * s**3 / (1.5 * self.k_s) ** 4)
        return k, step * (1 + 1j * slope)

    def _reflected(self, points, sources, wanted):
        """Those of displacement x, y and stress xx, yy, xy that are wanted: their products take all the time."""
        k, weight = self._wave_numbers(points, sources)
        a, b = decaying(k**2 - self.k_p**2), decaying(k**2 - self.k_s**2)
        omega, coupling = 2 * k**2 - self.k_s**2, 2j * k
        x, y = points.T
        xs, ys = sources.T
        scale = (weight / (4 * np.pi * self.k_s**2))[:, None]
        up_p = np.exp(np.outer(-1j * k, xs) + np.outer(a, ys)) * scale
        up_s = np.exp(np.outer(-1j * k, xs) + np.outer(b, ys)) * scale
        up_p = np.hstack([(-1j * k / a)[:, None] * up_p, up_p])  # potentials of a force along x, along y
        up_s = np.hstack([up_s, (1j * k / b)[:, None] * up_s])
        first = -omega[:, None] * up_p - (coupling * b)[:, None] * up_s
        last = (coupling * a)[:, None] * up_p - omega[:, None] * up_s
        rayleigh = (omega**2 + coupling**2 * a * b)[:, None]
        down_p = (omega[:, None] * first + (coupling * b)[:, None] * last) / rayleigh
        down_s = (omega[:, None] * last - (coupling * a)[:, None] * first) / rayleigh
        p, s = np.exp(1j * np.outer(x, k) + np.outer(y, a)), np.exp(1j * np.outer(x, k) + np.outer(y, b))
        sideways = -self.lame * self.k_p**2 - 2 * k**2
        factors = ((1j * k, b), (a, -1j * k), (sideways, coupling * b), (omega, -coupling * b), (coupling * a, omega))
        return np.array([(p * f) @ down_p + (s * h) @ down_s for f, h in factors[wanted]])


def decaying(square):
    """Root with a real part >= 0, or outgoing for exp(i w t)."""
    root = np.sqrt(square)
    return np.where((root.real < 1e-12 * abs(root)) & (root.imag < 0), -root, root)


def radial(k, r):
    """g, g', g'' - g'/r, g'/r and the third derivative's two parts, of g = -(i/4) H_0^(2)(k r)."""
    g, slope = -0.25j * hankel2(0, k * r), 0.25j * k * hankel2(1, k * r)
    over = slope / r
    curvature = -(k**2) * g - over
    change = (curvature - over) / r  # of g'/r
    return g, slope, curvature - over, over, -(k**2) * slope - 4 * change, change


def second(g, n, i, j):
    return g[2] * n[i] * n[j] + (g[3] if i == j else 0)


def third(g, n, r, i, j, k):
    mixed = (n[k] if i == j else 0) + (n[j] if i == k else 0) + (n[i] if j == k else 0)
    return g[4] * n[i] * n[j] * n[k] + g[5] * mixed


def traction(stress, normal):
    """(2 n, ...) of stress (3, n, ...) on faces with the normals (n, 2)."""
    nx, ny = (normal[:, i].reshape(-1, *([1] * (stress.ndim - 2))) for i in (0, 1))
    return np.concatenate([stress[0] * nx + stress[2] * ny, stress[2] * nx + stress[1] * ny])


class Semicircle:
    """Canyon of radius 1: points and normals (out of the rock) to fit, half as many sources on a circle inside."""

    def __init__(self, count=120, offset=0.3, least=0.05):
        """offset: of the circle of sources; least: depth that none of them falls short of."""
        angle = np.pi * (np.arange(count) + 0.5) / count
        self.points = np.column_stack([np.cos(angle), -np.sin(angle)])
        self.normals = -self.points
        inner = np.pi * (np.arange(count // 2) + 0.5) / (count // 2)
        ring = (1 - offset) * np.column_stack([np.cos(inner), -np.sin(inner)])
        self.sources = ring[ring[:, 1] < -least]


def scattered(half_space, cut, waves, receivers):
    """By wave: displacement over that of the wave from below (2, receivers); traction left on the cut over that of the flat ground's wave."""
    matrix = traction(half_space.stress(cut.points, cut.sources), cut.normals)  # of line forces, whatever the wave
    u = half_space.displacement(receivers, cut.sources)
    size, found = np.linalg.norm(matrix, axis=0), {}
    for wave in waves:
        wanted = -traction(half_space.incident(wave, cut.points)[1], cut.normals)
        strength = np.linalg.lstsq(matrix / size, wanted, rcond=1e-13)[0] / size
        left = np.linalg.norm(matrix @ strength - wanted) / np.linalg.norm(wanted)
        found[wave] = half_space.incident(wave, receivers)[0] + u @ strength, left
    return found
