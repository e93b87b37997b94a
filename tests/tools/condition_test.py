# SPDX-License-Identifier: GPL-3.0-or-later
"""hybrid condition: a slab that shakes down is conditioned, a block that slides down a plane never is."""
import json

import numpy as np
import pytest
from conftest import ONE_RUN, ROOT

from hybrid_run import Run
from hybrid_run.newmark import rate_on_slope, rigid_block
from hybrid_tools.condition.events import Events

SLAB = ROOT / "parameters/verification/shakedown.prm"
BLOCK = ROOT / "parameters/verification/incline.prm"
SLAB_WORDS = ("--quiet", "2", "-s", "Time/End time=6", "-s", "Output/Picture interval=0", *ONE_RUN)
BLOCK_WORDS = ("--quiet", "2", "--events", "3", "-s", "Time/End time=2", "-s", "Time/Time step=0.002", "-s", "Materials/rock/Friction angle=35",
               "-s", "Gravity/Static stage=equilibrium", "-s", "Motion/Type=ricker", "-s", "Motion/Frequency=1", "-s", "Motion/Peak=4", *ONE_RUN)


def read(directory):
    return json.loads((directory / "condition.json").read_text())


def test_a_slab_shakes_down_and_the_report_says_so(hybrid, tmp_path):
    out = tmp_path / "out"
    result = hybrid("condition", SLAB, *SLAB_WORDS, "--output", out)
    assert result.returncode == 0, result.stderr
    found = read(out)
    assert found["conditioned"] and [row["event"] for row in found["rows"]] == [1, 2]
    assert "Conditioned: event 2" in result.stdout and found["period_s"] == 8
    first, second = found["rows"]
    assert first["displacement added"] == pytest.approx(0.58e-3, rel=0.02) and first["at"] == "toe"
    assert abs(second["mean slip added"]) < 1e-4 * first["mean slip added"]
    states = {state["monitor"]: state for state in found["states"]}
    assert found["relative_to"] == "the base monitor ground" and "vectors, relative to the base monitor ground" in result.stdout
    assert states["toe"]["left, conditioned"] < 1e-3 * states["toe"]["left, virgin"] == first["displacement added"] * 1e-3
    # The run has both events, its summary the result, the page a chapter.
    run = Run(out / "run")
    assert run.time[-1] == pytest.approx(16) and run.summary["conditioning"]["verdict"] == found["verdict"]
    assert all((out / ("condition." + kind)).stat().st_size > 100 for kind in ("csv", "md", "png"))
    page = tmp_path / "page.html"
    assert hybrid("report", out / "run", "--output", page).returncode == 0
    assert "Virgin and conditioned" in page.read_text() and found["verdict"] in page.read_text()


def test_a_block_slides_the_same_in_every_event_as_newmark_says(hybrid, tmp_path):
    out = tmp_path / "out"
    result = hybrid("condition", BLOCK, *BLOCK_WORDS, "--output", out)
    assert result.returncode == 0, result.stderr
    found = read(out)
    assert not found["conditioned"] and len(found["rows"]) == 3 and "Not conditioned" in result.stdout
    slips = [row["mean slip added"] for row in found["rows"]]
    assert slips[1:] == pytest.approx([slips[0]] * 2, rel=1e-4)
    # Its monitor moves with the rigid base and slides: what is told is relative to the base, the slip alone.
    run = Run(out / "run")
    state, = found["states"]
    assert run.base == "" and found["relative_to"] == "the rigid base" and found["warnings"] == []
    assert state["peak displacement, virgin"] == pytest.approx(state["left, virgin"], rel=1e-3) == pytest.approx(slips[0], rel=1e-3)
    one = run.time <= found["period_s"]
    slope, friction = np.radians(30), np.radians(35)
    critical = 9.81 * np.tan(friction - slope)
    acceleration = run.get("input/acceleration")[: one.sum(), 0]
    expected = rigid_block(run.time[one], acceleration, critical, rate=rate_on_slope(slope, friction))[-1]
    assert slips[0] == pytest.approx(expected, rel=0.01)
    assert Events(run, found["period_s"]).event(2).failures == 0


def test_a_scene_that_would_end_at_rest_comes_again(hybrid, tmp_path):
    """Rest speed and an error target are those of one run. Warnings of the scene are told, before the events and in the files."""
    words = ("--quiet", "5", "--events", "2") + BLOCK_WORDS[4:] + (
        "-s", "Time/Rest speed=0.01", "-s", "Time/Error target=0.001 %", "-s", "Gravity/Acceleration=1")
    result = hybrid("condition", BLOCK, *words, "--output", tmp_path / "out")
    assert result.returncode == 0, result.stderr
    run = Run(tmp_path / "out/run")
    assert len(read(tmp_path / "out")["rows"]) == 2 and run.time[-1] == pytest.approx(14) and np.diff(run.time).max() == pytest.approx(0.002)
    of_scene, of_run = read(tmp_path / "out")["warnings"]  # of the run once, not with other numbers after each event
    assert of_scene.startswith("warning: Gravity/Acceleration = 1 m/s2 is doubtful") and of_run.startswith("warning: the time integration took")
    lines = result.stdout.splitlines()
    assert lines.index(of_scene) < min(k for k, line in enumerate(lines) if line.startswith("event  1")) < lines.index(of_run)
    assert of_scene in (tmp_path / "out/condition.md").read_text() and result.stdout.count("warning: ") == 2


@pytest.mark.parametrize("more, start, quiet", [(["--quiet", "0.5"], "0", "1.1"), (["--quiet", "1.2"], "0.5", "1.6")])
def test_events_that_would_overlap_are_refused_with_the_quiet_time_that_they_want(hybrid, tmp_path, more, start, quiet):
    """A wavelet of 3 s from Motion/Start on, End time 2 s."""
    result = hybrid("condition", BLOCK, *BLOCK_WORDS, *more, "-s", "Motion/Start=" + start, "--output", tmp_path / "out")
    assert result.returncode == 2 and "would overlap and add up" in result.stderr and "give --quiet %s or more" % quiet in result.stderr
    assert result.stderr.count("\n") == 1 and not (tmp_path / "out/run").exists()


def test_results_of_another_scene_are_not_replaced(hybrid, tmp_path):
    (tmp_path / "condition.json").write_text(json.dumps({"scene": "/elsewhere/scene.prm"}))
    result = hybrid("condition", SLAB, "--output", tmp_path)
    assert result.returncode == 2 and "holds results of '/elsewhere/scene.prm'" in result.stderr
    assert not (tmp_path / "run").exists()


def test_a_level_in_time_is_refused(hybrid, tmp_path):
    (tmp_path / "level.csv").write_text("time,level\n0,10\n2,0\n")
    result = hybrid("condition", BLOCK, *BLOCK_WORDS, "-s", "Water/Level file=level.csv", "-s", "Water/Method=submerged", "--output", "out", cwd=tmp_path)
    assert result.returncode == 2 and "would differ from event to event: Water/Level file" in result.stderr and result.stderr.count("\n") == 1
    assert not (tmp_path / "out/run").exists()


@pytest.mark.parametrize("words, part", [
    (["nowhere.prm"], "'nowhere.prm' is no parameter file"), ([SLAB, "--events", "1"], "--events is 1"), ([SLAB, "--part", "1"], "--part is 1"),
    ([SLAB, "--quiet", "-1"], "--quiet is -1"), ([BLOCK], "has no motion"), ([SLAB, "-s", "Motion/Repetitions=2"], "is set by hybrid condition: see its option --events"),
    ([SLAB, "-s", "Output/Directory=elsewhere"], "see its option --output"),
    ([SLAB, "-s", "Time/No=1"], "Time/No")])
def test_mistakes_are_one_line(hybrid, tmp_path, words, part):
    result = hybrid("condition", *words, "--output", "out", cwd=tmp_path)
    assert result.returncode == 2 and part in result.stderr and result.stderr.count("\n") == 1, result.stderr
