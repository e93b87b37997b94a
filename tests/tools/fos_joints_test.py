# SPDX-License-Identifier: GPL-3.0-or-later
"""hybrid fos of a mass of one rock with a joint of its own: bedding of 25 degrees, bonded, under eight columns of rock."""
import json

import numpy as np
import pytest
from conftest import around

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
def draw(tmp_path):
    """Draws columns of layers (name, lower and upper end [m], region, joint of the lower edge)."""

    def scene(*layers):
        along, up = np.array([np.cos(SLOPE), np.sin(SLOPE)]), np.array([-np.sin(SLOPE), np.cos(SLOPE)])
        rows = ["block,x,y,region,joint"]
        for name, low, high, region, joint in layers:
            for k in range(8):
                for number, (s, n) in enumerate(((k, low), (k + 1, low), (k + 1, high), (k, high))):
                    rows.append("%s_%d,%.12g,%.12g,%s,%s" % (name, k, *(LENGTH / 8 * s * along + n * up), region, "" if number else joint))
        (tmp_path / "mass.csv").write_text("\n".join(rows) + "\n")
        (tmp_path / "ground.csv").write_text("x,y\n%.12g,%.12g\n%.12g,%.12g\n" % (*(-10 * along), *(2 * LENGTH * along)))
        (tmp_path / "slope.prm").write_text(SCENE)
        return tmp_path / "slope.prm"

    return scene


@pytest.fixture
def slope(draw):
    return draw(("lower", 0, 2, "", ""), ("upper", 2, 2 + DEPTH, "", "joint_bedding"))


def factor(depth):
    weight = DENSITY * 9.81 * LENGTH * depth
    return (COHESION * LENGTH + weight * np.cos(SLOPE) * np.tan(np.radians(FRICTION))) / (weight * np.sin(SLOPE))


def test_rock_slides_on_its_bedding_and_is_not_warned_of(hybrid, slope, tmp_path):
    done = hybrid("fos", slope, *around(factor(DEPTH), 0.0075), "--output", tmp_path / "out")
    assert done.returncode == 0, done.stderr
    found = json.loads((tmp_path / "out/fos.json").read_text())
    assert found["fos"] == pytest.approx(factor(DEPTH), rel=0.005)
    assert found["parting_within_mass"] < 0.01 and "through itself" not in done.stdout


def test_a_strong_joint_sends_failure_through_the_mass_above(hybrid, draw, tmp_path):
    scene = draw(("rock", 0, 2, "sliding_mass_rock", ""), ("low", 2, 2 + DEPTH / 2, "", "joint_bedding"), ("high", 2 + DEPTH / 2, 2 + DEPTH, "", ""))
    settings = ["Blocks/Material=sliding_mass_rock: rock; sliding_mass: clay", "Blocks/Joint materials=rock", "Materials/clay/Density=%g" % DENSITY,
                "Materials/clay/Young modulus=200e6", "Materials/clay/Tensile strength=2e3"]
    done = hybrid("fos", scene, *around(factor(DEPTH / 2), 0.02), "--output", tmp_path / "out", *[word for setting in settings for word in ("-s", setting)])
    assert done.returncode == 0, done.stderr
    found = json.loads((tmp_path / "out/fos.json").read_text())
    assert found["fos"] == pytest.approx(factor(DEPTH / 2), rel=0.02)
    assert found["parting_within_mass"] > 0.9 and "through itself" in done.stdout


def test_section_draws_the_joints(hybrid, slope, tmp_path):
    done = hybrid("section", slope)
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "slope.section.png").stat().st_size > 10000
