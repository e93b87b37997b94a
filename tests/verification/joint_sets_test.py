#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Joints of the mass with a material of their own (Blocks/Joint materials).

- A slab of triangles slides on a joint of 10 degrees of friction that dips 20 degrees, over two and more edges of the rock below, whose friction
  is 45 degrees. It follows s = g (sin - cos tan) t^2 / 2, whatever the blocks' size, as do two polygons, bonded or loose. Where the joint has no
  material of its own it stands.
- With cohesion on a part of the joint (rock bridges: Jennings 1970) it stands or slides as the sum of both strengths says. A bonded mass of polygons
  that names its joint in the fifth column does the same.

    joint_sets_test.py HYBRID ROOT WORK_DIR   exit code 1 and a sentence if a requirement is not met
"""

import json
import pathlib
import sys

import h5py
import numpy as np

DIP, PHI = np.radians(20.0), np.radians(10.0)
GRAVITY, DENSITY = 9.81, 2500.0
LENGTH, HEIGHT = 6.0, 2.0  # of the slab along the joint and across it [m]
END = 0.8                  # [s]

# Along the joint from its upper end: the slab lies from 1.5 to 1.5 + LENGTH, its rear half on joint_rear, the other on joint_front.
GEO = """
h = DefineNumber[ 0.5, Name "Resolution/Blocks" ];
c = Cos(20 * Pi / 180); s = Sin(20 * Pi / 180);
x[] = {0, 1.5, 4.5, 7.5, 11};
For k In {0:4}
  Point(1 + k) = {x[k] * c, 6 - x[k] * s, 0, h};
EndFor
Point(6) = {0, 0, 0, 2 * h}; Point(7) = {11 * c, 0, 0, 2 * h};
Point(8) = {1.5 * c + 2 * s, 6 - 1.5 * s + 2 * c, 0, h}; Point(9) = {7.5 * c + 2 * s, 6 - 7.5 * s + 2 * c, 0, h};
For k In {1:4}
  Line(k) = {k, k + 1};
EndFor
Line(5) = {5, 7}; Line(6) = {7, 6}; Line(7) = {6, 1}; Line(8) = {4, 9}; Line(9) = {9, 8}; Line(10) = {8, 2};
Curve Loop(1) = {-7, -6, -5, -4, -3, -2, -1}; Plane Surface(1) = {1};
Curve Loop(2) = {2, 3, 8, 9, 10}; Plane Surface(2) = {2};
Physical Surface("sliding_mass") = {1, 2};
Physical Curve("sliding_surface") = {6};
Physical Curve("joint_rear") = {1, 2};
Physical Curve("joint_front") = {3, 4};
"""

PRM = """
subsection Time
  set End time = %(end)g
  set Time step = 0.001
end
subsection Mesh
  set File = slab.geo
end
subsection Model
  set Bedrock = rigid
end
subsection Materials
  set Names = rock, weak, bridge
  subsection rock
    set Density = %(density)g
    set Young modulus = 5e9
    set Friction angle = 45
    set Cohesion = 1e7
    set Tensile strength = 1e7
  end
  subsection weak
    set Density = %(density)g
    set Young modulus = 5e9
    set Friction angle = 10
  end
  subsection bridge
    set Density = %(density)g
    set Young modulus = 5e9
    set Friction angle = 10
    set Tensile strength = 1e6
  end
end
subsection Blocks
  set Material = rock
  set Belt material = rock
  set Damping ratio = 0.02
end
subsection Gravity
  set Acceleration = %(gravity)g
  set Static stage = held
end
subsection Monitors
  set Points = slab: 5, 5.5
end
subsection Output
  set Picture interval = 0
end
""" % {"density": DENSITY, "gravity": GRAVITY, "end": END}


def write_scene(work):
    work.mkdir(parents=True, exist_ok=True)
    (work / "slab.geo").write_text(GEO)
    scene = work / "slab.prm"
    scene.write_text(PRM)
    return scene


def write_polygons(path):
    """The slab and a wedge below it as two blocks; the lower one names the joint."""
    along, across = np.array([np.cos(DIP), -np.sin(DIP)]), np.array([np.sin(DIP), np.cos(DIP)])
    top = np.array([0.0, 6.0])
    rear, front, toe = top + 1.5 * along, top + (1.5 + LENGTH) * along, top + 11 * along
    wedge = [(np.zeros(2), ""), (np.array([toe[0], 0.0]), ""), (toe, "joint_front"), (front, "joint_front"), (rear, "joint_front"), (top, "")]
    slab = [(rear, ""), (front, ""), (front + HEIGHT * across, ""), (rear + HEIGHT * across, "")]
    rows = ["%s,%.12g,%.12g,,%s" % (name, p[0], p[1], joint) for name, outline in (("wedge", wedge), ("slab", slab)) for p, joint in outline]
    path.write_text("block,x,y,region,joint\n" + "\n".join(rows) + "\n")
    path.with_name("ground.csv").write_text("-5,0\n20,0\n")


def slip(directory):
    with h5py.File(directory / "run.h5") as run:
        return np.linalg.norm(run["monitors/slab/displacement"][-1])


def slip_told(directory):
    """The largest of the joint lines; where the line dips to the right its upper side goes along +x."""
    lines = json.loads((directory / "summary.json").read_text())["joint_line_slip_m"].values()
    return max((line["largest_left"] for line in lines), key=abs)


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    binary, root, work = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3]).resolve()
    sys.path.insert(0, str(root / "tests"))
    from run_hybrid import require, run_hybrid

    scene = write_scene(work / "scene")
    free = 0.5 * GRAVITY * (np.sin(DIP) - np.cos(DIP) * np.tan(PHI)) * END**2
    write_polygons(work / "scene" / "blocks.csv")
    of_polygons = ["Mesh/File=", "Mesh/Polygons file=%s" % (work / "scene" / "blocks.csv"), "Mesh/Surface file=%s" % (work / "scene" / "ground.csv")]
    for name, settings, expected in (("bonded", ["Blocks/Joint materials=weak"], free),
                                     ("polygons", ["Blocks/Joint materials=joint_front: weak"] + of_polygons, free),
                                     ("loose polygons", ["Blocks/Joint materials=weak", "Model/Blocks=loose"] + of_polygons, free),
                                     ("small blocks", ["Blocks/Joint materials=weak", "Mesh/Numbers=Resolution/Blocks = 0.25"], free),
                                     ("welded", [], 0.0)):
        code, output, errors, _ = run_hybrid(binary, scene, work / name, settings)
        require(code == 0, name + " runs", output + errors)
        found = slip(work / name)
        require(abs(found - expected) < 0.01 * free, "%s: slides %.5g m, closed form %.5g m" % (name, found, expected), output)
        told = slip_told(work / name)
        require(abs(told - expected) < 0.01 * free, "%s: the joint's slip is told as %.5g m" % (name, told), output)
        require(("joint_front  has slipped by" in output) == (expected > 0), "%s: the line is named if it has slipped" % name, output)

    # Cohesion that holds the slab where the front half of its sole has it.
    needed = DENSITY * GRAVITY * HEIGHT * LENGTH * (np.sin(DIP) - np.cos(DIP) * np.tan(PHI)) / (LENGTH / 2)
    for factor, stands in ((1.05, True), (0.95, False)):
        bridge = ["Blocks/Joint materials=joint_rear: weak; joint_front: bridge", "Gravity/Static stage=equilibrium or move",
                  "Materials/bridge/Cohesion=%g" % (factor * needed)]
        code, output, errors, _ = run_hybrid(binary, scene, work / "bridge", bridge)
        require(code == 0, "a bridge with %g of the cohesion needed runs" % factor, output + errors)
        require((slip(work / "bridge") < 0.01 * free) == stands, "%s: %g m" % ("it holds" if stands else "it breaks", slip(work / "bridge")), output)


if __name__ == "__main__":
    main()
