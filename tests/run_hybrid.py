# SPDX-License-Identifier: GPL-3.0-or-later
"""A run of the program, as the scenes of verification/ and stability/ need it."""

import os
import shutil
import subprocess


def run_hybrid(binary, scene, directory, overrides=()):
    """Exit code, standard output and error, and the command of a run of one thread that replaces a directory.

    overrides: "Section/Name=value".
    """
    shutil.rmtree(directory, ignore_errors=True)
    command = [str(binary), str(scene), "-s", "Output/Directory=%s" % directory]
    for override in overrides:
        command += ["-s", override]
    environment = dict(os.environ, OPENBLAS_NUM_THREADS="1", OMP_NUM_THREADS="1")
    done = subprocess.run(command, capture_output=True, text=True, env=environment, check=False)
    return done.returncode, done.stdout, done.stderr, " ".join(command)
