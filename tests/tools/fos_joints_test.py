# SPDX-License-Identifier: GPL-3.0-or-later
"""hybrid fos of a mass of one rock with a joint of its own: bedding of 25 degrees, bonded, under eight columns of rock."""
import json

import numpy as np
import pytest

SLOPE, LENGTH, DEPTH = np.radians(25), 16.0, 3.0  # of the rock above the bedding [m]
COHESION, FRICTION, DENSITY = 6e3, 22.0, 2500.0
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
  set Names = rock, clay
  subsection rock
    set Density = %g
    set Young modulus = 10e9
    set Friction angle = 45
    set Cohesion = 1e6
    set Tensile strength = 5e5
  end
  subsection clay
    set Friction angle = %g
    set Cohesion = %g
  end
end
subsection Blocks
  set Material = rock
  set Joint materials = joint_bedding: clay
end
""" % (DENSITY, FRICTION, COHESION)


@pytest.fixture
def slope(tmp_path):
    along, up = np.array([np.cos(SLOPE), np.sin(SLOPE)]), np.array([-np.sin(SLOPE), np.cos(SLOPE)])
    rows = ["block,x,y,region,joint"]
    for layer, low, high in (("lower", 0, 2), ("upper", 2, 2 + DEPTH)):
        for k in range(8):
            for number, (s, n) in enumerate(((k, low), (k + 1, low), (k + 1, high), (k, high))):
                joint = "joint_bedding" if layer == "upper" and number == 0 else ""
                rows.append("%s_%d,%.12g,%.12g,,%s" % (layer, k, *(LENGTH / 8 * s * along + n * up), joint))
    (tmp_path / "mass.csv").write_text("\n".join(rows) + "\n")
    (tmp_path / "ground.csv").write_text("x,y\n%.12g,%.12g\n%.12g,%.12g\n" % (*(-10 * along), *(2 * LENGTH * along)))
    (tmp_path / "slope.prm").write_text(SCENE)
    return tmp_path / "slope.prm"


def test_rock_slides_on_its_bedding_and_is_not_warned_of(hybrid, slope, tmp_path):
    weight = DENSITY * 9.81 * LENGTH * DEPTH
    factor = (COHESION * LENGTH + weight * np.cos(SLOPE) * np.tan(np.radians(FRICTION))) / (weight * np.sin(SLOPE))
    done = hybrid("fos", slope, "--range", "0.9", "1.3", "--output", tmp_path / "out")
    assert done.returncode == 0, done.stderr
    found = json.loads((tmp_path / "out/fos.json").read_text())
    assert found["fos"] == pytest.approx(factor, rel=0.005)
    assert found["parting_within_mass"] < 0.01 and "through itself" not in done.stdout


def test_section_draws_the_joints(hybrid, slope, tmp_path):
    done = hybrid("section", slope)
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "slope.section.png").stat().st_size > 10000
