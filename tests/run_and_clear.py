#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Run a test and remove what it wrote when it passes: all tests together would leave 5 GB.

    run_and_clear.py DIRECTORY COMMAND...

The directory of a test that fails stays, and with HYBRID_KEEP_RESULTS=1 each.
"""

import os
import shutil
import subprocess
import sys


def main():
    directory, command = sys.argv[1], sys.argv[2:]
    code = subprocess.run(command, check=False).returncode
    if code == 0 and os.environ.get("HYBRID_KEEP_RESULTS") != "1":
        shutil.rmtree(directory, ignore_errors=True)
    return 128 - code if code < 0 else code


if __name__ == "__main__":
    sys.exit(main())
