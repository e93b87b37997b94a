# SPDX-License-Identifier: GPL-3.0-or-later
"""Vertically incident plane wave in a layered column over an undamped half space: transfer matrices.

Rayleigh damping C = alpha M + beta K: rho (w^2 - i alpha w) = G (1 + i beta w) k^2 for exp(i w t).
"""

import numpy as np


class Layer:
    def __init__(self, thickness, material, wave):
        """wave: "S" or "P"; thickness [m], material of scene_numbers."""
        self.thickness, self.density = thickness, material.density
        self.modulus = material.shear_modulus if wave == "S" else material.oedometer
        self.speed = np.sqrt(self.modulus / self.density)
        self.impedance = self.density * self.speed

    def wave_number(self, omega, alpha=0.0, beta=0.0):
        return np.sqrt(self.density * (omega**2 - 1j * alpha * omega) / (self.modulus * (1 + 1j * beta * omega)))


def surface_over_outcrop(layers, half_space, omega, alpha=0.0, beta=0.0):
    """Complex ratio at the angular frequency omega; layers from the top down."""
    motion, stress = 1.0 + 0j, 0.0 + 0j  # u and tau = G* du/dy (y up) at the free surface
    for layer in layers:
        k = layer.wave_number(omega, alpha, beta)
        stiff = layer.modulus * (1 + 1j * beta * omega) * k
        c, s = np.cos(k * layer.thickness), np.sin(k * layer.thickness)
        motion, stress = motion * c - stress * s / stiff, motion * stiff * s + stress * c
    # in the half space tau = Z (v - 2 v_up), so the outcrop moves by 2 u_up = u - tau / (i w Z)
    return 1.0 / (motion - stress / (1j * omega * half_space.impedance))


def fourier(time, values, frequency):
    """Fourier integral of equally spaced samples at a frequency [Hz]."""
    return np.sum(values * np.exp(-2j * np.pi * frequency * time)) * (time[1] - time[0])


def surface_motion(time, outcrop, layers, half_space, alpha=0.0, beta=0.0):
    """Motion of the surface at the times of the outcrop's (equally spaced, at rest before and after)."""
    n = 1 << int(np.ceil(np.log2(8 * len(time))))  # zeros behind, in which the layers come to rest
    omega = 2 * np.pi * np.fft.rfftfreq(n, time[1] - time[0])
    omega[0] = omega[1] * 1e-6  # the limit at rest, without its division by zero
    return np.fft.irfft(np.fft.rfft(outcrop, n) * surface_over_outcrop(layers, half_space, omega, alpha, beta), n)[: len(time)]
