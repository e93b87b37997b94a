#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Mutated scenes for the whole program: hybrid --check, then a run of three steps of what was accepted.

    fuzz_scenes.py PROGRAM SOURCE WORK [--count 40] [--seed 1] [--long] [--seconds 15]

A scene is refused with exit code 2 and one line "error: ..." and leaves nothing behind, or it is accepted (0) and runs
to exit code 0, 1 (no convergence or no static equilibrium) or 2 without a number in run.h5 that is not finite. Nonsense (NONSENSE below) must be refused.
Each mutation depends on its number alone: `--seed N --count 1` repeats what is reported as N; its folder is kept.
"""
import argparse
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import threading
import time

VALUES = ["nan", "-nan", "inf", "-inf", "1e308", "-1e308", "1e-308", "1e400", "-1", "0", "-0.0", "", "1e20", "1e-20",
          "2147483648", "1000000000", "1,5", "12 m", "5e3 kPa", "thing", "rock soil", "../x", "\xff\xfe", "true", "10", "0.5"]
STEPS = 3

# (parameter, value, or more settings): each must be refused, whatever the scene
NONSENSE = [
    ("Time/Time step", "nan"), ("Time/Time step", "0"), ("Time/Time step", "-1e-3"), ("Time/Time step", "inf"),
    ("Time/Time step", "1e6"), ("Time/End time", "-1"), ("Time/End time", "nan"), ("Time/End time", "1e300"),
    ("Gravity/Horizontal coefficient", "nan"), ("Gravity/Horizontal coefficient", "1e300"),
    ("Materials/Strength reduction factor", "0"), ("Materials/Strength reduction factor", "-1"),
    ("Gravity/Acceleration", "nan"), ("Gravity/Acceleration", "-9.81"), ("Gravity/Acceleration", "1e300"),
    ("Gravity/Initial stress", "-0.1"), ("Gravity/Initial stress", "nan"), ("Gravity/Initial stress", "1e300"),
    ("Gravity/Initial stress", "1 - cos phi"), ("Gravity/Initial stress", "rock: staged"), ("Gravity/Lifts", "0"), ("Gravity/Lifts", "1001"),
    ("Gravity/Lifts", "2.5"), ("Motion/Repetitions", "0"), ("Motion/Repetition interval", "0"),
    ("Motion/Frequency", "1e-9"), ("Motion/Frequency", "1e308"), ("Motion/Peak", "nan"), ("Motion/Peak", "-1"), ("Motion/Peak", "1e300"),
    ("Blocks/Penalty ratio", "0"), ("Blocks/Penalty ratio", "nan"), ("Blocks/Penalty ratio", "1e300"),
    ("Maxwell damping/Block ratio", "0.3"), ("Maxwell damping/Bedrock ratio", "-0.01"), ("Maxwell damping/Branches", "0"),
    ("Maxwell damping/Lowest frequency", "1e9"), ("Maxwell damping/Highest frequency", "0"),
    ("Materials/*/Friction rate coefficient", "2"), ("Materials/*/Friction reference rate", "0"),
    ("Blocks/Shear ratio", "-1"), ("Blocks/Damping ratio", "-0.1"), ("Blocks/Tolerance", "0"),
    ("Monitors/Line interval", "-1"), ("Monitors/Line interval", "nan"), ("Monitors/Line points", "-1"), ("Monitors/Lines", "a: 1, nan, 2, 3"),
    ("Blocks/Maximum iterations", "0"), ("Blocks/Maximum iterations", "1e3"), ("Parallel/Threads", "0"),
    ("Materials/*/Density", "-2000"), ("Materials/*/Density", "0"), ("Materials/*/Density", "nan"),
    ("Materials/*/Density", "1e300"), ("Materials/*/Density", "1e-300"), ("Materials/*/Young modulus", "1e-300"),
    ("Bedding planes/Normal stiffness", "1e300"), ("Bedding planes/Shear stiffness", "1e300"), ("Materials/*/Young modulus", "0"), ("Materials/*/Young modulus", "-1e9"),
    ("Materials/*/Young modulus", "1e300"), ("Materials/*/Poisson ratio", "0.5"), ("Materials/*/Poisson ratio", "-1"),
    ("Materials/*/Cohesion", "-1"), ("Materials/*/Friction angle", "90"), ("Materials/*/Friction angle", "-5"),
    ("Continuum/Rayleigh stiffness", "1e308"), ("Continuum/Rayleigh mass", "1e308"),
    ("Materials/*/Tensile strength", "-1"), ("Water/Level", "1e9"), ("Water/Line file", "none.csv"), ("Point loads/Forces", "P: 10, 5, 0, -1e300"),
    ("Edge loads/Tractions", "T: 0, 30, 0, 30, 0, -1e30"),
    ("Blocks/Initial velocities", "v: -1e9, 1e9, -1e9, 1e9, nan, 0, 0"), ("Blocks/Initial velocities", "v: 0, 1, 0, 1, 1e300, 0, 0"),
    ("Initial wave/Frequency", "0"), ("Initial wave/Length", "0"),
    ("Initial wave/Width", "-1"), ("Initial wave/Amplitude", "1e300"), ("Initial wave/Centre", "1e400, 0"),
    ("Output/Picture interval", "nan"), ("Nothing/At all", "1"),
]


class Failure(Exception):
    """What a mutated scene did that it must not."""


class Watch:
    """Kills a process that has computed for more than some seconds; of wall time it may take twenty times as many."""

    def __init__(self, process, seconds):
        self.process = process
        self.cpu_end, self.wall_end = self.computed() + seconds, time.monotonic() + 20 * seconds
        self.has_killed, self.over = False, threading.Event()
        self.thread = threading.Thread(target=self.look, daemon=True)
        self.thread.start()

    def computed(self):
        """Processor time of the process so far [s]."""
        try:
            fields = pathlib.Path(f"/proc/{self.process.pid}/stat").read_text().rpartition(")")[2].split()
        except OSError:
            return 0.
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def look(self):
        while not self.over.wait(0.1):
            if self.computed() > self.cpu_end or time.monotonic() > self.wall_end:
                self.has_killed = True
                self.process.kill()
                return

    def end(self):
        """@return whether the process had to be killed."""
        self.over.set()
        self.thread.join()
        return self.has_killed


class Program:
    """hybrid, one process per command line; or scene_server, which takes one after the other until it dies."""

    def __init__(self, path, log):
        self.path, self.log, self.process = path, log, None
        self.environment = {**os.environ, "OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1",
                            "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
        self.environment.setdefault("ASAN_OPTIONS", "detect_leaks=0")

    def run(self, arguments, folder, seconds):
        """@return a CompletedProcess. Throws Failure if there is none after so many seconds."""
        arguments = [str(argument) for argument in arguments]
        hang = Failure(f"no end after {seconds} s of computing: hybrid {' '.join(arguments)}")
        if self.path.name == "scene_server":
            return self.ask([str(folder), *arguments], seconds, hang)
        process = subprocess.Popen([self.path, *arguments], cwd=folder, env=self.environment, stdin=subprocess.DEVNULL,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8", errors="replace")
        watch = Watch(process, seconds)
        out, error = process.communicate()
        if watch.end():
            raise hang
        return subprocess.CompletedProcess(arguments, process.returncode, out, error)

    def ask(self, words, seconds, hang):
        if self.process is None:
            with open(self.log, "wb") as log:
                self.process = subprocess.Popen([self.path], env=self.environment, stdin=subprocess.PIPE,
                                                stdout=subprocess.PIPE, stderr=log)
            self.log_end = 0
        watch = Watch(self.process, seconds)
        self.process.stdin.write(("\t".join(words) + "\n").encode())
        self.process.stdin.flush()
        head = self.process.stdout.readline().split()
        if head:
            code, out, error = int(head[0]), self.process.stdout.read(int(head[1])), self.process.stdout.read(int(head[2]))
        else:
            code, out, error = self.process.wait(), b"", b""
            self.process = None
        if watch.end() and not head:
            raise hang
        with open(self.log, "rb") as log:  # what the libraries write there
            log.seek(self.log_end)
            error += log.read()
            self.log_end = log.tell()
        if head and b"gmsh" in error:  # whose parser goes on with what an error left it
            self.process.stdin.close()
            self.process.wait()
            self.process = None
        return subprocess.CompletedProcess(words, code, out.decode(errors="replace"), error.decode(errors="replace"))


def judge(result, allowed):
    """One line `error:` where the code says that the input is at fault."""
    if result.returncode not in allowed:
        raise Failure(f"exit code {result.returncode}: {(result.stderr or result.stdout).strip()[-600:]}")
    errors = [line for line in result.stderr.splitlines() if line.startswith("error:")]
    others = [line for line in result.stderr.splitlines() if line.strip() and not line.startswith(("error:", "warning"))]
    if result.returncode == 2 and (len(errors) != 1 or others):
        raise Failure(f"not one line 'error: ...': {result.stderr.strip()[-600:]}")
    if result.returncode == 0 and errors:
        raise Failure(f"an error, but exit code 0: {errors[0]}")
    card = result.stdout.partition("Effects\n")[2]  # the title is the user's
    wrong = [line for line in card.splitlines() if re.search(r"(?<![\w-])-?(nan|inf)\b", line)]
    if wrong:
        raise Failure(f"nan or inf on the scene card: {wrong[0]}")


def check_numbers(directory):
    import h5py
    import numpy

    def look(name, item):
        if name == "joints/failure_time":
            return  # NaN: has not failed
        if isinstance(item, h5py.Dataset) and item.dtype.kind == "f" and not numpy.isfinite(item[()]).all():
            raise Failure(f"run.h5: {name} has numbers that are not finite")

    with h5py.File(directory / "run.h5", "r") as file:
        file.visititems(look)


def try_scene(program, folder, scene, limits):
    """Check a scene, then run three steps of it. @return 'refused', 'run', or 'only checked' where it is large."""
    before = sorted(folder.rglob("*"))
    result = program.run(["--check", scene], folder, limits["seconds"])
    judge(result, (0, 2))
    if sorted(folder.rglob("*")) != before:
        raise Failure("--check wrote files")
    if result.returncode == 2:
        limits["messages"].append(result.stderr.strip())
        return "refused"
    step = re.search(r"in steps of (\S+) s", result.stdout)
    end = re.search(r"Time +(\S+) s in steps", result.stdout)
    duration = min(STEPS * float(step.group(1)), float(end.group(1)))
    options = ["-s", f"Time/End time={duration:.17g}", "-s", "Output/Directory=out"]
    sizes = re.findall(r"(\d+) (?:unknowns|blocks|triangles)", result.stdout)
    if not limits["run"] or sum(map(int, sizes)) > 20000 or any(" blocks," in line and int(line.split()[1]) > 300
                                                                for line in result.stdout.splitlines() if line.startswith("Blocks ")):
        return "only checked"
    result = program.run([scene, *options], folder, 4 * limits["seconds"])
    judge(result, (0, 1, 2))
    if result.returncode == 2:
        raise Failure(f"--check accepts what the run refuses: {result.stderr.strip()}")
    if (folder / "out" / "run.h5").exists():
        check_numbers(folder / "out")
    return "run"


def scaled(number, random_):
    """The number times something that a user might try, or a wrong unit."""
    factor = random_.choice([10**random_.uniform(-1, 1), random_.uniform(0.8, 1.2), 10**random_.uniform(-4, 4), 1e3, 1e-3, -1, 0])
    return f"{float(number) * factor:.{random_.choice([2, 4, 17])}g}"


def scale_number(text, random_):
    # not the ends of gmsh's lists 1:n nor its numbers of nodes: it would count to any of them
    fixed = [range(*match.span()) for match in re.finditer(r"[^\n]*(?:Transfinite Curve|\d:|:-?\d)[^\n]*", text)]
    numbers = list(re.finditer(r"(?<![\w.])-?\d+\.?\d*(?:e[+-]?\d+)?(?![\w.])", text))
    numbers = [number for number in numbers if not any(number.start() in lines for lines in fixed)]
    if not numbers:
        return text
    number = random_.choice(numbers)
    return text[:number.start()] + scaled(number.group(), random_) + text[number.end():]


def scale_setting(lines, random_):
    at = [i for i, line in enumerate(lines) if re.match(r"\s*set .*=.*\d", line)]
    if at:
        i = random_.choice(at)
        head, _, value = lines[i].partition("=")
        lines[i] = f"{head}={scale_number(value, random_)}"


def change_setting(lines, random_):
    at = [i for i, line in enumerate(lines) if re.match(r"\s*set ", line)]
    i = random_.choice(at)
    head, _, value = lines[i].partition("=")
    words = re.findall(r"[^\s,;:]+", value.split("#")[0])
    if words and random_.random() < 0.5:
        word = random_.choice(words)
        value = value.replace(word, random_.choice(VALUES), 1)
    elif words and random_.random() < 0.3:
        number = random_.choice(words)
        value = value.replace(number, number + random_.choice(["e3", "e-3", "e6", "0", "000"]), 1)
    else:
        value = " " + random_.choice(VALUES)
    lines[i] = f"{head}={value}"


def change_lines(lines, random_):
    i, j = random_.randrange(len(lines)), random_.randrange(len(lines))
    kind = random_.randrange(6)
    if kind == 0:
        del lines[i]
    elif kind == 1:
        lines.insert(j, lines[i])
    elif kind == 2:
        lines[i], lines[j] = lines[j], lines[i]
    elif kind == 3:
        del lines[i + 1:]
    elif kind == 4:
        lines[i] = lines[i][:random_.randrange(len(lines[i]) + 1)] + "".join(chr(random_.randrange(256)) for _ in range(9))
    else:
        words = lines[i].split(" ")
        a, b = random_.randrange(len(words)), random_.randrange(len(words))
        words[a], words[b] = words[b], words[a]
        lines[i] = " ".join(words)


def change_table(text, random_):
    """A mesh, record or CSV file: a number, a line or the end of it is wrong."""
    if random_.random() < 0.6:
        return scale_number(text, random_)
    lines = text.split("\n")
    if random_.random() < 0.4:
        change_lines(lines, random_)
        return "\n".join(lines)
    numbers = list(re.finditer(r"(?<![\w.])-?\d+\.?\d*(e-?\d+)?", text))
    if not numbers:
        return text
    number = random_.choice(numbers)
    new = random_.choice(VALUES + [number.group() + "000", "-" + number.group()])
    return text[:number.start()] + new + text[number.end():]


def seeds(source, leave_out):
    result = []
    for folder in ("verification", "hard"):
        for path in sorted((source / "parameters" / folder).glob("*.prm")):
            if not re.fullmatch(leave_out, path.stem):
                result.append(path)
    return result


def make_folder(source, work, seed, scene):
    """A copy of what the scene needs: meshes and tables beside it, at the paths that it names."""
    folder = work / f"scene_{seed}"
    shutil.rmtree(folder, ignore_errors=True)
    home = folder / "parameters" / scene.parent.name
    home.mkdir(parents=True)
    shutil.copytree(source / "meshes", folder / "meshes")
    for path in scene.parent.iterdir():
        if path.suffix != ".prm":
            shutil.copy(path, home)
    return folder, home / "mutated.prm"


def mutate(source, work, seed, scenes):
    random_ = random.Random(seed)
    scene = random_.choice(scenes)
    folder, target = make_folder(source, work, seed, scene)
    lines = scene.read_text().split("\n")
    tables = [path for name in re.findall(r"[\w./-]+\.(?:geo|csv|txt|at2)", scene.read_text())
              if (path := (target.parent / name).resolve()).is_file()]
    if tables and random_.random() < 0.35:
        table = random_.choice(tables)
        table.write_text(change_table(table.read_text(), random_), encoding="latin-1", errors="replace")
    else:
        for _ in range(random_.randint(1, 3)):
            if not any(re.match(r"\s*set .*=", line) for line in lines):
                break
            random_.choices([scale_setting, change_setting, change_lines], [0.75, 0.17, 0.08])[0](lines, random_)
    target.write_text("\n".join(lines), encoding="latin-1", errors="replace")
    return folder, target


def try_nonsense(program, source, work, limits):
    """@return how many settings of NONSENSE were tried; failures are appended to limits['failures']."""
    scene = source / "parameters/verification/restart_coupled.prm"
    text = scene.read_text()
    names = re.search(r"set Names *= *(.*)", text[text.index("subsection Materials"):]).group(1)
    material = names.split(",")[0].strip()
    folder, target = make_folder(source, work, "nonsense", scene)
    target.write_text(text)
    for name, value in NONSENSE:
        setting = f"{name.replace('*', material)}={value}"
        try:
            result = program.run(["--check", "-s", setting, target], folder, limits["seconds"])
            judge(result, (2,))
            limits["messages"].append(result.stderr.strip())
            if "unknown" in result.stderr and not name.startswith("Nothing"):
                raise Failure(result.stderr.strip())
        except Failure as failure:
            limits["failures"].append(f"nonsense {setting}: {failure}")
    return len(NONSENSE)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=lambda name: pathlib.Path(name).resolve(), help="hybrid or scene_server")
    parser.add_argument("source", type=lambda name: pathlib.Path(name).resolve())
    parser.add_argument("work", type=lambda name: pathlib.Path(name).resolve())
    parser.add_argument("--count", type=int, default=1000000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--seconds", type=float, default=10., help="wall time after which no new scene is begun")
    parser.add_argument("--hang", type=float, default=30.,
                        help="processor time of --check that counts as a hang, and a quarter of that of a run")
    parser.add_argument("--no-run", dest="run", action="store_false", help="only --check")
    parser.add_argument("--messages", type=pathlib.Path, help="file for what the refused scenes were told")
    parser.add_argument("--leave-out", default="lamb.*|cantilever|heterogeneous_column|oblique.*",
                        help="regular expression of scenes that are not mutated, here those of seconds each")
    parser.add_argument("--sanitized", action="store_true",
                        help="the program is ten times slower: so is a hang, and more scenes are left out")
    parser.add_argument("--long", action="store_true", help="10,000 scenes, however long they take")
    arguments = parser.parse_args()
    if arguments.sanitized:
        arguments.hang *= 10
        arguments.leave_out += "|majiagou.*|all_joints.*|slope.*|wall|bin|soft.*"
    limits = {"seconds": arguments.hang, "run": arguments.run, "failures": [], "messages": []}
    count, seconds = (10000, 1e9) if arguments.long else (arguments.count, arguments.seconds)

    begin = time.monotonic()
    arguments.work.mkdir(parents=True, exist_ok=True)
    program = Program(arguments.program, arguments.work / "program.log")
    nonsense = try_nonsense(program, arguments.source, arguments.work, limits)
    scenes = seeds(arguments.source, arguments.leave_out)
    tally = {"refused": 0, "run": 0, "only checked": 0}
    for seed in range(arguments.seed, arguments.seed + count):
        if sum(tally.values()) > 0 and time.monotonic() - begin > seconds:
            break
        folder, target = mutate(arguments.source, arguments.work, seed, scenes)
        try:
            tally[try_scene(program, folder, target, limits)] += 1
            shutil.rmtree(folder)
        except Failure as failure:
            tally["failed"] = tally.get("failed", 0) + 1
            limits["failures"].append(f"scene {seed} (kept in {folder}): {failure}")
            print(limits["failures"][-1], flush=True)
    if arguments.messages:
        arguments.messages.write_text("".join(message + "\n" for message in sorted(set(limits["messages"]))))
    print(f"{nonsense} settings that are nonsense; scenes: {tally}, {time.monotonic() - begin:.0f} s")
    for failure in limits["failures"]:
        print("FAILED", failure)
    return 1 if limits["failures"] else 0


if __name__ == "__main__":
    sys.exit(main())
