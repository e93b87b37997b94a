#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Warnings of hybrid --check name a value that would do: with that value the warning is gone.

    warnings_test.py HYBRID SOURCE
"""
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from run_hybrid import run_program  # noqa: E402 (needs the path above)

COLUMN = "parameters/verification/coupled_column.prm"
SOFT_LAYER = "parameters/verification/soft_layer.prm"
TRIANGLES = "parameters/verification/bedrock_triangles.prm"
FALL = "parameters/hard/penalty.prm"
HALVES = "Mesh/Numbers=Width = 10; Height = 20; Block height = 10; Resolution/h = {:.9g}"
LAYERS = "Mesh/Numbers=Width = 40; Height = 500; Layer height = 400; Resolution/h = {:.9g}"
STRIP = "Mesh/Numbers=Width = 12; Height = 240; Resolution/h = {:.9g}"

# scene, setting with its value, a value that is too large or small, the warning with the values that would do
CASES = [
    (COLUMN, "Time/Time step={:.9g}", 0.02, r"the time step \S+ s has fewer than 20 points per period of \S+ Hz; (\S+) s would do"),
    (COLUMN, HALVES, 10, r"the continuum resolves \S+ Hz .* energy up to \S+ Hz; cells of at most (\S+) m would do"),
    (COLUMN, HALVES, 10, r"the sliding mass resolves \S+ Hz .* energy up to \S+ Hz; blocks of at most (\S+) m would do"),
    (SOFT_LAYER, LAYERS, 400, r"the continuum resolves \S+ Hz .*; cells of at most (\S+) m would do"),
    (TRIANGLES, STRIP, 40, r"the bedrock resolves \S+ Hz .*; blocks of at most (\S+) m would do"),
    (FALL, "Blocks/Penalty ratio={:.9g}", 1.04, r"the penalty ratio 1.04 makes .* so soft .*; (\S+) to (\S+) would do"),
    (FALL, "Blocks/Penalty ratio={:.9g}", 40000, r"the penalty ratio 40000 makes .* so stiff .*; (\S+) to (\S+) would do"),
]


def warnings(hybrid, scene, setting):
    code, output, errors = run_program(hybrid, ["--check", "-s", setting, scene])
    if code != 0:
        raise RuntimeError(f"{scene} with {setting}: {errors}")
    return [line for line in output.splitlines() + errors.splitlines() if line.startswith("warning: ")]


def main():
    hybrid, source = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    failures = 0
    for scene, setting, bad, pattern in CASES:
        lines = warnings(hybrid, source / scene, setting.format(bad))
        found = [match for line in lines if (match := re.search(pattern, line))]
        if len(found) != 1:
            print(f"FAILED {scene}, {setting.format(bad)}: '{pattern}' is not in {lines}")
            failures += 1
            continue
        print(found[0].string)
        subject = found[0][0][:15]
        for value in found[0].groups():
            left = [line for line in warnings(hybrid, source / scene, setting.format(float(value))) if subject in line]
            if left:
                print(f"FAILED {scene}, {setting.format(float(value))}: still {left}")
                failures += 1
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
