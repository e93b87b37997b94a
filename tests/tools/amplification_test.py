# SPDX-License-Identifier: GPL-3.0-or-later
"""hybrid amplification against closed forms: level ground, an elastic joint, layered columns."""
import csv
import json

import h5py
import numpy as np
import pytest
from conftest import ONE_RUN, ROOT

from hybrid_run import Layer, Run, konno_ohmachi, motion_in_column, transfer_function
from hybrid_tools.amplification import quantities, section_map

SCENES = ROOT / "parameters/verification"


@pytest.fixture(scope="module")
def run(hybrid, tmp_path_factory):
    """run(scene, "Section/Name=value", ...): directory of a run of a verification scene."""
    def make(scene, *settings):
        directory = tmp_path_factory.mktemp("run") / "out"
        words = [word for setting in settings for word in ("-s", setting)]
        result = hybrid(SCENES / scene, *words, *ONE_RUN, "-s", "Output/Picture interval=0", "-s", f"Output/Directory={directory}")
        assert result.returncode == 0, result.stderr
        return directory

    return make


@pytest.fixture(scope="module")
def level_ground(run):
    """A layer on a half space, 2 Hz Ricker, S wave from below, free-field sides."""
    return run("soft_layer.prm", "Time/End time=10", "Time/Time step=0.005",
               "Mesh/Numbers=Width = 40; Height = 200; Layer height = 60; Resolution/h = 10",
               "Continuum/Rayleigh mass=1", "Continuum/Rayleigh stiffness=0.003", "Motion/Frequency=2",
               "Monitors/Line interval=0.01", "Monitors/Points=surface: 5, 200",
               "Monitors/Lines=ground; left; shaft: 20, 200, 20, 0")


@pytest.fixture(scope="module")
def bar(run):
    """A P wave through a joint; it has not come back from the end of the bar when the run ends."""
    return run("elastic_joints.prm", "Time/End time=1.1", "Time/Time step=0.001", "Continuum/Degree=4", "Motion/Angle=90", "Motion/Frequency=8",
               "Mesh/Numbers=Lying = 0; Length = 1500; Width = 20; Planes = 1; First plane = 200; Resolution/h = 20",
               "Bedding planes/Normal stiffness=1e8", "Monitors/Points=end: 10, 1500", "Monitors/Lines=bedding_1", "Monitors/Line interval=0")


def amplification(hybrid, directory, *words):
    result = hybrid("amplification", directory, *words)
    assert result.returncode == 0, result.stderr
    return result.stdout, json.loads((directory / "amplification/table.json").read_text())


def test_a_run_that_ends_while_the_ground_shakes_is_told(hybrid, run):
    directory = run("soft_layer.prm", "Time/End time=0.9", "Time/Time step=0.005",
                    "Mesh/Numbers=Width = 40; Height = 100; Layer height = 60; Resolution/h = 10", "Motion/Frequency=2", "Monitors/Points=surface: 5, 100", "Monitors/Lines=ground")
    text, _ = amplification(hybrid, directory, "--no-figures")
    assert "warning    ground still shakes with 100 % of its largest acceleration as the run ends" in text


def test_a_line_at_rest_and_one_of_two_points_are_told_and_drawn_without_a_warning(hybrid, run):
    directory = run("soft_layer.prm", "Time/End time=3", "Time/Time step=0.005", "Mesh/Numbers=Width = 40; Height = 100; Layer height = 60; Resolution/h = 10",
                    "Motion/Frequency=2", "Monitors/Points=surface: 5, 100", "Monitors/Lines=ground; left; crack: 5, 10, 35, 95")
    with h5py.File(directory / "run.h5", "a") as file:
        for name in ("displacement", "acceleration"):
            file["lines/left/on/" + name][...] = 0
    result = hybrid("amplification", directory)
    assert result.returncode == 0 and result.stderr == ""  # no word of numpy or matplotlib
    assert "warning    left does not move" in result.stdout and "crack has 2 points" in result.stdout
    drawn = {path.stem for path in (directory / "amplification").glob("*.png")}
    assert {"wiggles_ground", "ratios_ground", "profile_left", "points"} <= drawn and not {"wiggles_left", "ratios_left"} & drawn
    points, values = section_map.in_pieces(np.array([(0.0, 0.0), (30.0, 40.0)]), np.array([1.0, 2.0]))
    assert len(points) >= 100 and values == pytest.approx(1 + np.hypot(*points.T) / 50)


def test_ratios_to_next_to_nothing_are_left_out_and_the_table_says_where(hybrid, level_ground):
    """A Ricker wavelet of f_0 has over 5 % of its largest amplitude where x^2 exp(1 - x^2) > 0.05, x = f / f_0: from 0.137 to 2.4 f_0."""
    text, table = amplification(hybrid, level_ground, "--no-figures")
    assert table["least_outcrop_amplitude"] == 0.05
    assert table["ratios_from_hz"] == pytest.approx(2 * 0.137, rel=0.15) and table["ratios_to_hz"] == pytest.approx(2 * 2.4, rel=0.06)
    assert "spectral ratios are told where the outcrop has over 5 % of its largest amplitude: within " in text
    with open(level_ground / "amplification/spectral_ratios.csv", encoding="utf-8", newline="") as file:
        head, first, *_ = csv.reader(file)
    cells = {float(name.split()[0]): cell for name, cell in zip(head[3:], first[3:])}
    assert all((cell == "") == (not table["ratios_from_hz"] * 0.999 <= f <= table["ratios_to_hz"] * 1.001) for f, cell in cells.items())


def test_what_differs_across_a_plane_at_rest_is_nothing():
    assert quantities.largest_difference(np.zeros(3), np.zeros(3)) == 0
    assert quantities.largest_difference(np.array([1.1, 0.0]), np.array([1.0, 0.0])) == pytest.approx(0.1)


def test_level_homogeneous_ground_shakes_as_an_outcrop(hybrid, run):
    directory = run("soft_layer.prm", "Time/End time=2.5", "Time/Time step=0.005", "Mesh/Numbers=Width = 40; Height = 100; Resolution/h = 10",
                    "Continuum/Materials=rock", "Continuum/Rayleigh mass=0", "Continuum/Rayleigh stiffness=0", "Motion/Frequency=2",
                    "Motion/Meaning=incident", "Monitors/Points=surface: 5, 100", "Monitors/Lines=ground")
    text, numbers = amplification(hybrid, directory, "--no-figures")
    assert "still shakes" not in text
    side = numbers["sides"][0]
    assert side["mean"] == pytest.approx(1.0, abs=0.01) and side["largest"]["ratio"] == pytest.approx(1.0, abs=0.01)
    assert side["largest_spectral_ratio"]["ratio"] == pytest.approx(1.0, abs=0.01)
    assert side["smallest_spectral_ratio"]["ratio"] == pytest.approx(1.0, abs=0.01)
    assert numbers["outcrop_peak_m_s2"] == pytest.approx(2.0, rel=0.02)  # twice the incident wave, below the low-pass
    assert numbers["component"] == "x" and "ground" in text and "1.00" in text


def test_a_joint_lets_through_what_schoenberg_says(bar):
    line = Run(bar).lines["bedding_1"]
    frequency = np.array([4.0, 6.0, 8.0, 11.0, 14.0])
    omega, impedance, stiffness = 2 * np.pi * frequency, np.sqrt(2000 * 6e9), 1e8
    transmitted = 1 / np.sqrt(1 + (omega * impedance / (2 * stiffness)) ** 2)  # Schoenberg (1980)
    above = line.spectral_ratio("above", 1, frequency, 200)[:, 0]
    below = line.spectral_ratio("below", 1, frequency, 200)[:, 0]
    assert 2 * above == pytest.approx(transmitted, rel=0.02)  # the outcrop motion is twice the incident one
    reflected = 1 - 1 / (1 + 1j * omega * impedance / (2 * stiffness))
    assert 2 * below == pytest.approx(np.abs(1 + reflected), rel=0.02)
    assert (above / below == pytest.approx(transmitted / np.abs(1 + reflected), rel=0.02))


def test_what_a_plane_bears_is_its_stiffness_times_its_jump(hybrid, bar):
    _, numbers = amplification(hybrid, bar, "--no-figures")
    run = Run(bar)
    jump = run.lines["bedding_1"].jump()
    assert numbers["jumps"][0]["largest_opening_m"] == pytest.approx(jump[:, :, 1].max(), rel=1e-6) and jump[:, :, 1].max() > 1e-6
    assert np.abs(jump[:, :, 0]).max() < 1e-6 * np.abs(jump[:, :, 1]).max() + 1e-9  # a P wave along the bar shears nothing
    # dp/dt of what goes up: the stress behind the joint is rho c v of the transmitted wave
    velocity = np.cumsum(run.lines["bedding_1"].acceleration("above")[:, 0, 1]) * 1e-3
    assert 1e8 * np.abs(jump[:, 0, 1]).max() == pytest.approx(np.sqrt(2000 * 6e9) * np.abs(velocity).max(), rel=0.02)


def test_a_run_over_a_level_layer_is_its_column(level_ground):
    run = Run(level_ground)
    frequency, fine = np.linspace(0.5, 4.5, 30), np.linspace(0.01, 6, 2000)
    for name, point in (("ground", 0), ("shaft", 0), ("left", 3)):
        line = run.lines[name]
        ratio = line.spectral_ratio("on", 0, frequency, 150)[:, point]
        column = konno_ohmachi(fine, motion_in_column(run, line.position[point], fine), frequency, 150)
        assert ratio == pytest.approx(column, rel=0.03), (name, point)
    ground = run.lines["ground"].spectral_ratio("on", 0, frequency, 150)
    assert np.ptp(ground, axis=1) == pytest.approx(0, abs=0.01)  # the same everywhere
    assert motion_in_column(run, (20, 200), frequency).max() > 1.4


def test_the_column_is_that_of_the_textbook():
    frequency = np.linspace(0.1, 20, 50)
    soil = Layer(20.0, 1800.0, 1800.0 * 200**2)
    rock = Layer(50.0, 2400.0, 2400.0 * 1000**2)
    k, ratio = 2 * np.pi * frequency / 200, 1800 * 200 / (2400 * 1000)
    expected = 1 / np.sqrt(np.cos(20 * k) ** 2 + (ratio * np.sin(20 * k)) ** 2)  # Kramer (1996), eq. 7.28
    assert np.abs(transfer_function([soil, rock], frequency)[0]) == pytest.approx(expected, rel=1e-9)
    assert np.abs(transfer_function([soil], frequency, half_space=rock)[0]) == pytest.approx(expected, rel=1e-9)
    rigid = 1 / np.abs(np.cos(20 * k))  # on a rigid base
    assert np.abs(transfer_function([soil], frequency, is_rigid=True)[0]) == pytest.approx(rigid, rel=1e-9)
    whole, parts = transfer_function([rock], frequency), transfer_function([Layer(20.0, 2400.0, 2.4e9), Layer(30.0, 2400.0, 2.4e9)], frequency)
    assert whole[0] == pytest.approx(parts[0]) and np.abs(whole[0]) == pytest.approx(1.0)
    # below a joint the surface reflects all: energy that comes up is energy that goes down, at any stiffness
    joint = Layer(10.0, 2400.0, 2.4e9, joint=1e8)
    motions = transfer_function([joint, rock], frequency)
    w = 2 * np.pi * frequency
    outcrop_free = np.abs(motions[0])
    stiffness_of_mass = np.tan(w / 1000 * 10) * 2400 * 1000 * w  # the layer as seen from the joint: -stress / u
    top_over_bottom = 1 / np.cos(w / 1000 * 10)
    jump = 1 / (1 - stiffness_of_mass / 1e8)  # u above over u below
    assert outcrop_free == pytest.approx(np.abs(top_over_bottom * jump * motions[1] ), rel=1e-9)


def test_a_layer_with_maxwell_damping_has_one_ratio_and_the_speed_of_its_middle():
    layer, w = Layer(10.0, 2000.0, 2e9, ratio=0.05, middle=2.0), 2 * np.pi * np.array([0.5, 2.0, 8.0])
    factor = layer.stiffness_factor(w)
    assert factor.imag / factor.real == pytest.approx(0.1)  # 1/Q
    speed = 1 / (1 / np.sqrt(factor)).real  # of phases, over that of the modulus
    assert speed == pytest.approx(4.0 ** (np.arctan(0.1) / np.pi * np.array([-1, 0, 1])))  # Kjartansson (1979): c ~ f^g


def test_figures_and_tables_hold_the_same_numbers(hybrid, level_ground):
    text, numbers = amplification(hybrid, level_ground)
    directory = level_ground / "amplification"
    for name in ("section", "profile_ground", "ratios_shaft", "points", "wiggles_ground", "peak_acceleration"):
        assert (directory / (name + ".png")).read_bytes().startswith(b"\x89PNG\r\n\x1a\n")
    with open(directory / "table.csv", encoding="utf-8") as rows:
        table = list(csv.DictReader(rows))
    ground = [float(row["peak a_x / outcrop [-]"]) for row in table if row["line"] == "ground"]
    assert max(ground) == pytest.approx(numbers["sides"][0]["largest"]["ratio"], rel=1e-6)
    assert "%.2f" % max(ground) in text


def test_peaks_at_nodes_are_those_of_the_lines(level_ground):
    run = Run(level_ground)
    line, nodes = run.lines["shaft"], run.get("fields/nodes/position")
    for point in (0, 1):
        node = np.hypot(*(nodes - line.position[point]).T).argmin()
        history = np.abs(line.acceleration("on")[:, point, 0]).max()
        assert run.get("fields/nodes/peak_acceleration")[node, 0] == pytest.approx(history, rel=0.02)
    assert (run.get("fields/nodes/peak_slip") == 0).all()


def test_the_jump_across_the_sliding_surface_is_the_slip_of_its_soles(run, tmp_path):
    (tmp_path / "lines.csv").write_text("name,x,z\ncrest,8,20\ncrest,12,20\nshaft,2.5,15\nshaft,2.5,10.5\nshaft,2.5,5\n")
    result = Run(run("restart_coupled.prm", "Motion/Peak=18", "Monitors/Lines=sliding_surface", "Monitors/Line points=9", "Monitors/Line interval=0",
                     f"Monitors/Lines file={tmp_path / 'lines.csv'}"))
    assert list(result.lines) == ["crest", "shaft", "sliding_surface"] and result.lines["shaft"].distance[-1] == 10
    line = result.lines["sliding_surface"]
    soles, slip = result.get("slip/position")[:, 0], result.get("slip/profile")[-1]
    jump = line.jump()[-1, :, 0]
    middles = [np.abs(line.position[:, 0] - x).argmin() for x in soles]
    assert len(set(middles)) == 4 and np.abs(jump).max() > 1e-3
    assert line.position[middles, 0] == pytest.approx(soles, abs=1e-9)
    assert jump[middles] == pytest.approx(slip, abs=1e-6)
    ground = result.monitors["ground"]  # a point of the bedrock, on the step's end as the lines
    assert len(line.time) == len(result.time) and np.ptp(ground.acceleration[:, 0]) > 0


def test_how_amplification_depends_on_a_parameter(hybrid, run, bar):
    other = run("elastic_joints.prm", "Time/End time=0.4", "Time/Time step=0.002", "Motion/Angle=90", "Motion/Frequency=8",
                "Mesh/Numbers=Lying = 0; Length = 1500; Width = 50; Planes = 1; First plane = 200; Resolution/h = 50",
                "Bedding planes/Normal stiffness=1e12", "Monitors/Points=end: 25, 1500", "Monitors/Lines=bedding_1")
    result = hybrid("amplification", bar, other, "--against", "Bedding planes/Normal stiffness")
    assert result.returncode == 0, result.stderr
    found = json.loads((bar / "amplification/sensitivity.json").read_text())
    soft, hard = (next(r for r in found["rows"] if r["value"] == k and r["side"] == "above") for k in (1e8, 1e12))
    assert soft["mean"] < 0.9 * hard["mean"] and hard["mean"] == pytest.approx(0.5, abs=0.02)  # the incident wave is half of the outcrop motion
    assert "Bedding planes/Normal stiffness [Pa/m]" in result.stdout
    assert (bar / "amplification/sensitivity.png").stat().st_size > 1000


@pytest.mark.parametrize("words, part", [
    (["--lines", "grund"], "no line 'grund' (did you mean 'ground'?)"), (["--component", "z"], "invalid choice: 'z'"),
    (["--component", "y"], "is along x alone"),
    (["--bandwidth", "0"], "--bandwidth is 0"), (["--hlep"], "did you mean '--help'")])
def test_mistakes_are_one_line(hybrid, level_ground, words, part):
    result = hybrid("amplification", level_ground, *words)
    assert result.returncode == 2 and part in result.stderr and result.stderr.count("\n") == 1, result.stderr


def test_several_runs_need_what_they_differ_in(hybrid, level_ground):
    result = hybrid("amplification", level_ground, level_ground)
    assert result.returncode == 2 and "--against is missing" in result.stderr
    result = hybrid("amplification", level_ground, level_ground, "--against", "Motion/Frequency")
    assert result.returncode == 2 and "is 2 in all runs" in result.stderr


def test_a_run_without_lines_is_told(hybrid, synthetic_run):
    result = hybrid("amplification", synthetic_run("bare"))
    assert result.returncode == 2 and "has no lines" in result.stderr and result.stderr.count("\n") == 1
