# SPDX-License-Identifier: GPL-3.0-or-later
"""Polylines from tables, as spreadsheets and surveys write them."""

import math
import os
import re

import numpy as np

from hybrid_run import UserError

# What a header may call the columns.
X_NAMES = ("x", "distance", "chainage", "station", "easting")
Y_NAMES = ("z", "y", "elevation", "height", "altitude", "level")


class Table:
    """Rows of a file: (line number, fields), empty lines as (line number, []); columns of x, y and a name where a header tells them."""

    def __init__(self, path):
        self.path = path
        try:
            with open(path, encoding="utf-8-sig", errors="replace") as lines:
                rows = [(number, split(line)) for number, line in enumerate(lines, 1)]
        except OSError as error:
            raise UserError("cannot read '%s': %s" % (path, error.strerror)) from error
        first = next((k for k, (_, fields) in enumerate(rows) if sum(to_number(f) is not None for f in fields) >= 2), len(rows))
        self.rows = rows[first:]
        header = next((fields for _, fields in reversed(rows[:first]) if len(fields) > 1), [])
        names = [field.lower().split("[")[0].split("(")[0].strip() for field in header]
        self.x = next((names.index(n) for n in X_NAMES if n in names), None)
        self.y = next((names.index(n) for n in Y_NAMES if n in names), None)
        if not any(fields for _, fields in self.rows):
            raise UserError("'%s' holds no rows of two numbers, x and y [m]" % path)

    def point(self, number, fields, has_name):
        """(x, y) of a row."""
        x, y = (self.x, self.y) if self.x is not None and self.y is not None else (1, 2) if has_name else (0, 1)
        values = [to_number(fields[k]) if k < len(fields) else None for k in (x, y)]
        if None in values or (self.x is None and len(fields) != (3 if has_name else 2)):
            raise UserError("%s, line %d: '%s' is not understood; expected are %s [m]%s" % (
                self.path, number, ", ".join(fields), "name, x, y" if has_name else "two numbers, x and y",
                "" if has_name else ", or a header that names the columns x and y"))
        return values


def split(line):
    """Fields between commas, semicolons, tabs or blanks; # begins a comment. Beside others, commas between digits are decimal marks."""
    text = line.split("#")[0].strip()
    if ";" in text:
        return [field.strip().replace(",", ".") for field in text.strip("; ").split(";")]
    if "," in text and "." not in text and len(text.split()) > 1 and not re.search(r"(?<!\d),|,(?!\d)", text):
        return text.replace(",", ".").split()
    return [field.strip() for field in text.strip(", ").split(",")] if "," in text else text.split()


def to_number(text):
    try:
        value = float(text)
    except ValueError:
        return None
    return value if math.isfinite(value) else None


def read_line(path, notes):
    """Points of one polyline in the order of the file, n x 2 [m]; equal neighbours count once."""
    table = Table(path)
    points = np.array([table.point(number, fields, False) for number, fields in table.rows if fields])
    different = np.r_[True, np.any(np.diff(points, axis=0) != 0, axis=1)]
    if not different.all():
        notes.append("%s: %d points that repeat the one before were left out" % (name_of(path), np.sum(~different)))
    points = points[different]
    if len(points) < 2:
        raise UserError("'%s' has one point; a line needs two" % path)
    return points


def read_profile(path, notes):
    """The ground from left to right; a cliff is two points with the same x, in their order.

    @raises UserError where points that are not in order leave open how the ground runs.
    """
    points = read_line(path, notes)
    steps = np.diff(points[:, 0])
    if (steps < 0).all() or ((steps <= 0).all() and points[0, 0] > points[-1, 0]):
        points = points[::-1]
    elif (steps < 0).any():
        points = points[np.argsort(points[:, 0], kind="stable")]
        notes.append("%s: the points were not in order; sorted by x" % name_of(path))
        points = points[np.r_[True, np.any(np.diff(points, axis=0) != 0, axis=1)]]
        for a, b in zip(points, points[1:]):
            if a[0] == b[0]:
                raise UserError("%s: at x = %g m the ground is at y = %g and at %g m; a cliff needs all points in the order of the ground" % (
                    path, a[0], a[1], b[1]))
    if np.ptp(points[:, 0]) <= 0:
        raise UserError("%s: all points have x = %g m; the ground runs along x" % (path, points[0, 0]))
    return points


def read_slip(path, notes):
    """A sliding surface from left to right."""
    points = read_line(path, notes)
    return points if points[-1, 0] > points[0, 0] else points[::-1]


def read_planes(path):
    """[(name, points)]: rows name, x, y, or x, y with an empty line between two planes; names in the order of the file."""
    table = Table(path)
    has_name = table.x not in (None, 0) or (table.x is None and any(len(fields) == 3 for _, fields in table.rows))
    planes, count = {}, 1
    for number, fields in table.rows:
        if not fields:
            count += 1
            continue
        planes.setdefault(fields[0] if has_name else "plane %d" % count, []).append(table.point(number, fields, has_name))
    found = []
    for name, points in planes.items():
        points = np.array(points)
        points = points[np.r_[True, np.any(np.diff(points, axis=0) != 0, axis=1)]]
        if len(points) < 2:
            raise UserError("%s: %s has one point, (%g, %g) m; a bedding plane needs two" % (path, name, *points[0]))
        found.append((name, points if tuple(points[-1]) > tuple(points[0]) else points[::-1]))
    return found


def name_of(path):
    return os.path.basename(str(path))
