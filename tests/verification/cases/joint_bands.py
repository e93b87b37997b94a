# SPDX-License-Identifier: GPL-3.0-or-later
"""Ground above a row of elastic joints: motion over that of the incident wave at all frequencies, by transfer matrices."""

import numpy as np
from layered_column import Layer, fourier
from scene_numbers import Numbers

COUNTS, SPACINGS = (1, 4), (50, 25)  # joints; apart and below the ground [m]
BAND = (0.1, 1.9)  # frequencies that are compared, over that of the motion
COLOURS = {0: "0.5", 1: "#1f5a94", 4: "#c8202f"}

shown = {}


class Row:
    """Joints at depths of 1, 2 ... spacings below the ground."""

    def __init__(self, rock, stiffness, spacing, count):
        self.rock, self.stiffness, self.spacing, self.count = rock, stiffness, spacing, count

    def amplification(self, frequency):
        """Ground over incident wave (complex)."""
        z, omega = self.rock.impedance, 2 * np.pi * frequency
        c, s = np.cos(omega / self.rock.speed * self.spacing), np.sin(omega / self.rock.speed * self.spacing)
        motion, stress = np.ones_like(frequency) + 0j, 0j * frequency
        for _ in range(self.count):
            motion, stress = motion * c - stress * s / (omega * z), motion * omega * z * s + stress * c
            motion = motion - stress / self.stiffness
        return 2 / (motion - stress / (1j * omega * z))  # incident: (u - tau / (i w Z)) / 2

    def stops(self, frequency):
        """Whether a wave dies out in an endless row: cosine of its phase from joint to joint above 1."""
        phase = 2 * np.pi * frequency * self.spacing / self.rock.speed
        return abs(np.cos(phase) - np.pi * frequency * self.rock.impedance / self.stiffness * np.sin(phase)) > 1


def run_bar(case, numbers, wave, count, spacing):
    first, middle, lying = numbers.mesh("First plane"), numbers.mesh("Width") / 2, wave == "S"
    length = first + max(count, 1) * spacing
    return case.run("%s_%d_%g" % (wave, count, spacing),
                    "Monitors/Points=ground: %g, %g" % ((length, middle) if lying else (middle, length)),
                    "Bedding planes/Names=" + ",".join("bedding_%d" % (n + 1) for n in range(count)),
                    mesh={"Lying": lying, "Planes": max(count, 1), "Spacing": spacing, "Length": length})


def check(case):
    numbers = Numbers(case.run("scene"))
    frequency = numbers.number("Motion/Frequency") * np.linspace(*BAND, 181)
    for wave in "SP":
        rock = Layer(0.0, numbers.material("rock"), wave)
        stiffness = numbers.number("Bedding planes/%s stiffness" % ("Shear" if wave == "S" else "Normal"))
        for count, spacing in [(0, SPACINGS[0])] + [(n, d) for d in SPACINGS for n in COUNTS]:
            run, row = run_bar(case, numbers, wave, count, spacing), Row(rock, stiffness, spacing, count)
            ground, incident = run.history("monitors/ground/velocity")[:, 1], 0.5 * run.history("input/velocity")[:, 1]
            found = np.array([abs(fourier(run.time, ground, f) / fourier(run.time, incident, f)) for f in frequency])
            expected = abs(row.amplification(frequency))
            what = "%s, %d joints, %g m: " % (wave, count, spacing)
            case.below(what + "difference over flat ground's 2, largest of %d frequencies" % len(frequency),
                       abs(found - expected).max() / 2, 0.01)
            case.near(what + "least amplification", found.min(), expected.min(), 0.05)
            case.near(what + "peak amplification", found.max(), expected.max(), 0.01)
            case.below(what + "motion left at the end over its peak", abs(ground[-200:]).max() / abs(ground).max(), 1e-3)
            if count == 0:
                case.below(what + "flat ground over incident wave, off 2.00", abs(found - 2).max(), 0.005)
            case.below(what + "energy residual", run.summary["energy_residual"], 1e-3)
            shown[wave, spacing, count] = row, frequency, found
        for spacing in SPACINGS:
            shown[wave, spacing, 0] = shown[wave, SPACINGS[0], 0]


def draw(case, figure):
    for column, spacing in zip(figure.subplots(2, 2, sharex=True, sharey=True).T, SPACINGS):
        for axes, wave in zip(column, "SP"):
            for count in (0, *COUNTS):
                row, frequency, found = shown[wave, spacing, count]
                fine = np.linspace(frequency[0], frequency[-1], 800)
                what = "%d joint%s, formula" % (count, "" if count == 1 else "s")
                axes.plot(fine, abs(row.amplification(fine)), color=COLOURS[count], lw=1, label=what)
                axes.plot(frequency[::6], found[::6], "o", color=COLOURS[count], ms=3, label="program")
            axes.fill_between(fine, 0, 1, where=row.stops(fine), transform=axes.get_xaxis_transform(), color="0.9", lw=0,
                              label="endless row: nothing passes")
            axes.set_title("%s wave, joints %g m apart" % (wave, spacing), fontsize=9)
        axes.set_xlabel("frequency [Hz]")
    for axes in figure.axes[::2]:
        axes.set_ylabel("ground over incident [-]")
    figure.axes[0].set(xlim=(0, frequency[-1]), ylim=(0, 5.4))
    handles, labels = figure.axes[0].get_legend_handles_labels()
    for axes, some in zip(figure.axes, (slice(0, 6), slice(6, 7))):
        axes.legend(handles[some], labels[some], fontsize=7, ncol=3, loc="upper center", columnspacing=0.8, handlelength=1)
