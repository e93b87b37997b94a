# SPDX-License-Identifier: GPL-3.0-or-later
"""hybrid plot: every figure of a run, as far as it was recorded."""
import os
import re
import shutil
import subprocess
import sys
import types

import h5py
import matplotlib.pyplot as plt
import numpy as np
import pytest
from conftest import ONE_RUN, ROOT, TOOLS
from moving_run import Maker

import tool
from hybrid_run import Run, UserError
from hybrid_run.geometry import chains
from hybrid_tools import style
from hybrid_tools.plot import boreholes, energy_balance, everything, failure_process, monitor_choice, overview, planes, section_view, slip, velocities, water

FIGURES = ["overview", "input_motion", "monitors_S", "monitors_D", "monitors_base", "velocities", "boreholes", "section", "slip", "energy", "steps"]


def pictures(directory):
    return sorted(picture.name for picture in (directory / "figures").iterdir())


def test_every_figure_of_a_complete_run(hybrid, synthetic_run):
    run = synthetic_run("complete")
    result = hybrid("plot", run)
    assert result.returncode == 0 and not result.stderr
    said, files = result.stdout.split(f"figures: {run}/figures: ")
    assert not said and files.count("\n") == 1  # no word on effects that are off
    assert pictures(run) == sorted(name + ".png" for name in FIGURES) == sorted(files.strip().split(", "))
    for picture in (run / "figures").iterdir():
        assert picture.read_bytes().startswith(b"\x89PNG\r\n\x1a\n")


def test_a_run_without_blocks_or_boreholes_is_drawn_as_far_as_it_goes(synthetic_run):
    run = synthetic_run("bare")
    assert tool.main("plot", [str(run)]) == 0
    assert pictures(run) == ["monitors_other.png", "overview.png", "velocities.png"]


def test_the_slip_of_a_single_block_is_drawn(synthetic_run):
    run = synthetic_run("complete")
    with h5py.File(run / "run.h5", "a") as file:
        profile, position = file["slip/profile"][:, 0], file["slip/position"][:1]
        del file["slip/profile"], file["slip/position"]
        file["slip/profile"], file["slip/position"] = profile, position
    assert tool.main("plot", ["--figures", "slip", str(run)]) == 0
    assert pictures(run) == ["slip.png"]


@pytest.mark.parametrize("group", planes.GROUPS)
def test_planes_that_have_slipped_are_drawn_from_left_to_right(synthetic_run, group):
    directory = synthetic_run("complete")
    along = np.array([3.0, 1.0, 4.0, 2.0])
    with h5py.File(directory / "run.h5", "a") as file:
        file[group + "/time"] = [0.0, 1.0, 2.0]
        for name, angle, largest in (("line_1", 20, 0.3), ("line_2", 91, 0.1), ("line_3", 0, 0.0)):
            points = np.outer(along, [np.cos(np.radians(angle)), np.sin(np.radians(angle))])
            for quantity, values in (("position", points), ("slip", -largest * np.outer([0, 1, 2], along)), ("opening", np.zeros((3, 4)))):
                file["%s/%s/%s" % (group, name, quantity)] = values
    assert tool.main("plot", ["--figures", "planes", str(directory)]) == 0
    assert pictures(directory) == ["planes.png"]
    found = planes.planes_of(Run(str(directory)))
    assert [plane.name for plane in found] == ["line_1", "line_2"]
    for plane, largest in zip(found, (0.3, 0.1)):
        assert plane.along == pytest.approx([0, 1, 2, 3]) and plane.slip[-1] == pytest.approx(-2 * largest * np.arange(1, 5))
    axes = plt.figure().add_subplot()
    found[0].opening[2] = 0.2
    planes.draw_history(found[0], axes, 1e3, "mm")
    assert len(axes.get_lines()) == 3 and "left side" in axes.get_ylabel() and "opening [mm]" in axes.get_ylabel()


def test_surfaces_and_slip_of_two_slides_are_not_joined_through_the_air(synthetic_run):
    directory = synthetic_run("complete")
    with h5py.File(directory / "run.h5", "a") as file:
        n, k = len(file["section/surface"]), len(file["slip/position"])
        file["section/surface_offsets"] = [0, n // 2, n]
        file["slip/slide"] = np.repeat([0.0, 1.0], [k // 2, k - k // 2])
        file["slip/downhill"] = np.repeat([1.0, -1.0], [k // 2, k - k // 2])
    run = Run(directory)
    assert [len(line) for line in run.surface] == [n // 2, n - n // 2]
    section, axes = section_view.Section(run), plt.figure().add_subplot()
    section_view.draw_rock(section, axes)
    drawn = [collection for collection in axes.collections if np.allclose(collection.get_color()[0, :3], plt.matplotlib.colors.to_rgb(style.SLIP))]
    assert [len(path) for path in drawn[0].get_segments()] == [n // 2, n - n // 2]
    axes = plt.figure().add_subplot()
    slip.draw_profiles(run, axes, 1.0, "m")
    lines = [line for line in axes.lines if len(line.get_xdata()) > 2]
    assert lines and all(np.isnan(line.get_ydata()[k // 2]) and np.isnan(line.get_ydata()).sum() == 1 for line in lines)
    assert axes.get_ylabel().startswith("slip downhill")
    top, bottom = section.surface[0][0] + [0, 30], section.surface[0][0] - [0, 30]
    run.file.close()
    with h5py.File(directory / "run.h5", "a") as file:
        gap = 0.5 * (section.surface[0][-1, 0] + section.surface[1][0, 0])
        file["profiles/gap/depth"] = [0.0, 1.0]
        file["profiles/gap"].attrs["position"] = [gap, 500.0, gap, 0.0]
        file["profiles/end/depth"] = [0.0, 1.0]
        file["profiles/end"].attrs["position"] = [*top, *bottom]
    run = Run(directory)
    assert boreholes.depth_of_slip(run, "profiles/gap") is None
    assert boreholes.depth_of_slip(run, "profiles/end") == pytest.approx(30)
    plt.close("all")


def test_the_floor_of_a_valley_between_two_masses_is_in_view():
    """Both masses lie above 4 m, the floor at 0; the base of the rock at -50 m is no ground."""
    surface = [np.array([[-100.0, 20.0], [0.0, 0.0], [50.0, 20.0]])]
    outline = np.array([[-100.0, -50, 100, -50], [100, -50, 100, 40], [100, 40, 50, 20], [50, 20, 0, 0], [0, 0, -100, 20], [-100, 20, -100, -50]])
    for lines, rock in ((surface, None), (None, outline), (surface, outline)):
        section = types.SimpleNamespace(low=np.array([-30.0, 4.0]), high=np.array([20.0, 12.0]), surface=lines, outline=rock)
        section_view.Section.show_ground_between(section)
        assert section.low.tolist() == [-30, 0] and section.high.tolist() == [20, 12]
    section = types.SimpleNamespace(low=np.array([-30.0, 4.0]), high=np.array([-20.0, 12.0]), surface=surface, outline=outline)
    section_view.Section.show_ground_between(section)
    assert section.low.tolist() == [-30, 4]  # one mass alone


def test_blocks_that_all_left_the_section_are_drawn_where_they_are(hybrid, synthetic_run):
    run = synthetic_run("away")
    assert tool.main("plot", ["--figures", "section,overview,boreholes", str(run)]) == 0
    assert "section.png" in pictures(run)


def levels_of(axes):
    return [float(line.get_ydata()[0]) for line in axes.lines if line.get_linestyle() == "--" and line.get_color() == style.WATER]


def test_a_level_that_moves_is_drawn_where_it_is(synthetic_run):
    run = synthetic_run("complete")
    with h5py.File(run / "run.h5", "a") as file:
        end = file["time"][-1]
        file["section/water_levels"] = [[0.25 * end, 175.0], [0.75 * end, 145.0]]
    section = section_view.Section(Run(str(run)))
    assert [section.water.level(part * end) for part in (0, 0.5, 2)] == pytest.approx([175, 160, 145])
    _, (first, last, beyond) = plt.subplots(1, 3)
    section_view.draw_main(section, first)
    section_view.draw_final(section, last)
    assert levels_of(first) == [175] and levels_of(last) == [145]
    assert {text.get_text() for text in first.texts} >= {"175 m at 0 s"}
    beyond.set(xlim=(0, 1), ylim=(150, 151))
    assert water.draw_water(section.water, beyond, 0.75 * end) == [] and not beyond.lines
    plt.close("all")


def test_the_failure_is_drawn_at_times_that_part_it(hybrid, tmp_path):
    words = ["-s", f"Output/Directory={tmp_path}", "-s", "Output/Picture interval=0.02", *ONE_RUN]
    result = hybrid(ROOT / "parameters/hard/all_joints_fail.prm", *words)
    assert result.returncode == 0, result.stderr
    run = Run(tmp_path)
    times = run.pictures("blocks").times
    failures = failure_process.motion_failures(run)
    chosen = failure_process.frames(run, failures, times)
    share = failure_process.progress(run, failures, times)
    assert chosen[-1] == len(times) - 1 and share[-1] == pytest.approx(1)
    failed = [(failures <= times[k]).mean() for k in (chosen[0] - 1, chosen[0])]
    assert failed[0] < 0.1 <= failed[1] or chosen[0] == 0  # the first frame is the first picture with a tenth of the failures
    assert (np.diff(chosen) > 0).all() and len(chosen) >= 4
    assert tool.main("plot", ["--figures", "failure_process", str(tmp_path)]) == 0
    assert pictures(tmp_path) == ["failure_process.png"]


def test_missing_modules_are_a_sentence(synthetic_run):
    words = [sys.executable, "-S", TOOLS / "tool.py", "plot", synthetic_run("bare")]  # -S: without the modules that Debian installs
    result = subprocess.run(words, capture_output=True, text=True)
    assert result.returncode == 1 and "python3-h5py" in result.stderr and result.stderr.count("\n") == 1, result.stderr


@pytest.mark.parametrize("words, part", [
    ([], "RUN"), (["nowhere"], "'nowhere' is not a directory"), (["."], "'.' holds no run.h5"),
    (["--figures", "sectoin", "run"], "unknown figure 'sectoin' in --figures (did you mean 'section'?); there are: input_motion, monitors,"),
    (["--format", "jpg", "run"], "'jpg'"), (["--figures", ",", "run"], "names no figure"),
    (["--all", "--list", "run"], "--all draws everything"), (["--all", "--figures", "slip", "run"], "neither --figures nor --list"),
    (["run", "--hlep"], "unknown option '--hlep' of hybrid plot (did you mean '--help'?)"), (["run", "--check"], "unknown option '--check'")])
def test_mistakes_are_one_line(tmp_path, monkeypatch, capsys, words, part):
    monkeypatch.chdir(tmp_path)
    assert tool.main("plot", words) == 2
    said = capsys.readouterr().err
    assert part in said and said.startswith("error: ") and said.count("\n") == 1, said


def test_the_program_tells_a_mistake_as_its_tool_does(hybrid, tmp_path):
    result = hybrid("plot", "nowhere", cwd=tmp_path)
    assert result.returncode == 2 and result.stderr == "error: 'nowhere' is not a directory; give the output directory of a run\n"


def test_chosen_figures_of_two_runs_in_another_format(synthetic_run, capsys):
    runs = [synthetic_run("bare", "one"), synthetic_run("bare", "two")]
    assert tool.main("plot", ["--format", "svg", "--figures", "monitors,section", *map(str, runs)]) == 0
    assert capsys.readouterr().out.count("section: left out, ") == 2
    for run in runs:
        assert pictures(run) == ["monitors_other.svg"]
        assert "acceleration below 25 Hz [m/s²]" in (run / "figures/monitors_other.svg").read_text()  # text is text
    assert tool.main("plot", ["--format", "pdf", "--figures", "overview", str(runs[0])]) == 0
    assert (runs[0] / "figures/overview.pdf").read_bytes().startswith(b"%PDF")


def test_the_list_says_what_there_is_and_draws_nothing(synthetic_run, capsys):
    run = synthetic_run("bare")
    assert tool.main("plot", ["--list", str(run)]) == 0 and not (run / "figures").exists()
    lines = {line.split()[0]: line for line in capsys.readouterr().out.splitlines()[1:]}
    assert "Histories of the monitors" in lines["monitors"] and "not there: no profiles" in lines["boreholes"]
    with pytest.raises(SystemExit):
        tool.main("plot", ["--help"])
    text = capsys.readouterr().out
    assert all(name in text for name in lines)


def legends(part):
    own = [[text.get_text() for text in legend.get_texts()] for legend in part.legends]
    return own + [legend for inner in getattr(part, "subfigs", []) for legend in legends(inner)]


def check_words_are_free(figure):
    """The name of the sliding surface lies on no curve."""
    figure.canvas.draw()
    for axes in figure.axes:
        words = [text for text in axes.texts if text.get_text() == "sliding surface"][0].get_window_extent()
        for line in axes.lines[:2]:  # at the peak, left at the end
            points = line.get_xydata()
            fine = np.linspace(0, len(points) - 1, 2000)
            points = np.column_stack([np.interp(fine, range(len(points)), points[:, c]) for c in (0, 1)])
            points = axes.transData.transform(points)
            inside = (points[:, 0] > words.x0) & (points[:, 0] < words.x1) & (points[:, 1] > words.y0) & (points[:, 1] < words.y1)
            assert not inside.any(), line.get_label()


def test_boreholes_are_explained_and_no_words_lie_on_their_curves(synthetic_run, monkeypatch):
    directory = synthetic_run("complete")
    figures = []
    monkeypatch.setattr(style, "save", lambda figure, *_: figures.append(figure))
    for is_deep in (False, True):  # most displacement at the ground, at the sliding surface
        if is_deep:
            with h5py.File(directory / "run.h5", "r+") as file:
                for name in file["profiles"]:
                    series = file["profiles/%s/displacement" % name]
                    u = series[:]
                    series[:] = u.reshape(len(u), -1, 2)[:, ::-1].reshape(u.shape)
        boreholes.draw(Run(directory), directory)
        check_words_are_free(figures.pop())
    overview.draw(Run(directory), directory)
    assert ["envelope of the run", "at peak of surface", "left: mean of the last 2 s", "measured"] in legends(figures.pop())


def test_the_overview_has_the_boreholes_that_move_most_and_names_the_others(synthetic_run, monkeypatch):
    directory = synthetic_run("complete")
    figures = []
    monkeypatch.setattr(style, "save", lambda figure, *_: figures.append(figure))
    for number, words in ((1, "without ZK0, which moves less"), (4, "without 4 others, which move less")):
        with h5py.File(directory / "run.h5", "r+") as file:
            for name in ["ZK%d" % k for k in (0, 5, 6, 7)][:number]:
                if name not in file["profiles"]:
                    file.copy("profiles/ZK1", "profiles/" + name)
                    file["profiles/%s/displacement" % name][:] *= 0.5
        overview.draw(Run(directory), directory)
        figure = figures.pop()
        assert [name for part in figure.subfigs for axes in part.axes if "ZK" in (name := axes.get_title("left"))] == ["ZK1", "ZK2"]
        assert any(legend[-1] == words for legend in legends(figure))


def test_bedding_planes_that_are_seen_are_in_the_legend_of_the_section(synthetic_run):
    directory = synthetic_run("complete")
    for planes, expected in (([[0, 100, 900, 290]], "bedding plane"), ([[0, -50, 900, -40]], None)):
        with h5py.File(directory / "run.h5", "r+") as file:
            file.pop("section/bedding", None)
            file["section/bedding/bedding_1"] = np.array(planes, float)
        axes = plt.figure().add_subplot()
        section_view.draw_main(section_view.Section(Run(directory)), axes)
        words = [text.get_text() for text in axes.get_legend().get_texts()]
        assert words[-1] == expected if expected else not any("bedding" in word for word in words)
        assert any("tensile: " in word for word in words)
        plt.close("all")


def test_boreholes_of_a_mass_that_still_slides_are_those_at_the_end(synthetic_run):
    """Slip that goes on growing: the mean of the last seconds is not what is left."""
    directory = synthetic_run("complete")
    run = Run(directory)
    x = run.get("profiles/ZK1/displacement")[:, 0::2]
    at_rest, what = boreholes.left_at_end(run, x)
    assert what == "left: mean of the last 2 s" and at_rest == pytest.approx(x[run.time > 10].mean(axis=0))
    run.file.close()
    with h5py.File(directory / "run.h5", "r+") as file:
        file["slip/largest"][...] += 2e-3 * np.maximum(run.time - 11, 0)
    at_end, what = boreholes.left_at_end(Run(directory), x)
    assert what == "at the end, 12 s: it still slides" and (at_end == x[-1]).all()


# Follows "Adding a picture" of doc/developer_guide.md: a module and a word in FIGURES.
def test_a_new_picture_is_a_module_and_a_word(synthetic_run, tmp_path):
    directory = synthetic_run("complete")
    tools = tmp_path / "tools"
    shutil.copytree(TOOLS, tools)
    (tools / "hybrid_tools/plot/how_long.py").write_text("""
import matplotlib.pyplot as plt

from hybrid_tools import style


def draw(run, directory):
    figure, axes = plt.subplots()
    axes.plot(run.time)
    style.save(figure, directory, "how_long")
""")
    command = tools / "hybrid_tools/plot/command.py"
    command.write_text(command.read_text().replace("FIGURES = (", 'FIGURES = ("how_long", '))
    subprocess.run([sys.executable, tools / "tool.py", "plot", "--figures", "how_long,overview", directory], check=True)
    assert {"how_long.png", "overview.png"} <= set(os.listdir(directory / "figures"))


def test_a_borehole_jumps_at_the_sliding_surface():
    depth = np.array([0.0, 4.0, 8.0, 12.0, 16.0])
    field = 3.0 - 0.1 * depth  # without a jump nothing changes
    at, x = boreholes.with_jump(depth, field, 9.0)
    assert at.tolist() == [0, 4, 8, 9, 9, 12, 16] and x == pytest.approx(3 - 0.1 * at)
    at, x = boreholes.with_jump(depth, np.stack([field + 5 * (depth < 9), field]), 9.0)
    assert x[0, 3:5] == pytest.approx([3 - 0.9 + 5, 3 - 0.9]) and x[1, 3:5] == pytest.approx([2.1, 2.1])
    assert boreholes.with_jump(depth[:2], field[:2], 2.0)[1].tolist() == [3, 3, 2.6, 2.6]
    for outside in (None, 20.0, 0.0):
        assert boreholes.with_jump(depth, field, outside)[0] is depth


def test_small_terms_of_energy_are_one_curve():
    time = np.linspace(0, 1, 11)
    terms = {"work_%d" % k: time * 10.0**-k for k in range(6)}
    terms["nothing"] = 0 * time
    found, rest = energy_balance.grouped(terms)
    assert list(found) == ["work 0", "work 1", "4 smaller terms"] and rest == ["work_2", "work_3", "work_4", "work_5"]
    assert found["4 smaller terms"][-1] == pytest.approx(0.011110)
    assert list(energy_balance.grouped({"a": time, "b": 1e-3 * time})[0]) == ["a", "b"]


def test_no_two_terms_of_energy_look_the_same():
    ledger = (ROOT / "src/output/energy_ledger.cc").read_text()
    names = set(re.findall(r'\{+"([a-z_]+)", ', ledger))
    assert len(names) > 20 and names <= set(energy_balance.TERMS)
    looks = [tuple(energy_balance.look(name).values()) for name in energy_balance.TERMS]
    assert len(set(looks)) == len(energy_balance.TERMS) and energy_balance.UNKNOWN != energy_balance.REST
    usual = [energy_balance.look(name)["color"] for name in ("input_work", "water_work", "friction_loss", "blocks_gravity", "boundary_loss")]
    assert len(set(usual)) == len(usual)


def test_what_the_largest_terms_dwarf_has_a_panel_of_its_own(synthetic_run, monkeypatch):
    time = np.linspace(0, 1, 11)
    terms = {"work": -time, "loss": 0.9 * time, "friction": 0.04 * time, "gravity": -0.03 * time, "nothing": 0 * time}
    assert list(energy_balance.lesser(terms)) == ["friction", "gravity"]
    assert energy_balance.lesser({"work": -time, "loss": time}) == {} == energy_balance.lesser({"work": -time, "friction": 0.01 * time})
    figures = []
    monkeypatch.setattr(style, "save", lambda figure, *_: figures.append(figure))
    energy_balance.draw(Run(synthetic_run("complete")), "")
    panels = figures.pop().axes
    labels = [axes.get_ylabel() for axes in panels]
    curves = [(line.get_color(), str(line.get_linestyle()), line.get_label()) for axes in panels[:2] for line in axes.lines]
    assert len({curve[:2] for curve in curves}) == len(curves) > 6
    assert labels[-2:] == ["failed joints [-]", "residual [%]"] and all(label.startswith("energy [") for label in labels[:-2])


def test_failures_are_counted_by_their_kind(synthetic_run):
    directory = synthetic_run("complete")
    with h5py.File(directory / "run.h5", "r+") as file:
        del file["joints/failure_time"], file["joints/failure_kind"]
        file["joints/failure_time"], file["joints/failure_kind"] = [-1.0, 3.0, 2.0, 5.0], [1.0, 1.0, 2.0, 1.0]
    found, at_rest = energy_balance.failures(Run(directory))
    assert {word: times.tolist() for word, times in found.items()} == {"tensile": [3, 5], "shear": [2]} and at_rest == 1
    assert energy_balance.failures(Run(synthetic_run("bare", "bare"))) == ({}, 0)


def test_frames_never_repeat_a_picture():
    class Still:
        """All joints fail between two pictures, and nothing slips."""

        def has(self, path):
            return False

    times = np.arange(0.0, 10.0)
    assert failure_process.frames(Still(), np.full(20, 3.5), times).tolist() == [4, 5, 6, 7, 8, 9]
    assert failure_process.frames(Still(), np.linspace(0.1, 8.9, 100), times).tolist()[0] == 1
    assert failure_process.frames(Still(), np.full(20, 8.5), times).tolist() == [9]


def test_groups_of_monitors_are_as_the_user_says():
    known = ["S1", "S2", "S3", "S10", "north-east", "D1"]
    assert monitor_choice.read_groups("S1|S2 - S10, D1 | north-east", known) == [["S1"], ["S2", "S3", "S10", "D1"], ["north-east"]]
    assert monitor_choice.read_groups("S3-S1,S2", known) == [["S1", "S2", "S3"]]
    with pytest.raises(UserError, match="unknown monitor 'north-west' in --groups .did you mean 'north-east'"):
        monitor_choice.read_groups("S1|north-west", known)
    with pytest.raises(UserError, match="names no monitor"):
        monitor_choice.read_groups(" | ,", known)
    assert monitor_choice.name_of(["S1", "S2", "S3"], known) == "S1 to S3" and monitor_choice.name_of(["S1", "S3"], known) == "S1, S3"


def test_monitors_that_move_alike_stand_together(synthetic_run):
    peaks = {"a": 8.0, "b": 9.0, "c": 2.0, "d": 1.5, "e": 0.9}
    assert monitor_choice.part(list(peaks), peaks, 2.0) == [["a", "b"], ["c", "d"], ["e"]]
    run = Run(synthetic_run("complete"))
    names = [name for name in run.names("monitors") if name != run.base]
    groups, ratio = monitor_choice.alike(run, {name: 1.0 for name in names})
    assert groups == [["S%d" % k for k in range(1, 9)], ["D%d" % k for k in range(1, 6)]] and ratio == 2.0
    groups, ratio = monitor_choice.alike(run, {name: 3.0**k for k, name in enumerate(names)})
    assert len(groups) <= 6 and ratio > 2.0 and sorted(sum(groups, [])) == sorted(names)
    assert len(monitor_choice.alike(run, {name: float(k % 2) for k, name in enumerate(names)})[0]) == 2  # some stand still


def test_velocities_are_drawn_in_groups(synthetic_run, monkeypatch, capsys):
    directory = synthetic_run("complete")
    figures = []
    monkeypatch.setattr(style, "save", lambda figure, *_: figures.append(figure))
    style.apply()  # titles stand on the left
    velocities.draw(Run(directory), "", "S1 | S2-S4 | D1,B1")
    assert [axes.get_title(loc="left") for axes in figures.pop().axes] == ["S1", "S2 to S4", "D1, B1"]
    velocities.draw(Run(directory), "")
    assert sum(len(axes.get_legend().get_texts()) for axes in figures.pop().axes) == 13  # all but the base
    assert tool.main("plot", ["--groups", "S1|S9", str(directory)]) == 2 and "unknown monitor 'S9'" in capsys.readouterr().err
    assert not (directory / "figures").exists()


def test_everything_of_several_runs_by_one_command(hybrid, tmp_path, capsys):
    runs = []
    for name, gravity in (("one", "9.81"), ("two", "5")):
        runs.append(tmp_path / name)
        words = ["-s", f"Output/Directory={runs[-1]}", "-s", "Output/Picture interval=0.1", "-s", f"Gravity/Acceleration={gravity}", *ONE_RUN]
        result = hybrid(ROOT / "parameters/hard/all_joints_fail.prm", *words)
        assert result.returncode == 0, result.stderr
    assert tool.main("plot", ["--all", *map(str, runs)]) == 0
    said = capsys.readouterr().out
    for run in runs:
        films = [picture for picture in pictures(run) if picture.startswith("motion.")]
        assert {"failure_process.png", "overview.png"} <= set(pictures(run)) and len(films) == 1 and f"{run}/figures/{films[0]}: " in said
    compared = pictures(tmp_path / "compare")
    assert "failures.png" in compared and f"side by side: {tmp_path}/compare: table.csv, table.json, table.md" in said
    assert sorted(said.split(f"side by side: {tmp_path}/compare/figures: ")[1].strip().split(", ")) == compared


def test_the_beginning_and_the_end_are_no_film(capsys):
    everything.films([types.SimpleNamespace(directory="still", pictures=lambda name: [0.0, 1.0])])
    assert capsys.readouterr().out.startswith("film: left out, 'still' has pictures of its beginning and its end only")


def test_runs_that_cannot_be_compared_are_drawn_all_the_same(synthetic_run, tmp_path, capsys):
    runs = [str(synthetic_run("bare", "bare")), str(Maker(tmp_path)("wide", width=11.0))]
    assert tool.main("plot", ["--all", *runs]) == 0
    said = capsys.readouterr().out
    assert said.count("film: left out, ") == 2 and said.count("side by side: left out, ") == 1 and "overview.png" in said


def test_segments_of_a_line_become_one_line():
    points = np.array([(0, 0), (1, 0), (2, 1), (3, 1), (4, 0)], float)
    segments = np.stack([points[:-1], points[1:]], axis=1)[[2, 0, 3, 1]]
    segments[1] = segments[1, ::-1]  # drawn the other way round
    (line,) = chains(segments)
    assert line.tolist() in (points.tolist(), points[::-1].tolist())
    ring = np.array([[(0, 0), (1, 0)], [(1, 0), (1, 1)], [(1, 1), (0, 0)]], float)
    assert len(chains(ring)) == 1 and len(chains(ring)[0]) == 4
    star = np.array([[(0, 0), (1, 0)], [(0, 0), (0, 1)], [(0, 0), (-1, 0)]], float)
    assert len(chains(star)) == 3 and chains([]) == []
