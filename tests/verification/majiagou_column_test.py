# SPDX-License-Identifier: GPL-3.0-or-later
"""The column of majiagou_column.py against closed forms."""

import sys

import numpy as np

from majiagou_column import Column, Layer, Soil, transform

OMEGA = 2 * np.pi * np.linspace(0.05, 20, 400)


def soil(density, shear_modulus):
    result = Soil.__new__(Soil)
    result.density, result.shear_modulus = density, shear_modulus
    return result


def largest_error(column, elevations, expected):
    return max(np.abs(a - b).max() for a, b in zip(column.motion(elevations, OMEGA), expected))


def damped_layer():
    """Surface over outcrop 1 / (cos kH + i a sin kH), a the impedance ratio, k complex."""
    top, rock, height, time = soil(2000.0, 2e7), soil(2500.0, 2e10), 25.0, 0.008
    modulus = top.shear_modulus * (1 + 1j * OMEGA * time)
    k = OMEGA * np.sqrt(top.density / modulus)
    a = np.sqrt(top.density * modulus) / rock.impedance()
    surface = 1 / (np.cos(k * height) + 1j * a * np.sin(k * height))
    column = Column([Layer(height, 0.0, top, time), Layer(0.0, -100.0, rock, 0.0)])
    delay = np.exp(-1j * OMEGA * 100.0 / np.sqrt(rock.shear_modulus / rock.density))
    return largest_error(column, [height, 0.5 * height], [surface * delay, surface * np.cos(k * height / 2) * delay])


def elastic_joint():
    """A joint of stiffness k under a free layer is a layer's stress over k: u below = u above + tau / k."""
    rock, height, stiffness = soil(2450.0, 2.5e10), 40.0, 3e9
    k, z = OMEGA * height / np.sqrt(rock.shear_modulus / rock.density), rock.impedance()
    u, tau = np.cos(k), -OMEGA * z * np.sin(k)
    outcrop = u + tau / stiffness + tau / (1j * OMEGA * z)
    column = Column([Layer(height, -1e-6, rock, 0.0)], [(0.0, stiffness)])
    return largest_error(column, [height], [1 / outcrop])


def stress_under_a_layer():
    """Stress at the foot of a layer, -G k sin(kH) times the motion of its surface."""
    top, rock, height, dt = soil(2000.0, 2e7), soil(2500.0, 2e10), 25.0, 0.005
    time = np.arange(0, 8, dt)
    shaking = np.exp(-(((time - 3) / 1) ** 2)) * np.sin(2 * np.pi * 1.3 * time)
    omega, padded, spectrum = transform(shaking, dt)
    k = omega * np.sqrt(top.density / top.shear_modulus)
    surface = 1 / (np.cos(k * height) + 1j * top.impedance() / rock.impedance() * np.sin(k * height))
    stress = -top.shear_modulus * k * np.sin(k * height) * surface
    expected = np.fft.irfft(stress * spectrum / -(omega**2), padded)[: len(time)]
    found = Column([Layer(height, 0.0, top, 0.0), Layer(0.0, -1e-9, rock, 0.0)]).shear_stress(0.0, shaking, dt)
    return np.abs(found - expected).max() / np.abs(expected).max()


def main():
    failed = 0
    for case, tolerance in ((damped_layer, 1e-9), (elastic_joint, 1e-6), (stress_under_a_layer, 1e-9)):
        error = case()
        print("%s: largest error %.2e, allowed %.0e" % (case.__name__, error, tolerance))
        failed += int(error > tolerance)
    return failed


if __name__ == "__main__":
    sys.exit(main())
