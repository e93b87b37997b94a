# SPDX-License-Identifier: GPL-3.0-or-later
"""Means over seeds of synthetic motions of the base against their power spectrum, with and without the second filter.

a(t) = w(t) sum over k of sqrt(S(f_k)) (c_k cos + s_k sin)(2 pi f_k t), c_k and s_k Gaussian. So the mean square of whatever is linear in a, as a Fourier
amplitude or the displacement, is the sum over k of S(f_k) times the squares that cos and sin give. Each motion is scaled to its peak; so all is
taken over its intensity.
"""

import numpy as np
from noise_spectrum import Accelerogram, in_band, octaves
from scene_numbers import Numbers

SPECTRA = ("Clough-Penzien", "Kanai-Tajimi")
LOW, HIGH = 0.025, 0.1  # lowest frequencies [Hz]
SEEDS = {LOW: 30, HIGH: 15}


def kanai_tajimi(r, damping=0.6):
    return (1 + (2 * damping * r) ** 2) / ((1 - r**2) ** 2 + (2 * damping * r) ** 2)


def second_filter(r, damping=0.6, corner=0.1):
    q = r / corner
    return q**4 / ((1 - q**2) ** 2 + (2 * damping * q) ** 2)


def envelope(s):
    return np.where(s < 0.15, (s / 0.15) ** 2, np.where(s <= 0.6, 1.0, np.cos(0.5 * np.pi * (s - 0.6) / 0.4) ** 2)) * (s <= 1)


def integral(values, step):
    """From the start, by trapezoids, over the last axis."""
    mean = 0.5 * (values[..., 1:] + values[..., :-1]) * step
    return np.concatenate([np.zeros(values.shape[:-1] + (1,)), np.cumsum(mean, axis=-1)], axis=-1)


class Expected:
    """Mean power [1/Hz] at the frequencies of a motion and mean square displacement [s^4], each over the mean square of the acceleration."""

    def __init__(self, run, motion):
        numbers = Numbers(run)
        ground, low, high, duration = (numbers.number("Motion/" + name)
                                       for name in ("Frequency", "Lowest frequency", "Highest frequency", "Duration"))
        lines = np.arange(int((high - low) * 2 * duration + 1e-9))
        f = low + (lines + 0.5) / (2 * duration)
        self.spectrum = kanai_tajimi(f / ground)
        if numbers.text("Motion/Noise spectrum") == "Clough-Penzien":
            self.spectrum = self.spectrum * second_filter(f / ground)
        time = motion.time[motion.time <= duration + 1e-9]
        window = envelope(time / duration)
        power, square, intensity = np.zeros(len(motion.frequency)), np.zeros(len(time)), 0.0
        for line, s in zip(f, self.spectrum):
            for wave in (np.cos, np.sin):
                a = window * wave(2 * np.pi * line * time)
                power += s * np.abs(np.fft.rfft(a, len(motion.time))) ** 2 * motion.step**2
                square += s * self.at_rest_in_the_end(a, time, duration, motion.step) ** 2
                intensity += s * np.sum(a**2) * motion.step
        self.power, self.displacement = power / intensity, np.sqrt(np.mean(square) / intensity)

    @staticmethod
    def at_rest_in_the_end(a, time, duration, step):
        """Displacement after the baseline correction: less two bumps, so that velocity and displacement end at zero."""
        bump = np.sin(np.pi * time / duration) ** 2
        shapes = np.array([bump, bump * np.cos(np.pi * time / duration), a])
        v = integral(shapes, step)
        u = integral(v, step)
        factors = np.linalg.solve(np.array([v[:2, -1], u[:2, -1]]), [v[2, -1], u[2, -1]])
        return u[2] - factors @ u[:2]


class Ensemble:
    """The motions of several seeds, each over its intensity."""

    def __init__(self, case, spectrum, lowest):
        runs = [case.run("%s_%g_%d" % (spectrum, lowest, seed), "Motion/Noise spectrum=" + spectrum, "Motion/Lowest frequency=%g" % lowest,
                         "Motion/Seed=%d" % seed) for seed in range(1, SEEDS[lowest] + 1)]
        motions = [Accelerogram(run) for run in runs]
        first = motions[0]
        duration = Numbers(runs[0]).number("Motion/Duration")
        while_it_lasts = first.time <= duration + 1e-9
        intensity = [np.sum(motion.acceleration**2) * first.step for motion in motions]
        self.frequency, self.time, self.one = first.frequency, first.time, first
        self.power = np.mean([motion.power / i for motion, i in zip(motions, intensity)], axis=0)
        self.displacement = np.sqrt(np.mean([np.mean(motion.displacement[while_it_lasts] ** 2) / i
                                             for motion, i in zip(motions, intensity)]))
        self.last = max(np.abs(motion.displacement[first.time > duration + first.step]).max() / np.abs(motion.displacement).max()
                        for motion in motions)
        self.expected = Expected(runs[0], first)


def check(case):
    case.shown = {(spectrum, lowest): Ensemble(case, spectrum, lowest) for lowest in SEEDS for spectrum in SPECTRA}
    for spectrum in SPECTRA:
        both = case.shown[spectrum, LOW]
        for low, high in octaves(0.0625, 8):
            at = in_band(both.frequency, low, high)
            case.near("%s: amplitude over the spectrum's, %.3g to %.3g Hz" % (spectrum, low, high),
                      np.sqrt(both.power[at].sum() / both.expected.power[at].sum()), 1.0, 0.15)
        for lowest in SEEDS:
            found = case.shown[spectrum, lowest]
            case.near("%s from %g Hz on: displacement over the root of the intensity" % (spectrum, lowest), found.displacement,
                      found.expected.displacement, 0.3)
            case.below("%s from %g Hz on: displacement after the motion over its peak" % (spectrum, lowest), found.last, 1e-9)
    with_filter, without = (case.shown[spectrum, LOW] for spectrum in SPECTRA)
    at = in_band(with_filter.frequency, 0.15, 0.25)  # the noise is the same, so its scatter falls out
    expected = with_filter.expected.power[at].sum() / without.expected.power[at].sum()
    case.near("what the second filter leaves at its corner, of the same seeds", with_filter.power[at].sum() / without.power[at].sum(), expected, 0.1)
    growth = [case.shown[spectrum, LOW].displacement / case.shown[spectrum, HIGH].displacement for spectrum in SPECTRA]
    case.true("displacement from %g Hz on over that from %g Hz on: %.2f, without the second filter %.2f" % (LOW, HIGH, *growth),
              growth[0] < 1.5 and growth[1] > 4)


def draw(case, figure):
    spectrum, history = figure.subplots(1, 2)
    for name, color in zip(SPECTRA, ("C0", "C1")):
        both = case.shown[name, LOW]
        spectrum.loglog(both.frequency, np.sqrt(both.power), color, lw=0.5)
        spectrum.loglog(both.frequency, np.sqrt(both.expected.power), "k--", lw=1)
        history.plot(both.time, 100 * both.one.displacement, color, label=name)
    spectrum.set(xlim=(0.03, 10), ylim=(1e-3, 2), xlabel="frequency [Hz]", ylabel="Fourier amplitude over the root of the intensity [s^0.5]",
                 title="mean of %d seeds; dashed: closed form" % SEEDS[LOW])
    history.set(xlabel="time [s]", ylabel="displacement [cm]", title="seed 1, peak 1 m/s2")
    history.legend()
