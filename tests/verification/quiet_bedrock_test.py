#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A bedrock of blocks that the wave has not reached yet costs one update per step, and no block of it is settled by itself.

    quiet_bedrock_test.py HYBRID ROOT WORK_DIR   exit code 1 and a sentence if a requirement is not met
"""

import json
import pathlib
import sys


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    binary, root, work = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    sys.path.insert(0, str(root / "tests"))
    from run_hybrid import require, run_hybrid

    code, output, _, _ = run_hybrid(binary, root / "parameters/benchmarks/triangles_8.prm", work / "quiet", ["Time/End time=0.02"])
    require(code == 0, "exit code 0", output)
    summary = json.loads((work / "quiet/summary.json").read_text())
    require(summary["iterations"] == summary["steps"] == 20, "%d steps of one update" % summary["steps"], output)
    require(summary["few_body_iterations"] == 0, "%d updates of few bodies" % summary["few_body_iterations"], output)


if __name__ == "__main__":
    main()
