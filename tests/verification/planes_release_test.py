#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A wedge of rock on a plane that comes out at the toe of a slope: weaker than its dip b it slides from the start, by

    s = g t^2 / 2 (sin b - cos b tan phi)

in finite elements as in triangles, and the program says that it cannot stand. Stronger it stays.

    planes_release_test.py HYBRID WORK_DIR   exit code 1 and a sentence if a requirement is not met
"""

import pathlib
import subprocess
import sys

import h5py
import numpy as np

DIP, HEIGHT, SLOPE, G = 30.0, 20.0, 50.0, 9.81  # deg, m, deg, m/s2
CREST = HEIGHT / np.tan(np.radians(DIP))        # where the plane ends [m]
EDGE = HEIGHT / np.tan(np.radians(SLOPE))       # of the slope [m]
WORDS = "cannot carry their load at rest"

GEO = """
Point(1) = {-80, -50, 0}; Point(2) = {130, -50, 0}; Point(3) = {130, %g, 0}; Point(4) = {%.12g, %g, 0};
Point(5) = {%.12g, %g, 0}; Point(6) = {0, 0, 0}; Point(7) = {-80, 0, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 5}; Line(5) = {5, 6}; Line(6) = {6, 7}; Line(7) = {7, 1}; Line(8) = {6, 4};
Curve Loop(1) = {1, 2, 3, -8, 6, 7}; Plane Surface(1) = {1};
Curve Loop(2) = {8, 4, 5}; Plane Surface(2) = {2};
MeshSize{1, 2, 3, 7} = 10; MeshSize{4, 5, 6} = 3;
Mesh.RecombinationAlgorithm = 3;
Recombine Surface{1, 2};
Physical Surface("bedrock") = {1, 2};
Physical Curve("base") = {1};
Physical Curve("left") = {7};
Physical Curve("right") = {2};
Physical Curve("ground") = {3, 4, 5, 6};
Physical Curve("bedding_1") = {8};
""" % (HEIGHT, CREST, HEIGHT, EDGE, HEIGHT)

PRM = """
subsection Time
  set End time = 1
  set Time step = 0.004
  set Error estimate = one run
end
subsection Mesh
  set File = wedge.geo
  set Error estimate = one run
end
subsection Model
  set Blocks = none
end
subsection Materials
  set Names = rock
  subsection rock
    set Density = 2500
    set Young modulus = 10e9
    set Poisson ratio = 0.25
  end
end
subsection Continuum
  set Materials = rock
end
subsection Bedding planes
  set Names = bedding_1
  set Strength = Mohr-Coulomb
end
subsection Monitors
  set Points = wedge: 17, 15; rock: 60, 19
end
"""


def slide(binary, work, bedrock, friction):
    """Way of the wedge down the plane [m], and what the program said."""
    directory = work / ("%s_%g" % (bedrock, friction))
    words = [str(binary), str(work / "wedge.prm"), "--force"]
    for override in ("Output/Directory=%s" % directory, "Output/Picture interval=0", "Model/Bedrock=" + bedrock,
                     "Bedding planes/Friction angle=%g" % friction):
        words += ["-s", override]
    done = subprocess.run(words, capture_output=True, text=True, check=True)
    with h5py.File(directory / "run.h5") as run:
        moved = run["monitors/wedge/displacement"][-1] - run["monitors/rock/displacement"][-1]
    return -moved @ [np.cos(np.radians(DIP)), np.sin(np.radians(DIP))], done.stdout + done.stderr


def main():
    binary, work = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    work.mkdir(parents=True, exist_ok=True)
    (work / "wedge.geo").write_text(GEO, encoding="utf-8")
    (work / "wedge.prm").write_text(PRM, encoding="utf-8")
    wrong = []
    for bedrock in ("continuum", "triangles"):
        for friction in (15.0, 25.0, 35.0):
            found, said = slide(binary, work, bedrock, friction)
            b = np.radians(DIP)
            expected = max(0.0, G / 2 * (np.sin(b) - np.cos(b) * np.tan(np.radians(friction))))
            print("%s, friction %g deg: %.4f m, closed form %.4f m" % (bedrock, friction, found, expected))
            # what the rock springs back as it is let go is left: below 2 cm
            if abs(found - expected) > (0.02 if expected > 0 else 1e-6):
                wrong.append("%s, friction %g: the wedge slid %.4g m, not %.4g m" % (bedrock, friction, found, expected))
            if (WORDS in said) != (expected > 0):
                wrong.append("%s, friction %g: the program does not say whether the wedge can stand" % (bedrock, friction))
    for sentence in wrong:
        print("error: " + sentence)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
