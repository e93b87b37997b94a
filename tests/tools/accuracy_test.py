# SPDX-License-Identifier: GPL-3.0-or-later
"""hybrid accuracy: what coarser runs say of a run's error is within a factor of 3 of what a finer one says."""
import json
import math
import os
import re

import pytest
from conftest import ONE_RUN, ROOT

from hybrid_tools.accuracy import coarser, estimate
from hybrid_tools.study import quantities
from hybrid_tools.study.analysis import distance
from hybrid_tools.study.quantities import Number

BAR = ROOT / "parameters/verification/bonded_bar.prm"


def bar(hybrid, directory, h, *words):
    numbers = "Width = 8; Height = 320; Resolution/h = %g" % h
    result = hybrid(BAR, "--force", "-s", "Output/Directory=%s" % directory, "-s", "Mesh/Numbers=" + numbers, *ONE_RUN, *words)
    assert result.returncode == 0, result.stderr
    return result


@pytest.mark.parametrize("order", [0.7, 1, 2])
def test_error_of_values_that_converge_is_exact(order):
    finest, next_one, last = (Number(1 + 0.03 * h**order) for h in (1, 2, 4))
    found = estimate.error_of(finest, next_one, last)
    assert found.converges and found.order == pytest.approx(order)
    assert found.value == pytest.approx(0.03 / 1.03)


def test_two_values_alone_count_as_of_first_order():
    found = estimate.error_of(Number(1.0), Number(1.04))
    assert found.value == pytest.approx(0.04) and math.isnan(found.order)


def test_finer_values_that_are_close_by_luck_do_not_count():
    found = estimate.error_of(Number(1.0), Number(1.0001), Number(1.12))
    assert found.value == pytest.approx(0.1199 / 4 / 3)  # not 0.0001 / 3


def test_values_that_do_not_come_closer_say_how_far_they_scatter():
    found = estimate.error_of(Number(1.0), Number(1.1), Number(1.05))
    assert not found.converges and found.value == pytest.approx(0.1)
    same = estimate.error_of(Number(1.0), Number(1.0), Number(1.0))
    assert same.converges and same.value == 0


def test_sizes_of_a_mesh_are_those_that_it_was_given_or_the_geometry_s(tmp_path):
    geometry = tmp_path / "a.geo"
    geometry.write_text('DefineConstant[ w = {40, Min 1, Name "Width"}, h = {4, Min 1, Max 20, Name "Resolution/h"},\n'
                        '  far = {1.5e1, Name "Resolution/far"} ];\n')
    scene = {"Mesh/File": str(geometry), "Mesh/Numbers": "Width = 50; Resolution/h = 2"}
    assert coarser.mesh_sizes(scene) == ({"Resolution/h": 2, "Resolution/far": 15}, ["Width = 50"])
    assert coarser.coarser_mesh(scene, 4).overrides == ["Mesh/Numbers=Width = 50; Resolution/h = 8; Resolution/far = 60"]
    assert coarser.coarser_mesh({"Mesh/File": "a.msh", "Mesh/Numbers": ""}, 2) is None


def test_a_mesh_that_does_not_become_coarser_says_nothing(hybrid, tmp_path):
    run = tmp_path / "run"
    bar(hybrid, run, 320, "-s", "Time/End time=0.1")
    result = hybrid("accuracy", run, "--mesh")
    assert result.returncode == 2 and "no coarser run to compare with" in result.stderr
    assert "mesh_2  is left out" in result.stdout


def test_blocks_count_where_there_are_some(tmp_path):
    def run(name, blocks, unknowns):
        (tmp_path / name).mkdir()
        (tmp_path / name / "summary.json").write_text(json.dumps({"blocks": blocks, "continuum_unknowns": unknowns}))
        return str(tmp_path / name)

    fine, graded, layer, alone, same = run("a", 1000, 900), run("b", 260, 700), run("c", 900, 250), run("d", 0, 900), run("e", 0, 700)
    assert coarser.is_coarser(graded, fine) and coarser.unchanged(graded, fine) == {"unknowns": (700, 900)}
    assert not coarser.is_coarser(layer, fine) and coarser.unchanged(layer, fine) == {"blocks": (900, 1000)}
    assert not coarser.is_coarser(same, alone)


def test_waves_alone_say_the_error_of_their_step_themselves(hybrid, tmp_path):
    run = tmp_path / "run"
    scene = ROOT / "parameters/verification/free_field.prm"
    assert hybrid(scene, "-s", "Output/Directory=%s" % run, "-s", "Output/Picture interval=0").returncode == 0
    result = hybrid("accuracy", run, "--step")
    assert result.returncode == 2 and "see the line 'Error'" in result.stderr


def test_a_changed_mesh_is_told(hybrid, tmp_path):
    run, scene = tmp_path / "run", tmp_path / "bar.prm"
    (tmp_path / "bonded_blocks.geo").write_text((ROOT / "meshes/bonded_blocks.geo").read_text())
    text = BAR.read_text().replace("../../meshes/bonded_blocks.geo", str(tmp_path / "bonded_blocks.geo"))
    scene.write_text(text)
    assert hybrid(scene, "-s", "Output/Directory=%s" % run, "-s", "Time/End time=0.05", *ONE_RUN).returncode == 0
    os.utime(tmp_path / "bonded_blocks.geo", (2e9, 2e9))
    assert "was changed after the run began" in hybrid("accuracy", run, "--step").stdout


def test_error_of_a_bar_is_that_against_a_finer_one(hybrid, tmp_path):
    run, fine = tmp_path / "run", tmp_path / "fine"
    until = ["-s", "Time/End time=1.4"]  # most of the pulse has passed the station
    end = bar(hybrid, run, 4, *until).stdout
    assert "hybrid accuracy %s" % run in end
    bar(hybrid, fine, 1.5, *until)
    result = hybrid("accuracy", run)
    assert result.returncode == 0, result.stderr
    found = json.loads((run / "accuracy/accuracy.json").read_text())
    assert re.search(r"Error of the mesh: largest [0-9.]+ % \(station/velocity\)", result.stdout)
    assert "Half the size of the mesh takes about" in result.stdout and "Half the step takes about" in result.stdout
    end = quantities.end_of(str(run))
    own, true = quantities.read(str(run), end), quantities.read(str(fine), end)
    for row in found["rows"]:
        error = distance(own[row["quantity"]], true[row["quantity"]])
        assert error / 3 < row["error of the mesh"] < 3 * error, row["quantity"]
    # What is there is not computed again.
    kept = (run / "accuracy/mesh_2/run.h5").stat().st_mtime_ns
    again = hybrid("accuracy", run, "--mesh", "--quantities", "station/peak*")
    assert again.returncode == 0 and (run / "accuracy/mesh_2/run.h5").stat().st_mtime_ns == kept
    rows = json.loads((run / "accuracy/accuracy.json").read_text())["rows"]
    assert {row["quantity"] for row in rows} == {"station/peak " + q for q in ("displacement", "velocity", "acceleration")}
    assert "error of the step" not in rows[0]


def test_mistakes_are_told(hybrid, tmp_path):
    nothing = hybrid("accuracy", tmp_path)
    assert nothing.returncode == 2 and "no directory of a run" in nothing.stderr
    run = tmp_path / "run"
    bar(hybrid, run, 8, "-s", "Time/End time=0.05")
    pattern = hybrid("accuracy", run, "--mesh", "--quantities", "crest/*")
    assert pattern.returncode == 2 and "no quantity is like 'crest/*'" in pattern.stderr
    summary = json.loads((run / "summary.json").read_text())
    (run / "summary.json").write_text(json.dumps(dict(summary, finished=False)))
    stopped = hybrid("accuracy", run)
    assert stopped.returncode == 2 and "has not finished" in stopped.stderr
