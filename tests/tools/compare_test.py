# SPDX-License-Identifier: GPL-3.0-or-later
"""hybrid compare: runs from formulas, whose differences are known, and runs of the program."""
import csv
import json

import h5py
import numpy as np
import pytest
from conftest import ONE_RUN, ROOT
from moving_run import STEP, Maker, quiver, wave

from hybrid_run import Run
from hybrid_run.parameter_differences import differences, main_difference
from hybrid_tools.compare import boreholes, command, curves, peaks, words
from hybrid_tools.compare.comparison import Comparison

@pytest.fixture
def make(tmp_path):
    return Maker(tmp_path)


@pytest.fixture
def compare(capsys):
    """compare(runs and words): exit code, what was printed; table.json as a dictionary."""
    def call(*given, figures=False):
        code = command.main([str(word) for word in given] + ([] if figures else ["--no-figures"]))
        path = next((word for k, word in enumerate(given) if given[k - 1] == "--out"), None) or given[0].parent / "compare"
        return code, capsys.readouterr().out, json.loads((path / "table.json").read_text())

    return call


def rows_by_name(table):
    return {(row["place"], row["quantity"]): row for row in table["rows"]}


def test_equal_runs_are_equal_in_every_digit(make, compare):
    code, text, table = compare(make("a"), make("b"), "--tolerance", "0%")
    assert code == 0 and "b = a in every digit" in table["verdict"][0] and table["within_tolerance"] and table["differences"] == []
    assert table["warnings"] == [] and "differs  nothing" in text and "within   0 %: all runs" in text


def test_known_differences_come_out_and_decide_the_exit_code(make, compare):
    a, b = make("a", slip=1.0, failures=[]), make("b", gain=1.04, slip=1.0, failures=[0.7, 1.1, 9.0])
    code, text, table = compare(a, b)
    rows = rows_by_name(table)
    t = STEP * np.arange(1, 4001)
    assert rows["crest", "peak u"]["a"] == pytest.approx(np.abs(wave(t)).max(), rel=1e-9)
    assert rows["crest", "left u"]["a"] == pytest.approx(wave(t)[-1], rel=1e-9)  # downhill is -x, and so it moves
    for name in ("peak u", "left u", "misfit u, L2", "peak u, up"):
        assert rows["crest", name]["b: change"] == pytest.approx(0.04, abs=1e-6), name
    assert rows["slip", "mean, left"]["b: change"] == 0
    assert rows["failed joints", ""]["a"] == 0 and rows["failed joints", ""]["b"] == 2  # the third came after the end
    assert code == 0 and "b differs from a: failed joints +2" in table["verdict"][0]
    assert compare(a, b, "--tolerance", "3%")[0] == 1
    make("c", gain=1.04, slip=1.0, failures=[])
    code, text, table = compare(a, a.parent / "c", "--tolerance", "5%")
    assert code == 0 and "c near a" in table["verdict"][0] and "+4 %" in text
    assert compare(a, a.parent / "c", "--tolerance", "0.03")[0] == 1
    make("d", gain=1.004, slip=1.0, failures=[])
    assert "d = a within 0.4 % everywhere" in compare(a, a.parent / "d")[2]["verdict"][0]


def test_another_reference_and_another_place(make, compare, tmp_path):
    a, b = make("one/a"), make("two/a", gain=0.5)
    code, text, table = compare(a, b, "--reference", b, "--out", tmp_path / "new")
    assert table["reference"] == "two/a" and [run["label"] for run in table["runs"]] == ["two/a", "one/a"]
    assert rows_by_name(table)["crest", "peak u"]["one/a: change"] == pytest.approx(1.0)
    assert sorted(path.name for path in (tmp_path / "new").iterdir()) == ["table.csv", "table.json", "table.md"]
    assert compare(a, make("one/wide", width=11.0), "--force")[0] == 0  # another section


def test_files_hold_the_same_numbers(make, compare):
    a, b = make("a"), make("b", gain=1.1)
    _, _, table = compare(a, b)
    with open(a.parent / "compare/table.csv", encoding="utf-8") as file:
        lines = list(csv.DictReader(file))
    assert [float(line["b"]) for line in lines if line["b"]] == [row["b"] for row in table["rows"] if row["b"] is not None]
    words = (a.parent / "compare/table.md").read_text()
    assert "| crest" in words and table["verdict"][0] in words


def test_differing_steps_and_lengths_are_resampled_and_cut(make, compare):
    a, b, c = make("a", step=2e-3), make("b", step=0.7e-3, end=3.0), make("c", step=2.5e-3, end=3.7)
    _, text, table = compare(a, b, c)
    assert table["compared_s"] == pytest.approx(3.0, abs=2.5e-3) and table["step_s"] == pytest.approx(2.5e-3)
    assert "(the shortest run)" in text
    rows = rows_by_name(table)
    for label in "bc":
        assert abs(rows["crest", "misfit u, L2"][label]) < 1e-4 and abs(rows["crest", "peak u"][label + ": change"]) < 1e-4
    assert any("the steps differ (2 | 0.7 | 2.5 ms)" in warning for warning in table["warnings"])


def test_filters_that_differ_are_made_the_same(make, compare):
    _, _, table = compare(make("a"), make("b", corner=10.0, parameters={"Monitors/Filter frequency": "10"}))
    assert table["low_pass_hz"] == 10 and rows_by_name(table)["crest", "peak a"]["b: change"] == 0
    assert any("the filters differ (25 | 10 Hz)" in warning for warning in table["warnings"])


def test_one_nan_is_told_and_is_within_no_tolerance(make, compare):
    code, text, table = compare(make("a"), make("b", nan_at=1.5), "--tolerance", "1000%")
    assert code == 1 and "b: not to be judged" in table["verdict"][0] and "(in b)" in table["verdict"][0]
    assert any("the displacement of crest is not a number in 1 of 4000 steps, first at 1.5 s" in warning for warning in table["warnings"])
    assert rows_by_name(table)["toe", "peak u"]["b: change"] == 0


def test_a_run_that_ended_before_the_motion_allows_no_verdict(make, compare):
    code, text, table = compare(make("a"), make("b", end=0.4), "--tolerance", "5%")
    assert code == 1 and "none: the motion has hardly begun in the first 0.4 s" in table["verdict"][0]


def test_a_part_of_the_motion_is_told(make, compare):
    table = compare(make("a"), make("b", end=1.2))[2]
    assert any("of the motion's energy" in warning for warning in table["warnings"])


def still(t):
    return 0 * t


def test_runs_that_do_not_move_are_not_called_equal(make, compare):
    table = compare(make("a", motion=still, sway=still), make("b", motion=still, sway=still))[2]
    assert table["verdict"] == ["none: nothing moves in any of the runs"]


@pytest.mark.parametrize("left, is_told", [(0.2, True), (0.001, False)])
def test_what_still_swings_at_the_end_is_told_and_what_trembles_is_not(make, compare, left, is_told):
    def swing(t):
        return 0.01 * np.sin(4 * np.pi * t) * np.where(t < 2, 1.0, left)

    table = compare(make("a", sway=swing), make("b", sway=swing))[2]
    assert any("still move" in warning for warning in table["warnings"]) == is_told


def test_a_run_that_goes_on_or_was_stopped_is_compared_and_fails_a_test(make, compare):
    a, b, c = make("a"), make("b", finished=False, end=3.0), make("c", summary={"finished": False}, end=3.5)
    code, text, table = compare(a, b, c, "--tolerance", "5%")
    assert code == 1 and "'b' goes on or was killed (3 s so far)" in text and "'c' stopped early, at 3.5 s" in text
    assert rows_by_name(table)["crest", "peak u"]["b: change"] == 0
    # of a run without filtered histories, too
    assert rows_by_name(table)["crest", "peak a"]["b: change"] == pytest.approx(0, abs=1e-9)


def test_what_does_not_move_as_the_others_is_small(make, compare):
    monitors = {"crest": ((0, 10), 1.0), "rock": ((5, 0), 1e-5), "base": ((0, -9), 0.0)}
    a, b = make("a", monitors=monitors), make("b", monitors={**monitors, "rock": ((5, 0), 1.5e-5)})
    code, text, table = compare(a, b, "--tolerance", "1%")
    assert code == 0 and rows_by_name(table)["rock", "peak u"]["b: change"] == pytest.approx(0.5) and "small" in text
    assert any("small: below a thousandth" in note for note in table["notes"])
    make("c", monitors={**monitors, "rock": ((5, 0), 0.5)})
    code, text, table = compare(a, a.parent / "c", "--tolerance", "1%")
    assert code == 1 and "rock peak u from 0" in table["verdict"][0] and rows_by_name(table)["rock", "peak u"]["c: change"] is None


def test_a_run_that_collapses_makes_the_others_neither_equal_nor_small(make, compare):
    a, b, c = make("a"), make("b", gain=1.12), make("c", gain=1e5)
    table = compare(a, b, c)[2]
    assert rows_by_name(table)["crest", "peak u"]["b: change"] == pytest.approx(0.12) and "b differs from a" in table["verdict"][0]


def test_what_springs_give_is_no_slip(make, compare):
    code, _, table = compare(make("a", slip=0.002), make("b", slip=0.004), "--tolerance", "1%")
    assert code == 0 and rows_by_name(table)["slip", "mean, left"]["b: change"] == pytest.approx(1)
    assert compare(make("c", slip=0.2), make("d", slip=0.4), "--tolerance", "1%")[0] == 1


def test_monitors_and_bases_that_differ_are_named(make, compare):
    monitors = {"crest": ((0, 10), 1.0), "base": ((0, -9), 0.0)}
    a, b = make("a", monitors={**monitors, "A1": ((1, 1), 1.0)}), make("b", monitors={**monitors, "crest": ((0.5, 10), 1.0)}, base="")
    warnings = "\n".join(compare(a, b)[2]["warnings"])
    assert "'a' also has the monitors A1" in warnings and "monitor crest lies at (0, 10) in 'a' and at (0.5, 10) in 'b'" in warnings
    assert "the base monitors differ (base | -): displacements are relative to 'base' in all runs" in warnings


def test_vertical_motion_has_rows_of_its_own(make, compare):
    _, _, table = compare(make("a", vertical=30.0), make("b", vertical=30.0, gain=1.02))
    rows = rows_by_name(table)
    assert ("crest", "peak u, up") in rows and ("crest", "peak u") not in rows
    assert rows["crest", "peak u, up"]["b: change"] == pytest.approx(0.02)


def test_what_is_left_near_zero_is_judged_by_the_peak(make, compare):
    def back(t):
        return wave(t) * (1 - np.clip((t - 2) / 1.999, 0, 1))

    _, text, table = compare(make("a", sway=back), make("b", sway=back, gain=1.5))
    assert abs(rows_by_name(table)["crest", "left u"]["b: change"]) < 0.01


def test_the_time_integration_and_the_mesh_are_warned_of(make, compare):
    summary = {"resolved_frequency_hz": 5.0, "motion_frequency_hz": 8.0,
               "resolved_by_part_hz": {"the sliding mass": 5.0, "the continuum": 9.0}}
    a, b = make("a", summary=summary), make("b", summary=dict(summary, resolved_frequency_hz=8.5), parameters={"Model/Blocks": "none"})
    warnings = "\n".join(compare(a, b)[2]["warnings"])
    assert "above 5 Hz the sliding mass of 'a' does not resolve the motion, which has energy up to 8 Hz" in warnings
    assert "8.5 Hz" not in warnings
    assert "the time integration differs (filtered | fourth order)" in warnings


@pytest.mark.parametrize("words, part", [
    (["a"], "one run alone"), (["a", "a"], "'a' is given twice"), (["a", "nowhere"], "'nowhere' is not a directory"),
    (["a", "wide"], "'wide' is of another section than 'a'"),
    (["a", "lonely"], "share no monitor: 'a' has base, crest, toe; 'lonely' has A1"),
    (["a", "b", "--tolerance", "much"], "--tolerance = 'much'"), (["a", "b", "--tolerance=-1%"], "is not a part"),
    (["a", "b", "--reference", "c"], "--reference = 'c' is none of the runs"), (["a", "b", "--out", "a"], "'a' holds a run"),
    (["a", "short"], "'short' has 2 steps"), (["a", "b", "--tolerence=1"], "did you mean '--tolerance'?")])
def test_mistakes_are_one_line(make, hybrid, words, part, tmp_path):
    options = {"wide": {"width": 11.0}, "lonely": {"monitors": {"A1": ((0, 0), 1.0)}, "base": ""}, "short": {"end": 2e-3}}
    for name in {"a", "b", *options} & set(words):
        make(name, **options.get(name, {}))
    result = hybrid("compare", *words, cwd=tmp_path)
    assert result.returncode == 2 and part in result.stderr and result.stderr.count("\n") == 1, result.stderr


def test_runs_without_motion_base_or_parameters(synthetic_run, compare):
    a, b = synthetic_run("bare", "a"), synthetic_run("bare", "b")
    code, text, table = compare(a, b, figures=True)
    assert code == 0 and "unknown: a run has no params.used.prm" in text and "b = a in every digit" in text
    assert sorted(path.stem for path in (a.parent / "compare/figures").iterdir()) == ["differences", "histories", "peaks", "response_spectra"]


def test_every_figure_of_complete_runs_and_none_of_an_earlier_comparison(synthetic_run, compare):
    a, b = synthetic_run("complete", "a"), synthetic_run("complete", "b")
    figures = a.parent / "compare/figures"
    figures.mkdir(parents=True)
    (figures / "failures.png").write_bytes(b"old")
    with h5py.File(b / "run.h5", "a") as file:
        file["slip/mean"][:] *= 1.5
        file["slip/largest"][:] *= 1.5
    code, text, table = compare(a, b, figures=True)
    assert code == 0 and "10 figures" in text
    assert sorted(path.stem for path in figures.iterdir()) == sorted(command.FIGURES)
    assert all(path.read_bytes().startswith(b"\x89PNG\r\n\x1a\n") for path in figures.iterdir())
    assert rows_by_name(table)["slip", "mean, left"]["b: change"] == pytest.approx(0.5)
    assert "8 more monitors" in text and "\nS" in text


@pytest.mark.parametrize("has_surface", [True, False])
def test_boreholes_name_the_sliding_surface_where_there_is_one(synthetic_run, has_surface, monkeypatch, tmp_path):
    runs = [synthetic_run("complete", name) for name in "ab"]
    for directory in runs:
        with h5py.File(directory / "run.h5", "a") as file:
            if not has_surface:
                del file["section/surface"]
                for borehole in file["profiles"].values():
                    borehole.attrs.pop("slip_depth_m", None)
    named = []
    monkeypatch.setattr(curves, "finish", lambda *given: named.extend(handle.get_label() for handle in given[-1]))
    boreholes.draw(Comparison([Run(directory) for directory in runs], ["a", "b"]), tmp_path)
    assert ("sliding surface" in named) == has_surface and named[:2] == ["a", "b"]


def test_peaks_of_monitors_are_those_of_the_histories(make):
    a, b = make("a"), make("b", gain=2.0)
    comparison = Comparison([Run(a), Run(b)], ["a", "b"])
    moved, fast, shaken = peaks.quantities(comparison, ["crest", "toe"])
    t = STEP * np.arange(1, 4001)
    largest = 1e3 * np.abs(wave(t)).max()  # [mm]
    assert moved[0] == pytest.approx(largest * np.array([[1.0, 0.5], [2.0, 1.0]])) and "[mm]" in moved[1] and moved[2] is None
    ground = np.abs(np.gradient(quiver(t) - wave(t), STEP)).max()
    assert fast[0][0, 0] == pytest.approx(ground, rel=2e-2) and "[m/s]" in fast[1]  # below 25 Hz
    outcrop = np.gradient(np.gradient(quiver(t), STEP), STEP)
    assert shaken[0][0, 0] == pytest.approx(np.abs(comparison.acceleration(0, "crest")[:, 0]).max() / np.abs(outcrop).max()) and shaken[2] == 1.0


def test_peaks_without_a_motion_are_in_g(make):
    still = [Run(make(name, motion=lambda t: 0 * t)) for name in "ab"]
    values, words, level = peaks.quantities(Comparison(still, ["a", "b"]), ["crest"])[-1]
    assert "[g]" in words and level is None and np.isfinite(values).all()


@pytest.mark.parametrize("values, scale, lowest", [([1.0, 8.0], "linear", 1.0), ([0.1, 80.0], "log", 0.1), ([0.0, 0.2, 80.0], "log", 0.2 / 1.5), ([0.0, 0.0], "linear", 0.0)])
def test_peaks_that_are_far_apart_have_a_logarithmic_axis(values, scale, lowest):
    axis = curves.plt.figure().add_subplot()
    drawn = peaks.set_scale(axis, np.array([values]))
    assert axis.get_yscale() == scale and drawn.min() == pytest.approx(lowest)
    curves.plt.close("all")


def test_runs_of_the_program(hybrid, tmp_path):
    scene = ROOT / "parameters/verification/coupled_column.prm"
    for name, words in (("fine", []), ("coarse", ["-s", "Time/Time step=0.004"]), ("hard", ["-s", "Materials/rock/Young modulus=250e6"])):
        result = hybrid(scene, "-s", f"Output/Directory={tmp_path}/{name}", *ONE_RUN, *words)
        assert result.returncode == 0, result.stderr
    result = hybrid("compare", *(tmp_path / name for name in ("fine", "coarse", "hard")), "--tolerance", "5%")
    assert result.returncode == 1 and not result.stderr, result.stderr
    assert "Time/Time step" in result.stdout and "Materials/rock/Young modulus" in result.stdout and "beyond   5 %: 'hard'" in result.stdout
    table = json.loads((tmp_path / "compare/table.json").read_text())
    rows = rows_by_name(table)
    assert rows["top", "misfit u, L2"]["coarse"] < 0.02 < rows["top", "misfit u, L2"]["hard"]
    fine = json.loads((tmp_path / "fine/summary.json").read_text())
    assert {"the continuum", "the sliding mass"} == set(fine["resolved_by_part_hz"])
    assert fine["resolved_frequency_hz"] == min(fine["resolved_by_part_hz"].values())
    assert fine["motion_frequency_hz"] == pytest.approx(1.664 * 6, abs=0.3)  # of a Ricker wavelet
    assert {"histories", "differences", "spectral_ratios", "response_spectra", "section_maps", "cost"} <= {
        path.stem for path in (tmp_path / "compare/figures").iterdir()}
    assert hybrid("compare", tmp_path / "fine", tmp_path / "hard", "--no-figures").returncode == 0
    rows = rows_by_name(json.loads((tmp_path / "compare/table.json").read_text()))
    for name in ("fine", "hard"):  # with equal steps the peaks are those of the program
        summary = json.loads((tmp_path / name / "summary.json").read_text())["monitors"]["top"]
        assert rows["top", "peak a"][name] == pytest.approx(abs(summary["peak_acceleration_m_s2"][0]), rel=1e-9)
        assert rows["top", "left u"][name] == pytest.approx(summary["final_displacement_m"][0], rel=1e-9)


def test_a_monitor_that_does_not_move_is_named_as_such(make, compare):
    """Within rigid bedrock -100 % says nothing of the mass."""
    within = {"crest": ((0, 10), 1.0), "toe": ((9, 1), 0.0), "base": ((0, -9), 0.0)}
    a, b = make("a", slip=1.0, failures=[]), make("b", gain=1.3, slip=1.0, failures=[], monitors=within)
    verdict = compare(a, b)[2]["verdict"][0]
    assert "toe does not move" in verdict and "toe peak" not in verdict and "crest" in verdict and "+30 %" in verdict, verdict


def test_many_runs_and_long_lists_stay_readable():
    points = ["; ".join("S%d: %d, 1" % (k, k) for k in range(30)) + "; E: %d, 2" % end for end in (1, 2)]
    assert words.shortened(points, ["a", "b"]) == ["E: 1, 2", "E: 2, 2"]
    folders = ["/a/very/long/path/" + 40 * "x" + end for end in ("/first/section.geo", "/second/section.geo")]
    shown = words.shortened(folders, ["a", "b"])
    assert all("/%s/section.geo" % name in text and len(text) < 60 for name, text in zip(("first", "second"), shown))
    values = ["1 m/s2"] * 5 + ["0.3 g"]
    assert words.shortened(values, list("abcdef")) == ["1 m/s2 (5 runs)", "0.3 g (f)"]
    looks = [(look["color"], str(look["ls"])) for look in map(curves.look, range(49))]
    assert len(set(looks)) == 49


def test_the_main_difference_is_no_length_of_the_run_and_no_record():
    found = differences([{"Time/End time": "1", "Monitors/Points": "a: 0, 0", "Motion/Peak": "1 g"},
                         {"Time/End time": "2", "Monitors/Points": "b: 0, 0", "Motion/Peak": "2 g"}])
    assert main_difference(found).name == "Motion/Peak" and main_difference(found[:1]).name == "Time/End time"
