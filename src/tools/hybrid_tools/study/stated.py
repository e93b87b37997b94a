# SPDX-License-Identifier: GPL-3.0-or-later
"""Closed forms that a scene states in its comments: what a study takes as the truth unless it changes the problem."""

import fnmatch
import os
import re

from hybrid_run import UserError
from hybrid_tools.study.axes import NUMERICS, REFINED, number

LINE = re.compile(r"^\s*#\s*Closed form:\s*([^=]+?)\s*=\s*(.+?)\s*$")
TIMES = ("Time/End time", "Time/Time step", "Title")  # with NUMERICS and REFINED what leaves the problem as it is


def read(scene):
    """{"monitor/quantity": number, or path of a CSV} of lines '# Closed form: monitor/quantity = 1.3 or file.csv' in a scene."""
    with open(scene, encoding="utf-8", errors="replace") as lines:
        found = dict(match.groups() for match in map(LINE.match, lines) if match)
    folder = os.path.dirname(os.path.abspath(scene))
    for name, value in found.items():
        if number(value) is None and not os.path.isfile(os.path.join(folder, value)):
            raise UserError("%s: closed form of %s: '%s' is no number, nor a file beside the scene" % (scene, name, value))
    return {name: number(value) if number(value) is not None else os.path.join(folder, value) for name, value in found.items()}


def other_problem(axes, common):
    """The first of the varied and set parameters with which the closed forms of the scene are those of another problem; "" if none is."""
    for axis in axes:
        if axis.kind in ("models", "samples"):
            return axis.name
    for override in common:
        key, _, value = override.partition("=")
        names = ["Mesh/Numbers:" + part.split("=")[0].strip() for part in value.split(";")] if key == "Mesh/Numbers" else [key]
        if not all(any(fnmatch.fnmatchcase(name, known) for known in (*NUMERICS, *REFINED, *TIMES)) for name in names):
            return key
    return ""
