# SPDX-License-Identifier: GPL-3.0-or-later
"""The program itself, asked about a scene: its parameters, the memory that it takes, its version."""

import functools
import os
import re
import subprocess

from hybrid_run import UserError
from hybrid_run.parameters import parse_parameters


def path():
    """Of the program. @raises UserError if nobody says where it is."""
    try:
        return os.environ["HYBRID_PROGRAM"]
    except KeyError:
        raise UserError("the variable HYBRID_PROGRAM does not say where the program hybrid is") from None


def ask(*words):
    """What the program prints. @raises UserError with its message."""
    done = subprocess.run([path(), *words], capture_output=True, text=True, errors="replace", check=False)
    if done.returncode != 0:
        lines = done.stderr.strip().splitlines() or ["exit code %d" % done.returncode]
        raise UserError(lines[-1].removeprefix("error: "))
    return done.stdout


# -s of runs that are compared by who starts them, and need not tell their own errors
ONE_RUN = ["Time/Error estimate=one run", "Mesh/Error estimate=one run"]


def options(overrides):
    """-s of each."""
    return [word for override in overrides for word in ("-s", override)]


def parameters_text(scene, overrides=()):
    """Every parameter of a scene, as a parameter file."""
    return ask("--print-parameters", scene, *options(overrides))


def parameters(scene, overrides=()):
    """The same by Section/Name."""
    return parse_parameters(parameters_text(scene, overrides).splitlines())


def memory(scene, overrides=()):
    """Estimate of what a run takes [MB]."""
    found = re.search(r"^Memory +about ([0-9.e+]+) MB", ask("--check", scene, *options(overrides)), re.MULTILINE)
    return float(found.group(1)) if found else 0.0


@functools.lru_cache
def version():
    """{"version": ..., "commit": ...} of the program."""
    text = ask("--version")
    commit = re.search(r"commit (\w+)", text)
    return {"version": text.splitlines()[0].strip(), "commit": commit.group(1) if commit else ""}
