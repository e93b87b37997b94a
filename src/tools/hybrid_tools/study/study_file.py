# SPDX-License-Identifier: GPL-3.0-or-later
"""A study file: TOML.

    scene = "slope.prm"                       # beside this file
    directory = "output/slope-study"          # beside the working directory
    set = ["Time/End time=5"]                 # -s of every run
    tolerance = "2%"
    seeds = 3
    quantities = ["crest/*"]

    [vary]
    "Time/Time step" = [4e-3, 2e-3, 1e-3]
    "Mesh/Numbers" = ["Resolution/h = 8", 4, 2]

    [finest]
    "Blocks/Shear ratio" = 1

    [effects]
    "viscous sides" = ["Continuum/Sides=viscous"]

    [closed_form]
    "block/final displacement" = 1.3143       # SI units
    "top/displacement" = "top.csv"            # time, x, y; beside this file
"""

import os
import tomllib

from hybrid_run import UserError

KNOWN = {"scene": str, "directory": str, "set": list, "tolerance": (str, float, int), "seeds": int, "quantities": list, "vary": dict,
         "finest": dict, "effects": dict, "closed_form": dict}


def read(path):
    """Its content, with paths that hold anywhere. @raises UserError for what is wrong in it."""
    try:
        with open(path, "rb") as file:
            content = tomllib.load(file)
    except OSError as error:
        raise UserError("cannot read the study file '%s': %s" % (path, error.strerror)) from error
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise UserError("%s: %s" % (path, error)) from error
    for name, value in content.items():
        if name not in KNOWN:
            raise UserError("%s: unknown entry '%s'; known are %s" % (path, name, ", ".join(KNOWN)))
        if not isinstance(value, KNOWN[name]) or isinstance(value, bool):
            raise UserError("%s: '%s' is of the wrong kind: %r" % (path, name, value))
    for table in ("vary", "effects"):
        for name, values in content.get(table, {}).items():
            if not isinstance(values, list) or not values:
                raise UserError("%s: [%s] '%s' needs a list of values, not %r" % (path, table, name, values))
    if "scene" not in content:
        raise UserError("%s: there is no entry 'scene'" % path)
    beside = os.path.dirname(os.path.abspath(path))
    content["scene"] = os.path.join(beside, content["scene"])
    content["closed_form"] = {name: os.path.join(beside, value) if isinstance(value, str) else value
                              for name, value in content.get("closed_form", {}).items()}
    for name, values in content.get("vary", {}).items():
        if name.lower().endswith("file"):
            content["vary"][name] = [os.path.join(beside, value) for value in values]
    return content
