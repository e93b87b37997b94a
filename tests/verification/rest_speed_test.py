#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A run with Time/Rest speed ends when its mass has come to rest, not before the motion has ended, and is finished.

    rest_speed_test.py HYBRID ROOT WORK_DIR   exit code 1 and a sentence if a requirement is not met
"""

import json
import pathlib
import sys

import h5py
import numpy as np


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    binary, root, work = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    sys.path.insert(0, str(root / "tests"))
    from run_hybrid import require, run_hybrid

    scene = root / "parameters/verification/shaken_base.prm"
    rest = ["Motion/Duration=3", "Time/Rest speed=1e-3"]
    code, output, _, _ = run_hybrid(binary, scene, work / "whole", ["Time/End time=8"] + rest)
    summary = json.loads((work / "whole/summary.json").read_text())
    end = summary["simulated_time_s"]
    require(code == 0 and summary["finished"], "finished, exit code 0", output)
    require("At rest" in output, "says that it is at rest", output)
    with h5py.File(work / "whole/run.h5") as run:
        time, shaking = run["time"][()], np.abs(run["input/acceleration"][()]).max(axis=1)
        last = time[np.nonzero(shaking)[0][-1]]
    require(last + 1 <= end < 8, "ends at %g s, a second or more after the shaking (%g s)" % (end, last), output)
    pushed = ["Motion/Type=none", "Time/End time=8", "Time/Rest speed=1e-3", "Edge loads/Start=2", "Edge loads/Rise time=1",
              "Edge loads/Tractions=push: -5, 5, -5, 5, 1, -1"]
    code, output, _, _ = run_hybrid(binary, scene, work / "pushed", pushed)
    end = json.loads((work / "pushed/summary.json").read_text())["simulated_time_s"]
    require(code == 0 and 4 <= end < 8, "a block at rest waits for the load that rises until 3 s: ends at %g s" % end, output)
    code, output, _, _ = run_hybrid(binary, scene, work / "cut", ["Time/End time=%g" % (0.5 * last)] + rest)
    require(code == 0 and "At rest" not in output, "a shorter run ends at its end", output)


if __name__ == "__main__":
    main()
