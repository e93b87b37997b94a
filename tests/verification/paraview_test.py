#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The three files for ParaView, read back with VTK: blocks and joints stay on the rock, as they moved and as exaggerated
by Warp By Vector, and points less displacement are the same in every picture.

Usage: paraview_test.py HYBRID_BINARY SCENE.prm WORK_DIR
"""
import pathlib
import shutil
import subprocess
import sys

import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy

SURFACE = 10.0  # level of the bedrock's surface in the scene [m]
TOLERANCE = 2e-3  # the bond of blocks and rock stretches [m]
SCALES = (1.0, 20.0)  # how many times as large the motion is drawn


def read(file, scale):
    """Points (n x 2) as ParaView draws them with Warp By Vector, and before they moved."""
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(file))
    reader.Update()
    data = reader.GetOutput().GetPointData()
    if data.SetActiveVectors("displacement [m]") < 0:
        sys.exit(f"{file.name} has no displacement")
    warp = vtk.vtkWarpVector()
    warp.SetInputConnection(reader.GetOutputPort())
    warp.SetInputArrayToProcess(0, 0, 0, vtk.vtkDataObject.FIELD_ASSOCIATION_POINTS, "displacement [m]")
    warp.SetScaleFactor(scale - 1)
    warp.Update()
    points = vtk_to_numpy(reader.GetOutput().GetPoints().GetData())
    drawn = vtk_to_numpy(warp.GetOutput().GetPoints().GetData())
    return drawn[:, :2], (points - vtk_to_numpy(data.GetVectors()))[:, :2]


def distance_to_surface(rock, initial, points):
    """Largest distance of points from the line of the rock's nodes that were at SURFACE [m]."""
    line = rock[np.abs(initial[:, 1] - SURFACE) < 1e-4]
    line = line[np.argsort(line[:, 0])]
    a, along = line[:-1], np.diff(line, axis=0)
    part = np.clip(((points[:, None] - a) * along).sum(axis=2) / (along**2).sum(axis=1), 0, 1)
    return np.linalg.norm(a + part[:, :, None] * along - points[:, None], axis=2).min(axis=1).max()


def main():
    binary, scene, work = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
    shutil.rmtree(work, ignore_errors=True)
    subprocess.run([binary, scene, "-s", f"Output/Directory={work}", "-s", "Output/Picture interval=0.1", "-s", "Motion/Peak=8",
                    "-s", "Motion/Frequency=1.5", "-s", "Time/End time=1", "-s", "Time/Error estimate=one run", "-s", "Mesh/Error estimate=one run"],
                   check=True, stdout=subprocess.DEVNULL)
    wrong, moved, first = 0, 0.0, {}
    for number in range(len(list((work / "vtu").glob("blocks_*.vtu")))):
        for scale in SCALES:
            rock, rock_before = read(work / f"vtu/continuum_{number:05d}.vtu", scale)
            moved = max(moved, np.linalg.norm(rock - rock_before, axis=1).max())
            for part in ("continuum", "blocks", "joints"):
                drawn, before = read(work / f"vtu/{part}_{number:05d}.vtu", scale)
                shift = np.abs(before - first.setdefault(part, before)).max()
                off = distance_to_surface(rock, rock_before, drawn[np.abs(before[:, 1] - SURFACE) < 1e-4])
                if shift > 1e-5 or off > scale * TOLERANCE:
                    print(f"{part}, picture {number}, drawn {scale:g} times: points on the surface are {off:.4f} m off the rock, "
                          f"initial points differ by {shift:.2g} m from the first picture")
                    wrong += 1
    print(f"largest motion drawn: {moved:.3f} m")
    return 1 if wrong or moved < 100 * TOLERANCE else 0


if __name__ == "__main__":
    sys.exit(main())
