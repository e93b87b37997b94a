# SPDX-License-Identifier: GPL-3.0-or-later
"""hybrid animate: films of blocks that fall, and of a mass whose displacements must be enlarged."""
import argparse
import shutil
import subprocess

import numpy as np
import pytest
import tool
from conftest import ONE_RUN, ROOT
from PIL import Image, ImageSequence

from hybrid_run import MissingData, Run
from hybrid_tools.animate import command, film, motion

G = 9.81


@pytest.fixture(scope="module")
def falling(hybrid, tmp_path_factory):
    """Two blocks slide over the end of a slope and fall into the void."""
    directory = tmp_path_factory.mktemp("falling") / "run"
    result = hybrid(ROOT / "parameters/hard/leaves_model.prm", "-s", "Output/Picture interval=0.25", "-s", f"Output/Directory={directory}",
                    *ONE_RUN)
    assert result.returncode == 0, result.stderr
    return Run(directory)


@pytest.fixture(scope="module")
def column(hybrid, tmp_path_factory):
    """A wave through a continuum into blocks: micrometres."""
    directory = tmp_path_factory.mktemp("column") / "run"
    result = hybrid(ROOT / "parameters/verification/coupled_column.prm", "-s", "Time/End time=0.3", "-s", "Output/Picture interval=0.02",
                    "-s", f"Output/Directory={directory}", *ONE_RUN)
    assert result.returncode == 0, result.stderr
    return Run(directory)


def test_pictures_say_what_run_h5_says(falling):
    blocks = falling.pictures("blocks")
    assert len(blocks) == 11 and blocks.times == pytest.approx(0.25 * np.arange(11), abs=1e-6)
    last = blocks[10]
    assert last.points == pytest.approx(np.vstack(falling.blocks.final_polygons), abs=1e-12)
    assert last.of_cells(last.fields["displacement [m]"]) == pytest.approx(falling.blocks.displacement, rel=1e-5)
    first = falling.pictures("blocks")[1]  # 30 deg, 5 deg of friction
    speed = np.hypot(*first.of_cells(first.fields["velocity [m/s]"]).T)
    assert speed == pytest.approx(0.25 * G * (np.sin(np.pi / 6) - np.cos(np.pi / 6) * np.tan(np.radians(5))), rel=0.01)


def test_vtk_reads_the_same(column):
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

    for name in ("blocks", "joints", "continuum"):
        series = column.pictures(name)
        reader = vtkXMLUnstructuredGridReader()
        reader.SetFileName(series.files[-1])
        reader.Update()
        grid, picture = reader.GetOutput(), series[len(series) - 1]
        assert np.array_equal(vtk_to_numpy(grid.GetPoints().GetData())[:, :2], picture.points)
        assert np.array_equal(vtk_to_numpy(grid.GetCells().GetConnectivityArray()), picture.connectivity)
        for data in (grid.GetPointData(), grid.GetCellData()):
            for i in range(data.GetNumberOfArrays()):
                values = vtk_to_numpy(data.GetArray(i))
                assert np.array_equal(values[:, :2] if values.ndim > 1 and "stress" not in data.GetArrayName(i) else values,
                                      picture.fields[data.GetArrayName(i)])


def film_of(run, scale=1.0):
    moves = motion.Motion(run, scale)
    extent = motion.Extent(moves, "displacement", range(len(moves.times)))
    return moves, extent, film.Film(moves, extent, "displacement", False)


def test_axes_hold_all_that_flies(falling):
    _, _, shown = film_of(falling)
    shown.figure.canvas.draw()
    (left, right), (bottom, top) = shown.axes.get_xlim(), shown.axes.get_ylim()
    for picture in (falling.pictures("blocks")[0], falling.pictures("blocks")[10]):
        x, y = picture.points.T
        assert left < x.min() and x.max() < right and bottom < y.min() and y.max() < top
    box = shown.axes.get_window_extent()
    assert (right - left) / box.width == pytest.approx((top - bottom) / box.height, rel=1e-3)  # squares are squares
    assert np.array_equal(shown.figure.get_size_inches() * film.DPI % 2, [0, 0])


def test_blocks_are_drawn_where_they_are_and_enlarged_about_where_they_lay(column):
    moves, extent, shown = film_of(column)
    assert command.fitting_scale(extent) > 100 and command.fitting_scale(extent) * extent.moved < 0.03 * 1.001 * max(extent.first[1] - extent.first[0])
    k = 10
    shown.draw(k)
    picture, time = moves.blocks[k], moves.times[k]
    lay = picture.points - picture.fields["displacement [m]"]
    ground = moves.base_displacement(time)
    assert np.vstack([path.vertices[:-1] for path in shown.blocks.get_paths()]) == pytest.approx(picture.points - ground, abs=1e-12)
    moves.scale = 1000.0
    assert moves.drawn(picture, time) - lay == pytest.approx(1000 * (picture.points - ground - lay), rel=1e-4, abs=1e-6)
    assert len(shown.cells.get_paths()) == len(moves.bedrock[k].starts)
    assert shown.clock.get_text().startswith("t = 0.20 s")


def test_a_gif_plays_as_long_as_it_says(falling, tmp_path, capsys):
    path = tmp_path / "fall.gif"
    assert tool.main("animate", [falling.directory, "--output", str(path), "--speed", "0.5", "--fps", "5"]) == 0
    with Image.open(path) as found:
        played = sum(frame.info["duration"] for frame in ImageSequence.Iterator(found))  # equal frames are one that lasts
    assert played == 26 * 200
    assert "26 frames" in capsys.readouterr().out and path.stat().st_size < 1e6


def test_an_mp4_is_what_browsers_play(falling, tmp_path):
    path = tmp_path / "fall.mp4"
    assert tool.main("animate", [falling.directory, "--output", str(path), "--color", "velocity"]) == 0
    told = subprocess.run(["ffprobe", "-v", "error", "-show_entries", "stream=codec_name,pix_fmt,nb_frames", "-of", "csv=p=0", path],
                          capture_output=True, text=True, check=True).stdout
    assert told.strip() == "h264,yuv420p,11"


def test_frames_are_the_nearest_pictures():
    times = np.arange(0, 2.01, 0.1)
    frames, fps = command.timing(times, None, None, 25)
    assert list(frames) == list(range(21)) and fps == pytest.approx(5)  # 2 s last 4 s
    frames, fps = command.timing(times, 1.0, 5, 25)
    assert list(frames) == list(range(0, 21, 2)) and fps == 5
    frames, fps = command.timing(np.linspace(0, 100, 5001), None, None, 10)
    assert len(frames) == 151 and fps == 10 and frames[-1] == 5000
    assert command.round_scale(999) == 500 and command.round_scale(0.2) == pytest.approx(0.2)


@pytest.mark.parametrize("words, part", [
    ([], "RUN"), (["nowhere"], "'nowhere' is not a directory"), (["run", "--fps", "0"], "number above 0"), (["run", "--speed", "nan"], "number above 0"),
    (["run", "--output", "film.avi"], "'film.avi' ends neither with .mp4 nor with .gif"), (["run", "--scael", "3"], "did you mean '--scale'?"),
    (["run", "--format", "gif", "--output", "film.mp4"], "do not fit")])
def test_mistakes_are_one_line(tmp_path, monkeypatch, capsys, words, part):
    monkeypatch.chdir(tmp_path)
    assert tool.main("animate", words) == 2
    said = capsys.readouterr().err
    assert part in said and said.startswith("error: ") and said.count("\n") == 1, said


def test_what_is_missing_is_told(synthetic_run, falling, monkeypatch):
    with pytest.raises(MissingData, match="fewer than two pictures"):
        motion.Motion(Run(synthetic_run("bare")))
    monkeypatch.setattr(shutil, "which", lambda name: None)
    assert command.format_of(argparse.Namespace(output=None, format=None)) == "gif"
    with pytest.raises(command.UserError, match="apt-get install ffmpeg"):
        command.format_of(argparse.Namespace(output="a.mp4", format=None))


def test_a_picture_that_is_cut_off_is_told(falling, tmp_path):
    broken = tmp_path / "blocks.vtu"
    broken.write_bytes(open(falling.pictures("blocks").files[1], "rb").read()[:900])
    from hybrid_run.pictures import Picture
    with pytest.raises(command.UserError, match="cannot read the picture"):
        Picture(broken)
