# SPDX-License-Identifier: GPL-3.0-or-later
"""Lengths of a new section: elements by wavelength, margins by height and wavelength; times by frequency."""

import numpy as np

from hybrid_run import UserError

EDGES = 10  # per shortest wavelength
DEGREE = 2  # of the bedrock's elements: twice as many nodes as edges
MARGIN = 150.0  # of rock between a mass of SLOPE height and the sides [m]
SLOPE = 100.0  # [m]
BLOCK = 1.1  # largest block (root of its area) over the edge length h of the mesh
MOST_BLOCKS = 8000


def block_edge(material, mass, record, given, notes, finer=1.0):
    """Edge h of the blocks [m]: of the waves; smaller where the mass is thin, larger where there would be too many."""
    waves = finer * material.s_wave_speed / (EDGES * record.highest_frequency)
    thickest, x = mass.thickest
    if given:
        if given > thickest:
            raise UserError("--size is %g m, but the mass is only %.3g m thick (at x = %.4g m): give at most that, better %g m or less" % (
                given, thickest, x, rounded_down(thickest / 2.5)))
        return given
    h = rounded_down(waves / BLOCK)
    if h > thickest / 2.5:
        h = rounded_down(thickest / 2.5)
        notes.append("blocks: %g m instead of %.3g m, as the mass is only %.3g m thick (at x = %.4g m)" % (h, waves / BLOCK, thickest, x))
    fewest = np.sqrt(mass.polygon.area / (MOST_BLOCKS * 0.43))
    if h < fewest:
        resolved = material.s_wave_speed / (EDGES * BLOCK * rounded_up(fewest))
        notes.append("blocks: %.3g m instead of %.3g m, else there were %d of them; they resolve %.2g Hz of the motion's %.2g Hz" % (
            rounded_up(fewest), h, mass.polygon.area / (0.43 * h * h), resolved, record.highest_frequency))
        h = rounded_up(fewest)
    return h


def far_edge(material, record, h, finer=1.0):
    """Edge of bedrock elements where the ground is level [m]."""
    return max(rounded_down(finer * 0.7 * DEGREE * material.s_wave_speed / (EDGES * record.highest_frequency)), h or 0.0)


def ground_edge(profile, far, h):
    """Edge of bedrock elements at the slope [m]: five on its height; far, where it is too low to be seen by waves."""
    height = np.ptp(profile[:, 1])
    return far if height < 0.1 * far else max(min(rounded_down(0.2 * height), far), h or 0.0)


def margins(ground, mass, material, record, height):
    """(beside mass or slope, below the lowest point) [m]: 150 m for 100 m of height, at least a quarter of a wavelength, which waves see."""
    wave = material.s_wave_speed / record.mean_frequency
    beside = max(MARGIN * height / SLOPE, 0.25 * wave)
    return rounded_up(beside), rounded_up(max(0.75 * height, 0.125 * wave))


def time_step(record):
    """At most 4 ms, and forty steps per period of the highest frequency: 1 % in doc/accuracy-vs-time.md [s]."""
    return min(4e-3, rounded_down(1 / (40 * record.highest_frequency)))


def estimated_cost(blocks, unknowns, steps):
    """Processor time [s], within a factor of two: steps of the runs in doc/cost.md (two iterations each)."""
    return steps * (6e-6 * blocks + 3e-7 * unknowns)


def rounded_down(value, up=False):
    """Two digits."""
    power = 10.0 ** (np.floor(np.log10(value)) - 1)
    return float("%.6g" % ((np.ceil if up else np.floor)(round(value / power, 9)) * power))


def rounded_up(value):
    return rounded_down(value, True)
