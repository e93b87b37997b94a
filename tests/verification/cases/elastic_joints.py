# SPDX-License-Identifier: GPL-3.0-or-later
"""Elastic joints in a row: transmission by transfer matrices, one joint |T| = 1 / sqrt(1 + (w Z / 2 k)^2).

The free end of the bar doubles what has passed the joints: until the wave that it sends back returns from the joints, the
end with joints over the end of the same bar without joints is the transmission.
"""

import numpy as np
from layered_column import Layer, fourier
from scene_numbers import Numbers

FREQUENCIES = (0.4, 0.6, 0.8, 1.0, 1.3, 1.6)  # over that of the motion
COUNTS = (1, 3, 5)  # joints
FADED = 0.001  # of the peak: the multiples between the joints are over
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

    def ringing(self, frequency):
        """Time from the middle of a Ricker pulse of this frequency behind the joints until it has faded [s]."""
        duration, highest = 400 / frequency, 4 * frequency
        f = np.arange(1, int(duration * highest)) / duration
        passed = np.array([self.transmission(x) for x in f]) * (f / frequency) ** 2 * np.exp(-((f / frequency) ** 2))
        motion = abs(np.fft.irfft(np.concatenate([[0], passed, np.zeros(len(f))])))
        half = len(motion) // 2  # the later half is before the pulse
        return np.flatnonzero(motion[:half] > FADED * motion.max())[-1] * duration / len(motion)

    def single(self, frequency):
        return 1 / np.sqrt(1 + (np.pi * frequency * self.rock.impedance / self.stiffness) ** 2)


def end_motion(run):
    return run.history("monitors/end/velocity")[:, 1]


def run_bar(case, numbers, wave, joints, welded=False):
    """The bar with a number of joints until the reflection from its end returns; welded: without them.

    It is made longer where the multiples take longer to fade.
    """
    rock, f, step = Layer(0.0, numbers.material("rock"), wave), numbers.number("Motion/Frequency"), numbers.number("Time/Time step")
    middle, lying, h = numbers.mesh("Width") / 2, wave == "S", numbers.mesh("Resolution/h")
    last = numbers.mesh("First plane") + (max(COUNTS) - 1) * numbers.mesh("Spacing")
    ringing = {count: 3.0 / f + Joints(numbers, wave, count).ringing(f) for count in COUNTS}
    behind = max(numbers.mesh("Length") - last, h * np.ceil(rock.speed * max(ringing.values()) / (2 * h)))
    length = last + behind
    return case.run(
        "%s_%s" % (wave, "welded" if welded else joints),
        "Monitors/Points=end: %g, %g" % ((length, middle) if lying else (middle, length)),
        "Bedding planes/Names=" + ("" if welded else ",".join("bedding_%d" % (n + 1) for n in range(joints))),
        "Time/End time=%.10g" % (step * np.floor((length / rock.speed + ringing[joints]) / step)),
        mesh={"Lying": lying, "Planes": joints, "Length": length})


def check(case):
    case.curves = {}
    numbers = Numbers(case.run())
    frequencies = numbers.number("Motion/Frequency") * np.array(FREQUENCIES)
    for wave in "SP":
        welded = run_bar(case, numbers, wave, max(COUNTS), welded=True)
        for count in COUNTS:
            run = run_bar(case, numbers, wave, count)
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
