# SPDX-License-Identifier: GPL-3.0-or-later
"""What hybrid amplification computes, once for table, files and figures."""

import difflib
import os
import re

import numpy as np

from hybrid_run import MissingData, UserError, fourier_amplitude, has_energy

GAP = 5  # times the usual distance of two points: the line has a gap there


END = 0.1  # of a run: what still shakes then is missing in its spectra
QUIET = 0.1  # of the largest acceleration
REST = 1e-6  # of the outcrop motion: less is no motion
FEW = 3  # points of a polyline that say little between them


class Side:
    """One side of one line: peaks over those of the outcrop motion, and spectral ratios."""

    def __init__(self, study, line, side):
        self.study, self.line, self.name = study, line, side
        self.position, self.distance = line.position, line.distance
        self.ratio = line.peak_ratio(side, study.component)
        self.spectral = line.spectral_ratio(side, study.component, study.frequency, study.bandwidth)
        self.spectral[~study.is_clear] = np.nan  # also where zeros at its end refine it

    @property
    def label(self):
        return self.line.name if self.name == "on" else "%s, %s" % (self.line.name, self.name)

    def length(self):
        return float(self.distance[-1])

    def tips(self):
        """(upper, lower): numbers of the first and last point, the higher one first; at one level the first."""
        ends = 0, len(self.distance) - 1
        return ends if self.position[ends[0], 1] >= self.position[ends[1], 1] else ends[::-1]

    def largest(self):
        return int(np.argmax(self.ratio))

    def mean(self):
        """Along the line, weighted by distance; gaps do not count."""
        steps = np.diff(self.distance)
        if not len(steps):
            return float(self.ratio[0])
        steps = np.where(steps > GAP * np.median(steps), 0.0, steps)
        return float((0.5 * (self.ratio[1:] + self.ratio[:-1]) * steps).sum() / steps.sum())

    def spectral_extreme(self, pick):
        """(ratio, frequency [Hz], point) of the largest (np.nanargmax) or smallest (np.nanargmin) spectral ratio that is resolved; None: none."""
        values = self.spectral[self.study.frequency <= self.study.resolved]
        if not np.isfinite(values).any():
            return None
        row, point = np.unravel_index(pick(values), values.shape)
        return float(values[row, point]), float(self.study.frequency[row]), int(point)


class Study:
    """Amplification along the lines of one run."""

    def __init__(self, run, names=(), component=None, bandwidth=40.0):
        self.run, self.bandwidth = run, bandwidth
        lines = run.lines
        if not lines:
            raise MissingData("'%s' has no lines; set Monitors/Lines = bedding_1; ground; ..." % run.directory)
        for name in names:
            if name not in lines:
                near = difflib.get_close_matches(name, lines, 1)
                raise UserError("--lines: '%s' has no line '%s'%s; it has %s" % (
                    run.directory, name, " (did you mean '%s'?)" % near[0] if near else "", ", ".join(lines)))
        self.lines = [lines[name] for name in (names or lines)]
        self.outcrop_peaks = np.abs(self.lines[0].low_passed(self.lines[0].outcrop())).max(axis=0)
        if not self.outcrop_peaks.max() > 0:
            raise MissingData("'%s' has no input motion: amplification is relative to that of an outcrop" % run.directory)
        self.component = int(np.argmax(self.outcrop_peaks)) if component is None else component
        if not self.outcrop_peak > REST * self.outcrop_peaks.max():
            raise UserError("--component %s: the outcrop motion of '%s' is along %s alone" % (self.letter, run.directory, "yx"[self.component]))
        self.resolved = resolved_frequency(run)
        self.frequency, self.is_clear = self._frequencies()
        self.sides = [Side(self, line, side) for line in self.lines for side in line.sides]

    @property
    def outcrop_peak(self):
        """Of the component [m/s2]."""
        return float(self.outcrop_peaks[self.component])

    @property
    def letter(self):
        return "xy"[self.component]

    def _outcrop(self):
        """(spacing [s], acceleration in equal steps)."""
        return self.lines[0].equal_steps(self.lines[0].outcrop()[:, self.component])

    def outcrop_amplitude(self):
        """(frequency [Hz], |A(f)|) of the outcrop's acceleration."""
        spacing, outcrop = self._outcrop()
        return fourier_amplitude(outcrop, spacing)

    def _frequencies(self, points=160):
        """Equal on a logarithmic axis, from three periods in the run to the low-pass or half the rate of rows; where the outcrop has energy."""
        spacing, outcrop = self._outcrop()
        highest = min(self.run.corner or np.inf, 0.5 / spacing)
        frequency = np.geomspace(min(3 / (spacing * len(outcrop)), 0.5 * highest), highest, points)
        return frequency, has_energy(outcrop, spacing, frequency, self.bandwidth)

    def cut_short(self):
        """(line, part of its largest acceleration that is left in the last tenth of the run) of the line that shakes most then; None: quiet."""
        most = None
        for side in self.sides:
            motion = np.abs(side.line.acceleration(side.name)[:, :, self.component]).max(axis=1)
            left = motion[-max(1, int(END * len(motion))):].max() / max(motion.max(), 1e-300)
            if left > max(QUIET, most[1] if most else 0.0):
                most = side.line.name, float(left)
        return most

    def at_rest(self):
        """Names of lines that do not move."""
        return [line.name for line in self.lines if max(side.ratio.max() for side in self.sides if side.line is line) < REST]

    def coarse(self):
        """[(name, points)] of lines with few of them."""
        return [(line.name, len(line.distance)) for line in self.lines if 1 < len(line.distance) <= FEW]

    def jumps(self):
        """[{line, ...}] of every line with two sides: what differs across it, and what the plane bears."""
        return [jump_of(self, line) for line in self.lines if "above" in line.sides]


def jump_of(study, line):
    above, below = (next(s for s in study.sides if s.line is line and s.name == name) for name in ("above", "below"))
    jump = line.jump()
    found = {"line": line.name,
             "peak_acceleration_difference": largest_difference(above.ratio, below.ratio),
             "largest_slip_m": float(np.abs(jump[:, :, 0]).max()),
             "largest_opening_m": float(max(jump[:, :, 1].max(), 0.0))}
    run = study.run
    if run.has("bedding/%s/shear_stress" % line.name):
        found["largest_shear_stress_pa"] = float(np.abs(run.get("bedding/%s/shear_stress" % line.name)).max())
        found["largest_plastic_slip_m"] = float(np.abs(run.get("bedding/%s/slip" % line.name)).max())
    elif is_elastic_plane(run, line.name):  # stress from the shaking: stiffness times jump
        stiffness = float(run.parameters.get("Bedding planes/Shear stiffness", "nan"))
        found["largest_shear_stress_pa"] = stiffness * found["largest_slip_m"]
        found["largest_plastic_slip_m"] = 0.0
    return found


def largest_difference(values, reference):
    """Over the reference [-], where that moves; 0 where nothing does."""
    parts = np.divide(values, reference, out=np.ones_like(values), where=reference > REST * max(reference.max(), 1e-300))
    return float(np.abs(parts - 1).max())


def is_elastic_plane(run, name):
    return name in [n.strip() for n in run.parameters.get("Bedding planes/Names", "").split(",")]


def resolved_frequency(run):
    """Up to which mesh and blocks resolve waves, ten points per wavelength [Hz]; infinite where the run does not say."""
    told = run.summary.get("resolved_frequency_hz")
    if told:
        return float(told)
    path = os.path.join(run.directory, "log.txt")
    if not os.path.exists(path):
        return np.inf
    with open(path, encoding="utf-8", errors="replace") as log:
        found = re.findall(r"^(?:\[.*?\] *)?(?:Bedrock|Blocks|Continuum) .*: resolves ([0-9.eE+]+) Hz", log.read(), re.MULTILINE)
    return min(map(float, found), default=np.inf)
