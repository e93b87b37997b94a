# SPDX-License-Identifier: GPL-3.0-or-later
"""A run whose motion comes again and again: each further event resumes the run with a later end."""

import math
import os
import re
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


def refuse_part(card, period, end):
    """A motion longer than an event goes on in the next one and adds up with that."""
    cut = next(filter(None, (re.search(r"the run ends at t = \S+ s, the motion at (\S+) s: the rest of it is not used", line) for line in card)), None)
    if cut:
        enough = math.floor(10 * (float(cut[1]) - end) + 1) / 10  # its end is rounded
        raise UserError("the motion ends at %s s, an event at %g s (Time/End time = %g s and --quiet): events would overlap and add up, so that "
                        "each is another motion; give --quiet %g or more, or a shorter motion" % (cut[1], period, end, enough))


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
        step, end = float(values["Time/Time step"]), float(values["Time/End time"])
        self.period = step * round((end + quiet) / step)  # [s]
        card = call(["--check", scene] + self.overrides + settings({"Time/End time": "%.12g" % self.period, "Motion/Repetitions": 1})).splitlines()
        refuse_part(card, self.period, end)
        self.warnings = [line for line in card if line.startswith("warning: ")]  # of the scene, and of its run
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
        self.add_warnings()
        if abs(run.time[-1] - number * self.period) > 1e-6 * self.period:
            raise UserError("event %d ended early:\n%s" % (number, said[-500:]))
        return run

    def add_warnings(self):
        """Those of the run so far, but none that differs from one of an earlier event in its numbers alone."""
        def without_numbers(line):
            return re.sub(r"[\d.]+(e[+-]\d+)?", "", line)

        known = set(map(without_numbers, self.warnings))
        with open(os.path.join(self.directory, "log.txt"), encoding="utf-8") as log:
            found = [line.rstrip() for line in log if line.startswith("warning: ")]
        self.warnings += dict.fromkeys(line for line in found if without_numbers(line) not in known)
