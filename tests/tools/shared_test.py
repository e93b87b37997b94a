# SPDX-License-Identifier: GPL-3.0-or-later
"""What several tools share: one time axis for several runs, misfits, the program's low-pass, parameters that differ, tables."""
import csv
import io
import json

import numpy as np
import pytest
from conftest import ONE_RUN, ROOT
from moving_run import PARAMETERS

from hybrid_run import Run, misfit
from hybrid_run.low_pass import low_pass
from hybrid_run.parameter_differences import differences, main_difference
from hybrid_run.resample import common_axis, resample
from hybrid_tools.compare import verdict
from hybrid_tools.table import Cell, Column, Table, percent


def steps(dt, end):
    return dt * np.arange(1, round(end / dt) + 1)


def test_the_axis_of_equal_runs_is_their_own_and_their_rows_stay_as_they_are():
    time = np.cumsum(np.full(500, 1e-3))
    values = np.random.default_rng(1).standard_normal((500, 2))
    axis = common_axis([time, time[:400]])
    assert np.array_equal(axis, time[:400])
    assert np.array_equal(resample(time, values, axis), values[:400])


def test_the_axis_is_as_coarse_as_the_coarsest_and_as_short_as_the_shortest():
    axis = common_axis([steps(1e-3, 2), steps(4e-3, 3), steps(2.5e-3, 2.6)])
    assert axis == pytest.approx(steps(4e-3, 2))
    assert len(common_axis([steps(1e-3, 0.1), 5 + steps(1e-3, 1)])) == 0


@pytest.mark.parametrize("fine", [1e-3, 0.7e-3, 2.5e-3, 4.3e-3])
def test_slow_waves_keep_amplitude_and_phase(fine):
    def wave(t):
        return np.column_stack([np.sin(2 * np.pi * 3 * t), 0.2 * t + np.cos(2 * np.pi * 5 * t)])

    time, axis = steps(fine, 4), steps(5e-3, 3.9)
    inner = (axis > 0.1) & (axis < 3.8)
    assert np.abs(resample(time, wave(time), axis) - wave(axis))[inner].max() < 2e-4


def test_displacements_are_taken_at_their_times_up_to_the_end():
    time, axis = steps(1e-3, 1), steps(4e-3, 1)
    assert np.abs(resample(time, 5 * time**2, axis, has_aliases=False) - 5 * axis**2).max() < 1e-13
    assert np.abs(resample(time, 5 * time**2, axis) - 5 * axis**2).max() > 1e-6  # the low-pass does not know what comes after the end


def test_what_the_coarse_steps_cannot_show_is_taken_out_instead_of_folded_back():
    time, axis = steps(1e-3, 4), steps(1e-2, 4)
    fast = np.sin(2 * np.pi * 91 * time)  # would look like 9 Hz in steps of 10 ms
    inner = (axis > 0.2) & (axis < 3.8)
    assert np.abs(np.interp(axis, time, fast))[inner].max() > 0.9
    assert np.abs(resample(time, fast, axis))[inner].max() < 1e-3


def test_cut_steps_are_filled_and_one_nan_stays_in_its_column():
    time = np.sort(np.concatenate([steps(2e-3, 2), 1 + 1e-3 * np.arange(0.5, 20)]))
    values = np.column_stack([np.sin(9 * time), np.cos(9 * time)])
    axis = common_axis([time, steps(2e-3, 2)])
    assert resample(time, values, axis) == pytest.approx(np.column_stack([np.sin(9 * axis), np.cos(9 * axis)]), abs=1e-6)
    values[7, 1] = np.nan
    found = resample(time, values, axis)
    assert np.isfinite(found[:, 0]).all() and np.isnan(found[:, 1]).all()


def test_misfits():
    reference = np.sin(np.linspace(0, 9, 1000))[:, None] * [1, 2]
    assert misfit.relative_l2(1.03 * reference, reference) == pytest.approx(0.03)
    assert misfit.relative_l2(reference, reference) == 0 == misfit.relative_l2(0 * reference, 0 * reference)
    assert misfit.relative_l2(reference, 0 * reference) == np.inf
    assert np.isnan(misfit.relative_l2([1, np.nan], [1, 2])) and np.isnan(misfit.relative_l2([1, 2], [np.inf, 2]))
    assert misfit.relative_change(-3, -2) == -0.5 and misfit.relative_change(3, 2, scale=10) == 0.1
    assert misfit.relative_change(0, 0) == 0 and misfit.relative_change(-1, 0) == -np.inf
    assert misfit.peak([1, -3, 2]) == -3 and np.array_equal(misfit.peak([[1, 2], [-4, 0]]), [-4, 2])
    assert np.isnan(misfit.peak([1, np.nan])) and np.isnan(misfit.peak([[1, 2], [np.inf, 0]])[0])


def test_the_low_pass_is_that_of_the_program(hybrid, tmp_path):
    scene = ROOT / "parameters/verification/coupled_column.prm"
    result = hybrid(scene, "-s", "Time/End time=0.3", "-s", f"Output/Directory={tmp_path}/run", *ONE_RUN)
    assert result.returncode == 0, result.stderr
    run = Run(tmp_path / "run")
    for monitor in run.monitors.values():
        time, filtered = monitor.filtered("acceleration")
        assert low_pass(monitor.acceleration, time[1] - time[0], run.corner) == pytest.approx(filtered, rel=1e-9, abs=1e-9)


@pytest.fixture
def table():
    return Table([Column("place"), Column("peak", "m", "%.3f"), Column("change", show=percent)],
                 [["crest", np.float64(1 / 3), 0.0213], ["crest", Cell(1.25e-3, "1.25 mm"), float("nan")], ["a|b", None, np.inf]])


def test_a_table_for_people(table):
    assert table.text().splitlines() == ["place      peak [m]    change",
                                         "crest         0.333      +2 %",
                                         "            1.25 mm         ?",
                                         "a|b               -    from 0"]
    head, line, *rows = table.markdown().splitlines()
    assert line.split("|")[1].startswith(":-") and line.split("|")[2].endswith("-:")  # words to the left, numbers to the right
    assert rows[1].split("|")[1].strip() == "crest" and "a\\|b" in rows[2]


def test_a_table_for_machines(table, tmp_path):
    rows = list(csv.reader(io.StringIO(table.csv())))
    assert rows[0] == ["place", "peak [m]", "change"] and float(rows[1][1]) == 1 / 3 and float(rows[2][1]) == 1.25e-3 and rows[3][1] == ""
    paths = table.write(tmp_path / "new", "table", {"title": "t"})
    content = json.loads((tmp_path / "new/table.json").read_text())
    assert len(paths) == 3 and content["title"] == "t" and content["units"] == {"peak": "m"}
    assert content["rows"][0] == {"place": "crest", "peak": 1 / 3, "change": 0.0213} and content["rows"][1]["change"] is None


@pytest.mark.parametrize("value, words", [(0, "0 %"), (0.02, "+2 %"), (-0.394, "-39 %"), (0.004, "+0.4 %"), (2e-5, "+0.002 %"),
                                          (-2e-9, "~0 %"), (-7.1, "-710 %"),
                                          (0.0096, "+1 %"), (float("inf"), "from 0"), (float("nan"), "?")])
def test_percents_have_two_digits(value, words):
    assert percent(value) == words


def test_parameters_that_differ_are_sorted_out():
    layers = {"Model/Bedrock": "layers", "Continuum/Sides": "viscous", "Time/Time step": "1e-3", "Output/Directory": "y"}
    scenes = [dict(PARAMETERS), {**PARAMETERS, **layers},
              {**PARAMETERS, "Model/Bedrock": "rigid", "Continuum/Sides": "viscous", "Output/Flush interval": "3"}]
    found = {difference.name: difference for difference in differences(scenes)}
    assert set(found) == {"Model/Bedrock", "Continuum/Sides", "Output/Flush interval"}  # 1e-3 is 0.001, a directory is a name
    assert found["Continuum/Sides"].values == ("free field", "viscous", None)  # a rigid bedrock has no sides
    assert not found["Output/Flush interval"].has_effect
    assert main_difference(found.values()).name == "Model/Bedrock" and main_difference([]) is None
    levels = [dict(PARAMETERS, **{"Time/Time step": step, "Motion/Seed": seed}) for step, seed in (("1", "1"), ("2", "2"), ("3", "1"))]
    assert main_difference(differences(levels)).name == "Time/Time step"


@pytest.mark.parametrize("change, words", [(0.004, "0.4 %"), (0.00401, "0.5 %"), (0.0199, "2 %"), (0.123, "13 %"), (1.0, "100 %")])
def test_what_is_rounded_up_stays_true(change, words):
    assert verdict.rounded_up(change) == words
