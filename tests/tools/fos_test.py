# SPDX-License-Identifier: GPL-3.0-or-later
"""hybrid fos: factor of safety and yield acceleration against limit equilibrium, Newmark's displacement against that of a run."""
import json
import re

import numpy as np
import pytest
from conftest import ONE_RUN, ROOT, around

from hybrid_run import Run

SLAB = ROOT / "parameters/verification/bonded_slab.prm"  # belt of 25 degrees on a slope of 20
PLANES = ROOT / "parameters/verification/column_planes.prm"  # rock on a level bedding plane, no blocks
SLAB_FACTOR = np.tan(np.radians(25)) / np.tan(np.radians(20))

# A wedge above a plane through the toe of a face (Culmann 1866).
HEIGHT, FACE, PLANE = 10.0, 60.0, 35.0
WEDGE = """
H = %g;
face = %g * Pi / 180;
plane = %g * Pi / 180;
Point(1) = {0, 0, 0};
Point(2) = {H / Tan(plane), H, 0};
Point(3) = {H / Tan(face), H, 0};
Point(4) = {-5, -5 * Tan(plane), 0};
Point(5) = {H / Tan(plane) + 5, H + 5 * Tan(plane), 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 1};
Line(4) = {4, 1};
Line(5) = {2, 5};
Curve Loop(1) = {1, 2, 3};
Plane Surface(1) = {1};
MeshSize {:} = 2;
Transfinite Curve {4, 5} = 2;
Physical Surface("sliding_mass") = {1};
Physical Curve("sliding_surface") = {1};
Physical Curve("mass_surface") = {2, 3};
Physical Curve("ground") = {4, 5};
""" % (HEIGHT, FACE, PLANE)

# A wedge of the bedrock above a bedding plane that comes out at the toe of a slope.
ROCK_WEDGE = """
Point(1) = {-40, -30, 0}; Point(2) = {70, -30, 0}; Point(3) = {70, 20, 0}; Point(4) = {%.12g, 20, 0};
Point(5) = {16, 20, 0}; Point(6) = {0, 0, 0}; Point(7) = {-40, 0, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 5}; Line(5) = {5, 6}; Line(6) = {6, 7}; Line(7) = {7, 1}; Line(8) = {6, 4};
Curve Loop(1) = {1, 2, 3, -8, 6, 7}; Plane Surface(1) = {1};
Curve Loop(2) = {8, 4, 5}; Plane Surface(2) = {2};
MeshSize{:} = 10;
Mesh.RecombinationAlgorithm = 3;
Recombine Surface{1, 2};
Physical Surface("bedrock") = {1, 2};
Physical Curve("base") = {1};
Physical Curve("left") = {7};
Physical Curve("right") = {2};
Physical Curve("ground") = {3, 4, 5, 6};
Physical Curve("bedding_1") = {8};
"""


@pytest.fixture(scope="module")
def slab(hybrid, tmp_path_factory):
    """A run of the slab, and where it is."""
    directory = tmp_path_factory.mktemp("slab") / "run"
    result = hybrid(SLAB, "-s", f"Output/Directory={directory}", *ONE_RUN)
    assert result.returncode == 0, result.stderr
    return directory, result.stdout


def read(directory, name):
    return json.loads((directory / (name + ".json")).read_text())


def assert_brackets(found, key, exact, error):
    assert found["stands"] < found["fails"] and found[key] == pytest.approx(exact, rel=error)
    assert all(trial["stands"] == (trial["value"] < found[key]) for trial in found["trials"])


def around_yield(exact, error=0.005):
    """As around(), of a coefficient; others search from 0 on."""
    return around(exact, error)[:-1] + [10 * 2.02 * error * exact]


def test_base_shear_of_a_slab_is_its_weight_along_the_slope(slab):
    directory, said = slab
    run = Run(directory)
    weight = 20 * 4 * 2000 * 9.81
    b = np.radians(20)
    assert np.ravel(run.attribute("base_shear", "weight")) == pytest.approx(weight)
    shear, normal, strength = np.ravel(run.attribute("base_shear", "at_rest"))
    assert (shear, normal) == pytest.approx((weight * np.sin(b), weight * np.cos(b)), rel=1e-6)
    assert shear / strength == pytest.approx(1 / SLAB_FACTOR, rel=1e-6)
    assert run.get("base_shear/force") == pytest.approx(run.get("interface/total_force"), abs=1e-6 * weight)
    mobilised, mean = run.mobilised(), run.get("slip/mean")
    assert mobilised.max() == pytest.approx(1, abs=1e-9)  # never above the strength
    sliding = np.gradient(mean, run.time) > 0.01
    assert mobilised[sliding] == pytest.approx(1, abs=1e-6) and sliding.sum() > 100
    part = run.get("slip/part")
    assert part[0] == 0 and part[-1] == 1 and (np.diff(part) >= 0).all()
    assert (part > 0).argmax() == pytest.approx((mean > 1e-3).argmax(), abs=2)
    summary = run.summary
    assert summary["slip_m"]["part_slipped"] == 1 and summary["slip_m"]["threshold"] == 1e-3
    assert summary["base_shear"]["mobilised_at_rest"] == pytest.approx(1 / SLAB_FACTOR, rel=1e-6)
    assert re.search(r"Finished  1.6 s in \d+:\d\d, 1600 steps", said) and "78.1 % mobilised at rest, at most 100 %" in said
    assert " in 0:" not in (directory / "log.txt").read_text()  # logs of equal runs are equal


@pytest.mark.parametrize("bedrock", ["continuum", "triangles"])
def test_base_shear_of_a_level_layer_is_that_of_every_bedrock(hybrid, tmp_path, bedrock):
    result = hybrid(ROOT / "parameters/verification/coupled_column.prm", "-s", "Time/End time=0.05", "-s", f"Model/Bedrock={bedrock}",
                    "-s", f"Output/Directory={tmp_path / 'run'}", *ONE_RUN)
    assert result.returncode == 0, result.stderr
    run = Run(tmp_path / "run")
    weight = float(np.ravel(run.attribute("base_shear", "weight"))[0])
    shear, normal, _ = np.ravel(run.attribute("base_shear", "at_rest"))
    assert normal == pytest.approx(weight, rel=1e-6) and abs(shear) < 1e-6 * weight
    assert (run.blocks.mass.stop < len(run.blocks)) == (bedrock == "triangles")  # blocks of the bedrock follow those of the mass
    assert all(polygon[:, 1].min() > 10 - 1e-6 for polygon in run.blocks.polygons[run.blocks.mass])
    assert weight > 0 and run.get("base_shear/normal") == pytest.approx(-run.get("base_shear/force")[:, 1], abs=1e-6 * weight)


def test_slab_on_a_slope_fails_where_its_friction_does(hybrid, tmp_path):
    result = hybrid("fos", SLAB, "--output", tmp_path / "out", "--range", "1.2", "1.4", "--tolerance", "0.002")
    assert result.returncode == 0, result.stderr
    found = read(tmp_path / "out", "fos")
    assert_brackets(found, "fos", SLAB_FACTOR, 0.002)
    assert found["parting_within_mass"] < 0.01 and "warning" not in result.stdout
    assert (tmp_path / "out/fos.png").read_bytes().startswith(b"\x89PNG")
    assert len((tmp_path / "out/fos.csv").read_text().splitlines()) == 1 + len(found["trials"])


@pytest.mark.parametrize("bedrock", ["continuum", "triangles"])
def test_a_wedge_of_rock_on_a_bedding_plane_fails_where_its_friction_does(hybrid, tmp_path, bedrock):
    dip, crest = np.radians(30), 20 / np.tan(np.radians(30))
    exact = np.tan(np.radians(35)) / np.tan(dip)
    (tmp_path / "wedge.geo").write_text(ROCK_WEDGE % crest)
    (tmp_path / "wedge.prm").write_text(PLANES.read_text().replace("../../meshes/joint_bar.geo", "wedge.geo"))
    settings = ["Mesh/Numbers=", "Bedding planes/Friction angle=35", "Continuum/Sides=viscous", "Monitors/Points=", f"Model/Bedrock={bedrock}"]
    words = [word for setting in settings for word in ("-s", setting)]
    result = hybrid("fos", tmp_path / "wedge.prm", "--output", tmp_path / "out", *around(exact), *words)
    assert result.returncode == 0, result.stderr
    assert_brackets(read(tmp_path / "out", "fos"), "fos", exact, 0.005)


def test_results_of_another_scene_are_not_replaced(hybrid, tmp_path):
    (tmp_path / "fos.json").write_text(json.dumps({"scene": "/elsewhere/scene.prm"}))
    result = hybrid("fos", SLAB, "--output", tmp_path)
    assert result.returncode == 2 and "holds results of '/elsewhere/scene.prm'" in result.stderr
    assert not (tmp_path / "fos.csv").exists()
    result = hybrid("fos", SLAB, "--output", tmp_path, "--force", "--range", "1.5", "2")
    assert "fails at its lower end" in result.stderr


@pytest.mark.parametrize("bedrock", ["continuum", "triangles"])
def test_a_level_layer_is_pushed_off_by_its_friction_on_every_bedrock(hybrid, tmp_path, bedrock):
    exact = np.tan(np.radians(15))
    settings = [f"Model/Bedrock={bedrock}", "Blocks/Belt material=", "Materials/rock/Friction angle=15",
                "Mesh/Numbers=Width = 10; Height = 20; Block height = 10; Resolution/h = 5"]
    result = hybrid("fos", ROOT / "parameters/verification/coupled_column.prm", "--yield", *around_yield(exact, 0.02), "--output", tmp_path / "out",
                    *[word for setting in settings for word in ("-s", setting)])
    assert result.returncode == 0, result.stderr
    found = read(tmp_path / "out", "yield")
    assert_brackets(found, "yield", exact, 0.02)
    assert found["parting_within_mass"] < 0.01  # the bedrock, which stays, is no part of the mass


def test_wedge_of_culmann(hybrid, tmp_path):
    (tmp_path / "wedge.geo").write_text(WEDGE)
    cohesion, phi, density = 30e3, np.radians(25), 2000.0
    scene = tmp_path / "wedge.prm"
    scene.write_text(SLAB.read_text().replace("../../meshes/bonded_blocks.geo", "wedge.geo"))
    settings = ["Mesh/Numbers=", f"Materials/belt/Cohesion={cohesion}", "Materials/belt/Tensile strength=1e9",
                "Monitors/Points="]
    words = [word for setting in settings for word in ("-s", setting)]
    b, face = np.radians(PLANE), np.radians(FACE)
    weight = density * 9.81 * HEIGHT**2 / 2 * (1 / np.tan(b) - 1 / np.tan(face))
    exact = (cohesion * HEIGHT / np.sin(b) + weight * np.cos(b) * np.tan(phi)) / (weight * np.sin(b))
    result = hybrid("fos", scene, "--output", tmp_path / "out", *around(exact), *words, cwd=tmp_path)
    assert result.returncode == 0, result.stderr
    assert_brackets(read(tmp_path / "out", "fos"), "fos", exact, 0.01)


DAM = """subsection Time
  set End time = 0
end
subsection Model
  set Bedrock = rigid
  set Blocks = loose
end
subsection Materials
  set Names = rock
  subsection rock
    set Density = 2400
    set Young modulus = 1e9
    set Poisson ratio = 0.2
    set Friction angle = 30
  end
end
subsection Blocks
  set Material = rock
end
subsection Mesh
  set Polygons file = dam.csv
  set Surface file = ground.csv
end
subsection Water
  set Line file = line.csv
  set Method = %s
end
"""


@pytest.mark.parametrize("gap", [0.3, 0.8])
def test_a_block_that_slides_against_a_stop_has_failed(hybrid, tmp_path, gap):
    """2 m wide, on a plane of 30 degrees that ends in a wall below it."""
    angle = np.radians(30)
    along, across = np.array([np.cos(angle), np.sin(angle)]), np.array([-np.sin(angle), np.cos(angle)])
    corners = [gap * along, (gap + 2) * along, (gap + 2) * along + 2 * across, gap * along + 2 * across]
    stop = (DAM % "paper").replace("  set Line file = line.csv\n", "").replace("dam.csv", "block.csv").replace("= 30", "= 20")
    (tmp_path / "stop.prm").write_text(stop)
    (tmp_path / "block.csv").write_text("block,x,y\n" + "".join("1,%.9g,%.9g\n" % tuple(corner) for corner in corners))
    (tmp_path / "ground.csv").write_text("x,y\n-6,10\n-5.99,3\n%.9g,%.9g\n0,0\n%.9g,%.9g\n" % (*(3 * across), *(40 * along)))
    exact = np.tan(np.radians(20)) / np.tan(angle)
    where = around(exact) if gap > 0.5 else ["--range", "0.6", "1", "--tolerance", "0.01"]
    result = hybrid("fos", tmp_path / "stop.prm", *where, "--output", tmp_path / "out")
    assert result.returncode == 0, result.stderr
    assert_brackets(read(tmp_path / "out", "fos"), "fos", exact, 0.005)


@pytest.mark.parametrize("method", ["submerged", "pressures"])
def test_a_dam_does_not_slide_out_of_the_thrust_of_its_water(hybrid, tmp_path, method):
    (tmp_path / "dam.prm").write_text(DAM % method)
    for name, rows in (("dam", "block,x,y\n1,0,0\n1,8,0\n1,2,10\n1,0,10\n"), ("ground", "x,y\n-50,0\n50,0\n"),
                       ("line", "x,y\n-50,9\n0,9\n8,0\n50,0\n")):
        (tmp_path / (name + ".csv")).write_text(rows)
    weight, uplift, thrust = 50 * 2400, 36 * 1000, 40.5 * 1000  # uplift and thrust of 9 m that fall to 0 over 8 m
    exact = (weight - uplift) * np.tan(np.radians(30)) / thrust
    result = hybrid("fos", tmp_path / "dam.prm", "--output", tmp_path / "out", *(around(exact) if method == "pressures" else []))
    assert result.returncode == 0, result.stderr
    found = read(tmp_path / "out", "fos")
    assert_brackets(found, "fos", exact, 0.005)
    assert found["jump_of_displacement"] > 100 and "warning" not in result.stdout


PUSH, FRICTION, DRY, WIDE = 0.2, np.tan(np.radians(30)), 8 * 10 * 2400, 8 * 1000  # weight [kg/m], buoyancy per level [kg/m2]


@pytest.fixture
def pushed_block(tmp_path):
    """A rectangle of 8 x 10 m on level ground, pushed by 0.2 of its weight, in water that rises from 0 to 5 m in 10 s."""
    scene = tmp_path / "pushed.prm"
    scene.write_text((DAM % "submerged").replace("Line file = line.csv", "Level file = level.csv") + """subsection Gravity
  set Horizontal coefficient = %g
end
subsection Motion
  set Type = text
  set File = along.txt
  set Peak = 1 m/s2
  set Vertical file = up.txt
  set Vertical peak = 0.5 m/s2
end
""" % PUSH)
    for name, rows in (("dam.csv", "block,x,y\n1,0,0\n1,8,0\n1,8,10\n1,0,10\n"), ("ground.csv", "x,y\n-50,0\n50,0\n"),
                       ("level.csv", "time,level\n0,0\n10,5\n"), ("along.txt", "0 0\n0.1 1\n0.2 0\n"), ("up.txt", "0 0\n0.1 1\n0.2 0\n")):
        (tmp_path / name).write_text(rows)
    return scene


@pytest.mark.parametrize("words, level, said", [
    ([], 0, "level 0 m (Water/Level file at 0 s; --time tells it at another time), Method submerged"),
    (["--time", "4"], 2, "level 2 m (Water/Level file at 4 s), Method submerged"),
    (["--time", "99"], 5, "level 5 m (Water/Level file at 99 s), Method submerged"),
    (["-s", "Water/Level file=", "-s", "Water/Level=3"], 3, "level 3 m, Method submerged")])
def test_a_factor_is_of_the_level_at_a_time_and_tells_it(hybrid, pushed_block, tmp_path, words, level, said):
    """A record of two components, which shakes nothing here, is in no one's way."""
    exact = (DRY - WIDE * level) * FRICTION / (PUSH * DRY)
    result = hybrid("fos", pushed_block, *words, *around(exact), "--output", tmp_path / "out")
    assert result.returncode == 0, result.stderr
    found = read(tmp_path / "out", "fos")
    assert_brackets(found, "fos", exact, 0.005)
    assert "water    " + said + "\n" in result.stdout and found["water"]["level_m"] == level


def test_a_slope_on_level_ground_is_pushed_downhill_and_a_wedge_on_it_both_ways(hybrid, tmp_path):
    """A triangle with a vertical back turns over its toe sooner than over its heel; a polygon has no mass_surface that falls."""
    wedge = DAM % "paper"
    wedge = wedge.replace("  set Line file = line.csv\n", "").replace("= 30", "= 80")
    (tmp_path / "wedge.prm").write_text(wedge)
    (tmp_path / "dam.csv").write_text("block,x,y\n1,0,0\n1,4,0\n1,0,10\n")
    (tmp_path / "ground.csv").write_text("x,y\n-50,0\n50,0\n")
    exact = (4 / 3) / (10 / 3)  # towards -x, about (0, 0)
    result = hybrid("fos", tmp_path / "wedge.prm", "--yield", *around_yield(exact, 0.02), "--output", tmp_path / "out")
    assert result.returncode == 0, result.stderr
    assert "pushed both ways, it stands towards +x and it fails at 0.4000 towards -x" in result.stdout
    assert_brackets(read(tmp_path / "out", "yield"), "yield", exact, 0.02)


def valley(folder, blocks, left, right=(40, 40 * np.tan(np.radians(25)))):
    """A scene of squares of 4 x 2 m on the flanks of a valley: (place along the flank [m], its angle [degrees], to the right positive)."""
    rows = "block,x,y\n"
    for k, (place, degrees) in enumerate(blocks):
        side, angle = np.sign(degrees), np.radians(abs(degrees))
        along, up = np.array([np.cos(angle), np.sin(angle)]), np.array([-np.sin(angle), np.cos(angle)])
        corners = np.array([place * along, (place + 4) * along, (place + 4) * along + 2 * up, place * along + 2 * up]) * [side, 1]
        rows += "".join("%d,%.9g,%.9g\n" % (k, *corner) for corner in corners[::int(side)])
    (folder / "blocks.csv").write_text(rows)
    (folder / "valley.csv").write_text("x,y\n%.9g,%.9g\n0,0\n%.9g,%.9g\n" % (*left, *right))
    scene = folder / "valley.prm"
    scene.write_text((DAM % "paper").replace("  set Line file = line.csv\n", "").replace("dam.csv", "blocks.csv").replace("ground.csv", "valley.csv"))
    return scene


def shake(hybrid, scene, directory):
    settings = ["Time/End time=5", "Time/Time step=0.001", "Gravity/Static stage=equilibrium", "Motion/Type=sine", "Motion/Frequency=1",
                "Motion/Peak=4", "Motion/Cycles=4", f"Output/Directory={directory}"]
    result = hybrid(scene, *[word for setting in settings for word in ("-s", setting)], *ONE_RUN, cwd=directory.parent)
    assert result.returncode == 0, result.stderr


def test_a_mass_below_a_higher_flank_is_pushed_downhill(hybrid, tmp_path):
    """Friction of 30 on a flank of 25 degrees; the flank opposite is higher."""
    scene = valley(tmp_path, [(12, 25)], (-60, 45))
    shake(hybrid, scene, tmp_path / "run")
    run, tan = Run(tmp_path / "run"), {degrees: np.tan(np.radians(degrees)) for degrees in (5, 25, 30)}
    assert run.downhill == -1 and not run.is_level and run.slips_downhill and not run.is_on_both_flanks
    assert run.summary["slip_m"]["mean_left"] > 0.1
    assert run.summary["base_shear"]["mobilised_at_rest"] == pytest.approx(tan[25] / tan[30], rel=1e-6)
    result = hybrid("fos", tmp_path / "run", "--newmark", "--output", tmp_path / "out", *around_yield(tan[5]))
    assert result.returncode == 0, result.stderr
    assert "pushed towards -x" in result.stdout
    found, newmark = read(tmp_path / "out", "yield"), read(tmp_path / "out", "newmark")
    assert_brackets(found, "yield", tan[5], 0.01)
    assert found["towards"] == newmark["towards"] == "-x"
    assert newmark["rate_on_surface"] == pytest.approx(np.cos(np.radians(5)) / np.cos(np.radians(30)), rel=1e-6)
    assert newmark["rigid_block_m"] == pytest.approx(newmark["coupled_mean_m"], rel=0.02)


def test_masses_on_both_flanks_slide_their_own_ways_and_are_pushed_both_ways(hybrid, tmp_path):
    scene = valley(tmp_path, [(12, 25), (24, -10)], (-150, 150 * np.tan(np.radians(10))))
    shake(hybrid, scene, tmp_path / "run")
    run = Run(tmp_path / "run")
    assert run.is_on_both_flanks and run.is_level and run.slips_downhill  # no direction of x is downhill of both
    assert list(run.downhill_of_soles) == [-1, 1] and list(run.get("slip/slide")) == [0, 1]
    left = run.get("slip/profile")[-1]
    assert left[0] > 0.1 and left[1] > -1e-3 and run.summary["slip_m"]["mean_left"] == pytest.approx(left.mean(), rel=1e-6)
    result = hybrid("fos", tmp_path / "run", "--newmark", "--output", tmp_path / "out")
    assert result.returncode == 0, result.stderr
    assert "slides lie on both flanks: pushed both ways" in result.stdout and "pushed towards -x" in result.stdout
    found, newmark = read(tmp_path / "out", "yield"), read(tmp_path / "out", "newmark")
    assert_brackets(found, "yield", np.tan(np.radians(5)), 0.01)
    assert found["towards"] == "-x" and found["other_way"] == pytest.approx(np.tan(np.radians(20)), rel=0.01)
    assert newmark["coupled_mean_m"] == pytest.approx(left[0], rel=1e-9)
    assert newmark["rigid_block_m"] == pytest.approx(newmark["coupled_mean_m"], rel=0.02)


def test_yield_coefficient_and_displacements_of_a_stiff_slab(hybrid, slab, tmp_path):
    exact = np.tan(np.radians(5))
    result = hybrid("fos", slab[0], "--newmark", "--output", tmp_path / "out", *around_yield(exact))
    assert result.returncode == 0, result.stderr
    assert_brackets(read(tmp_path / "out", "yield"), "yield", exact, 0.01)
    found = read(tmp_path / "out", "newmark")
    assert found["rate_on_surface"] == pytest.approx(np.cos(np.radians(5)) / np.cos(np.radians(25)), rel=1e-6)
    # a stiff slab is a rigid block: all three agree, but for what its yield coefficient is off
    for name in ("rigid_block_m", "decoupled_m"):
        assert found[name] == pytest.approx(found["coupled_mean_m"], rel=0.02)
    assert (tmp_path / "out/newmark.png").read_bytes().startswith(b"\x89PNG")


TOPPLING = """
subsection Time
  set Time step = 0.001
end
subsection Model
  set Bedrock = rigid
  set Blocks = loose
end
subsection Mesh
  set Polygons file = columns.csv
  set Surface file = ground.csv
end
subsection Blocks
  set Material = rock
end
subsection Gravity
  set Static stage = equilibrium
  set Acceleration = %.15g
  set Horizontal coefficient = %.15g
end
subsection Materials
  set Names = rock
  subsection rock
    set Density = %.15g
    set Young modulus = 20e9
    set Friction angle = 44.2435
  end
end
""" % (9.81 * np.cos(np.radians(20)), -np.tan(np.radians(20)), 25e3 / 9.81)


def test_columns_that_topple_have_another_equilibrium(hybrid, tmp_path):
    """Ten columns on a stepped base that dips 20 degrees, drawn turned: tan(phi) = 0.7492 by Goodman and Bray (1976), 1.30 times that here."""
    corners, ground = ["block,x,y"], ["x,y", "-100,0"]
    heights = (2, 4, 6.5, 9, 11.5, 13, 11, 8.5, 6, 3.5)
    for k, height in enumerate(heights):
        foot = 0.6 * k
        for x, y in ((0, 0), (3, 0), (3, height), (0, height)):
            corners.append("%d,%g,%g" % (k, 3 * k + x, foot + y))
        ground += ["%g,%g" % (3 * k, foot)] if k else ["0,0"]
        ground.append("%g,%g" % (3 * k + 3, foot))
    ground.append("90,5.4")
    (tmp_path / "columns.csv").write_text("\n".join(corners) + "\n")
    (tmp_path / "ground.csv").write_text("\n".join(ground) + "\n")
    (tmp_path / "columns.prm").write_text(TOPPLING)
    told = {}
    for ratio, low, high in ((1.0, "1.34", "1.6"), (0.3, "1.287", "1.313")):
        done = hybrid("fos", tmp_path / "columns.prm", "--range", low, high, "--tolerance", "0.0205", "--output", tmp_path / "out", "--force",
                      "-s", "Blocks/Shear ratio=%g" % ratio)
        assert done.returncode == 0, done.stderr
        told[ratio] = read(tmp_path / "out", "fos"), done.stdout
    assert told[0.3][0]["fos"] == pytest.approx(1.30, rel=0.01)
    assert told[1.0][0]["fos"] > 1.03 * told[0.3][0]["fos"]
    assert "with softer shear springs it fails at" in told[1.0][1] and 'repeat with -s "Blocks/Shear ratio=0.3"' in told[1.0][1]
    assert told[0.3][0]["stands_with_softer_shear"] and "softer shear springs" not in told[0.3][1]
    assert "flattens" not in told[1.0][1], "no column rests on a riser"


@pytest.mark.parametrize("words, part", [
    (["nowhere.prm"], "'nowhere.prm' is no parameter file"), ([SLAB, "--newmark"], "--newmark needs the output directory of a run"),
    ([SLAB, "--tolerance", "0"], "--tolerance is 0"), ([SLAB, "--time", "-1"], "--time is -1"),
    ([SLAB, "--time", "1"], "the water does not change in time"), ([SLAB, "--range", "2", "1"], "two rising factors"),
    ([SLAB, "-s", "Gravity/Acceleration=0"], "nothing settles: there is no gravity"),
    ([PLANES, "--yield"], "a scene without blocks has no sliding mass"),
    ([SLAB, "--range", "1.5", "2"], "fails at its lower end"), ([SLAB, "--yield", "--range", "0.1", "0.2"], "fails at its lower end, 0.1"),
    ([SLAB, "--range", "1", "1.1"], "stands at its upper end"),
    ([SLAB, "-s", "Time/No=1"], "Time/No")])
def test_mistakes_are_one_line(hybrid, tmp_path, words, part):
    result = hybrid("fos", *words, "--output", "out", cwd=tmp_path)
    assert result.returncode == 2 and part in result.stderr and result.stderr.count("\n") == 1, result.stderr
