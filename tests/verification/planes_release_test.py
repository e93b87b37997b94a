#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A wedge of rock on a plane that comes out at the toe of a slope: weaker than its dip b it slides from the start, by

    s = g t^2 / 2 (sin b - cos b tan phi)

in finite elements as in triangles, and the program says that it cannot stand, and where on the plane, wherever the section is drawn.
Stronger it stays.

    planes_release_test.py HYBRID WORK_DIR   exit code 1 and a sentence if a requirement is not met
"""

import pathlib
import re
import subprocess
import sys

import h5py
import numpy as np

DIP, HEIGHT, SLOPE, G = 30.0, 20.0, 50.0, 9.81  # deg, m, deg, m/s2
CREST = HEIGHT / np.tan(np.radians(DIP))        # where the plane ends [m]
EDGE = HEIGHT / np.tan(np.radians(SLOPE))       # of the slope [m]
WORDS = "cannot carry their load at rest"
PLACE = re.compile(WORDS + r", most of all bedding_1 near \((-?[\d.]+), (-?[\d.]+)\)")
MOVED = (100.0, 30.0)  # the section drawn elsewhere [m]

GEO = """
Point(1) = {-80, -50, 0}; Point(2) = {130, -50, 0}; Point(3) = {130, %g, 0}; Point(4) = {%.12g, %g, 0};
Point(5) = {%.12g, %g, 0}; Point(6) = {0, 0, 0}; Point(7) = {-80, 0, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 5}; Line(5) = {5, 6}; Line(6) = {6, 7}; Line(7) = {7, 1}; Line(8) = {6, 4};
Curve Loop(1) = {1, 2, 3, -8, 6, 7}; Plane Surface(1) = {1};
Curve Loop(2) = {8, 4, 5}; Plane Surface(2) = {2};
MeshSize{1, 2, 3, 7} = 20; MeshSize{4, 5, 6} = 4;
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


def compute(binary, work, directory, bedrock, friction, *more):
    """What the program said."""
    words = [str(binary), str(work / "wedge.prm"), "--force"]
    for override in more + ("Output/Directory=%s" % directory, "Output/Picture interval=0", "Model/Bedrock=" + bedrock,
                     "Bedding planes/Friction angle=%g" % friction):
        words += ["-s", override]
    done = subprocess.run(words, capture_output=True, text=True, check=True)
    return done.stdout + done.stderr


def slide(binary, work, bedrock, friction):
    """Way of the wedge down the plane [m], and what the program said."""
    directory = work / ("%s_%g" % (bedrock, friction))
    said = compute(binary, work, directory, bedrock, friction)
    with h5py.File(directory / "run.h5") as run:
        moved = run["monitors/wedge/displacement"][-1] - run["monitors/rock/displacement"][-1]
    return -moved @ [np.cos(np.radians(DIP)), np.sin(np.radians(DIP))], said


def named_places(binary, work, bedrock):
    """The place that the warning names [m], in sections drawn here and elsewhere, in the coordinates of the first."""
    found = []
    for x, y in ((0.0, 0.0), MOVED):
        moved = (work / "moved.geo").resolve()
        moved.write_text(GEO + "Translate{%g, %g, 0}{ Surface{:}; }\n" % (x, y), encoding="utf-8")
        said = compute(binary, work, work / "place", bedrock, 15.0, "Mesh/File=%s" % moved, "Time/End time=0.004",
                       "Monitors/Points=wedge: %g, %g" % (17 + x, 15 + y))
        place = PLACE.search(said)
        found.append(np.array([float(place[1]) - x, float(place[2]) - y]) if place else np.full(2, np.nan))
    return found


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
        places = named_places(binary, work, bedrock)
        print("%s: most of all near %s and, drawn elsewhere, %s" % (bedrock, *places))
        for place in places:
            on_plane = abs(place[1] - place[0] * np.tan(np.radians(DIP))) < 0.011 and -0.01 < place[0] < CREST + 0.01
            if not on_plane or np.abs(place - places[0]).max() > 0.011:
                wrong.append("%s: the program names (%.2f, %.2f) for what cannot stand" % (bedrock, *place))
    for sentence in wrong:
        print("error: " + sentence)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
