# SPDX-License-Identifier: GPL-3.0-or-later
"""Where a tool puts what it makes of a scene, and whether results of another scene are there."""

import json
import os

from hybrid_run import UserError


def default_directory(scene, ending):
    """output/NAME plus the ending. A file scene.prm, as hybrid new writes it for every slope, has the name of its directory."""
    name = os.path.splitext(os.path.basename(scene))[0]
    if name == "scene":
        name = os.path.basename(os.path.dirname(os.path.abspath(scene))) or name
    return os.path.join("output", name + ending)


def refuse_other_scene(directory, name, scene):
    """@raises UserError if NAME.json there is of another scene."""
    try:
        with open(os.path.join(directory, name + ".json"), encoding="utf-8") as file:
            earlier = json.load(file)["scene"]
    except (OSError, ValueError, KeyError):
        return
    if os.path.realpath(earlier) != os.path.realpath(scene):
        raise UserError("'%s' holds results of '%s'; name another directory with --output, or --force to replace them" % (directory, earlier))
