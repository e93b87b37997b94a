# SPDX-License-Identifier: GPL-3.0-or-later
"""Means over seeds of stochastic motions of the base against the source's spectrum (Boore 2003), which is written anew here."""

import numpy as np
from noise_spectrum import Accelerogram, octaves, in_band
from scene_numbers import Numbers
from scipy.optimize import curve_fit

SEEDS = 40


class Source:
    """Point source of one corner frequency (Brune 1970)."""

    def __init__(self, run):
        numbers = Numbers(run)

        def number(name):
            return numbers.number("Motion/" + name)

        self.moment = 10 ** (1.5 * number("Magnitude") + 9.05)
        self.speed, self.density, self.distance = number("Source velocity"), number("Source density"), number("Distance")
        self.corner = 0.49 * self.speed * (number("Stress drop") / self.moment) ** (1 / 3)
        self.quality, self.exponent, self.kappa = number("Quality factor"), number("Quality exponent"), number("Kappa")
        self.surface = 2.0 if numbers.text("Motion/Meaning") == "outcrop" else 1.0
        self.band = number("Lowest frequency"), number("Highest frequency")
        self.duration = 1 / self.corner + 0.05e-3 * self.distance

    def path(self, f):
        """What is left of it on the way [-]."""
        return np.exp(-np.pi * f * (self.distance / (self.quality * f**self.exponent * self.speed) + self.kappa))

    def amplitude(self, f, corner=None):
        """Fourier amplitude of the acceleration [m/s]."""
        long_periods = self.surface * 0.55 / np.sqrt(2) * self.moment / (4 * np.pi * self.density * self.speed**3 * self.distance)
        return long_periods * (2 * np.pi * f) ** 2 / (1 + (f / (corner or self.corner)) ** 2) * self.path(f)

    def tapered(self, f):
        """The same with the band's tapers, cosines of a quarter of an octave."""
        rise = [0.5 * (1 - np.cos(np.pi * np.clip(4 * np.log2(ratio), 0, 1))) for ratio in (f / self.band[0], self.band[1] / f)]
        return self.amplitude(f) * rise[0] * rise[1]


def window_duration():
    """From 5 to 95 % of the energy of Saragoni & Hart's window (1974), peak 1 at 0.2, 0.05 at 1, up to 1.5 [of t_n]."""
    s = np.linspace(1e-6, 1.5, 150001)
    b = -0.2 * np.log(0.05) / (1 + 0.2 * (np.log(0.2) - 1))
    energy = np.cumsum(((np.e / 0.2 * s) ** b * np.exp(-b / 0.2 * s)) ** 2)
    return np.diff(np.interp([0.05, 0.95], energy / energy[-1], s))[0]


def check(case):
    case.shown = []
    for name, seeds, further in (("M 5.1 at 20 km", SEEDS, []),
                                 ("M 6.5 at 60 km", SEEDS, ["Motion/Magnitude=6.5", "Motion/Distance=60e3", "Motion/Stress drop=10e6",
                                                            "Motion/Lowest frequency=0.1", "Time/End time=75"])):
        runs = [case.run("%s_seed_%d" % (name.replace(" ", "_"), seed), "Motion/Seed=%d" % seed, *further) for seed in range(1, seeds + 1)]
        source, motions = Source(runs[0]), [Accelerogram(run) for run in runs]
        f = motions[0].frequency[1:]
        power = np.mean([motion.power[1:] for motion in motions], axis=0)
        expected = source.tapered(f) ** 2
        inside = f < 0.2 / motions[0].step  # ten samples and more in two periods
        case.near(name + ": intensity over the source's", (power[inside].sum() / expected[inside].sum()), 1.0, 0.1)
        for low, high in octaves(source.band[0] * 2**0.25, 25 / 2**0.25):
            at = in_band(f, low, high)
            case.near(name + ": amplitude over the source's, %.3g to %.3g Hz" % (low, high),
                      np.sqrt(np.mean(power[at] / expected[at])), 1.0, 0.15)
        at = in_band(f, source.band[0] * 2**0.25, 10.0)
        (corner,), _ = curve_fit(lambda x, corner: np.log(source.amplitude(x, corner)), f[at], 0.5 * np.log(power[at]), (1.0,),
                                 sigma=np.sqrt(f[at]), bounds=(0.01, 10.0))
        case.near(name + ": corner frequency", corner, source.corner, 0.05, "Hz")
        found = np.mean([motion.significant_duration() for motion in motions])
        case.near(name + ": mean 5 to 95 % duration", found, 2 * source.duration * window_duration(), 0.1, "s")
        case.shown.append((name, f, np.sqrt(power), source))


def draw(case, figure):
    axes = figure.subplots()
    for name, f, amplitude, source in case.shown:
        axes.loglog(f, amplitude, lw=0.6, label="program, %s, mean of %d" % (name, SEEDS))
        axes.loglog(f, source.amplitude(f), "k--", lw=1, label="source" if source is case.shown[0][3] else None)
    axes.set(xlim=(0.1, 25), ylim=(1e-4, 3), xlabel="frequency [Hz]", ylabel="Fourier amplitude of the acceleration [m/s]")
    axes.legend()
