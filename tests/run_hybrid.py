# SPDX-License-Identifier: GPL-3.0-or-later
"""A run of the program, as the scenes of verification/ and stability/ need it, and what is asked of it."""

import atexit
import functools
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile


def environment():
    return dict(os.environ, OPENBLAS_NUM_THREADS="1", OMP_NUM_THREADS="1")


class Server:
    """The program for many runs in one process (tests/fuzz/scene_server.cc): loading its libraries takes longer than a small scene."""

    def __init__(self, binary, **variables):
        self.path, self.variables, self.past_streams = self.path_of(binary), variables, tempfile.TemporaryFile()
        self._start()

    @staticmethod
    def path_of(binary):
        return pathlib.Path(binary).parent / "tests/fuzz/scene_server"

    def _start(self):
        self.process = subprocess.Popen([str(self.path)], env=dict(environment(), **self.variables), stdin=subprocess.PIPE,
                                        stdout=subprocess.PIPE, stderr=self.past_streams)

    def ask(self, words, folder=None):
        """Exit code, standard output and error of the program with these words, in a folder."""
        self.process.stdin.write(("\t".join([str(folder or os.getcwd()), *map(str, words)]) + "\n").encode())
        self.process.stdin.flush()
        head = self.process.stdout.readline().split()
        if not head:
            code = self.process.wait()
            self._start()  # for those that follow
            return code, "", "the process of many runs has ended: " + self.said_elsewhere()[-1500:]
        code, out, error = map(int, head)
        return (code, *(self.process.stdout.read(size).decode(errors="replace") for size in (out, error)))

    def said_elsewhere(self):
        """What was written to standard error so far, but not by the program's own stream."""
        self.past_streams.seek(0)
        return self.past_streams.read().decode(errors="replace")

    def processor_time(self):
        """Of the program and of what it has started, in user mode [s]."""
        fields = pathlib.Path("/proc/%d/stat" % self.process.pid).read_text(encoding="utf-8").rpartition(")")[2].split()
        return (int(fields[11]) + int(fields[13])) / os.sysconf("SC_CLK_TCK")

    def end(self):
        self.process.stdin.close()
        self.process.wait()


class Started:
    """The same, started for each of them."""

    def __init__(self, binary, **variables):
        self.binary, self.variables = str(binary), variables

    def ask(self, words, folder=None):
        done = subprocess.run([self.binary, *map(str, words)], cwd=folder, capture_output=True, text=True,
                              env=dict(environment(), **self.variables), check=False)
        return done.returncode, done.stdout, done.stderr

    def said_elsewhere(self):
        return ""

    def processor_time(self):
        return os.times().children_user

    def end(self):
        pass


def program_for_many(binary, **variables):
    """A Server; Started if there is none, or one that lacks what was built into the program since."""
    server, built = Server.path_of(binary), pathlib.Path(binary).stat().st_mtime
    libraries = [library.stat().st_mtime for library in pathlib.Path(binary).parent.glob("src/**/*.a")]
    if not server.exists() or any(server.stat().st_mtime < library <= built for library in libraries):
        return Started(binary, **variables)
    return Server(binary, **variables)


@functools.cache
def program_of(binary):
    program = program_for_many(binary)
    atexit.register(program.end)
    return program


def run_program(binary, words, folder=None):
    """Exit code, standard output and error of the program with these words."""
    return program_of(str(binary)).ask(words, folder)


def must_run(binary, words, folder=None):
    """Standard output of the program with these words; ends the test if it fails."""
    code, output, errors = run_program(binary, words, folder)
    if code != 0:
        sys.exit("error: %s ended with code %d\n%s%s" % (" ".join(map(str, words)), code, output[-2000:], errors[-2000:]))
    return output


def run_hybrid(binary, scene, directory, overrides=(), program=None):
    """Exit code, standard output and error, and the command of a run of one thread that replaces a directory, and of no further ones
    for its errors.

    overrides: "Section/Name=value". program: Server or Started that makes the run.
    """
    shutil.rmtree(directory, ignore_errors=True)
    command = [str(binary), str(scene), "-s", "Output/Directory=%s" % directory, "-s", "Time/Error estimate=one run",
               "-s", "Mesh/Error estimate=one run"]
    for override in overrides:
        command += ["-s", override]
    return (*(program or program_of(str(binary))).ask(command[1:]), " ".join(command))


def require(fulfilled, sentence, output):
    """Print what is asked; end the test with it and the end of @p output if it is not met."""
    print(("ok    " if fulfilled else "FAIL  ") + sentence)
    if not fulfilled:
        sys.exit("error: not met: %s\n%s" % (sentence, output[-1500:]))
