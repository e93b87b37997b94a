# SPDX-License-Identifier: GPL-3.0-or-later
"""hybrid fos of a mass of two materials: debris on rock, bonded, on a slope of 25 degrees."""
import json

import numpy as np
import pytest
from conftest import around

SLOPE, LENGTH, DEPTH = np.radians(25), 16.0, 3.0  # of the debris [m]
COHESION, FRICTION, DENSITY = 6e3, 22.0, 2000.0
SCENE = """
subsection Mesh
  set Polygons file = mass.csv
  set Surface file = ground.csv
end
subsection Model
  set Bedrock = rigid
  set Blocks = bonded
end
subsection Materials
  set Names = rock, debris
  subsection rock
    set Young modulus = 10e9
    set Friction angle = 45
    set Cohesion = 1e6
    set Tensile strength = 5e5
  end
  subsection debris
    set Density = %g
    set Young modulus = 200e6
    set Friction angle = %g
    set Cohesion = %g
    set Tensile strength = 2e3
  end
end
subsection Blocks
  set Material = sliding_mass: rock; sliding_mass_debris: debris
end
""" % (DENSITY, FRICTION, COHESION)


@pytest.fixture
def layers(tmp_path):
    """Eight columns of two blocks, 2 m of rock below 3 m of debris."""
    along, up = np.array([np.cos(SLOPE), np.sin(SLOPE)]), np.array([-np.sin(SLOPE), np.cos(SLOPE)])
    rows = ["block,x,y,region"]
    for region, low, high in (("sliding_mass", 0, 2), ("sliding_mass_debris", 2, 2 + DEPTH)):
        for k in range(8):
            for s, n in ((k, low), (k + 1, low), (k + 1, high), (k, high)):
                rows.append("%s_%d,%.12g,%.12g,%s" % (region, k, *(LENGTH / 8 * s * along + n * up), region))
    (tmp_path / "mass.csv").write_text("\n".join(rows) + "\n")
    (tmp_path / "ground.csv").write_text("x,y\n%.12g,%.12g\n%.12g,%.12g\n" % (*(-10 * along), *(2 * LENGTH * along)))
    (tmp_path / "layers.prm").write_text(SCENE)
    return tmp_path / "layers.prm"


def test_debris_slides_on_rock_along_the_boundary_and_is_not_warned_of(hybrid, layers, tmp_path):
    weight = DENSITY * 9.81 * LENGTH * DEPTH
    factor = (COHESION * LENGTH + weight * np.cos(SLOPE) * np.tan(np.radians(FRICTION))) / (weight * np.sin(SLOPE))
    done = hybrid("fos", layers, *around(factor, 0.0075), "--output", tmp_path / "out")
    assert done.returncode == 0, done.stderr
    found = json.loads((tmp_path / "out/fos.json").read_text())
    assert found["fos"] == pytest.approx(factor, rel=0.005)
    assert found["parting_within_mass"] < 0.01 and "through itself" not in done.stdout


def test_newmark_needs_one_material_on_the_sliding_surface(hybrid, layers, tmp_path):
    motion = ["Motion/Type=sine", "Motion/Peak=2 m/s2", "Motion/Frequency=2", "Time/End time=0.1", "Time/Error estimate=one run",
              "Materials/debris/Friction angle=30"]
    done = hybrid(layers, *[word for setting in [*motion, f"Output/Directory={tmp_path}/run"] for word in ("-s", setting)])
    assert done.returncode == 0, done.stderr
    done = hybrid("fos", tmp_path / "run", "--newmark", "--range", "0.15", "0.2", "--tolerance", "0.49")
    assert done.returncode == 2 and "has the friction of several materials" in done.stderr
