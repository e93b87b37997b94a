#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws doc/verification/convergence.png from what a test on library level prints.

    convergence_figure.py BUILD_DIR
"""

import pathlib
import re
import subprocess
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plot  # noqa: E402 (needs the backend)
import numpy as np  # noqa: E402

PAGES = pathlib.Path(__file__).resolve().parents[2] / "doc/verification"
NUMBER = r"([-\d.e+]+)"


def output(build, test):
    run = subprocess.run([str(pathlib.Path(build) / "tests/verification" / test)], capture_output=True, text=True)
    if run.returncode != 0:
        sys.exit("error: %s failed\n%s" % (test, run.stdout[-2000:]))
    return run.stdout


def draw_convergence(text):
    figure = plot.figure(figsize=(8, 4.5), dpi=110, constrained_layout=True)
    for axes, pattern, label, order in zip(
        figure.subplots(1, 2),
        (r"degree (\d): errors %s %s %s" % ((NUMBER,) * 3), r"([a-z ]+): errors %s %s %s" % ((NUMBER,) * 3)),
        ("cell size (coarsest mesh = 1)", "time step (largest = 1)"),
        (lambda name: int(name) + 1, {"trapezoidal": 2, "fourth order": 4, "filtered": 2, "dissipative": 1, "shi": 1}.get),
    ):
        for name, *errors in re.findall(pattern, text):
            if name.isdigit() != ("cell" in label):
                continue
            errors, h = np.array(errors, dtype=float), np.array([1.0, 0.5, 0.25])
            (line,) = axes.loglog(h, errors, "o-", lw=1, label=("degree " if name.isdigit() else "") + name)
            axes.loglog(h, errors[2] * (h / h[2]) ** order(name), "--", color=line.get_color(), lw=0.8)
        axes.set_xlabel(label)
        axes.legend(fontsize=8)
    figure.axes[0].set_ylabel("relative error of the displacement [-]")
    figure.axes[0].set_title("in space; dashed: order p + 1")
    figure.axes[1].set_title("in time; dashed: order 2, 4, 1, 1")
    figure.savefig(PAGES / "convergence.png")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    draw_convergence(output(sys.argv[1], "continuum_convergence_test"))
