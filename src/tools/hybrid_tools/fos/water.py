# SPDX-License-Identifier: GPL-3.0-or-later
"""Which water a factor holds for: a level that moves stands still in the static stage."""

import numpy as np

from hybrid_run import UserError
from hybrid_tools.new.polylines import split, to_number

LEVEL, FILE, LINE = "Water/Level", "Water/Level file", "Water/Line file"


def read_levels(path):
    """Times [s] and levels [m] of a table that the program has read without complaint."""
    with open(path, encoding="utf-8-sig") as lines:
        rows = [[to_number(field) for field in split(line)] for line in lines]
    return np.array([row for row in rows if row and None not in row]).T


class Water:
    """The water of all trials. parameters: of the scene, by Section/Name. time: --time [s], or None: the level of the static stage."""

    def __init__(self, parameters, time=None):
        self.parameters, self.time = parameters, time
        if time is not None and not parameters[FILE]:
            raise UserError("--time %g: the water does not change in time, as %s is not set" % (time, FILE))
        if parameters[FILE]:
            self.level = float(np.interp(time or 0.0, *read_levels(parameters[FILE])))  # [m]
        else:
            self.level = None if parameters[LEVEL] == "none" else float(parameters[LEVEL].split()[0])

    def overrides(self):
        """-s of the trials."""
        return [] if self.time is None else [FILE + "=", "%s=%.12g" % (LEVEL, self.level)]

    def words(self):
        """What the answer holds for; empty without water."""
        found = []
        if self.level is not None:
            found.append("level %.6g m" % self.level)
        if self.parameters[FILE]:
            found[-1] += " (%s at %g s%s)" % (FILE, self.time or 0.0, "; --time tells it at another time" if self.time is None else "")
        if self.parameters[LINE]:
            found.append("phreatic line")
        return ", ".join(found + ["Method " + self.parameters["Water/Method"]]) if found else ""

    def results(self):
        """For fos.json and yield.json."""
        if not self.words():
            return {}
        return {"water": {"level_m": self.level, "time_s": (self.time or 0.0) if self.parameters[FILE] else None,
                          "line_file": self.parameters[LINE] or None, "method": self.parameters["Water/Method"]}}
