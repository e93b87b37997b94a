# SPDX-License-Identifier: GPL-3.0-or-later
"""A run of the program, as the scenes of verification/ and stability/ need it, and what is asked of it."""

import os
import shutil
import subprocess
import sys


def run_hybrid(binary, scene, directory, overrides=()):
    """Exit code, standard output and error, and the command of a run of one thread that replaces a directory, and of no further ones
    for its errors.

    overrides: "Section/Name=value".
    """
    shutil.rmtree(directory, ignore_errors=True)
    command = [str(binary), str(scene), "-s", "Output/Directory=%s" % directory, "-s", "Time/Error estimate=one run",
               "-s", "Mesh/Error estimate=one run"]
    for override in overrides:
        command += ["-s", override]
    environment = dict(os.environ, OPENBLAS_NUM_THREADS="1", OMP_NUM_THREADS="1")
    done = subprocess.run(command, capture_output=True, text=True, env=environment, check=False)
    return done.returncode, done.stdout, done.stderr, " ".join(command)


def require(fulfilled, sentence, output):
    """Print what is asked; end the test with it and the end of @p output if it is not met."""
    print(("ok    " if fulfilled else "FAIL  ") + sentence)
    if not fulfilled:
        sys.exit("error: not met: %s\n%s" % (sentence, output[-1500:]))
