# SPDX-License-Identifier: GPL-3.0-or-later
"""A run whose motion comes again and again: each further event resumes the run with a later end."""

import os
import subprocess

from hybrid_run import Run, UserError
from hybrid_run.parameters import parse_parameters

# What this tool sets itself, and by which option.
OWN = {"Motion/Repetitions": "--events", "Motion/Repetition interval": "--quiet", "Output/Directory": "--output"}


def call(words):
    """What the program prints. @raises UserError for what it refuses or does not finish."""
    done = subprocess.run([os.environ["HYBRID_PROGRAM"]] + words, capture_output=True, text=True)
    if done.returncode != 0:
        reason = [line for line in done.stderr.splitlines() if line.startswith("error: ")]
        raise UserError(reason[-1][len("error: "):] if reason else "hybrid %s ended with code %d" % (" ".join(words), done.returncode))
    return done.stdout


def settings(pairs):
    return [word for path, value in pairs.items() for word in ("-s", "%s=%s" % (path, value))]


class Repetition:
    """A scene whose motion comes up to `events` times."""

    def __init__(self, scene, overrides, quiet, events, directory):
        if refused := [path for path in (pair.split("=")[0].strip() for pair in overrides) if path in OWN]:
            raise UserError("%s is set by hybrid condition: see its option %s" % (refused[0], OWN[refused[0]]))
        self.scene, self.overrides, self.directory = scene, [word for pair in overrides for word in ("-s", pair)], directory
        values = parse_parameters(call(["--print-parameters", scene] + self.overrides).splitlines())
        if values["Motion/Type"] == "none":
            raise UserError("'%s' has no motion that could come again: Motion/Type is none" % scene)
        if values["Edge loads/Tractions"]:
            raise UserError("'%s' has edge loads, which would act in the first event only: Edge loads/Tractions" % scene)
        if values["Water/Level file"]:
            raise UserError("'%s' has a level of the water in time, which would differ from event to event: Water/Level file; give the level of all "
                            "events, -s \"Water/Level file=\" -s \"Water/Level=...\"" % scene)
        step = float(values["Time/Time step"])
        self.period = step * round((float(values["Time/End time"]) + quiet) / step)  # [s]
        self.fixed = {"Time/Error estimate": "one run", "Time/Error target": "none", "Mesh/Error estimate": "one run", "Time/Rest speed": "none",
                      "Motion/Repetitions": events, "Motion/Repetition interval": "%.12g" % self.period}
        if values["Checkpoint/Step interval"] == values["Checkpoint/Wall interval"] == "0":
            self.fixed["Checkpoint/Wall interval"] = 600  # there has to be one to go on from

    def run_event(self, number):
        """The run up to the end of an event."""
        end = {"Time/End time": "%.12g" % (number * self.period)}
        if number == 1:
            said = call([self.scene, "--force"] + self.overrides + settings(dict(self.fixed, **end, **{"Output/Directory": self.directory})))
        else:
            said = call(["--resume", self.directory] + settings(end))
        run = Run(self.directory)
        if abs(run.time[-1] - number * self.period) > 1e-6 * self.period:
            raise UserError("event %d ended early:\n%s" % (number, said[-500:]))
        return run
