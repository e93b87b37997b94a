#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The command line as a user meets it: mistakes give exit code 2 and one line on stderr that names the file
(and the line), leave no output behind, and --check finds them too.

Usage: command_line_test.py HYBRID_BINARY SOURCE_DIR WORK_DIR
"""
import fcntl
import os
import pathlib
import pty
import re
import shutil
import struct
import subprocess
import sys
import termios

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from run_hybrid import program_for_many  # noqa: E402 (needs the path above)

BINARY, SOURCE, WORK = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
SCENE = (SOURCE / "parameters/verification/coupled_column.prm").read_text(encoding="utf-8")
complaints = []
server = program_for_many(BINARY)


def run(*words):
    """The program as it is started by hand."""
    return subprocess.run([BINARY, *map(str, words)], cwd=WORK, capture_output=True, text=True, timeout=600)


def ask(*words):
    """The same without a start of its own."""
    code, out, error = server.ask(words, WORK)
    return subprocess.CompletedProcess(words, code, out, error)


def require(condition, text, result=None):
    if not condition:
        complaints.append(text)
        print("FAILED:", text)
        if result is not None:
            print(f"  exit code {result.returncode}\n  stderr: {result.stderr!r}\n  stdout: {result.stdout[-500:]!r}")


def scene_file(name, text):
    """A scene in the working directory."""
    text = text.replace("../../meshes/half_blocks.geo", str(SOURCE / "meshes/half_blocks.geo"))
    path = WORK / name
    path.write_text(text, encoding="utf-8")
    return path


def expect_mistake(what, words, *parts, started=False):
    """Both a run and --check say so in one line, with exit code 2, and leave nothing behind; started: by hand."""
    for mode in ([], ["--check"]):
        before = sorted(WORK.rglob("*"))
        result = (run if started else ask)(*mode, *words)
        label = f"{what} {' '.join(mode)}".strip()
        lines = result.stderr.splitlines()
        require(result.returncode == 2, f"{label}: exit code 2", result)
        require(len(lines) == 1 and lines[0].startswith("error: "), f"{label}: one line 'error: ...'", result)
        for part in parts:
            require(str(part) in result.stderr, f"{label}: the message names '{part}'", result)
        require(sorted(WORK.rglob("*")) == before, f"{label}: nothing is left behind", result)


def replaced(old, new):
    require(old in SCENE, f"the scene has the line '{old}'")
    return SCENE.replace(old, new, 1)


def line_of(text, word):
    return next(i for i, line in enumerate(text.splitlines(), 1) if word in line)


def check_mistakes():
    good = scene_file("good.prm", SCENE)
    expect_mistake("missing file", ["nowhere.prm"], "nowhere.prm", started=True)
    expect_mistake("directory as file", [WORK], WORK.name)

    text = replaced("  set Frequency = 6", "  set Frequenzy = 6")
    expect_mistake("unknown parameter", [scene_file("unknown.prm", text)],
                   f"unknown.prm:{line_of(text, 'Frequenzy')}", "Frequenzy", "Frequency", started=True)

    text = replaced("  set Peak      = 0.5", "  set Peak      = 0.5\n  set Peak = 0.6")
    expect_mistake("duplicate key", [scene_file("duplicate.prm", text)],
                   f"duplicate.prm:{line_of(text, 'Peak = 0.6')}", "Peak")

    text = replaced("set Poisson ratio    = 0.25", "set Poisson ratio    = 0.5")
    expect_mistake("impossible value", [scene_file("impossible.prm", text)],
                   f"impossible.prm:{line_of(text, 'Poisson')}", "0.5")

    text = replaced("set Time step = 0.002", "set Time step = -1")
    expect_mistake("negative step", [scene_file("negative.prm", text)], f"negative.prm:{line_of(text, 'Time step')}", "-1")

    text = replaced("half_blocks.geo", "column.geo").replace(str("../../meshes/column.geo"), str(SOURCE / "meshes/column.geo"))
    text = text.replace("; Block height = 10", "")
    expect_mistake("missing group", [scene_file("group.prm", text)], "group.prm", "sliding_mass")

    text = replaced("set Type      = ricker", "set Type      = text\n  set File = nowhere.txt")
    expect_mistake("missing record", [scene_file("record.prm", text)], f"record.prm:{line_of(text, 'nowhere.txt')}",
                   "nowhere.txt")

    (WORK / "bad_record.txt").write_text("0 0\n0.01 what\n0.02 0\n", encoding="utf-8")
    text = replaced("set Type      = ricker", "set Type      = text\n  set File = bad_record.txt")
    expect_mistake("unreadable record", [scene_file("bad_record.prm", text)], "bad_record.txt:2", "what")

    text = replaced("half_blocks.geo", "no_such_mesh.geo")
    expect_mistake("missing mesh", [scene_file("mesh.prm", text)], "no_such_mesh.geo", f"mesh.prm:{line_of(text, 'no_such')}")

    (WORK / "broken.geo").write_text("Point(1) = {0, 0;\n", encoding="utf-8")
    text = replaced("../../meshes/half_blocks.geo", "broken.geo")
    expect_mistake("broken geometry", [scene_file("broken.prm", text)], "broken.geo", started=True)

    # A curve loop that does not close.
    disc = (SOURCE / "meshes/disc.geo").read_text(encoding="utf-8")
    (WORK / "crashing.geo").write_text(disc.replace("-10, -9}", "-10, 10}"), encoding="utf-8")
    text = (SOURCE / "parameters/verification/brazilian_disc.prm").read_text(encoding="utf-8")
    text = text.replace("../../meshes/disc.geo", "crashing.geo")
    expect_mistake("geometry on which gmsh crashes", [scene_file("crashing.prm", text)], "crashing.geo", "gmsh crashes", started=True)

    text = replaced("Block height = 10", "Block hight = 10")
    expect_mistake("unknown number of the mesh", [scene_file("number.prm", text)], "number.prm", "Block hight")

    text = replaced("top: 5, 20", "top: 5, 99")
    expect_mistake("monitor outside", [scene_file("monitor.prm", text)], "monitor.prm", "top")

    text = replaced("  set Base   = base", "  set Base   = nobody")
    expect_mistake("unknown base monitor", [scene_file("base.prm", text)], "nobody")

    text = replaced("Belt material = rock", "Belt material = clay")
    expect_mistake("unknown material", [scene_file("material.prm", text)], "clay")

    expect_mistake("unknown -s path", [good, "-s", "Time/Tim step=1"], "Time/Tim step")
    expect_mistake("impossible -s value", [good, "-s", "Time/Time step=fast"], "fast")
    expect_mistake("-s without value", [good, "-s", "Time/Time step"], "-s")
    expect_mistake("two files", [good, good], "good.prm")
    expect_mistake("unknown option", [good, "--fast"], "--fast", started=True)
    expect_mistake("misspelt option", [good, "--forse"], "did you mean '--force'?")
    result = ask("--chek", good)
    require(result.returncode == 2 and "did you mean '--check'?" in result.stderr, "--chek", result)
    for way, words, part in ((ask, ["plott", "run"], "did you mean 'plot'?"), (run, ["plot"], "required: RUN"),
                             (ask, [good, "plot"], "'plot' stands first"), (run, ["plot", "run", "--hlep"], "did you mean '--help'?"),
                             (ask, ["-"], "unknown option '-'"), (ask, ["--check=yes", good], "takes no value")):
        result = way(*words)
        require(result.returncode == 2 and part in result.stderr and len(result.stderr.splitlines()) == 1, f"{words}", result)
    expect_mistake("quoted record", [good, "-s", "Motion/Type=text", "-s", "Motion/File='record.txt'"], "leave the quotation marks away")
    expect_mistake("~ in the output directory", [good, "-s", "Output/Directory=~/output"], "write the whole path")

    (WORK / "a_file").write_text("", encoding="utf-8")
    before = sorted(WORK.rglob("*"))
    result = ask(good, "-s", "Output/Directory=a_file/run")
    require(result.returncode == 2 and len(result.stderr.splitlines()) == 1 and "a_file/run" in result.stderr,
            "output directory that cannot be made", result)
    require(sorted(WORK.rglob("*")) == before, "output directory that cannot be made: nothing is left behind")


def check_good_ways():
    good = WORK / "good.prm"
    before = sorted(WORK.rglob("*"))
    result = run("--check", good)
    require(result.returncode == 0 and not result.stderr, "--check of a good scene", result)
    require(sorted(WORK.rglob("*")) == before, "--check writes nothing")

    result = ask("--help")
    require(result.returncode == 0 and "--check" in result.stdout, "--help", result)

    fine = "Mesh/Numbers=Width = 10; Height = 20; Block height = 10; Resolution/h = 0.135"
    result = ask("--check", good, "-s", fine, "-s", "Model/Blocks=none", "-s", "Monitors/Points=base: 5, 0")
    require(result.returncode == 0 and "Meshing: up to 0.02" in result.stdout, "a fine mesh is announced", result)

    for words in (["plot", "--help"], ["help", "plot"]):
        result = run(*words)
        require(result.returncode == 0 and "Usage: hybrid plot" in result.stdout, " ".join(words), result)
    result = ask("help")
    require(result.returncode == 0 and "--version" in result.stdout, "help", result)
    result = run("--version")
    require(result.returncode == 0 and all(word in result.stdout for word in (
        "hybrid ", "commit ", "deal.II ", "Trilinos ", "gmsh ", "Eigen ", "HDF5 ")), "--version", result)
    flags = re.search(r"^flags\s*:(.*)$", pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8"), re.MULTILINE)
    if flags and {"avx2", "fma"} <= set(flags.group(1).split()) and "OPENBLAS_CORETYPE" not in os.environ:
        require("Prescott" not in result.stdout, "OpenBLAS uses what the processor has", result)

    result = run("--print-parameters")
    require(result.returncode == 0 and not result.stderr, "--print-parameters", result)
    every = WORK / "every.prm"
    every.write_text(result.stdout, encoding="utf-8")
    result = ask("--check", every, "-s", f"Mesh/File={SOURCE / 'meshes/half_blocks.geo'}")
    require(result.returncode == 0, "--print-parameters reads back", result)
    result = ask("--print-parameters", good, "-s", "Time/End time=0.125")
    require(result.returncode == 0 and "= 0.125" in result.stdout and not result.stderr, "--print-parameters of a scene", result)
    result = ask("--print-parameters", "missing.prm")
    require(result.returncode == 2 and "missing.prm" in result.stderr and not result.stdout, "--print-parameters of no scene", result)

    result = run(good, "-s", "Output/Directory=done", "-s", "Time/End time=0.02")
    require(result.returncode == 0 and not result.stderr, "a run", result)
    for name in ("run.h5", "summary.json", "params.used.prm", "log.txt"):
        require((WORK / "done" / name).is_file(), f"a run writes {name}")
    result = ask("--check", WORK / "done/params.used.prm")
    require(result.returncode == 0, "params.used.prm reads back", result)

    result = run(good, "-s", "Output/Directory=stopped", "-s", "Time/Maximum halvings=0", "-s",
                 "Time/Maximum displacement ratio=1e-9", "-s", "Gravity/Static stage=none")
    require(result.returncode == 1, "a run that cannot converge ends with 1", result)
    require((WORK / "stopped/summary.json").is_file(), "a stopped run has a summary")


def on_a_terminal(columns, *words):
    """What the program draws on a terminal of so many columns."""
    master, slave = pty.openpty()
    fcntl.ioctl(slave, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
    process = subprocess.Popen([BINARY, *map(str, words)], cwd=WORK, stdout=slave, stderr=subprocess.DEVNULL)
    os.close(slave)
    text = b""
    while True:
        try:
            piece = os.read(master, 4096)
        except OSError:  # the other end is closed
            break
        if not piece:
            break
        text += piece
    os.close(master)
    process.wait()
    return text.decode()


def check_two_runs():
    """Of two runs in one directory the second is refused, and the first goes on."""
    directory = WORK / "of_one_run"
    words = [WORK / "good.prm", "-s", f"Output/Directory={directory}"]
    first = subprocess.Popen([BINARY, *map(str, words), "-s", "Time/End time=1000"], cwd=WORK, stdout=subprocess.PIPE, text=True)
    while not (directory / "params.used.prm").exists() and first.stdout.readline():
        pass
    for second in (["--force", *words], ["--resume", directory]):
        result = ask(*second)
        require(result.returncode == 2 and "another run" in result.stderr, f"{second[0]} is refused while a run is under way", result)
    require(first.poll() is None, "the first run goes on")
    first.terminate()
    first.communicate(timeout=60)
    result = ask(*words, "--force", "-s", "Time/End time=0.01")
    require(result.returncode == 0, "once it has ended the directory is free", result)


def check_progress_line():
    """Redrawn lines are narrower than the terminal: a wider one would begin another at each redraw."""
    for columns in (80, 50):
        text = on_a_terminal(columns, WORK / "good.prm", "--force", "-s", "Output/Directory=drawn", "-s", "Time/End time=0.2")
        drawn = [line for line in re.findall(r"\r\033\[K([^\r\n]*)", text) if "%  t =" in line]
        require(drawn, f"a terminal of {columns} columns shows the progress")
        for line in drawn:
            require(len(line) < columns, f"{len(line)} characters are drawn on {columns} columns: {line}")


def check_slope_that_cannot_stand():
    """A slope that cannot stand ends the run, unless the scene says that it may move."""
    text = (SOURCE / "parameters/verification/friction.prm").read_text(encoding="utf-8")
    scene = WORK / "slides.prm"
    scene.write_text(text.replace("../../meshes", str(SOURCE / "meshes")), encoding="utf-8")
    settings = ["-s", "Materials/rock/Friction angle=29", "-s", "Time/End time=0.01"]
    result = ask(scene, *settings, "-s", "Output/Directory=slides")
    require(result.returncode == 1, "a slope that cannot stand: exit code 1", result)
    for word in ("no static equilibrium", "block 0 at (", "the run ends here", "Blocks/Material", "held", "none",
                 "equilibrium or move"):
        require(word in result.stdout, f"a slope that cannot stand: '{word}' is said", result)
    require("Stopped   at 0 s" in result.stdout and " 0 steps" in result.stdout, "a slope that cannot stand is not shaken", result)
    require((WORK / "slides/summary.json").is_file(), "a slope that cannot stand has a summary")
    for stage in ("equilibrium or move", "held", "none"):
        result = ask(scene, *settings, "-s", f"Gravity/Static stage={stage}", "-s",
                     f"Output/Directory=slides_{stage.replace(' ', '_')}")
        require(result.returncode == 0, f"a slope that cannot stand with Static stage = {stage}: exit code 0", result)


def main():
    shutil.rmtree(WORK, ignore_errors=True)
    WORK.mkdir(parents=True)
    check_mistakes()
    check_good_ways()
    check_two_runs()
    check_progress_line()
    check_slope_that_cannot_stand()
    server.end()
    require(not server.said_elsewhere(), f"nothing else is said: {server.said_elsewhere()[:500]!r}")
    print(f"{len(complaints)} complaints")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
