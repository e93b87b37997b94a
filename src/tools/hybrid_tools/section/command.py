# SPDX-License-Identifier: GPL-3.0-or-later
"""hybrid section SCENE.prm: the section as the program understands it, before anything is run."""

import os
import subprocess
import tempfile

from hybrid_run import Run, UserError
from hybrid_tools.arguments import Arguments

from .drawing import Scene, draw

ABOUT = "Draw the section of a scene: materials, mesh, named lines, monitors, boreholes, water, artificial boundaries. Nothing is run."
EXAMPLES = """  hybrid section my-slope/scene.prm                              my-slope/scene.section.png
  hybrid section my-slope/scene.prm --output figure.pdf -s "Mesh/Numbers=Resolution/h = 3"
"""
FORMATS = (".png", ".pdf", ".svg")


def arguments():
    found = Arguments("section", ABOUT, EXAMPLES)
    found.add_argument("scene", metavar="SCENE.prm", help="parameter file")
    found.add_argument("--output", metavar="FILE", help="picture to write, .png, .pdf or .svg; default: SCENE.section.png beside the scene")
    found.add_argument("-s", "--set", action="append", default=[], metavar="NAME=VALUE", help="override a parameter, as in a run")
    return found


def read_scene(path, overrides, directory):
    """What the program makes of the scene, by a run without a step. @raises UserError with the program's own words if it refuses it."""
    words = [os.environ["HYBRID_PROGRAM"], path]
    still = ["Time/End time=0", "Gravity/Static stage=none", "Gravity/Initial stress=elastic", "Checkpoint/Wall interval=0"]
    for override in overrides + still + ["Output/Directory=" + directory]:
        words += ["-s", override]
    result = subprocess.run(words, capture_output=True, text=True)
    if result.returncode != 0:
        said = [line for line in result.stderr.splitlines() if line.startswith("error")]
        raise UserError((said[-1] if said else "the program ended with exit code %d" % result.returncode)[len("error: ") if said else 0:])
    return Run(directory)


def main(words):
    options = arguments().read(words)
    path = options.output or os.path.splitext(options.scene)[0] + ".section.png"
    if os.path.splitext(path)[1] not in FORMATS:
        raise UserError("'%s': the picture must end in %s" % (path, ", ".join(FORMATS)))
    folder = os.path.dirname(path) or "."
    if not os.path.isdir(folder):
        raise UserError("'%s' is not a directory; give another --output" % folder)
    with tempfile.TemporaryDirectory() as temporary:
        run = read_scene(options.scene, options.set, os.path.join(temporary, "run"))
        draw(Scene(run), run.parameters.get("Title") or os.path.basename(options.scene), path)
    print("section: " + path)
    return 0
