# SPDX-License-Identifier: GPL-3.0-or-later
"""Elastic joints in a row: transmission by transfer matrices, one joint |T| = 1 / sqrt(1 + (w Z / 2 k)^2).

The free end of the bar doubles what has passed the joints, and the outcrop motion is twice the incident wave: until the
wave that the free end sends back returns from the joints, end over outcrop is the transmission.
"""

import numpy as np
from layered_column import Layer, fourier

LENGTH, FIRST, SPACING = 2500.0, 100.0, 20.0
FREQUENCIES = (4.0, 6.0, 8.0, 10.0, 13.0, 16.0)
STIFFNESS = {"S": 1e8, "P": 1.8e8}  # [Pa/m]
RINGING = {1: 0.8, 3: 1.5, 5: 3.6}  # time after the pulse until the joints' multiples have faded [s]
COLOURS = {1: "#1f5a94", 3: "#d98b2b", 5: "#c8202f"}

shown = {}


def rock(wave):
    return Layer(LENGTH, 2000.0, 5e9, 0.25, wave)


def transmission(wave, joints, frequency):
    material, omega = rock(wave), 2 * np.pi * frequency
    z, k = material.impedance, omega / material.speed
    c, s = np.cos(k * SPACING), np.sin(k * SPACING)
    motion, stress = 1.0 + 0j, -1j * omega * z  # an upgoing wave above the last joint
    for joint in range(joints):
        if joint > 0:
            motion, stress = motion * c - stress * s / (omega * z), motion * omega * z * s + stress * c
        motion = motion - stress / STIFFNESS[wave]  # the joint closes by stress / k from above to below
    return 2.0 / (motion - stress / (1j * omega * z))  # incident: (u - tau / (i w Z)) / 2


def run_bar(case, wave, joints):
    lying = wave == "S"
    speed = rock(wave).speed
    returns = (LENGTH + 2 * (LENGTH - FIRST - (joints - 1) * SPACING)) / speed
    end = min(LENGTH / speed + 0.3 + RINGING[joints], returns)
    names = ",".join("bedding_%d" % (n + 1) for n in range(joints))
    run = case.run(
        "%s_%d" % (wave, joints),
        "Mesh/Numbers=Lying=%d; Length=%g; Planes=%d; First plane=%g; Spacing=%g; Resolution/h=10"
        % (lying, LENGTH, joints, FIRST, SPACING),
        "Monitors/Points=end: " + ("%g, 5" if lying else "5, %g") % LENGTH,
        "Bedding planes/Names=" + names,
        "Time/End time=%.6g" % (np.floor(end / 5e-4) * 5e-4),
    )
    return run, run.history("monitors/end/velocity")[:, 1], run.history("input/velocity")[:, 1]


def check(case):
    for wave in ("S", "P"):
        for joints in (1, 3, 5):
            run, end, outcrop = run_bar(case, wave, joints)
            for f in FREQUENCIES:
                found = abs(fourier(run.time, end, f) / fourier(run.time, outcrop, f))
                name = "%s, %d joints, %g Hz: |T|" % (wave, joints, f)
                case.near(name, found, abs(transmission(wave, joints, f)), 0.02)
                if joints == 1:
                    ratio = np.pi * f * rock(wave).impedance / STIFFNESS[wave]
                    case.near(name + ", formula of one joint", found, 1 / np.sqrt(1 + ratio**2), 0.02)
                shown.setdefault((wave, joints), []).append((f, found))
            case.below("%s, %d joints: motion left at the end over its peak" % (wave, joints),
                       abs(end[-200:]).max() / abs(end).max(), 0.005)
            case.below("%s, %d joints: energy residual" % (wave, joints), run.summary["energy_residual"], 1e-3)


def draw(case, figure):
    f = np.linspace(2, 18, 500)
    for axes, wave in zip(figure.subplots(1, 2, sharey=True), ("S", "P")):
        for joints, colour in COLOURS.items():
            axes.plot(f, [abs(transmission(wave, joints, x)) for x in f], color=colour, lw=1,
                      label="%d, closed form" % joints)
            axes.plot(*np.transpose(shown[wave, joints]), "o", color=colour, ms=5, label="%d, program" % joints)
        axes.set_xlabel("frequency [Hz]")
        axes.set_title(wave + " wave")
    figure.axes[0].set_ylabel("transmission |T| [-]")
    figure.axes[0].set_ylim(0, 1.05)
    figure.axes[0].legend(title="joints", ncol=2, fontsize=8, loc="lower left")
