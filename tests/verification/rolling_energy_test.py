#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Regular polygons roll on level ground: no energy comes in as their edges turn through 3 degrees, and the audit closes.

    rolling_energy_test.py HYBRID ROOT WORK_DIR   exit code 1 and a sentence if a requirement is not met

A wheel of 360 corners (r = 1 m) turns by 3e-3 in each step and has three edges within 3 degrees of the ground at any time: what longer and
shorter springs give is nothing, and its motion loses energy. One of 24 corners (r = 0.1 m) turns by 3e-2: its works are on arcs.
"""

import json
import math
import pathlib
import sys

SCENE = """
subsection Model
  set Bedrock = rigid
  set Blocks = loose
end
subsection Materials
  set Names = rock
  subsection rock
    set Density = 2400
    set Young modulus = 5e9
    set Poisson ratio = 0.25
    set Friction angle = 40
  end
end
subsection Blocks
  set Material = rock
  set Initial velocities = a: -3,3,-1,5,3,0,{turn}
end
subsection Output
  set Picture interval = 0
end
subsection Mesh
  set Polygons file = {folder}/wheel.csv
  set Surface file = {folder}/ground.csv
end
subsection Gravity
  set Static stage = none
end
subsection Monitors
  set Points = c: 0,{radius}
end
subsection Time
  set End time = 2
  set Time step = 0.001
end
"""


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    binary, root, work = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    sys.path.insert(0, str(root / "tests"))
    from run_hybrid import require, run_hybrid

    for corners, radius, residual in ((360, 1.0, 1e-6), (24, 0.1, 1e-6)):
        folder = work / str(corners)
        write_scene(folder, corners, radius)
        code, output, _, _ = run_hybrid(binary, folder / "roll.prm", folder / "run", [])
        require(code == 0, "%d corners rolled to the end" % corners, output)
        summary = json.loads((folder / "run/summary.json").read_text())
        energy, mass = summary["energy_J_per_m"], 2400 * corners / 2 * radius**2 * math.sin(2 * math.pi / corners)
        start = 0.75 * mass * 3**2  # of a disc, within 1 %
        found = "%d corners: residual %.1e, replaced springs %+.5f of the energy, change %+.4f" % (
            corners, summary["energy_residual"], energy["spring_replacement_loss"] / start, energy["blocks_kinetic"] / start)
        require(summary["energy_residual"] < residual, found, output)
        require(energy["blocks_kinetic"] + energy["joints_and_contacts"] + energy["blocks_strain"] < 0, "it slows down", found)
        if corners == 360:
            require(abs(energy["spring_replacement_loss"]) < 1e-4 * start, "turning edges give nothing", found)


def write_scene(folder, corners, radius):
    folder.mkdir(parents=True, exist_ok=True)
    half = math.pi / corners
    places = [(radius * math.sin(half + 2 * half * k), radius * (math.cos(half) - math.cos(half + 2 * half * k))) for k in range(corners)]
    (folder / "wheel.csv").write_text("block,x,y\n" + "".join("1,%.17g,%.17g\n" % place for place in places))
    (folder / "ground.csv").write_text("x,y\n-200,0\n200,0\n")
    (folder / "roll.prm").write_text(SCENE.format(turn=-3 / radius, radius=radius, folder=folder.resolve()))


if __name__ == "__main__":
    main()
