# SPDX-License-Identifier: GPL-3.0-or-later
"""A tool in a copy of this process: as the program calls it, but nothing is imported anew."""
import importlib
import io
import os
import pathlib
import pkgutil
import signal
import subprocess
import sys
import tempfile
import traceback

import tool

NAMES = {path.parent.name for path in pathlib.Path(tool.__file__).parent.glob("hybrid_tools/*/command.py")}


def import_all(name):
    """Every module of a tool, those that it imports late too."""
    package = importlib.import_module("hybrid_tools." + name)
    for module in pkgutil.iter_modules(package.__path__, package.__name__ + "."):
        importlib.import_module(module.name)


def exit_code(name, words):
    """As of a process of its own."""
    try:
        return tool.main(name, words)
    except SystemExit as end:
        if end.code is None or isinstance(end.code, int):
            return end.code or 0
        print(end.code, file=sys.stderr)
    except BaseException:  # pylint: disable=broad-exception-caught (the child must not go on as a second pytest)
        traceback.print_exc()
    return 1


def become_tool(name, words, files, limit, cwd):
    """The child: never returns."""
    code = 1
    try:
        signal.alarm(limit)
        for number, file in enumerate(files, 1):
            os.dup2(file.fileno(), number)
        sys.stdout, sys.stderr = (io.TextIOWrapper(open(number, "wb", closefd=False), encoding="utf-8", line_buffering=number == 2)
                                  for number in (1, 2))
        os.chdir(cwd or os.getcwd())
        code = exit_code(name, words)
        sys.stdout.flush()
        sys.stderr.flush()
    finally:
        os._exit(code)


def run(name, words, limit, cwd=None):
    """The tool with these words, for limit [s] at most; its exit code and output as of subprocess.run."""
    import_all(name)
    with tempfile.TemporaryFile() as output, tempfile.TemporaryFile() as errors:
        child = os.fork()
        if child == 0:
            become_tool(name, words, (output, errors), limit, cwd)
        code = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
        said = []
        for file in (output, errors):
            file.seek(0)
            said.append(file.read().decode())
    return subprocess.CompletedProcess([name, *words], code, *said)
