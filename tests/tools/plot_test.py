# SPDX-License-Identifier: GPL-3.0-or-later
"""hybrid plot: every figure of a run, as far as it was recorded."""
import os
import shutil
import subprocess
import sys

import h5py
import numpy as np
import pytest
from conftest import TOOLS

import tool
from hybrid_run import Run
from hybrid_tools import style
from hybrid_tools.plot import boreholes, overview

FIGURES = ["overview", "input_motion", "monitors_S", "monitors_D", "monitors_base", "boreholes", "section", "slip", "energy", "steps"]


def pictures(directory):
    return sorted(picture.name for picture in (directory / "figures").iterdir())


def test_every_figure_of_a_complete_run(hybrid, synthetic_run):
    run = synthetic_run("complete")
    result = hybrid("plot", run)
    assert result.returncode == 0 and result.stdout == f"figures: {run}/figures\n" and not result.stderr  # no word on effects that are off
    assert pictures(run) == sorted(name + ".png" for name in FIGURES)
    for picture in (run / "figures").iterdir():
        assert picture.read_bytes().startswith(b"\x89PNG\r\n\x1a\n")


def test_a_run_without_blocks_or_boreholes_is_drawn_as_far_as_it_goes(synthetic_run):
    run = synthetic_run("bare")
    assert tool.main("plot", [str(run)]) == 0
    assert pictures(run) == ["monitors_other.png", "overview.png"]


def test_the_slip_of_a_single_block_is_drawn(synthetic_run):
    run = synthetic_run("complete")
    with h5py.File(run / "run.h5", "a") as file:
        profile, position = file["slip/profile"][:, 0], file["slip/position"][:1]
        del file["slip/profile"], file["slip/position"]
        file["slip/profile"], file["slip/position"] = profile, position
    assert tool.main("plot", ["--figures", "slip", str(run)]) == 0
    assert pictures(run) == ["slip.png"]


def test_blocks_that_all_left_the_section_are_drawn_where_they_are(hybrid, synthetic_run):
    run = synthetic_run("away")
    assert tool.main("plot", [str(run)]) == 0
    assert "section.png" in pictures(run)


def test_missing_modules_are_a_sentence(synthetic_run):
    words = [sys.executable, "-S", TOOLS / "tool.py", "plot", synthetic_run("bare")]  # -S: without the modules that Debian installs
    result = subprocess.run(words, capture_output=True, text=True)
    assert result.returncode == 1 and "python3-h5py" in result.stderr and result.stderr.count("\n") == 1, result.stderr


@pytest.mark.parametrize("words, part", [
    ([], "RUN"), (["nowhere"], "'nowhere' is not a directory"), (["."], "'.' holds no run.h5"),
    (["--figures", "sectoin", "run"], "unknown figure 'sectoin' in --figures (did you mean 'section'?); there are: input_motion, monitors,"),
    (["--format", "jpg", "run"], "'jpg'"), (["--figures", ",", "run"], "names no figure"),
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
