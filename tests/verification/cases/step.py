# SPDX-License-Identifier: GPL-3.0-or-later
"""Step in the ground under a vertically incident S wave: motion along the ground over that of flat ground.

There is no closed form. Asked is what Ashford et al. (1997) found with another method, the regression of Bouckovalas & Papadimitriou
(2005), and that a finer mesh in a wider box gives the same.
"""

import numpy as np
from layered_column import fourier
from scene_numbers import Numbers

ANGLES = (30, 60, 90)  # [deg]
HEIGHTS = np.linspace(0.06, 0.6, 55)  # of the step over the wave length
ALONG = np.concatenate([-np.arange(5, -0.1, -0.5), np.arange(0, 5.1, 0.5)])  # behind the crest, before the toe, over the height
FINER = {"Half width": 1200, "Depth": 800, "Resolution/h": 30, "Resolution/step": 12.5}
COLOURS = {30: "#1f5a94", 60: "#d98b2b", 90: "#c8202f"}

shown = {}


def regression(angle, heights):
    """Largest horizontal amplification along the ground by the regression of Bouckovalas & Papadimitriou (2005), without damping, as Ju, Jia & Pan
    give it (Prediction framework of slope topographic amplification, equations 10 to 14). Its authors state 29 to 40 % of scatter."""
    steepness = angle / 90
    by_angle = (steepness**2 + 2 * steepness**6) / (steepness**3 + 0.02)
    return 1 + 0.225 * by_angle * heights**0.4


def places(height, angle):
    """Points along the upper ground to the crest and from the toe on."""
    crest = 0.0 if angle == 90 else -height / np.tan(np.radians(angle))
    half = len(ALONG) // 2
    return [(crest + height * at, height) for at in ALONG[:half]] + [(height * at, 0.0) for at in ALONG[half:]]


def amplification(run, frequencies):
    """Horizontal and vertical motion over flat ground's (twice the incident wave's): 2 x points x frequencies."""
    outcrop = run.history("input/velocity")[:, 0]
    flat = np.array([fourier(run.time, outcrop, f) for f in frequencies])
    motions = [run.history("monitors/%s/velocity" % name) for name in run.names("monitors")]
    return np.array([[[abs(fourier(run.time, motion[:, k], f)) for f in frequencies] for motion in motions]
                     for k in (0, 1)]) / abs(flat)


def run_step(case, height, angle, variant, mesh=None, *settings):
    points = "; ".join("g%02d: %.9g, %.9g" % (n, *place) for n, place in enumerate(places(height, angle)))
    return case.run(variant, "Monitors/Points=" + points, *settings, mesh=dict(mesh or {}, Angle=angle))


def check(case, angles=ANGLES, finer=()):
    numbers = Numbers(case.run("scene"))
    height, rock = numbers.mesh("Height"), numbers.material("rock")
    frequencies = HEIGHTS * rock.speed("S") / height
    crest, toe = len(ALONG) // 2 - 1, len(ALONG) // 2
    for angle in angles:
        run = run_step(case, height, angle, "angle_%g" % angle)
        shown[angle] = found = amplification(run, frequencies)
        case.below("%g deg: energy residual" % angle, run.summary["energy_residual"], 1e-3)
        if angle in finer:
            later = (FINER["Depth"] - numbers.mesh("Depth")) / rock.speed("S")
            fine = run_step(case, height, angle, "finer_%g" % angle, FINER,
                            "Time/End time=%g" % (numbers.number("Time/End time") + later),
                            "Time/Time step=%g" % (numbers.number("Time/Time step") / 2))
            difference = found - amplification(fine, frequencies)
            case.below("%g deg: crest and toe, largest difference from a finer mesh in a wider box" % angle,
                       abs(difference[:, [crest, toe]]).max(), 0.05)
            case.below("%g deg: %d points, root of the mean square of the difference" % (angle, len(ALONG)),
                       np.sqrt((difference**2).mean()), 0.03)
    vertical_step = shown[90]
    case.within("90 deg: height over wave length where the crest moves most (Ashford et al. 1997)",
                HEIGHTS[vertical_step[0, crest].argmax()], 0.2, 0.02)
    peaks = [shown[angle][0, crest].max() for angle in angles]
    case.true("the crest moves more than flat ground, the more the steeper: %s" % np.round(peaks, 3),
              1.05 < peaks[0] and np.all(np.diff(peaks) > 0))
    least = [shown[angle][0, toe].min() for angle in angles]
    case.true("the toe moves less than flat ground, the less the steeper: %s" % np.round(least, 3),
              least[0] < 0.8 and np.all(np.diff(least) < 0))
    for angle in angles:
        largest, expected = shown[angle][0].max(axis=0), regression(angle, HEIGHTS)
        case.below("%g deg: largest along the ground %.2f to %.2f, regression %.2f to %.2f; root of the mean square of the difference"
                   % (angle, largest.min(), largest.max(), expected.min(), expected.max()), np.sqrt(np.mean((largest - expected)**2)), 0.2)
    parasitic = [(shown[angle][1, crest] / shown[angle][0, crest]).max() for angle in angles]
    case.true("vertical over horizontal motion of the crest grows with the angle, beyond 1: %s" % np.round(parasitic, 3),
              np.all(np.diff(parasitic) > 0) and parasitic[-1] > 1)


def draw(case, figure):
    grid = figure.subplots(2, 3, sharex="col", sharey="row")
    crest, half = len(ALONG) // 2 - 1, len(ALONG) // 2
    at = np.abs(HEIGHTS - 0.2).argmin()
    for row, what in enumerate(("horizontal", "vertical")):
        for angle, colour in COLOURS.items():
            found = shown[angle][row]
            grid[row, 0].plot(HEIGHTS, found[crest], color=colour, lw=1.2, label="%g deg" % angle)
            grid[row, 2].plot(HEIGHTS, found.max(axis=0), color=colour, lw=1.2)
            if row == 0:
                grid[row, 2].plot(HEIGHTS, regression(angle, HEIGHTS), color=colour, lw=1, ls="--")
            for part in (slice(0, half), slice(half, None)):
                shift = -0.5 if part.start == 0 else 0.5  # the slope in between is not to scale
                grid[row, 1].plot(ALONG[part] + shift, found[part, at], ".-", color=colour, lw=1, ms=4)
        grid[row, 0].set_ylabel("%s motion over\nflat ground's [-]" % what)
        grid[row, 1].axvspan(-0.5, 0.5, color="0.9", lw=0)
    for axes in grid[0]:
        axes.axhline(1, color="0.5", lw=0.6)
    grid[0, 0].axvline(0.2, ymax=0.8, color="k", ls=":", lw=1, label="Ashford et al.: most at 0.2")
    grid[0, 0].set_title("crest", fontsize=9)
    grid[0, 1].set_title("along the ground, H / wave length = 0.2", fontsize=9)
    grid[0, 2].set_title("largest along the ground", fontsize=9)
    grid[0, 2].plot([], [], color="k", lw=1, ls="--", label="regression of Bouckovalas\n& Papadimitriou")
    grid[0, 2].legend(fontsize=7, loc="upper center")
    for axes in grid[1, ::2]:
        axes.set_xlabel("H / wave length of S [-]")
    grid[1, 1].set_xlabel("behind crest, before toe, / H [-]")
    grid[1, 1].set_xticks([x + 0.5 * np.sign(x) for x in (-4, -2, 2, 4)] + [-0.5, 0.5], ["4", "2", "2", "4", "0", "0"])
    grid[0, 0].set_ylim(0.3, 2.1)
    grid[0, 0].legend(fontsize=6, ncol=2, loc="upper center", columnspacing=1)
