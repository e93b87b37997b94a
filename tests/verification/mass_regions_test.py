#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A mass of two regions with a material each.

- A P pulse climbs a bonded bar whose upper half is four or a hundred times as stiff. Displacements are those of two elastic layers:
  what comes through where they meet is 2 Z1 / (Z1 + Z2), what comes back (Z1 - Z2) / (Z1 + Z2) with Z = rho c, and the free end doubles.
- Two names of the same values are one material to the bit.
- A region of the mesh without a material, one that the mesh has not, and a material that the scene has not are refused.

    mass_regions_test.py HYBRID ROOT WORK_DIR   exit code 1 and a sentence if a requirement is not met
"""

import pathlib
import sys

import h5py
import numpy as np

WIDTH, MIDDLE, SIZE = 8.0, 160.0, 4.0   # of the bar, where the two materials meet, of triangles [m]
DENSITY, SOFT, STIFF = 2000.0, 200e6, 800e6
FREQUENCY, PEAK = 2.0, 0.1              # of the pulse [Hz], [m/s2]

GEO = """
Point(1) = {0, 0, 0}; Point(2) = {%(w)g, 0, 0}; Point(3) = {%(w)g, %(m)g, 0}; Point(4) = {%(w)g, %(t)g, 0}; Point(5) = {0, %(t)g, 0}; Point(6) = {0, %(m)g, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 5}; Line(5) = {5, 6}; Line(6) = {6, 1}; Line(7) = {6, 3};
Curve Loop(1) = {1, 2, -7, 6}; Plane Surface(1) = {1};
Curve Loop(2) = {7, 3, 4, 5}; Plane Surface(2) = {2};
Transfinite Curve{1, 4, 7} = %(across)d + 1; Transfinite Curve{2, 3, 5, 6} = %(along)d + 1;
Transfinite Surface{1, 2} Alternate;
Physical Surface("sliding_mass") = {1};
Physical Surface("sliding_mass_upper") = {2};
Physical Curve("sliding_surface") = {1};
""" % {"w": WIDTH, "m": MIDDLE, "t": 2 * MIDDLE, "across": WIDTH / SIZE, "along": MIDDLE / SIZE}

PRM = """
subsection Time
  set End time = 1.4
  set Time step = 0.001
end
subsection Mesh
  set File = bar.geo
end
subsection Model
  set Bedrock = rigid
end
subsection Materials
  set Names = lower, upper
  subsection lower
    set Density = %(density)g
    set Young modulus = %(soft)g
    set Poisson ratio = 0
    set Cohesion = 1e9
    set Tensile strength = 1e9
  end
  subsection upper
    set Density = %(density)g
    set Young modulus = %(stiff)g
    set Poisson ratio = 0
    set Cohesion = 1e9
    set Tensile strength = 1e9
  end
end
subsection Blocks
  set Material = sliding_mass: lower; sliding_mass_upper: upper
  set Belt material = lower
end
subsection Gravity
  set Acceleration = 0
end
subsection Motion
  set Type = ricker
  set Peak = %(peak)g m/s2
  set Frequency = %(frequency)g
  set Angle = 90
end
subsection Monitors
  set Points = lower: 4, 80; top: 4, 320
end
subsection Output
  set Picture interval = 0
end
""" % {"density": DENSITY, "soft": SOFT, "stiff": STIFF, "peak": PEAK, "frequency": FREQUENCY}


def write_scene(work):
    work.mkdir(parents=True, exist_ok=True)
    (work / "bar.geo").write_text(GEO)
    scene = work / "bar.prm"
    scene.write_text(PRM)
    return scene


def displacements(directory):
    """Time [s], {monitor: vertical displacement [m]}, and the base's."""
    with h5py.File(directory / "run.h5") as run:
        found = {name: run["monitors/%s/displacement" % name][:, 1] for name in ("lower", "top")}
        return run["time"][()], found, run["input/displacement"][:, 1]


def climb(time, base, stiff):
    """{monitor: displacement [m]} of two layers on a base that moves as given: d'Alembert's waves, all of them, summed by Laplace transforms
    (frequencies with a small imaginary part, so that what comes after the end fades)."""
    n, dt = 4 * len(time), time[1] - time[0]
    fade = 6 / (n * dt)  # [1/s]
    s = 2 * np.pi * np.fft.rfftfreq(n, dt) - 1j * fade
    slow, fast = s / np.sqrt(SOFT / DENSITY), s / np.sqrt(stiff / DENSITY)  # wave numbers [1/m]
    ratio = np.sqrt(stiff / SOFT)  # of impedances, densities are equal

    def below_joint(depth):
        return np.cos(fast * MIDDLE) * np.cos(slow * depth) - ratio * np.sin(fast * MIDDLE) * np.sin(slow * depth)

    moved = np.fft.rfft(base * np.exp(-fade * time), n)
    return {name: np.fft.irfft(moved * shape / below_joint(MIDDLE), n)[:len(time)] * np.exp(fade * time)
            for name, shape in (("lower", below_joint(MIDDLE - 80)), ("top", 1.0))}


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    binary, root, work = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3]).resolve()
    sys.path.insert(0, str(root / "tests"))
    from run_hybrid import require, run_hybrid

    scene = write_scene(work / "scene")
    for stiff in (STIFF, 100 * SOFT):
        code, output, errors, _ = run_hybrid(binary, scene, work / "two", ["Materials/upper/Young modulus=%g" % stiff])
        require(code == 0, "runs", output + errors)
        time, found, base = displacements(work / "two")
        for name, expected in climb(time, base, stiff).items():
            error = np.abs(found[name] - expected).max() / np.abs(expected).max()
            require(error < 0.02, "upper half %g times as stiff, %s: displacement within %.2f %% of two layers'" % (
                stiff / SOFT, name, 100 * error), output)

    same = ["Materials/upper/Young modulus=%g" % SOFT]
    run_hybrid(binary, scene, work / "same", same)
    run_hybrid(binary, scene, work / "one", same + ["Blocks/Material=lower"])
    require(all(np.array_equal(displacements(work / "same")[1][name], displacements(work / "one")[1][name]) for name in found),
            "two names of one material: the same bits", output)

    for materials, words in (("sliding_mass: lower", "Blocks/Material: the region 'sliding_mass_upper' of the mesh has no material"),
                             ("sliding_mass: lower; sliding_mass_uper: upper", "the mesh has no region 'sliding_mass_uper'"),
                             ("sliding_mass: lower; sliding_mass_upper: cheese", "no such material")):
        code, output, errors, _ = run_hybrid(binary, scene, work / "refused", ["Blocks/Material=" + materials])
        require(code == 2 and words in errors, "refused: " + words, output + errors)


if __name__ == "__main__":
    main()
