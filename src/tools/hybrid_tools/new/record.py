# SPDX-License-Identifier: GPL-3.0-or-later
"""What of a record decides sizes and times: how high its frequencies go and how long it is."""

import os
import re

import numpy as np

from hybrid_run import UserError

from .polylines import split, to_number

LONGEST = 1.0  # spacing of a record [s]
SHARE = 0.95  # of the energy of a motion lies below its highest frequency, as on the scene card


class Record:
    """A recorded motion: its file, type of Motion/Type, spacing [s], accelerations (any unit, offset removed)."""

    def __init__(self, path, kind, dt, values):
        self.path, self.kind, self.dt, self.values = path, kind, dt, values - values.mean()

    @property
    def duration(self):
        return self.dt * (len(self.values) - 1)

    @property
    def highest_frequency(self):
        """[Hz], at most 50 as on the scene card."""
        frequency = np.fft.rfftfreq(len(self.values), self.dt)
        power = np.abs(np.fft.rfft(self.values)) ** 2 * (frequency <= 50)
        return float(frequency[np.searchsorted(np.cumsum(power), SHARE * power.sum())])

    @property
    def mean_frequency(self):
        """Of the power spectrum [Hz]."""
        frequency = np.fft.rfftfreq(len(self.values), self.dt)
        power = np.abs(np.fft.rfft(self.values)) ** 2
        return float((power * frequency).sum() / power.sum())

    def husid(self, share):
        """When this part of the Arias intensity has come [s]."""
        energy = np.cumsum(self.values**2)
        return self.dt * int(np.searchsorted(energy, share * energy[-1]))


class Ricker:
    """The pulse of a scene without a record."""

    path, kind = None, "ricker"

    def __init__(self, frequency):
        self.frequency = self.mean_frequency = frequency
        self.highest_frequency = 1.75 * frequency  # 95 % of the power of its acceleration
        self.duration = 3 / frequency


def read_record(path):
    """@raises UserError unless the file is a record of PEER or two columns, time [s] and acceleration."""
    try:
        with open(path, encoding="utf-8", errors="replace") as text:
            lines = text.read().splitlines()
    except OSError as error:
        raise UserError("cannot read '%s': %s" % (path, error.strerror)) from error
    for number, line in enumerate(lines[:100]):
        if re.search(r"\bNPTS\b", line.upper()):
            return read_at2(path, line.upper(), lines[number + 1:])
    if os.path.splitext(path)[1].lower() == ".at2":
        raise UserError("%s: no header line has NPTS and DT, as PEER's records do" % path)
    return read_columns(path, lines)


def read_at2(path, header, lines):
    found = re.search(r"NPTS\s*[=:]?\s*(\d+).*?DT\s*[=:]?\s*([\d.E+-]+)", header) or re.search(r"(\d+)\s+([\d.E+-]+)\s+NPTS", header)
    try:
        points, dt = int(found[1]), float(found[2].rstrip("."))
        values = np.array(" ".join(lines).split(), float)[:points]
    except (TypeError, ValueError) as error:
        raise UserError("%s: the header '%s' or the values below it are not those of a PEER record" % (path, header.strip())) from error
    return checked(path, "at2", dt, values)


def numbers_of(line):
    """Fields of a line, exponents as Fortran writes them included."""
    return [re.sub(r"(?<=[\d.])[dD](?=[+-]?\d)", "e", field) for field in split(line.lstrip("\ufeff"))]


def read_columns(path, lines):
    """Lines of words at the top are left out, as the program does."""
    rows = [(number, row) for number, line in enumerate(lines, 1) if (row := numbers_of(line))]
    first = next((k for k, (_, row) in enumerate(rows) if to_number(row[0]) is not None), 0)
    rows = rows[first:]
    bad = next(((number, row) for number, row in rows if len(row) != 2 or None in map(to_number, row)), None)
    if bad or len(rows) < 2:
        where = "line %d is '%s'; " % (bad[0], lines[bad[0] - 1].strip()) if bad else ""
        raise UserError("%s: %sexpected are two columns, time [s] and acceleration, or a PEER record (.at2)" % (
            path, where))
    table = np.array([row for _, row in rows], float)
    return checked(path, "text", float((table[-1, 0] - table[0, 0]) / (len(table) - 1)), table[:, 1])


def checked(path, kind, dt, values):
    if len(values) < 10 or not dt > 0 or not np.ptp(values) > 0:
        raise UserError("%s: %d values with a spacing of %g s are no motion" % (path, len(values), dt))
    if dt > LONGEST:
        raise UserError("%s: the samples are %g s apart, which resolves no earthquake; if the times were meant in ms, divide them by 1000" % (path, dt))
    return Record(path, kind, dt, values)
