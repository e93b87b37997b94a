#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A uniform half space without blocks: its surface moves like an outcrop, whether the scene gives the outcrop
motion or the incident wave (half of it).

Usage: motion_meaning_test.py HYBRID_BINARY SCENE.prm WORK_DIR
"""
import pathlib
import shutil
import subprocess
import sys

import h5py
import numpy


def surface_and_input(binary, scene, directory, meaning):
    """Histories of the horizontal velocity at the surface and of the recorded outcrop motion [m/s]."""
    subprocess.run([binary, scene, "-s", f"Output/Directory={directory}", "-s", f"Motion/Meaning={meaning}",
                    "-s", "Model/Blocks=none", "-s", "Monitors/Points=base: 5, 0; surface: 5, 10"],
                   check=True, stdout=subprocess.DEVNULL)
    with h5py.File(directory / "run.h5", "r") as file:
        return file["monitors/surface/velocity"][:, 0], file["input/velocity"][:, 0]


def main():
    binary, scene, work = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
    shutil.rmtree(work, ignore_errors=True)
    peaks, failed = {}, 0
    for meaning in ("outcrop", "incident"):
        surface, outcrop = surface_and_input(binary, scene, work / meaning, meaning)
        peaks[meaning] = numpy.abs(surface).max()
        ratio = peaks[meaning] / numpy.abs(outcrop).max()
        print(f"{meaning}: surface over outcrop {ratio:.4f}")
        failed += abs(ratio - 1.) > 0.02
    ratio = peaks["incident"] / peaks["outcrop"]
    print(f"incident over outcrop {ratio:.6f}")
    failed += abs(ratio - 2.) > 1e-6
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
