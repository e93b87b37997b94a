#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The Badong scene and its mirror image: a slope that falls to the right has the numbers and pictures of one that falls to
the left.

Coarse (h = 8), 0.6 s of a motion of 2 s. gmsh meshes a mirrored geometry differently, so the mesh itself is
mirrored. Both runs solve the same equations in another order, to a residual of 1e-8 of all forces (Blocks/Tolerance):
numbers have to agree within 5e-5 of the largest one of their kind (found: 4e-7, at the toe, where the belt slips), a
tenth of a picture's line.

Usage: mirror_test.py HYBRID_BINARY SOURCE_DIR WORK_DIR
"""
import json
import pathlib
import shutil
import subprocess
import sys

import h5py
import matplotlib.image
import numpy

TOLERANCE = 5e-5
FIGURES = ("boreholes", "energy")
BOREHOLES = "ZK1: %g, 177, %g, 147; ZK2: %g, 190, %g, 164"
NODES_OF = {1: 2, 2: 3, 3: 4, 15: 1}  # of gmsh's types of elements


def mesh_section(binary, source, work):
    """The mesh of the section as gmsh makes it, in ASCII."""
    (work / "save.geo").write_text('h = 8;\nInclude "%s";\nMesh.MshFileVersion = 2.2;\nMesh 2;\nSave "%s";\n'
                                   % (source / "meshes/majiagou.geo", work / "left.msh"))
    subprocess.run([binary, "--check", source / "parameters/majiagou/badong_long_periods.prm", "-s", f"Mesh/File={work / 'save.geo'}",
                    "-s", "Mesh/Numbers="], check=True, stdout=subprocess.DEVNULL)


def mirror_mesh(source, target):
    """x -> -x, the sides interchanged, and the nodes of each element in the other direction."""
    section, out = "", []
    for line in source.read_text().splitlines():
        fields = line.split()
        if line.startswith("$"):
            section = line
        elif section == "$PhysicalNames":
            line = line.replace('"left"', '"_"').replace('"right"', '"left"').replace('"_"', '"right"')
        elif section == "$Nodes" and len(fields) == 4:
            line = "%s %r %s %s" % (fields[0], -float(fields[1]), fields[2], fields[3])
        elif section == "$Elements" and len(fields) > 1:
            count = NODES_OF[int(fields[1])]
            line = " ".join(fields[:-count] + fields[: -count - 1 : -1])
        out.append(line)
    target.write_text("\n".join(out) + "\n")


def mirror_points(source, target):
    """A CSV file of points: the header, then name, x, y."""
    rows = [line.split(",") for line in source.read_text().splitlines() if not line.startswith("#")]
    mirrored = rows[:1] + [[row[0], repr(-float(row[1]))] + row[2:] for row in rows[1:]]
    target.write_text("\n".join(",".join(row) for row in mirrored) + "\n")


def run(binary, source, work, side):
    directory, factor = work / side, -1 if side == "right" else 1
    mirror_points(source / "meshes/majiagou_section.csv", work / "right.csv")
    points = work / "right.csv" if side == "right" else source / "meshes/majiagou_section.csv"
    subprocess.run([binary, source / "parameters/majiagou/badong_long_periods.prm", "-s", f"Mesh/File={work / (side + '.msh')}",
                    "-s", "Mesh/Numbers=", "-s", f"Motion/Angle={180 if side == 'right' else 0}", "-s", "Motion/Duration=2",
                    "-s", f"Monitors/File={points}",
                    "-s", "Boreholes/Lines=" + BOREHOLES % (factor * 288, factor * 288, factor * 334, factor * 334),
                    "-s", "Time/End time=0.6", "-s", "Time/Time step=0.002", "-s", "Output/Picture interval=0.5",
                    "-s", "Time/Error estimate=one run", "-s", "Mesh/Error estimate=one run",
                    "-s", f"Output/Directory={directory}"], check=True, stdout=subprocess.DEVNULL)
    subprocess.run([binary, "plot", "--figures", ",".join(FIGURES), directory], check=True, stdout=subprocess.DEVNULL)
    with open(directory / "summary.json", encoding="utf-8") as text:
        return h5py.File(directory / "run.h5", "r"), json.load(text)


class Comparison:
    def __init__(self):
        self.failed = 0

    def equal(self, name, found, expected):
        found, expected = numpy.asarray(found), numpy.asarray(expected)
        error = numpy.abs(found - expected).max() / max(numpy.abs(expected).max(), 1e-300) if found.shape == expected.shape else numpy.inf
        wrong = not error <= TOLERANCE
        self.failed += wrong
        print("%-40s largest difference %.1e%s" % (name, error, "  WRONG" if wrong else ""))

    def pictures(self, name, one, other):
        images = [matplotlib.image.imread(directory / "figures" / (name + ".png")) for directory in (one, other)]
        if name == "energy":  # not the residual below it: that is round-off, on a logarithmic axis
            images = [image[:int(0.7 * len(image))] for image in images]
        same = images[0].shape == images[1].shape and numpy.abs(images[0] - images[1]).mean() < 1e-4
        self.failed += not same
        print("%-40s %s" % ("picture " + name, "the same" if same else "WRONG"))


def main():
    binary, source, work = sys.argv[1], pathlib.Path(sys.argv[2]).resolve(), pathlib.Path(sys.argv[3]).resolve()
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    mesh_section(binary, source, work)
    mirror_mesh(work / "left.msh", work / "right.msh")
    (left, left_summary), (right, right_summary) = (run(binary, source, work, side) for side in ("left", "right"))
    check, flip = Comparison(), numpy.array([-1.0, 1.0])
    check.equal("downhill sign", right.attrs.get("downhill_sign", -1.0), [1.0])
    check.equal("downhill sign", left.attrs.get("downhill_sign", -1.0), [-1.0])
    check.equal("time", right["time"], left["time"])
    for name in left["monitors"]:
        for quantity in ("displacement", "velocity"):
            path = f"monitors/{name}/{quantity}"
            check.equal(path, right[path][:] * flip, left[path][:])
    for name in left["profiles"]:
        path = f"profiles/{name}/displacement"
        check.equal(path, right[path][:] * numpy.tile(flip, left[path].shape[1] // 2), left[path][:])
    for name in ("mean", "largest"):
        check.equal("slip/" + name, right["slip/" + name], left["slip/" + name])
    orders = [numpy.argsort(sign * file["slip/position"][:, 0]) for file, sign in ((left, 1), (right, -1))]
    check.equal("slip/profile", right["slip/profile"][:][:, orders[1]], left["slip/profile"][:][:, orders[0]])
    for name in ("mean", "largest", "mean_left", "largest_left"):
        check.equal("summary: slip, " + name, right_summary["slip_m"][name], left_summary["slip_m"][name])
    for kind in ("tensile", "shear"):
        check.equal("summary: failed, " + kind, right_summary["joints"]["static"][kind], left_summary["joints"]["static"][kind])
    for name in FIGURES:
        check.pictures(name, work / "left", work / "right")
    return 1 if check.failed else 0


if __name__ == "__main__":
    sys.exit(main())
