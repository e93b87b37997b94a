# SPDX-License-Identifier: GPL-3.0-or-later
"""One static stage: does the slope stand with its strengths divided by a factor, or pushed by a pseudo-static coefficient?"""

import os
import subprocess

from hybrid_run import Run, UserError
from hybrid_tools.study import program

STEP = "1e-4"  # a run takes a step after its static stage [s]


class Trial:
    """What became of one static stage."""

    def __init__(self, value, directory, stage):
        self.value = value  # strength reduction factor or coefficient [-]
        self.directory = directory
        # loose blocks that slide and come to rest elsewhere have not stood as they were drawn
        self.stands = bool(stage["equilibrium"] and stage["planes_hold"] and not stage["slid"])
        self.planes_hold = bool(stage["planes_hold"])
        self.displacement = stage["largest_displacement_m"]  # of a block, where it stands or where the stage ended [m]
        self.residual = stage["residual"]
        self.iterations = stage["iterations"]
        self.is_planes_alone = self.run().parameters["Model/Blocks"] == "none"  # rock on bedding planes, no sliding mass

    def run(self):
        return Run(self.directory)


class Trials:
    """Static stages of one scene, in directories of their own below another."""

    def __init__(self, scene, overrides, directory, progress=print):
        self.scene, self.overrides, self.directory, self.progress = scene, overrides, directory, progress
        self.done = []
        self.warnings = []  # of the scene

    def settings(self, changes):
        static = ["Time/Time step=" + STEP, "Time/End time=" + STEP, "Time/Error target=none", "Motion/Type=none",
                  "Gravity/Static stage=equilibrium", "Water/Static place=drawn"]
        return self.overrides + static + ["%s=%.12g" % change for change in changes.items()]

    def repeat_warnings(self, directory):
        """What the program has warned of before its static stage: it holds for all trials."""
        with open(os.path.join(directory, "log.txt"), encoding="utf-8") as log:
            for line in log:
                if line.startswith("Static stage"):
                    break
                if line.startswith("warning: "):
                    self.warnings.append(line.rstrip())
                    self.progress(self.warnings[-1])

    def run(self, name, settings):
        """Exit code 0 or 1 of the program; @raises UserError for what it refuses."""
        directory = os.path.join(self.directory, name)
        words = [os.environ["HYBRID_PROGRAM"], self.scene, "--force"] + program.options(program.ONE_RUN)
        for setting in settings + ["Output/Directory=" + directory]:
            words += ["-s", setting]
        done = subprocess.run(words, capture_output=True, text=True)
        if done.returncode not in (0, 1):
            reason = [line for line in done.stderr.splitlines() if line.startswith("error: ")]
            raise UserError(reason[-1][len("error: "):] if reason else "the run in '%s' ended with code %d" % (directory, done.returncode))
        return directory

    def __call__(self, name, value, changes):
        """The static stage with some parameters changed."""
        directory = self.run(name, self.settings(changes))
        run = Run(directory)
        stage = run.summary.get("static_stage")
        if stage is None:
            raise UserError("%s: nothing settles: there is no gravity, or neither blocks nor bedding planes with strength; there is no slope "
                            "to judge" % self.scene)
        trial = Trial(value, directory, stage)
        if not self.done:
            self.repeat_warnings(directory)
        self.done.append(trial)
        moved = "" if trial.is_planes_alone else "   moved %9.3g mm   %4d iterations" % (1e3 * trial.displacement, trial.iterations)
        self.progress("%-8s %9.4f   %-6s%s" % (name.split("_")[0], value, "stands" if trial.stands else "FAILS", moved))
        return trial
