#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws doc/verification/oblique_waves.png and convergence.png from what two tests on library level print.

    library_figures.py BUILD_DIR
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


def reflected(wave, angle, ratio=np.sqrt(3.0)):
    """Roots of the reflected parts of the energy (P, SV), and their sum; c_s = rho = w = 1, c_p = ratio."""
    kp, ks = 1 / ratio, 1.0
    kx = np.sin(angle) * (kp if wave == "P" else ks)
    py, sy = np.sqrt(kp**2 - kx**2 + 0j), np.sqrt(ks**2 - kx**2 + 0j)

    def residual(ky, ux, uy):
        normal = (ratio**2 - 2) * (kx * ux + ky * uy) + 2 * ky * uy
        return np.array([ky * ux + kx * uy + ux, normal + ratio * uy])

    up = np.column_stack([residual(py, kx / kp, py / kp), residual(sy, -sy / ks, kx / ks)])
    down = residual(-py, kx / kp, -py / kp) if wave == "P" else residual(-sy, sy / ks, kx / ks)
    flux = np.array([ratio**2 * py.real, sy.real])
    parts = abs(np.linalg.solve(up, -down)) ** 2 * flux / flux[0 if wave == "P" else 1]
    return np.sqrt(parts[0]), np.sqrt(parts[1]), parts.sum()


def draw_oblique(text):
    row = r"(P|SV) +(\d+) deg: P %s .*?, S %s .*?, energy %s" % (NUMBER, NUMBER, NUMBER)
    found = [(w, float(d), float(p), float(s), float(e)) for w, d, p, s, e in re.findall(row, text)]
    figure = plot.figure(figsize=(8, 4.5), dpi=110, constrained_layout=True)
    angles = np.radians(np.linspace(0, 65, 400))
    for axes, wave in zip(figure.subplots(1, 2, sharey=True), ("P", "SV")):
        exact = np.array([reflected(wave, a) for a in angles])
        mine = np.array([row[1:] for row in found if row[0] == wave])
        below = mine[:, 0] < (90 if wave == "P" else np.degrees(np.arcsin(1 / np.sqrt(3))))
        for k, name, colour in ((0, "P", "#1f5a94"), (1, "SV", "#d98b2b"), (2, "energy", "#262626")):
            shown = below if k < 2 else below | True
            axes.plot(np.degrees(angles), exact[:, k], color=colour, lw=1, label=name + ", closed form")
            axes.plot(mine[shown, 0], mine[shown, 1 + k], "o", color=colour, ms=5, label=name + ", program")
        axes.set_title("incident %s wave" % wave)
        axes.set_xlabel("angle from the normal [degrees]")
    figure.axes[0].set_ylabel("reflected: root of the energy's part; energy [-]")
    figure.axes[0].legend(fontsize=8)
    figure.savefig(PAGES / "oblique_waves.png")


def draw_convergence(text):
    figure = plot.figure(figsize=(8, 4.5), dpi=110, constrained_layout=True)
    for axes, pattern, label, order in zip(
        figure.subplots(1, 2),
        (r"degree (\d): errors %s %s %s" % ((NUMBER,) * 3), r"([a-z ]+): errors %s %s %s" % ((NUMBER,) * 3)),
        ("cell size (coarsest mesh = 1)", "time step (largest = 1)"),
        (lambda name: int(name) + 1, {"trapezoidal": 2, "fourth order": 4, "dissipative": 1, "shi": 1}.get),
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
    draw_oblique(output(sys.argv[1], "continuum_oblique_test"))
    draw_convergence(output(sys.argv[1], "continuum_convergence_test"))
