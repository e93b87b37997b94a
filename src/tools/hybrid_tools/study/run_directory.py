# SPDX-License-Identifier: GPL-3.0-or-later
"""One run of a study: a directory with a manifest, beside what hybrid writes there."""

import json
import os
import shutil

from hybrid_tools.study import program


def write_json(path, content):
    """Atomically: a reader, and who goes on after a kill, never sees half a file."""
    with open(path + ".new", "w", encoding="utf-8") as file:
        json.dump(content, file, indent=2)
        file.write("\n")
    os.replace(path + ".new", path)


def read_json(path):
    """Content of a file; {} if there is none, or no JSON in it."""
    try:
        with open(path, encoding="utf-8") as file:
            return json.load(file)
    except (OSError, ValueError):
        return {}


class RunDirectory:
    """What is known of a run. manifest: see doc/study.md."""

    def __init__(self, study_directory, name):
        self.path = os.path.join(study_directory, "runs", name)
        self.manifest = read_json(self._manifest_path)

    @property
    def _manifest_path(self):
        return os.path.join(self.path, "manifest.json")

    @property
    def state(self):
        return self.manifest.get("state", "planned")

    @property
    def summary(self):
        """summary.json; {} while there is none."""
        return read_json(os.path.join(self.path, "summary.json"))

    def plan(self, study, setting):
        """Make the directory and its manifest, unless they are there."""
        varied = {axis.name: axis.labels[level] for axis, level in zip(study.axes, setting.levels)}
        if not self.manifest:
            self.update(name=setting.name, varied=varied, effect=setting.effect, seed=setting.seed,
                        overrides=study.common + setting.overrides, state="planned", reason="")

    def update(self, **values):
        os.makedirs(self.path, exist_ok=True)
        self.manifest.update(values)
        write_json(self._manifest_path, self.manifest)

    def has_begun(self):
        """Whether hybrid has left something that --resume goes on from."""
        return os.path.exists(os.path.join(self.path, "params.used.prm"))

    def words(self, scene):
        """What hybrid is called with to compute the run, to go on with it, or to take its time once more."""
        if self.has_begun() and self.state != "done":
            return ["--resume", self.path]
        words = [scene, "--force"] + program.options(program.ONE_RUN)
        for override in self.manifest["overrides"] + ["Output/Directory=" + (self.timing_path if self.state == "done" else self.path)]:
            words += ["-s", override]
        return words

    @property
    def timing_path(self):
        """Where a run goes whose time alone is of use."""
        return os.path.join(self.path, "timing")

    def take_time(self, exit_code, taken):
        """Of a repetition: the least time counts. One that failed or was stopped took none."""
        summary = read_json(os.path.join(self.timing_path, "summary.json"))
        shutil.rmtree(self.timing_path, ignore_errors=True)
        if exit_code == 0 and summary.get("finished"):
            times = self.times + [{"processor_time_s": summary["processor_time_s"], "wall_time_s": summary["wall_time_s"], "taken": taken}]
            least = min(times, key=lambda time: time["processor_time_s"])
            self.update(times=times, **least)

    @property
    def times(self):
        """Of all repetitions, the first one too unless it was resumed."""
        first = {name: self.manifest.get(name) for name in ("processor_time_s", "wall_time_s", "taken")}
        return self.manifest.get("times") or ([first] if self.state == "done" and not self.manifest.get("resumed") else [])

    def take_result(self, exit_code=0, console=""):
        """State after hybrid has ended."""
        summary = self.summary
        if exit_code == 0 and summary.get("finished"):
            self.update(state="done", reason="", processor_time_s=summary.get("processor_time_s"), wall_time_s=summary["wall_time_s"],
                        peak_memory_mb=summary["peak_memory_mb"], steps=summary["steps"], exit_code=0)
        elif exit_code in (130, 143):
            self.update(state="planned", reason="interrupted", exit_code=exit_code)
        elif exit_code < 0:
            self.update(state="failed", reason="killed by signal %d" % -exit_code, exit_code=exit_code)
        else:
            self.update(state="failed", reason=reason_of(console), exit_code=exit_code, processor_time_s=summary.get("processor_time_s"))

    def is_to_run(self, again=False, repeats=1):
        """Whether it is to be computed, or timed again. What was killed is tried again; what failed by itself would fail again."""
        if self.state == "done":
            return repeats > 1 and len(self.times) < repeats
        return self.state in ("planned", "running") or (self.state == "failed" and (again or self.manifest.get("exit_code", 0) < 0))


def clipped(reason, most=160):
    """The beginning of a sentence that is too long for a line of the terminal."""
    return reason if len(reason) <= most else reason[: most - 3].rsplit(" ", 1)[0] + " ..."


def reason_of(console):
    """The sentence in which hybrid says why it ended."""
    lines = [line.strip() for line in console.splitlines() if line.strip()]
    for mark in ("error: ", "Warning: stopped", "warning: stopped"):
        for line in reversed(lines):
            if line.startswith(mark):
                return line.split(": ", 1)[1]
    for line in reversed(lines):
        if line.lower().startswith("warning: "):
            return line.split(": ", 1)[1]
    return lines[-1] if lines else "it said nothing"
