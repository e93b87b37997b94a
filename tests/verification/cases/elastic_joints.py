# SPDX-License-Identifier: GPL-3.0-or-later
"""Elastic joints in a row: transmission by transfer matrices, one joint |T| = 1 / sqrt(1 + (w Z / 2 k)^2).

The free end of the bar doubles what has passed the joints: until the wave that it sends back returns from the joints, the
end with joints over the end of the same bar without joints is the transmission.
"""

import numpy as np
from layered_column import Layer, fourier
from scene_numbers import Numbers

FREQUENCIES = (0.4, 0.6, 0.8, 1.0, 1.3, 1.6)  # over that of the motion
RINGING = {1: 8.0, 3: 15.0, 5: 36.0}  # time after the pulse until the joints' multiples have faded, in its periods
COLOURS = {1: "#1f5a94", 3: "#d98b2b", 5: "#c8202f"}


class Joints:
    def __init__(self, numbers, wave, count):
        self.rock, self.count = Layer(0.0, numbers.material("rock"), wave), count
        self.spacing = numbers.mesh("Spacing")
        self.stiffness = numbers.number("Bedding planes/%s stiffness" % ("Shear" if wave == "S" else "Normal"))

    def transmission(self, frequency):
        z, omega = self.rock.impedance, 2 * np.pi * frequency
        k = omega / self.rock.speed
        c, s = np.cos(k * self.spacing), np.sin(k * self.spacing)
        motion, stress = 1.0 + 0j, -1j * omega * z  # an upgoing wave above the last joint
        for joint in range(self.count):
            if joint > 0:
                motion, stress = motion * c - stress * s / (omega * z), motion * omega * z * s + stress * c
            motion = motion - stress / self.stiffness  # the joint closes by stress / k from above to below
        return 2.0 / (motion - stress / (1j * omega * z))  # incident: (u - tau / (i w Z)) / 2

    def single(self, frequency):
        return 1 / np.sqrt(1 + (np.pi * frequency * self.rock.impedance / self.stiffness) ** 2)


def end_motion(run):
    return run.history("monitors/end/velocity")[:, 1]


def run_bar(case, numbers, wave, joints, welded=False):
    """The bar with a number of joints until the reflection from its end returns; welded: without them."""
    rock, f = Layer(0.0, numbers.material("rock"), wave), numbers.number("Motion/Frequency")
    length, middle, lying = numbers.mesh("Length"), numbers.mesh("Width") / 2, wave == "S"
    behind = length - numbers.mesh("First plane") - (joints - 1) * numbers.mesh("Spacing")
    end = min(length / rock.speed + (3.0 + RINGING[joints]) / f, (length + 2 * behind) / rock.speed)
    return case.run(
        "%s_%s" % (wave, "welded" if welded else joints),
        "Monitors/Points=end: %g, %g" % ((length, middle) if lying else (middle, length)),
        "Bedding planes/Names=" + ("" if welded else ",".join("bedding_%d" % (n + 1) for n in range(joints))),
        "Time/End time=%.10g" % (numbers.number("Time/Time step") * np.floor(end / numbers.number("Time/Time step"))),
        mesh={"Lying": lying, "Planes": joints})


def check(case):
    case.curves = {}
    first = case.run()  # S wave, one joint
    numbers = Numbers(first)
    frequencies = numbers.number("Motion/Frequency") * np.array(FREQUENCIES)
    for wave in "SP":
        welded = run_bar(case, numbers, wave, max(RINGING), welded=True)
        for count in RINGING:
            run = first if (wave, count) == ("S", 1) else run_bar(case, numbers, wave, count)
            joints = Joints(numbers, wave, count)
            end, whole = end_motion(run), end_motion(welded)
            found = [abs(fourier(run.time, end, f) / fourier(welded.time, whole, f)) for f in frequencies]
            for f, t in zip(frequencies, found):
                name = "%s, %d joints, %.3g Hz: |T|" % (wave, count, f)
                case.near(name, t, abs(joints.transmission(f)), 0.02)
                if count == 1:
                    case.near(name + ", formula of one joint", t, joints.single(f), 0.02)
            case.below("%s, %d joints: motion left at the end over its peak" % (wave, count),
                       abs(end[-200:]).max() / abs(end).max(), 0.005)
            case.below("%s, %d joints: energy residual" % (wave, count), run.summary["energy_residual"], 1e-3)
            case.curves[wave, count] = joints, frequencies, found


def draw(case, figure):
    panels = dict(zip("SP", figure.subplots(1, 2, sharey=True)))
    for (wave, count), (joints, frequencies, found) in case.curves.items():
        f = np.linspace(0.5 * frequencies[0], 1.1 * frequencies[-1], 500)
        panels[wave].plot(f, [abs(joints.transmission(x)) for x in f], color=COLOURS[count], lw=1,
                          label="%d, closed form" % count)
        panels[wave].plot(frequencies, found, "o", color=COLOURS[count], ms=5, label="%d, program" % count)
        panels[wave].set_xlabel("frequency [Hz]")
        panels[wave].set_title(wave + " wave")
    panels["S"].set_ylabel("transmission |T| [-]")
    panels["S"].set_ylim(0, 1.05)
    panels["S"].legend(title="joints", ncol=2, fontsize=8, loc="lower left")
