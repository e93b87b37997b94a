#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A run whose energy audit does not close says so and stops with a checkpoint; resumed with a larger limit it ends as if never stopped.

    energy_limit_test.py HYBRID ROOT WORK_DIR   exit code 1 and a sentence if a requirement is not met

The limits are so low that the round-off of a sound scene passes them.
"""

import json
import os
import pathlib
import subprocess
import sys

import h5py
import numpy as np


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    binary, root, work = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    sys.path.insert(0, str(root / "tests"))
    from run_hybrid import require, run_hybrid

    scene, never = root / "parameters/verification/coupled_column.prm", "Output/Energy limit=0"
    code, output, _, _ = run_hybrid(binary, scene, work / "whole", [never, "Output/Energy warning=1e-9"])
    require(code == 0 and output.count("the energy audit does not close at t =") == 1, "one warning and no stop without a limit", output)
    code, output, _, _ = run_hybrid(binary, scene, work / "stopped", ["Output/Energy warning=0", "Output/Energy limit=1e-9"])
    require(code == 1 and "because the energy audit does not close" in output, "stopped with code 1", output)
    require(not json.loads((work / "stopped/summary.json").read_text())["finished"], "not finished in summary.json", output)
    resumed = subprocess.run([binary, "--resume", str(work / "stopped"), "-s", never], capture_output=True, text=True, check=False,
                             env=dict(os.environ, OPENBLAS_NUM_THREADS="1", OMP_NUM_THREADS="1"))
    require(resumed.returncode == 0, "resumed to its end", resumed.stdout + resumed.stderr)
    with h5py.File(work / "whole/run.h5") as whole, h5py.File(work / "stopped/run.h5") as parts:
        for name in ("time", "monitors/top/displacement"):
            require(np.array_equal(whole[name][()], parts[name][()]), "the same bits of " + name, "")


if __name__ == "__main__":
    main()
