# SPDX-License-Identifier: GPL-3.0-or-later
"""hybrid new: slopes from polylines are cut, meshed, checked and run; what cannot be is refused with its place."""
import re

import numpy as np
import pytest
from conftest import ONE_RUN

from hybrid_run import Run, UserError
from hybrid_tools.new.materials import Material, Slices, culmann
from hybrid_tools.new.mass import find_mass
from hybrid_tools.new.planes import refuse_crossings
from hybrid_tools.new.polylines import read_planes, read_profile
from hybrid_tools.new.record import Ricker, read_record
from hybrid_tools.new.section import Section

GROUND = np.array([(0, 10), (60, 12), (100, 20), (180, 58), (230, 70), (330, 72)], float)
SLIP = np.array([(95, 18), (110, 15), (140, 24), (180, 42), (205, 62)], float)
PLANES = [("A", np.array([(50, -15), (300, 48)], float)), ("B", np.array([(50, -35), (300, 28)], float))]


def section(ground=GROUND, slip=SLIP, planes=PLANES, frequency=2.0, h=None):
    notes = []
    return Section(np.array(ground, float), None if slip is None else np.array(slip, float), planes, Ricker(frequency), h, notes), notes


def mirrored(points):
    return np.column_stack([-np.asarray(points)[::-1, 0], np.asarray(points)[::-1, 1]])


def group_lengths(found):
    lengths = {}
    for edge, label in found.mesh.edges.items():
        lengths[label] = lengths.get(label, 0) + found.mesh.length(edge)
    return lengths


def area(found, faces):
    return sum(found.mesh.polygon(face).area for face in faces)


def write(path, points, head="", separator=","):
    path.write_text(head + "".join(separator.join("%.10g" % v for v in p) + "\n" for p in points))
    return path


def plane_table(path, planes):
    path.write_text("plane,x,y\n" + "".join("%s,%g,%g\n" % (name, *p) for name, points in planes for p in points))
    return path


def slope(hybrid, folder, *words, ground=GROUND, slip=SLIP, planes=PLANES):
    folder.mkdir(exist_ok=True)
    words = ["--profile", write(folder / "ground.csv", ground), *words, folder / "slope"]
    if slip is not None:
        words += ["--slip", write(folder / "slip.csv", slip)]
    if planes:
        words += ["--planes", plane_table(folder / "planes.csv", planes)]
    return hybrid("new", *words)


# ---- tables

@pytest.mark.parametrize("text, expected", [
    ("0,1\n2,3\n", [(0, 1), (2, 3)]), ("x;z\n0,5;1\n2;3,25\n", [(0.5, 1), (2, 3.25)]), ("# a survey\n0 1\n2\t3\n", [(0, 1), (2, 3)]),
    ("name,x,z\nP1,0,1\nP2,2,3\n", [(0, 1), (2, 3)]), ("z [m],x [m]\n1,0\n3,2\n", [(0, 1), (2, 3)]), ("0,1\n0,1\n2,3\n", [(0, 1), (2, 3)]),
    ("2,3\n0,1\n", [(0, 1), (2, 3)]), ("0,1\n5,0\n2,3\n", [(0, 1), (2, 3), (5, 0)]), ("\ufeff0,1\r\n2,3\r\n", [(0, 1), (2, 3)]),
    ("0,1\n0,4\n2,4\n", [(0, 1), (0, 4), (2, 4)])])
def test_profiles_of_any_kind_are_read(tmp_path, text, expected):
    path = tmp_path / "ground.csv"
    path.write_text(text, encoding="utf-8")
    assert read_profile(path, []).tolist() == [list(p) for p in expected]


@pytest.mark.parametrize("text, part", [
    ("x,z\n", "holds no rows"), ("0,1\n", "needs two"), ("0,1\n2,x\n", "line 2"), ("0,1\n2\n", "line 2"), ("1,0\n1,5\n", "all points have x = 1"),
    ("0,1\n5,0\n2,3\n2,4\n", "a cliff needs all points in the order"), ("0,1,2\n3,4,5\n", "a header that names"), ("0,1\n1,nan\n2,2", "line 2")])
def test_tables_that_say_nothing_are_refused_with_their_line(tmp_path, text, part):
    path = tmp_path / "ground.csv"
    path.write_text(text)
    with pytest.raises(UserError, match=re.escape(part)):
        read_profile(path, [])


@pytest.mark.parametrize("text", ["plane,x,y\nA,0,1\nA,2,3\nB,0,-1\nB,2,1\n", "0,1\n2,3\n\n0,-1\n2,1\n", "A;0;1\nA;2;3\nB;0;-1\nB;2;1\n"])
def test_planes_have_names_or_empty_lines_between_them(tmp_path, text):
    path = tmp_path / "planes.csv"
    path.write_text(text)
    assert [points.tolist() for _, points in read_planes(path)] == [[[0, 1], [2, 3]], [[0, -1], [2, 1]]]


def test_the_frequencies_of_records_are_those_of_their_waves(tmp_path):
    t = 0.01 * np.arange(4000)
    values = np.sin(2 * np.pi * 3 * t) * np.hanning(4000)
    path = write(tmp_path / "sine.txt", np.column_stack([t, values]), separator=" ")
    assert read_record(path).highest_frequency == pytest.approx(3, abs=0.1) and read_record(path).duration == pytest.approx(39.99)
    for head in ("A\nB\nG\nNPTS= 4000, DT= .0100 SEC,\n", "A\nB\nC\n4000 0.0100 NPTS, DT\n"):
        at2 = tmp_path / "r.at2"
        at2.write_text(head + "\n".join("%.7e" % v for v in values))
        assert read_record(at2).mean_frequency == pytest.approx(3, abs=0.05)


@pytest.mark.parametrize("comma, separator, is_known", [
    (False, ",", True), (True, ";", True), (True, "\t", True), (True, " ", True), (True, ",", False)])
def test_records_with_decimal_commas_are_read_as_the_program_reads_them(hybrid, tmp_path, comma, separator, is_known):
    rows = [(0.01 * k, 20 * np.sin(0.2 * k) * np.sin(np.pi * k / 300)) for k in range(301)]
    text = "# Zeit, Beschleunigung\n" + "".join("%.4f%s%.5f\n" % (t, "|", a) for t, a in rows)
    (tmp_path / "r.txt").write_text((text.replace(".", ",") if comma else text).replace("|", separator))
    if not is_known:
        with pytest.raises(UserError, match="line 2 is '0,0000,0,00000'"):
            read_record(tmp_path / "r.txt")
        return
    assert read_record(tmp_path / "r.txt").duration == pytest.approx(3)
    assert np.abs(read_record(tmp_path / "r.txt").values).max() == pytest.approx(20, rel=0.02)
    made = slope(hybrid, tmp_path, "--record", tmp_path / "r.txt", "--unit", "gal", slip=None, planes=None)
    card = hybrid("--check", tmp_path / "slope/scene.prm").stdout
    assert made.returncode == 0 and re.search(r"peak 0.[12][0-9]* m/s2", card), made.stderr + card


# ---- strengths

def test_the_factor_of_safety_of_a_planar_wedge_is_its_closed_form():
    angle, height, density = np.radians(30), 20.0, 2100.0
    ground = np.array([(-100, 0), (0, 0), (20, 20), (200, 20)], float)  # a slope of 45 degrees over a plane of 30
    mass = find_mass(np.array([(0, 0), (height / np.tan(angle), height)]), ground, [])
    weight = density * 9.81 * mass.polygon.area
    length = height / np.sin(angle)
    expected = (40e3 * length + weight * np.cos(angle) * np.tan(np.radians(25))) / (weight * np.sin(angle))
    assert Slices(mass, density).safety(25, 40e3) == pytest.approx(expected, rel=0.01)
    assert mass.falls_left and not find_mass(mirrored(mass.slip), mirrored(ground), []).falls_left


def test_a_vertical_wall_stands_with_the_cohesion_of_its_closed_form():
    assert culmann(90, 30) == pytest.approx(np.tan(np.radians(45 - 15)) / 4)  # critical height 4 c / gamma tan(45 + phi / 2)
    assert culmann(25, 30) == 0
    wall = find_mass(np.array([(0, 0), (20, 20)], float), np.array([(-50, 0), (0, 0), (0, 20), (50, 20)], float), [])
    assert wall.steepest > 85 and wall.polygon.area == pytest.approx(200)


# ---- sections

def test_the_section_is_whole_and_every_group_is_there():
    found, notes = section()
    lengths = group_lengths(found)
    width, height = found.right - found.left, found.ground[:, 1] - found.base
    assert lengths["base"] == pytest.approx(width) and lengths["left"] == pytest.approx(height[0]) and lengths["right"] == pytest.approx(height[-1])
    assert area(found, found.body_faces) == pytest.approx(found.mass.polygon.area, rel=1e-3)
    assert area(found, found.bedrock + found.body_faces) == pytest.approx(np.trapz(height, found.ground[:, 0]), rel=1e-3)
    for number, (_, points) in enumerate(PLANES, 1):
        assert lengths["bedding_%d" % number] == pytest.approx(np.hypot(*np.diff(points, axis=0)[0]), rel=1e-3)
    assert len(found.bedrock) == 3 and len(found.body_faces) == 1
    assert sum("extended by" in note for note in notes) == 2


@pytest.mark.parametrize("shift", [(0, 0), (5e5, 3e3), (-1e4, -200)])
def test_slopes_to_either_side_in_any_origin_are_the_same(shift):
    shifted = [(name, points + shift) for name, points in PLANES]
    first = group_lengths(section(GROUND, SLIP, PLANES)[0])
    moved = group_lengths(section(GROUND + shift, SLIP + shift, shifted)[0])
    turned = group_lengths(section(mirrored(GROUND + shift), mirrored(SLIP + shift), [(n, mirrored(p)) for n, p in shifted])[0])
    turned["left"], turned["right"] = turned["right"], turned["left"]
    assert moved == pytest.approx(first, rel=1e-4) and turned == pytest.approx(first, rel=1e-4)


def test_a_slip_line_beyond_the_ground_is_cut_there():
    found, notes = section(slip=[(80, 30), (110, 15), (140, 24), (180, 42), (220, 80)])
    for x, y in found.slip[[0, -1]]:
        assert y == pytest.approx(np.interp(x, found.ground[:, 0], found.ground[:, 1]), abs=1e-6)
    assert sum("was cut at the ground" in note for note in notes) == 2


@pytest.mark.parametrize("slip, part", [
    ([(95, 30), (140, 60), (200, 90)], "highest point is (200, 90) m, the ground there at y = 62.8 m"),
    ([(95, 18), (110, 15), (140, 60), (180, 42), (205, 62)], "above the ground between (1"), ([(95, 18), (180, 30), (120, 5), (150, 40)], "crosses itself"),
    ([(95, -60), (205, -60)], "does not reach it straight on"), ([(400, 0), (500, 5)], "above the ground or beside it"),
    ([(100, 20), (140, 38.9), (180, 58)], "thick at most")])
def test_slip_lines_that_bound_no_mass_are_refused_with_their_place(slip, part):
    with pytest.raises(UserError, match=re.escape(part)):
        section(slip=slip)


def test_planes_are_cut_where_they_leave_the_bedrock():
    crossing = [("through the mass", np.array([(-50, -20), (140, 30), (300, 66)], float)), ("out of the ground", np.array([(0, -40), (330, 90)], float))]
    found, notes = section(planes=crossing[:1])
    assert len([1 for _, number, _ in found.planes if number == 1]) == 2 and any("were left out" in note for note in notes)
    found, _ = section(planes=crossing[1:])
    top = found.planes[-1][2][-1]
    assert top[1] == pytest.approx(np.interp(top[0], found.ground[:, 0], found.ground[:, 1]), abs=1e-6)
    with pytest.raises(UserError, match="lies nowhere in the bedrock"):
        section(planes=[("sky", np.array([(0, 100), (300, 120)], float))])


@pytest.mark.parametrize("start, end", [(-900, 150), (150, 900), (-900, 900), (-200, 600), (-195, 150)])
def test_planes_may_reach_the_ends_of_the_profile(start, end):
    """Its ends are the sides here, as the profile is long; a tip a little inside goes straight on."""
    left, right = -200, 600
    found, notes = section(ground=np.vstack([[(left, 10)], GROUND, [(right, 72)]]), planes=[("p", np.array([(start, 0.02 * start), (end, 0.02 * end)], float))])
    assert (found.left, found.right) == (left, right) and not any("level ground" in note for note in notes)
    kept = min(end, right) - max(start, left)
    assert len(found.bedrock) == 2 and group_lengths(found)["bedding_1"] == pytest.approx(kept * np.hypot(1, 0.02), rel=0.02)
    for x in [left] * (start < left + 10) + [right] * (end >= right):
        heights = [y for at, y in found.mesh.points if at == x]
        assert min(abs(y - 0.02 * x) for y in heights) < 1e-3


def test_a_plane_along_a_side_is_refused():
    with pytest.raises(UserError, match="p runs 0 m beside the right side at"):
        section(ground=np.vstack([GROUND, [(800, 72)]]), planes=[("p", np.array([(800, -20), (800, 20)], float))])


def test_planes_that_cross_are_refused_and_one_may_end_on_another():
    a, b = np.array([(0, 0), (100, 10)], float), np.array([(0, 10), (100, 0)], float)
    with pytest.raises(UserError, match=re.escape("a and b cross at (50, 5) m")):
        refuse_crossings([("a", 1, a), ("b", 2, b)])
    refuse_crossings([("a", 1, a), ("b", 2, np.array([(50, 5), (100, -50)], float))])


@pytest.mark.parametrize("angle", [0, 15, 40, 70, 90, 120, 165])
def test_a_plane_of_any_dip_divides_the_bedrock_and_leaves_the_base_whole(angle):
    along = 60 * np.array([np.cos(np.radians(angle)), np.sin(np.radians(angle))])
    middle = np.array([(250.0, 0.0)])
    points = np.vstack([middle - 0.4 * along, middle + 0.4 * along])
    found, _ = section(planes=[("p", points if points[1, 0] > points[0, 0] else points[::-1])])
    assert len(found.bedrock) == 2
    bottom = [face for face in found.bedrock if any(found.mesh.edges[e] == "base" for e in edges_of(face))]
    assert len(bottom) == 1 and group_lengths(found)["bedding_1"] == pytest.approx(48, rel=1e-3)


@pytest.mark.parametrize("depth, is_refused", [(0.2, True), (1.0, False)])
def test_a_lid_of_rock_thinner_than_elements_is_told_or_refused_with_its_place(depth, is_refused):
    below = [("p", np.array([(105, 15), (110, 15), (140, 24), (180, 42), (200, 58)], float) - [0, depth])]
    if not is_refused:
        assert any("are distorted" in note for note in section(planes=below)[1])
        return
    with pytest.raises(UserError, match=r"p runs 0.[0-9]+ m beside the slip line at \(1[0-9.]+, [0-9.]+\) m"):
        section(planes=below)


def test_a_plane_that_the_mass_slides_on_goes_on_behind_it():
    """The slip line is a piece of a bedding plane and a scarp: the plane goes on from its corner to the ground."""
    ground = GROUND
    plane = np.array([(100, 20), (300, 80)], float)
    slip = np.array([(100, 20), (120, 26), (180, 44), (206, 62)], float)
    found, notes = section(ground, slip, [("p", plane)])
    assert any("83.5 m of it on the slip line were left out" in note for note in notes)
    (_, _, points), = found.planes
    assert points[0] == pytest.approx((180, 44)) and points[-1][1] == pytest.approx(np.interp(points[-1][0], *ground.T))
    assert group_lengths(found)["bedding_1"] == pytest.approx(np.hypot(*(points[-1] - points[0])), rel=1e-3) and len(found.bedrock) == 2
    with pytest.raises(UserError, match="p coincides with the slip line: leave it out"):
        section(planes=[("p", SLIP)])


@pytest.mark.parametrize("slip", [None, SLIP * [0.2, 0.2]])
def test_rock_far_from_a_low_slope_has_elements_by_wavelength(slip):
    found, _ = section(ground=GROUND * [0.2, 0.2], slip=slip, planes=[])
    waves = 0.7 * 2 * found.rock.s_wave_speed / (10 * found.record.highest_frequency)
    assert found.ground_size < 3 and found.far == pytest.approx(waves, rel=0.1)
    at_foot, below = found.size_at(20, 4), found.size_at(20, found.base)
    assert at_foot < 3.1 and below == pytest.approx(min(found.far, at_foot + 0.15 * (4 - found.base)), rel=0.1)


def edges_of(face):
    return [(min(a, b), max(a, b)) for a, b in zip(face, face[1:] + face[:1])]


def test_a_survey_with_a_point_every_half_metre_makes_no_tiny_edges():
    x = np.arange(0, 330, 0.5)
    rng = np.random.default_rng(1)
    found, notes = section(ground=np.column_stack([x, np.interp(x, *GROUND.T) + 0.05 * rng.standard_normal(len(x))]))
    assert min(found.mesh.length(edge) for edge in found.mesh.edges) > 0.2 * found.h
    assert any("points were left out" in note for note in notes)


@pytest.mark.parametrize("slip", [None, [(62, 3), (100, 24)]])
def test_benches_shorter_than_elements_are_kept(slip):
    benches = np.array([(0, 0), (60, 0), (64, 6), (66, 6), (70, 12), (72, 12), (76, 18), (78, 18), (82, 24), (130, 24)], float)
    found, notes = section(benches, slip, [])
    assert found.h > 2 / 0.8
    for corner in benches[1:-1]:
        assert np.hypot(*(found.ground - corner).T).min() < 1e-9, corner
    assert not [note for note in notes if "moves" in note]
    if slip:
        assert found.mass.polygon.area == pytest.approx(180, rel=1e-9)
        assert found.belt.safety == pytest.approx(1.52, abs=0.01)


def test_a_toe_beside_the_slip_line_is_kept():
    """A wedge on a plane: its factor of safety is the closed form."""
    found, _ = section([(0, 0), (60, 0), (90, 20), (160, 24), (220, 26)], [(61.5, 1), (110, 21.5)], [])
    assert np.hypot(*(found.ground - (60, 0)).T).min() < 1e-9
    weight, angle = found.body.density * 9.81 * found.mass.polygon.area, np.arctan2(20.5, 48.5)
    length = np.hypot(*(found.slip[-1] - found.slip[0]))
    closed = (weight * np.cos(angle) * np.tan(np.radians(25)) + found.belt.cohesion * length) / (weight * np.sin(angle))
    assert found.belt.safety == pytest.approx(closed, rel=2e-3)


def test_thin_masses_get_smaller_blocks_and_the_user_is_told():
    found, notes = section(slip=[(100, 20), (110, 22), (160, 45), (180, 58)], planes=[])
    assert found.h <= found.mass.thickest[0] / 2.4 and any("only" in note and "thick" in note for note in notes)
    assert Material(2500, 10e9, 0.25).s_wave_speed == pytest.approx(np.sqrt(4e9 / 2500))


# ---- with the program

def test_a_slope_is_checked_without_warnings_and_runs_on_every_bedrock(hybrid, tmp_path):
    made = slope(hybrid, tmp_path)
    assert made.returncode == 0 and "warning" not in made.stdout + made.stderr, made.stdout + made.stderr
    assert "processor time" in made.stdout and "bedding_2 is B" in made.stdout
    scene = tmp_path / "slope/scene.prm"
    assert "warning" not in hybrid("--check", scene).stdout
    for bedrock in ("continuum", "triangles", "layers", "rigid"):
        words = [scene, "-s", "Model/Bedrock=" + bedrock, "-s", "Time/End time=0.02", "-s", "Output/Directory=%s/%s" % (tmp_path, bedrock), *ONE_RUN]
        ran = hybrid(*words, *(["-s", "Continuum/Sides=viscous"] if bedrock == "layers" else []))
        assert ran.returncode == 0 and Run(tmp_path / bedrock).summary["joints"]["shear"] == 0, ran.stdout + ran.stderr
    assert set(Run(tmp_path / "continuum").monitors) >= {"S1", "S7", "D1", "D3", "B1"}


def test_a_mass_that_is_soft_for_its_height_gets_strengths_that_hold_it(hybrid, tmp_path):
    ground = [(8900, 345), (9390, 326), (9440, 322), (10000, 0), (11300, 0)]
    slip = [(9380, 330), (9550, 80), (9715, -55), (9880, -80), (10045, 5)]
    made = slope(hybrid, tmp_path, "--frequency", "1", ground=ground, slip=slip, planes=None)
    assert made.returncode == 0 and float(re.search(r"factor of safety at rest ([\d.]+)", made.stdout)[1]) > 1.55, made.stdout
    ran = hybrid(tmp_path / "slope/scene.prm", "-s", "Time/End time=0", "-s", "Output/Directory=%s/out" % tmp_path, *ONE_RUN)
    assert ran.returncode == 0, ran.stdout


@pytest.mark.parametrize("turn", [False, True])
def test_a_slope_without_mass_carries_waves(hybrid, tmp_path, turn):
    made = slope(hybrid, tmp_path, "--frequency", "4", ground=mirrored(GROUND) if turn else GROUND, slip=None, planes=None)
    assert made.returncode == 0 and "warning" not in made.stdout, made.stdout + made.stderr
    assert hybrid(tmp_path / "slope/scene.prm", "-s", "Time/End time=0.02", "-s", "Output/Directory=%s/out" % tmp_path, *ONE_RUN).returncode == 0


def test_a_directory_is_not_replaced_without_force(hybrid, tmp_path):
    (tmp_path / "slope").mkdir()
    mine = tmp_path / "slope/mine.txt"
    mine.write_text("mine")
    refused = slope(hybrid, tmp_path)
    assert refused.returncode == 2 and "--force" in refused.stderr and not (tmp_path / "slope/scene.prm").exists()
    assert slope(hybrid, tmp_path, "--force").returncode == 0 and mine.read_text() == "mine"


def test_what_is_refused_leaves_nothing_and_replaces_nothing(hybrid, tmp_path):
    refused = slope(hybrid, tmp_path, "--size", "30")
    assert refused.returncode == 2 and "--size is 30 m, but the mass is only 16 m thick" in refused.stderr and not (tmp_path / "slope").exists()
    (tmp_path / "r.txt").write_text("".join("%g %g\n" % (0.01 * k + 0.05 * (k > 50), np.sin(k)) for k in range(100)))
    words = ["--record", tmp_path / "r.txt", "--unit", "g"]
    refused = slope(hybrid, tmp_path, *words)
    assert refused.returncode == 2 and "r.txt:52: the spacing" in refused.stderr and refused.stderr.count("\n") == 1
    assert not (tmp_path / "slope").exists()
    assert slope(hybrid, tmp_path).returncode == 0
    before = (tmp_path / "slope/scene.prm").read_text()
    assert slope(hybrid, tmp_path, "--force", *words).returncode == 2 and (tmp_path / "slope/scene.prm").read_text() == before


@pytest.mark.parametrize("words, part", [
    ([], "--profile"), (["--profile", "nowhere.csv", "d"], "cannot read 'nowhere.csv'"), (["--profile", "g.csv", "--size", "-1", "d"], "must be positive"),
    (["--profile", "g.csv", "--record", "r.txt", "d"], "--unit g, m/s2, cm/s2 or gal"), (["--profil", "g.csv", "d"], "--profile")])
def test_mistakes_are_one_line(hybrid, tmp_path, words, part):
    write(tmp_path / "g.csv", GROUND)
    write(tmp_path / "r.txt", [(0.01 * k, np.sin(k)) for k in range(100)], separator=" ")
    result = hybrid("new", *words, cwd=tmp_path)
    assert result.returncode == 2 and part in result.stderr and result.stderr.count("\n") == 1, result.stderr
    assert not (tmp_path / "d").exists()


@pytest.mark.parametrize("flip", [False, True])
@pytest.mark.parametrize("h", [None, 7.3, 6.0, 3.0])
def test_a_slip_line_that_ends_on_a_corner_of_the_ground_bounds_the_mass(h, flip):
    """A straight last piece passes the corner by round-off."""
    ground = np.array([(0, 60), (80, 60), (110, 45), (125, 45), (165, 20), (230, 20)], float)
    slip = np.array([(72, 60), (95, 42), (130, 24), (165, 20)], float)
    found, _ = section(*(map(mirrored, (ground, slip)) if flip else (ground, slip)), [], 3.0, h)
    assert area(found, found.body_faces) == pytest.approx(found.mass.polygon.area, rel=0.02)


def test_records_are_read_as_the_program_reads_them(tmp_path):
    rows = ["%g %s" % (0.01 * k, ("%.3e" % np.sin(k)).replace("e", "D")) for k in range(40)]
    (tmp_path / "a.txt").write_text("\n".join(["Station KJMA", "time acc", *rows]))
    found = read_record(str(tmp_path / "a.txt"))
    assert found.dt == pytest.approx(0.01) and len(found.values) == 40 and np.ptp(found.values) == pytest.approx(2, rel=0.01)
    (tmp_path / "ms.txt").write_text("\n".join("%g %g" % (10 * k, np.sin(k)) for k in range(40)))
    with pytest.raises(UserError, match="10 s apart.*in ms, divide them by 1000"):
        read_record(str(tmp_path / "ms.txt"))
