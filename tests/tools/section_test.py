# SPDX-License-Identifier: GPL-3.0-or-later
"""hybrid section: what is drawn is what the program understood, and nothing is run or left behind."""
import h5py
import numpy as np
import pytest
from conftest import ROOT

from hybrid_run import Run
from hybrid_tools.section.command import read_scene
from hybrid_tools.section.drawing import Scene, views

PIT = ROOT / "parameters/verification/restart_coupled.prm"
FALLING = ROOT / "parameters/examples/05_falling_blocks/scene.prm"
COLUMN = ROOT / "parameters/examples/02_layered_column/scene.prm"


def scene(path, tmp_path, *overrides):
    return Scene(read_scene(str(path), list(overrides), str(tmp_path / "run")))


def test_the_lines_of_the_mesh_are_in_the_run(tmp_path):
    found = scene(COLUMN, tmp_path)
    with h5py.File(tmp_path / "run/run.h5") as file:
        assert set(file["section/lines"]) >= {"base", "left", "right", "ground"}
        assert file["section/lines/base"].attrs["unit"] == "m"
    lengths = {name: np.hypot(*(edges[:, 1] - edges[:, 0]).T).sum() for name, edges in found.lines.items()}
    assert lengths["base"] == pytest.approx(4) and lengths["ground"] == pytest.approx(4) and lengths["left"] == pytest.approx(40)
    assert len(found.cells) == 10 and sorted(np.bincount(found.cell_material)) == [5, 5]
    assert found.monitors["surface"] == pytest.approx([2, 40]) and len(views(found)) == 1
    assert Run(tmp_path / "run").n == 0  # nothing was run


def test_polygons_on_a_polyline_are_drawn(tmp_path):
    found = scene(FALLING, tmp_path)
    assert len(found.blocks) == 3 and not found.has_bedrock and not len(found.cells)
    low, high = found.extent
    assert low == pytest.approx([-40, 0]) and high == pytest.approx([60, 25.71], abs=0.5)


@pytest.mark.parametrize("path, ending", [(PIT, "png"), (FALLING, "svg"), (COLUMN, "svg")])
def test_pictures_are_written_and_nothing_else(hybrid, tmp_path, path, ending):
    picture = tmp_path / ("section." + ending)
    result = hybrid("section", path, "--output", picture, cwd=tmp_path)
    assert result.returncode == 0 and not result.stderr, result.stderr
    assert [p.name for p in tmp_path.iterdir()] == [picture.name] and picture.stat().st_size > 5000
    if ending == "svg":
        assert "monitor" in picture.read_text()


@pytest.mark.parametrize("name", ["initial_stress", "staged_columns"])
def test_scenes_that_begin_with_stress_are_drawn(hybrid, tmp_path, name):
    result = hybrid("section", ROOT / "parameters/verification" / (name + ".prm"), "--output", tmp_path / "a.png", cwd=tmp_path)
    assert result.returncode == 0 and not result.stderr, result.stderr


@pytest.mark.parametrize("words, part", [
    ([], "SCENE.prm"), (["nothing.prm"], "'nothing.prm' cannot be read"), ([COLUMN, "--output", "a.bmp"], "must end in .png"),
    ([COLUMN, "--output", "nowhere/a.png"], "'nowhere' is not a directory"), ([COLUMN, "-s", "Time/End tim=1", "--output", "a.png"], "End tim")])
def test_mistakes_are_one_line(hybrid, tmp_path, words, part):
    result = hybrid("section", *words, cwd=tmp_path)
    assert result.returncode == 2 and part in result.stderr and result.stderr.count("\n") == 1, result.stderr
    assert not list(tmp_path.iterdir())
