#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Slip on the sliding surface is what monitors on both its sides say, whatever the bedrock and whatever holds the mass.

A level layer of stiff blocks is shaken on every bedrock: bonded, on a belt whose strength is its friction (after a tenth of
a joint's length its joints are released to contacts), and loose. Monitors are on the middles of the soles and in the ground
a millimetre below; the slip of a sole has to be the difference of their displacements along the surface (within 1e-3 of the
largest: a sole is level at rest but for the mass's settlement), at every time, and the summary has to say the same. Nothing
throws a block: no sole leaves the ground, or goes into it, by more than a thousandth of its length, whatever the step and the
number of columns.

Usage: slip_test.py HYBRID_BINARY WORK_DIR
"""
import json
import pathlib
import shutil
import sys

import h5py
import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from run_hybrid import run_hybrid  # noqa: E402 (needs the path above)

# Three layers over the whole width, each one surface; the highest is the mass.
GEOMETRY = """
DefineConstant[columns = {8, Min 1, Max 100, Name "Columns"}];
level[] = {0, 5, 10, 12.5};
For i In {0:3}
  a = newp; Point(a) = {0, level[i], 0};
  b = newp; Point(b) = {20, level[i], 0};
  l = newl; Line(l) = {a, b};
  Transfinite Curve {l} = columns + 1;
  across[] += l;
  If (i > 0)
    ll = newl; Line(ll) = {below_a, a};
    lr = newl; Line(lr) = {below_b, b};
    Transfinite Curve {ll, lr} = Ceil((level[i] - level[i - 1]) / 2.5) + 1;
    loop = newll; Curve Loop(loop) = {across[i - 1], lr, -l, -ll};
    s = news; Plane Surface(s) = {loop};
    Transfinite Surface {s} AlternateRight;
    If (i < 3)
      Recombine Surface {s};
    EndIf
    part[]  += s;
    left[]  += ll;
    right[] += lr;
  EndIf
  below_a = a;
  below_b = b;
EndFor
Physical Surface("bedrock")       = {part[0], part[1]};
Physical Surface("sliding_mass")  = {part[2]};
Physical Curve("base")            = {across[0]};
Physical Curve("bedding_1")       = {across[1]};
Physical Curve("sliding_surface") = {across[2]};
Physical Curve("mass_surface")    = {left[2], across[3], right[2]};
Physical Curve("left")            = {left[0], left[1]};
Physical Curve("right")           = {right[0], right[1]};
"""

SCENE = """
set Title = %(title)s
subsection Time
  set End time  = 2.4
  set Time step = 0.002
end
subsection Mesh
  set File = %(mesh)s
end
subsection Model
  set Bedrock = %(bedrock)s
  set Blocks  = %(blocks)s
end
subsection Materials
  set Names = rock, belt
  subsection rock
    set Density          = 2000
    set Young modulus    = 5e9
    set Poisson ratio    = 0.25
    set Friction angle   = 20
    set Cohesion         = %(cohesion)s
    set Tensile strength = %(cohesion)s
  end
  subsection belt
    set Friction angle   = 10
    set Cohesion         = 0
    set Tensile strength = 0
  end
end
subsection Continuum
  set Materials = rock
  set Base      = rigid
  set Sides     = viscous
end
subsection Bedding planes
  set Names            = bedding_1
  set Normal stiffness = 1e12
  set Shear stiffness  = 1e12
end
subsection Blocks
  set Material = rock
%(belt)send
subsection Gravity
  set Acceleration = 9.81
end
subsection Motion
  set Type      = ricker
  set Frequency = 1
  set Peak      = %(peak)s
end
subsection Monitors
  set Points = %(points)s
end
subsection Output
  set Picture interval = 0.8
end
"""

WIDTH = 20.0  # of the mass [m]


def check(binary, work, bedrock, blocks, columns=8, step=0.002):
    """Whether slip of one scene is right; says so. The mass has so many columns of two triangles; step [s]."""
    directory = work / ("%s_%s_%d_%g" % (bedrock, blocks, columns, step))
    sole = WIDTH / columns
    middles = [(k + 0.5) * sole for k in range(columns)]  # of the soles
    scene = directory.with_suffix(".prm")
    bonded = blocks == "bonded"
    scene.write_text(SCENE % {"title": bedrock + ", " + blocks, "mesh": work / "layers.geo", "bedrock": bedrock, "blocks": blocks,
                              "cohesion": "1e9" if bonded else "0", "peak": 7 if bonded else 6,
                              "points": "; ".join("m%d: %g, 10; g%d: %g, 9.999" % (k, x, k, x) for k, x in enumerate(middles)),
                              "belt": "  set Belt material = belt\n" if bonded else ""})
    code, output, errors, command = run_hybrid(binary, scene, directory, ["Mesh/Numbers=Columns = %d" % columns, "Time/Time step=%g" % step])
    if code != 0:
        sys.exit("%s\nexit code %d\n%s%s" % (command, code, output, errors))
    with h5py.File(directory / "run.h5", "r") as file:
        expected, lift = (numpy.column_stack([file[f"monitors/m{k}/displacement"][:, c] - file[f"monitors/g{k}/displacement"][:, c]
                                              for k in range(columns)]) for c in (0, 1))
        mean, largest, profile = file["slip/mean"][:], file["slip/largest"][:], file["slip/profile"][:]
        order = numpy.argsort(file["slip/position"][:, 0])
        soles, length = file["slip/position"][:][order], file["slip/length"][:][order]
        sign, times = file.attrs["downhill_sign"][0], file["slip/time"][:]
        frames = [file[name][:] for name in ("slip/time", "interface/time", "energy/time") if name in file]
    slip = json.loads((directory / "summary.json").read_text())["slip_m"]
    size = numpy.abs(expected).max()
    farthest = numpy.take_along_axis(expected, numpy.abs(expected).argmax(axis=1)[:, None], axis=1)[:, 0]
    errors = {
        "soles": numpy.abs(soles - [(x, 10) for x in middles]).max() + numpy.abs(length - sole).max() if len(soles) == columns else 1,
        "lift": numpy.abs(lift).max() / sole,
        "mean": numpy.abs(mean - expected.mean(axis=1)).max() / size,
        "largest": numpy.abs(numpy.abs(largest) - numpy.abs(farthest)).max() / size,
        "profile": numpy.abs(profile[-1][order] - expected[-1]).max() / size,
        "summary": max(abs(abs(slip["mean"]) - numpy.abs(mean).max()), abs(abs(slip["largest"]) - numpy.abs(largest).max()),
                       abs(slip["mean_left"] - mean[-1]), abs(slip["largest_left"] - largest[-1])) / size,
    }
    once = all((numpy.diff(series) > 0).all() for series in frames)  # no frame is written twice, nor the last one
    good = size > 1e-4 and sign == 0 and len(times) == 4 and once and max(errors.values()) < 1e-3
    print(f"{bedrock}, {blocks}, {columns} columns, {step} s: slid {size:.4f} m at most, mean left {mean[-1]:.4f} m; " +
          ", ".join(f"{name} {error:.1e}" for name, error in errors.items()) + ("" if good else "  WRONG"))
    return good


def main():
    binary, work = sys.argv[1], pathlib.Path(sys.argv[2]).resolve()
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    (work / "layers.geo").write_text(GEOMETRY)
    failed = 0
    for bedrock in ("rigid", "continuum", "layers", "triangles"):
        for blocks in ("bonded", "loose"):
            failed += not check(binary, work, bedrock, blocks)
    for columns, step in ((8, 0.0005), (3, 0.002), (5, 0.005)):
        failed += not check(binary, work, "continuum", "loose", columns, step)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
