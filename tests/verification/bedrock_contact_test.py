#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Contact with the bedrock does not depend on what the bedrock is made of, on who bonds the mass, or on whose edges are finer.

slab  A slab on a slope, with friction that lets it slide, on every bedrock: made of loose blocks that share the nodes of the
      surface, of blocks that are bonded but not to the bedrock (no `Belt material`), and as one block over cells much larger and much
      smaller than itself. Every one rests where it was drawn before it is let go, and slides like Newmark's block, g (sin - cos tan phi) t^2 / 2.
patch A block on a confined rod of finite elements as wide as itself: one dimension. Whatever the number of cells below the
      block and their degree the surface stays straight, and every run is that with one cell.

Usage: bedrock_contact_test.py HYBRID_BINARY WORK_DIR
"""
import json
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from run_hybrid import run_hybrid  # noqa: E402

SLOPE, FRICTION, END = 20.0, 15.0, 0.3  # deg, deg, s

SLAB = """
c = Cos(20 * Pi / 180); s = Sin(20 * Pi / 180);
x[] = {-12, 0, 12, 24};
DefineConstant[cells = {6, Min 1, Max 100, Name "Cells"}];
For i In {0:3}
  t[i] = newp; Point(t[i]) = {c * x[i], s * x[i], 0};
  b[i] = newp; Point(b[i]) = {c * x[i], s * x[i] - 8, 0};
EndFor
For i In {0:2}
  tl[i] = newl; Line(tl[i]) = {t[i], t[i + 1]}; Transfinite Curve {tl[i]} = cells + 1;
  bl[i] = newl; Line(bl[i]) = {b[i], b[i + 1]}; Transfinite Curve {bl[i]} = cells + 1;
EndFor
For i In {0:3}
  v[i] = newl; Line(v[i]) = {b[i], t[i]}; Transfinite Curve {v[i]} = 4;
EndFor
For i In {0:2}
  l = newll; Curve Loop(l) = {bl[i], v[i + 1], -tl[i], -v[i]};
  f = news; Plane Surface(f) = {l}; Transfinite Surface {f}; Recombine Surface {f};
  rock[] += f;
EndFor
m[0] = newp; Point(m[0]) = {c * 12 - s * 2, s * 12 + c * 2, 0};
m[1] = newp; Point(m[1]) = {-s * 2, c * 2, 0};
q[0] = newl; Line(q[0]) = {t[2], m[0]};
q[1] = newl; Line(q[1]) = {m[0], m[1]}; Transfinite Curve {q[1]} = cells + 1;
q[2] = newl; Line(q[2]) = {m[1], t[1]};
Transfinite Curve {q[0], q[2]} = 2;
l = newll; Curve Loop(l) = {tl[1], q[0], q[1], q[2]};
f = news; Plane Surface(f) = {l}; Transfinite Surface {f} AlternateRight;
Recombine Surface {f};
Physical Surface("bedrock")       = {rock[]};
Physical Surface("sliding_mass")  = {f};
Physical Curve("base")            = {bl[]};
Physical Curve("left")            = {v[0]};
Physical Curve("right")           = {v[3]};
Physical Curve("sliding_surface") = {tl[1]};
Physical Curve("ground")          = {tl[0], tl[2]};
"""

ROD = """
DefineConstant[cells = {1, Min 1, Max 100, Name "Cells"}];
Point(1) = {0, -40, 0}; Point(2) = {10, -40, 0}; Point(3) = {10, 0, 0}; Point(4) = {0, 0, 0};
For i In {1:4}
  Line(i) = {i, i % 4 + 1};
EndFor
Transfinite Curve {1, 3} = cells + 1;
Transfinite Curve {2, 4} = 9;
Curve Loop(1) = {1:4};
Plane Surface(1) = {1};
Transfinite Surface {1};
Recombine Surface {1};
Physical Surface("bedrock")       = {1};
Physical Curve("base")            = {1};
Physical Curve("right")           = {2};
Physical Curve("sliding_surface") = {3};
Physical Curve("left")            = {4};
"""

SCENE = """
set Title = contact with the bedrock
subsection Time
  set End time  = %(end)s
  set Time step = 0.001
end
subsection Mesh
  set File = %(mesh)s
end
subsection Model
  set Bedrock = continuum
  set Blocks  = loose
end
subsection Materials
  set Names = mass, rock
  subsection mass
    set Density          = %(density)s
    set Young modulus    = 1e10
    set Poisson ratio    = 0
    set Friction angle   = 15
    set Cohesion         = 1e8
    set Tensile strength = 1e8
  end
  subsection rock
    set Density       = 2000
    set Young modulus = 1e10
    set Poisson ratio = 0
  end
end
subsection Continuum
  set Materials = rock
  set Base      = fixed
  set Sides     = %(sides)s
end
subsection Blocks
  set Material = mass
end
subsection Gravity
  set Static stage = %(stage)s
end
subsection Monitors
  set Points = %(points)s
end
subsection Output
  set Picture interval = 0
end
"""


def polygon(path, corners):
    path.write_text("block,x,y\n" + "".join("0,%r,%r\n" % corner for corner in corners))


def run(binary, work, name, scene, overrides):
    code, out, err, command = run_hybrid(binary, scene, work / "runs" / name, overrides)
    if code != 0:
        sys.exit("%s\nexit code %d\n%s%s" % (command, code, out, err))
    return json.loads((work / "runs" / name / "summary.json").read_text())["monitors"]


def check_slab(binary, work):
    """Slides of the middle of the slab [m], one per bedrock and kind of mass."""
    angle = math.radians(SLOPE)
    cosine, sine = math.cos(angle), math.sin(angle)
    expected = 0.5 * 9.81 * (sine - cosine * math.tan(math.radians(FRICTION))) * END**2
    (work / "slab.geo").write_text(SLAB)
    polygon(work / "one.csv", [(cosine * x - sine * y, sine * x + cosine * y)
                               for x, y in ((0.13, 0), (11.9, 0), (11.9, 2), (0.13, 2))])
    scene = work / "slab.prm"
    middle = (cosine * 5.0 - sine * 1.0, sine * 5.0 + cosine * 1.0)
    scene.write_text(SCENE % dict(end=END, mesh="slab.geo", density=2200, sides="viscous", stage="held",
                                  points="middle: %r, %r" % middle))
    one = "Mesh/Polygons file=%s" % (work / "one.csv")
    masses = {
        "bonded": ["Model/Blocks=bonded"],
        "one_block_on_2_cells": [one, "Mesh/Numbers=Cells = 2"],
        "one_block_on_30_cells": [one, "Mesh/Numbers=Cells = 30"],
    }
    faults = []
    for bedrock in ("continuum", "triangles", "rigid"):
        for kind, overrides in masses.items():
            name = "%s_%s" % (bedrock, kind)
            monitors = run(binary, work, name, scene, ["Model/Bedrock=" + bedrock] + overrides)
            x, y = monitors["middle"]["final_displacement_m"]
            slide, lift = -(x * cosine + y * sine), y * cosine - x * sine
            print("%-32s slides %.6f m, expected %.6f; leaves the plane by %.1e m" % (name, slide, expected, lift))
            if abs(slide / expected - 1.0) > 0.003 or abs(lift) > 1e-4:
                faults.append(name)
    return faults


def check_patch(binary, work):
    """Settlement of the block, and how far the surface is from straight."""
    (work / "rod.geo").write_text(ROD)
    polygon(work / "press.csv", [(0, 0), (10, 0), (10, 5), (0, 5)])
    scene = work / "rod.prm"
    scene.write_text(SCENE % dict(end=0.1, mesh="rod.geo", density=20000, sides="roller", stage="none",
                                  points="block: 5, 2; middle: 5, -0.001; edge: 0.001, -0.001"))
    faults, first = [], None
    for degree in (1, 2, 3):
        for cells in (1, 3, 10, 30):
            name = "patch_%d_%d" % (degree, cells)
            monitors = run(binary, work, name, scene,
                           ["Mesh/Polygons file=%s" % (work / "press.csv"), "Mesh/Numbers=Cells = %d" % cells,
                            "Continuum/Degree=%d" % degree])
            block, middle, edge = (monitors[m]["peak_displacement_m"][1] for m in ("block", "middle", "edge"))
            first = block if cells == 1 else first
            print("degree %d, %2d cells: block %.8f m, surface in its middle %.8f, at its edge %.8f" %
                  (degree, cells, block, middle, edge))
            if abs(block / first - 1.0) > 1e-6 or abs(edge / middle - 1.0) > 1e-6:
                faults.append(name)
    return faults


def main():
    binary, work = sys.argv[1], pathlib.Path(sys.argv[2]).resolve()
    work.mkdir(parents=True, exist_ok=True)
    faults = check_slab(binary, work) + check_patch(binary, work)
    if faults:
        sys.exit("not as expected: " + ", ".join(faults))


if __name__ == "__main__":
    main()
