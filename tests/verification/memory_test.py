#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The memory that --check announces is that of the run, within a factor of 1.5; of a bonded mass within 15 %.

Usage: memory_test.py HYBRID_BINARY WORK_DIR [--long]     --long: larger models
"""
import json
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
FACTOR, BONDED = 1.5, 1.15
BADONG = ROOT / "parameters/majiagou/badong_long_periods.prm"
SURFACE = ROOT / "parameters/benchmarks/coupled_long.prm"
ONE_RUN = ["Time/Error estimate=one run", "Mesh/Error estimate=one run"]  # further ones have memory of their own

# What dominates: blocks and condensed bedrock; slip of bedding planes; a surface of which a band is kept; blocks alone; histories.
SCENES = {
    "badong": (BADONG, ["Time/End time=0.02"]),
    "slipping planes": (BADONG, ["Mesh/Numbers=Resolution/h = 8", "Time/End time=0.02",
                                 "Bedding planes/Strength=Mohr-Coulomb", "Bedding planes/Friction angle=30"]),
    "triangles": (BADONG, ["Mesh/Numbers=Resolution/h = 6", "Time/End time=0.012", "Model/Bedrock=triangles"]),
    "long surface": (SURFACE, ["Mesh/Numbers=Width = 1000; Height = 22; Block height = 2; Resolution/h = 1", "Time/End time=0.003",
                               "Continuum/Surface stiffness=banded"]),
    "loose": (ROOT / "parameters/benchmarks/rest_2000.prm", []),
    "bonded 5000": (ROOT / "parameters/benchmarks/bonded_5000.prm", ["Checkpoint/Wall interval=0"]),
    "long run": (ROOT / "parameters/verification/coupled_column.prm",
                 ["Model/Blocks=none", "Monitors/Points=base: 5, 0; " + "; ".join(f"p{k}: 5, {0.1 * k}" for k in range(99)),
                  "Time/Time step=0.0001", "Time/End time=1.2"]),
}
# A surface where a band is what the program takes by itself; a larger mass.
LARGE = {
    "longer surface": (SURFACE, ["Mesh/Numbers=Width = 2000; Height = 22; Block height = 2; Resolution/h = 1", "Time/End time=0.003"]),
    "bonded 20000": (ROOT / "parameters/benchmarks/bonded_20000.prm", ["Checkpoint/Wall interval=0"]),
}


def main():
    binary, work = sys.argv[1], pathlib.Path(sys.argv[2])
    shutil.rmtree(work, ignore_errors=True)
    failed = 0
    for name, (scene, settings) in (LARGE if "--long" in sys.argv else SCENES).items():
        directory = work / name.replace(" ", "_")
        options = [word for setting in [*settings, *ONE_RUN] for word in ("-s", setting)]
        card = subprocess.run([binary, "--check", scene, *options], check=True, capture_output=True, text=True).stdout
        estimate = float(re.search(r"Memory +about (\d+) MB", card).group(1))
        subprocess.run([binary, scene, *options, "-s", f"Output/Directory={directory}"], check=True,
                       stdout=subprocess.DEVNULL)
        measured = json.loads((directory / "summary.json").read_text(encoding="utf-8"))["peak_memory_mb"]
        factor = BONDED if name.startswith("bonded") else FACTOR
        good = measured / factor <= estimate <= measured * factor
        failed += not good
        print(f"{'ok' if good else 'FAIL'}  {name}: announced {estimate:.0f} MB, measured {measured:.0f} MB, "
              f"{estimate / measured:.2f}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
