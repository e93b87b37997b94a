# SPDX-License-Identifier: GPL-3.0-or-later
"""Computes the runs of a study, one after another or side by side, so that a kill at any moment loses little.

Runs are children that get SIGTERM when the study dies: hybrid then writes a checkpoint and ends. Each holds the lock of its directory, so
that nobody goes on with it before it has ended.
"""

import ctypes
import fcntl
import os
import signal
import subprocess
import time

from hybrid_run import UserError
from hybrid_tools.study import program
from hybrid_tools.study.axes import label_text
from hybrid_tools.study.run_directory import RunDirectory, clipped

DEATH_SIGNAL = 1  # PR_SET_PDEATHSIG of prctl(2)
POLL = 0.05  # [s]
OTHER_LOAD = 0.15  # of all cores: with more, a run was not alone
PATIENCE = 20.0  # for the children of a study that was killed [s]

libc = ctypes.CDLL(None)


def die_with_parent():
    """SIGTERM for this process when its parent ends."""
    libc.prctl(DEATH_SIGNAL, signal.SIGTERM)


def lock(directory):
    """Descriptor of the lock of a directory. @raises UserError while another process works there."""
    os.makedirs(directory, exist_ok=True)
    descriptor = os.open(os.path.join(directory, "lock"), os.O_CREAT | os.O_RDWR, 0o644)
    end = time.monotonic() + PATIENCE
    while True:
        try:
            fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
            return descriptor
        except OSError:
            if time.monotonic() > end:
                os.close(descriptor)
                raise UserError("another process is at work in '%s'; wait for it" % directory) from None
            time.sleep(POLL)


def available_memory():
    """What new processes may use [MB]."""
    with open("/proc/meminfo", encoding="ascii") as lines:
        free = next(float(line.split()[1]) / 1024 for line in lines if line.startswith("MemAvailable"))
    try:
        with open("/sys/fs/cgroup/memory.max", encoding="ascii") as limit, open("/sys/fs/cgroup/memory.current", encoding="ascii") as used:
            return min(free, (float(limit.read()) - float(used.read())) / 2**20)
    except (OSError, ValueError):  # no such group, or "max"
        return free


def busy_time():
    """Processor time that this machine has spent on anything [s]."""
    with open("/proc/stat", encoding="ascii") as lines:
        user, nice, system, _, _, irq, softirq = map(int, lines.readline().split()[1:8])
    return (user + nice + system + irq + softirq) / os.sysconf("SC_CLK_TCK")


def own_time():
    """Of it, that of this process and of its runs that have ended [s]."""
    times = os.times()
    return times.user + times.system + times.children_user + times.children_system


class Child:
    """A run that is going on."""

    def __init__(self, run, scene, taken):
        self.run, self.threads = run, run.manifest.get("threads", 1)
        self.locked = lock(run.path)
        self.taken, self.before = taken, (time.monotonic(), busy_time() - own_time())
        self.other_load = None
        words = run.words(scene)
        self.was_resumed, self.is_repetition = words[0] == "--resume", run.state == "done"
        if not self.is_repetition:
            resumed = run.manifest.get("resumed", 0) + (1 if run.has_begun() else 0)
            run.update(state="running", taken=taken, resumed=resumed, program=program.version(), reason="")
        self.console = os.devnull if self.is_repetition else os.path.join(run.path, "console.txt")
        with open(self.console, "wb") as console:
            # pylint: disable=subprocess-popen-preexec-fn (one thread; no other way to ask for the signal)
            self.process = subprocess.Popen([program.path(), *words], stdin=subprocess.DEVNULL, stdout=console, stderr=subprocess.STDOUT,
                                            start_new_session=True, preexec_fn=die_with_parent, pass_fds=(self.locked,))

    def has_ended(self):
        """Whether it has; its manifest then says how."""
        code = self.process.poll()
        if code is None:
            return False
        os.close(self.locked)
        if self.taken == "alone":
            self.judge_time()
        if self.is_repetition:
            self.run.take_time(code, self.taken)
            return True
        self.run.update(taken=self.taken, **({"other_load": self.other_load} if self.other_load is not None else {}))
        with open(self.console, encoding="utf-8", errors="replace") as console:
            self.run.take_result(code, console.read())
        return True

    def judge_time(self):
        """Whether the run had the machine for itself."""
        begin, others = self.before
        load = max(0.0, busy_time() - own_time() - others) / max(time.monotonic() - begin, 1e-3)
        self.other_load = round(load, 2)
        self.taken = "alone" if load < OTHER_LOAD * os.cpu_count() else "beside other work"


class Runner:
    """jobs: how many runs at once at most; fewer where cores or memory do not suffice. taken: what the manifests say of the times.

    repeats: how often each run is timed.
    """

    def __init__(self, scene, jobs=1, taken=None, repeats=1, tell=print):
        self.scene, self.jobs, self.repeats, self.tell = scene, jobs, repeats, tell
        self.taken = taken or ("side by side" if jobs > 1 else "alone")
        self.cores = len(os.sched_getaffinity(0))
        self.is_stopping = False

    def stop(self, *_):
        """Handler of SIGINT and SIGTERM."""
        self.is_stopping = True

    def compute(self, runs):
        """@return whether all of them have come to an end; False if it was interrupted."""
        before = [(number, signal.signal(number, self.stop)) for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)]
        try:
            return self._compute(runs)
        finally:
            for number, handler in before:
                signal.signal(number, handler)

    def _compute(self, runs):
        waiting, going, count = list(runs), [], 0
        memory = available_memory()
        while (waiting and not self.is_stopping) or going:
            while waiting and not self.is_stopping and self.fits(waiting[0], going, memory):
                going.append(Child(waiting.pop(0), self.scene, self.taken))
            if self.is_stopping:
                self.end(going)
            time.sleep(POLL)
            for child in [child for child in going if child.has_ended()]:
                going.remove(child)
                if child.was_resumed and child.run.manifest.get("exit_code") == 2:  # of another version: it cannot go on
                    os.remove(os.path.join(child.run.path, "params.used.prm"))
                    child.run.update(state="planned", reason="")
                    waiting.insert(0, child.run)
                    continue
                if not child.is_repetition:
                    count += 1
                    self.report(child.run, count, len(runs))
                if child.run.is_to_run(repeats=self.repeats) and child.run.state == "done" and not self.is_stopping:
                    waiting.append(child.run)
        return not self.is_stopping

    def fits(self, run, going, memory):
        """Whether cores and memory allow one more run beside those that are going on."""
        if not going:
            return True
        if len(going) >= self.jobs or sum(child.threads for child in going) + run.manifest.get("threads", 1) > self.cores:
            return False
        return sum(child.run.manifest.get("memory_mb", 0) for child in going) + run.manifest.get("memory_mb", 0) <= memory

    def end(self, going):
        """One SIGTERM each: a second one would end them without a checkpoint."""
        for child in going:
            if not getattr(child, "is_told", False):
                child.is_told = True
                child.process.terminate()

    def report(self, run, count, total):
        manifest = run.manifest
        seconds = manifest.get("processor_time_s")
        words = {"done": "%8.4g s" % seconds if seconds is not None else "",
                 "failed": "failed: %s" % clipped(manifest.get("reason", ""))}
        self.tell("[%*d/%d] %s  %s" % (len(str(total)), count, total, words.get(run.state, manifest.get("reason", "")), title(manifest)))


def title(manifest):
    """Of a run, in words."""
    words = ["%s = %s" % (name, label_text(value)) for name, value in manifest["varied"].items()]
    words += [manifest["effect"]] * bool(manifest["effect"]) + ["seed %d" % manifest["seed"]] * bool(manifest["seed"])
    return ", ".join(words) or "the scene"


def estimate(runs, scene):
    """Memory of each run by hybrid --check, in its manifest."""
    for run in runs:
        if "memory_mb" not in run.manifest:
            try:
                run.update(memory_mb=program.memory(scene, run.manifest["overrides"] + ["Output/Directory=" + run.path + "/none"]))
            except UserError as error:  # the run will say the same
                run.update(memory_mb=0.0, estimate=str(error))


def plan_runs(study, settings):
    """Run directories of these settings."""
    found = []
    for setting in settings:
        run = RunDirectory(study.directory, setting.name)
        run.plan(study, setting)
        threads = dict(override.split("=", 1) for override in run.manifest["overrides"]).get("Parallel/Threads")
        if "threads" not in run.manifest:
            run.update(threads=int(threads or study.base.get("Parallel/Threads", 1)))
        found.append(run)
    return found
