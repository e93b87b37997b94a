# SPDX-License-Identifier: GPL-3.0-or-later
"""Parts of hybrid study that need no run: orders and errors of formulas, what is varied, study files, pages."""
import math

import numpy as np
import pytest
from conftest import ROOT

from hybrid_run import UserError, convergence
from hybrid_tools.study import analysis, axes, command, page, plan, profile_bands, quantities, report, stated, study_file, tables
from hybrid_tools.study.run_directory import RunDirectory, reason_of

# Orders, extrapolation, chaos: closed forms.


@pytest.mark.parametrize("sizes", [(4, 2, 1), (1, 0.5, 0.2), (3, 2, 1.5)])
@pytest.mark.parametrize("p", [0.6, 1.0, 2.0, 4.0])
def test_order_and_limit_of_a_power_law(sizes, p):
    values = [7 + 0.3 * h**p for h in sizes]
    differences = np.abs(np.diff(values))
    assert convergence.order(sizes, differences) == pytest.approx(p, rel=1e-9)
    factor = convergence.correction(sizes[1:], p)
    assert values[2] + factor * (values[2] - values[1]) == pytest.approx(7, rel=1e-12)
    found = convergence.assess(sizes, differences / 7, [1.0])
    assert found.verdict == "converges" and found.is_clean and found.order == pytest.approx(p)
    assert convergence.order_of_errors(sizes[:2], [0.3 * h**p for h in sizes[:2]]) == pytest.approx(p)


def test_levels_that_do_not_converge_have_no_order():
    def verdict(differences, directions, scatter=None):
        found = convergence.assess([8, 4, 2, 1][-1 - len(differences):], differences, directions, scatter)
        assert found.verdict == "converges" or math.isnan(found.order)
        return found.verdict, found.is_doubtful

    assert verdict([0.05, 0.02, 0.06], [1, 1]) == ("does not converge", False)  # fine runs differ by more than coarse ones
    assert verdict([0.08, 0.04, 0.02], [1, 1], scatter=0.03) == ("does not converge", False)  # no more than next to nothing does
    assert verdict([0.08, 0.04, 0.02], [1, -1]) == ("irregular", True)
    assert verdict([0.08, 0.04, 0.02], [1, -1], scatter=1e-6) == ("irregular", False)
    assert verdict([0.002, 0.001, 0.0011], [1, 1]) == ("irregular", False)
    assert verdict([0.0, 1e-12, 0.0], [1, 1]) == ("equal", False)
    assert verdict([0.08, 0.04, 0.02], [1, 1], scatter=1e-6) == ("converges", False)
    assert not convergence.assess([8, 4, 2, 1], [0.3, 0.04, 0.02], [1, 1]).is_clean  # orders 2.9 and 1: not steady
    rng = np.random.default_rng(1)
    for _ in range(20):  # histories drawn at random
        samples = rng.standard_normal((4, 400))
        steps = np.diff(samples, axis=0)
        directions = [a @ b / np.linalg.norm(a) / np.linalg.norm(b) for a, b in zip(steps, steps[1:])]
        found = convergence.assess([8, 4, 2, 1], np.linalg.norm(steps, axis=1) / np.linalg.norm(samples[-1]), directions)
        assert math.isnan(found.order) and (found.is_doubtful or found.verdict == "does not converge")


def test_the_pareto_front_is_what_nothing_beats():
    assert convergence.pareto([1, 2, 3, 4, 2], [9, 5, 6, 1, 4]) == [0, 4, 3]
    assert convergence.pareto([], []) == []


def test_a_peak_between_two_steps_is_found():
    t = np.arange(0.023, 1.4, 0.05)  # the peak is in the middle between two of them
    values = np.column_stack([3 * np.sin(2.1 * t), 4 * np.sin(2.1 * t)])
    assert quantities.peak(t, values) == pytest.approx(5, rel=1e-4)
    assert np.linalg.norm(values, axis=1).max() < 5 * (1 - 1e-3)


# What is varied.


def test_values_with_commas_and_equal_signs():
    axis = axes.parse_axis("Mesh/Numbers=Resolution/h = 2|8|4")
    assert (axis.name, axis.labels, axis.kind) == ("Mesh/Numbers:Resolution/h", ["8", "4", "2"], "ladder")
    assert (axis.sizes, axis.reference) == ([8, 4, 2], 2)
    assert axis.override(0, {"Mesh/Numbers": "Width = 10; Resolution/h = 1"}) == "Mesh/Numbers=Width = 10; Resolution/h = 8"
    axis = axes.parse_axis("Bedding planes/Names=|a, b|a, b, c")
    assert axis.labels == ["", "a, b", "a, b, c"] and axis.kind == "models" and axis.override(1, {}) == "Bedding planes/Names=a, b"
    assert axes.parse_axis("Continuum/Degree=3,1,2").labels == ["1", "2", "3"]
    assert axes.parse_axis("Heterogeneity/Seed=1,2").kind == "samples"
    assert axes.parse_axis("Time/Scheme=trapezoidal,dissipative").kind == axes.parse_axis("Mesh/File=a.geo,b.geo").kind == "options"
    bedrock = axes.parse_axis("Model/Bedrock=rigid,continuum")
    assert bedrock.kind == "models" and axes.sort_levels(bedrock, "continuum").kind == "options" and bedrock.reference == 1
    assert axes.parse_axis("Blocks/Penalty ratio=10,40").sizes == [0.1, 0.025]
    axis = axes.sort_levels(axes.parse_axis("Blocks/Shear ratio=1,0.25,0.5"), "0.25")
    assert axis.kind == "ladder" and axis.labels == ["1", "0.5", "0.25"]
    for wrong in ("Time/Time step", "=1,2", "Time/Time step=1e-3,1e-3", "Mesh/Numbers=1|2", "Output/Directory=a,b"):
        with pytest.raises(UserError):
            axes.parse_axis(wrong)


def test_a_tolerance_is_a_part():
    assert plan.parse_tolerance("2%") == plan.parse_tolerance("0.02") == 0.02
    for wrong in ("", "two", "-1%", "0", "2"):
        with pytest.raises(UserError, match="tolerance"):
            plan.parse_tolerance(wrong)


def test_a_value_with_a_unit_is_shown_whole_and_a_file_by_its_name():
    assert [axes.label_text(label) for label in ("1 m/s2", "50 cm/s2", "records/a.at2", "")] == ["1 m/s2", "50 cm/s2", "a.at2", "none"]


def test_a_study_file_is_read_and_its_mistakes_are_told(tmp_path):
    path = tmp_path / "study.toml"
    path.write_text('scene = "a.prm"\ntolerance = "2%"\n[vary]\n"Time/Time step" = [1e-3, 2e-3]\n'
                    '[closed_form]\n"a/displacement" = "a.csv"\n')
    content = study_file.read(str(path))
    assert content["scene"] == str(tmp_path / "a.prm") and content["closed_form"] == {"a/displacement": str(tmp_path / "a.csv")}
    for text, message in (("scene = 3", "wrong kind"), ("secne = 'a'", "unknown entry"), ("tolerance = 1", "no entry 'scene'"),
                          ("a = [", "study.toml"), ("scene = 'a'\n[vary]\nb = 3", "list of values")):
        path.write_text(text)
        with pytest.raises(UserError, match=message):
            study_file.read(str(path))


def test_a_closed_form_of_a_history_has_its_peak_and_its_end(tmp_path):
    t = np.linspace(0.01, 1, 100)
    np.savetxt(tmp_path / "a.csv", np.column_stack([t, t**2, 0 * t]), delimiter=",", header="time, x, y")
    found = quantities.closed_form(("a/displacement", str(tmp_path / "a.csv")), 0.5)
    assert found["a/final displacement"].value == pytest.approx(0.25, rel=1e-4)
    assert found["a/displacement"].at(np.array([0.303]))[0, 0] == pytest.approx(0.303**2, rel=1e-4)
    with pytest.raises(UserError, match="up to 2 s"):
        quantities.closed_form(("a/displacement", str(tmp_path / "a.csv")), 2.0)


def test_what_a_run_said_last_is_its_reason(tmp_path):
    assert reason_of("card\nwarning: a\nwarning: stopped at t = 1 s: b\nStopped: 1 step\n") == "stopped at t = 1 s: b"
    assert reason_of("warning: a\nerror: no file\n") == "no file"
    run = RunDirectory(str(tmp_path), "a")
    run.take_result(-9)
    assert run.state == "failed" and run.is_to_run()
    run.take_result(3, "error: disk full")
    assert run.state == "failed" and run.manifest["reason"] == "disk full" and not run.is_to_run() and run.is_to_run(again=True)


def made_up(directory, error, failed=()):
    """A study of runs whose results are formulas: error(h, dt) of a number whose true value is 1."""
    varied = [axes.parse_axis("Mesh/Numbers=Resolution/h = 4|2|1"), axes.parse_axis("Time/Time step=4e-3,2e-3,1e-3")]
    study = plan.Study("scene.prm", str(directory), [], varied, base={"Title": "made up"})
    runs = []
    for setting in study.settings():
        run = RunDirectory(str(directory), setting.name)
        h, dt = (axis.sizes[level] for axis, level in zip(varied, setting.levels))
        run.update(state="failed" if (h, dt) in failed else "done", processor_time_s=1 / h / dt)
        runs.append((setting, run, {"a/peak displacement": quantities.Number(1 + error(h, dt))}))
    return study, runs


def analysed(monkeypatch, study, runs):
    found = {run.path: values for _, run, values in runs}
    monkeypatch.setattr(quantities, "end_of", lambda path: 1.0)
    monkeypatch.setattr(quantities, "read", lambda path, end: found[path])
    return analysis.Analysis(study, [(setting, run) for setting, run, _ in runs])


def test_errors_of_a_grid_are_those_of_the_formula(tmp_path, monkeypatch):
    def error(h, dt):
        return 0.01 * h**2 + 3 * dt

    found = analysed(monkeypatch, *made_up(tmp_path, error))
    for result in found.done:
        h, dt = (axis.sizes[level] for axis, level in zip(found.study.axes, result.setting.levels))
        assert found.error(result)[0] == pytest.approx(error(h, dt), rel=1e-6)
    assert [row.order for ladder in tables.ladders(found) for row in ladder.rows.values()] == pytest.approx([2, 1])
    assert {kind for kind in (found.errors(result)["a/peak displacement"][1] for result in found.done)} == {"Richardson"}
    settings = [entry.name(found.study) for entry in tables.pareto(found)]
    assert settings[0] == "h 4, Time step 4e-3" and settings[-1] == "h 1, Time step 1e-3"


def test_samples_share_a_setting(tmp_path, monkeypatch):
    study = plan.Study("scene.prm", str(tmp_path), [], [axes.parse_axis("Motion/Seed=1,2"), axes.parse_axis("Time/Time step=2e-3,1e-3")],
                       base={}, tolerance=0.4)
    runs = []
    for setting in study.settings():
        run, (seed, step) = RunDirectory(str(tmp_path), setting.name), setting.levels
        run.update(state="done", processor_time_s=10.0 * (1 + step) + seed)
        runs.append((setting, run, {"a/peak displacement": quantities.Number((1 + seed) * (1.0 if step else 1.1 + 0.2 * seed))}))
    found = analysed(monkeypatch, study, runs)
    (entry,) = tables.judged(found)
    assert entry.error == pytest.approx(0.3) and entry.cost == pytest.approx(10.5) and entry.name(study) == "Time step 2e-3 (2 samples)"
    assert "is Time step 2e-3 (2 samples); it costs 10.5 s" in report.sentence(found)


def test_another_model_is_another_problem_with_a_front_of_its_own(tmp_path, monkeypatch):
    """Rigid bedrock is no cheap way to the answer on an elastic one: its errors are those against its own finest run."""
    def analyse(axis):
        study = plan.Study("scene.prm", str(tmp_path), [], [axis, axes.parse_axis("Time/Time step=4e-3,2e-3,1e-3")], base={}, tolerance=0.02)
        runs = []
        for setting in study.settings():
            run, (model, step) = RunDirectory(str(tmp_path), setting.name), setting.levels
            run.update(state="done", processor_time_s=(1.0 if model else 10.0) * 2**step)
            runs.append((setting, run, {"a/peak displacement": quantities.Number((2.0 if model else 1.0) * (1 + 0.04 / 4**step))}))
        return analysed(monkeypatch, study, runs)

    found = analyse(axes.parse_axis("Model/Bedrock=continuum,rigid"))
    for result in found.done:
        assert found.error(result)[0] == pytest.approx(0.04 / 4 ** result.setting.levels[1], rel=1e-6)
    assert [len(tables.front_of(entries)) for entries in tables.problems(found).values()] == [3, 3]
    assert report.sentence(found).count("The cheapest setting") == 2 and "Bedrock rigid, Time step 2e-3; it costs 2 s" in report.sentence(found)
    change = next(row for row in tables.options(found).rows if row[0] == "Bedrock = rigid")[3]
    assert change == pytest.approx(1, rel=1e-2)  # what the model changes is told, as no error
    found = analyse(axes.sort_levels(axes.parse_axis("Model/Bedrock=continuum,rigid"), "continuum"))
    assert found.error(found.of((1, 2)))[0] == pytest.approx(1, rel=1e-2) and list(tables.problems(found)) == [""]


def test_without_its_finest_run_a_study_takes_the_next(tmp_path, monkeypatch):
    found = analysed(monkeypatch, *made_up(tmp_path, lambda h, dt: 0.01 * h**2 + 3 * dt, failed={(1, 1e-3), (2, 1e-3), (4, 1e-3)}))
    assert len(found.done) == 6 and found.study.describe(found.finest(found.study.finest).setting) == "h 1, Time step 2e-3"
    coarse = found.error(found.of((0, 0)))[0]
    assert coarse == pytest.approx(abs(1 + 0.16 + 0.012 - 1.016) / 1.016, rel=1e-6)
    assert [tables.ladder_title(found, ladder) for ladder in tables.ladders(found)] == ["h (Time step 2e-3)", "Time step (h 1)"]
    assert len(tables.runs(found).rows) == 9


def test_the_closed_form_of_a_scene_is_that_of_its_problem_alone(tmp_path):
    scene = tmp_path / "a.prm"
    scene.write_text("# Closed form: a/final displacement = 1.5\n#Closed form:  a/displacement=b.csv\n")
    with pytest.raises(UserError, match="closed form of a/displacement: 'b.csv' is no number"):
        stated.read(str(scene))
    (tmp_path / "b.csv").write_text("")
    assert stated.read(str(scene)) == {"a/final displacement": 1.5, "a/displacement": str(tmp_path / "b.csv")}
    step, motion = axes.parse_axis("Time/Time step=1e-3,2e-3"), axes.parse_axis("Motion/Peak=1,2")
    assert stated.other_problem([step], ["Time/End time=3", "Continuum/Degree=4", "Mesh/Numbers=Resolution/h = 2; Resolution/far = 3"]) == ""
    assert stated.other_problem([step, motion], []) == "Motion/Peak"
    assert stated.other_problem([step], ["Mesh/Numbers=Resolution/h = 2; Width = 3"]) == "Mesh/Numbers"
    assert stated.other_problem([step], ["Blocks/Damping ratio=0.1"]) == "Blocks/Damping ratio"


# Pages.


def test_a_page_gets_the_front_and_the_verdict_between_its_marks(monkeypatch, tmp_path):
    study, runs = made_up(tmp_path / "bar-study", lambda h, dt: 1e-3 * h**2 + 1e4 * dt**2)
    study.tolerance = 0.05
    path = tmp_path / "page.md"
    path.write_text("before\n<!-- study bar -->\nold\n<!-- end of study bar -->\nafter\n")
    page.check(path, study)
    made = analysed(monkeypatch, study, runs)
    page.put(path, made)
    first = path.read_text()
    page.put(path, made)
    assert path.read_text() == first and "old" not in first and first.startswith("before\n<!-- study bar -->\n")
    assert first.endswith("<!-- end of study bar -->\nafter\n") and "The cheapest setting with an error below 5 % is " in first
    rows = [line for line in first.splitlines() if line.startswith("| h ")]
    assert len(rows) == len(tables.pareto(made)) > 1


def test_a_page_without_the_marks_is_refused(tmp_path):
    study, _ = made_up(tmp_path / "bar-study", lambda h, dt: h + dt)
    path = tmp_path / "page.md"
    path.write_text("nothing\n")
    with pytest.raises(UserError, match="study bar"):
        page.check(path, study)


def test_bands_along_a_borehole_keep_the_jump_at_the_sliding_surface():
    depth, x = np.array([0.0, 10.0, 20.0, 20.0, 30.0]), np.array([5.0, 4.0, 3.0, 1.0, 0.0])
    wanted, found = profile_bands.resampled(depth, x, 20.0)
    above = wanted[: profile_bands.POINTS]
    assert above[-1] == 20.0 and found[profile_bands.POINTS - 1] == 3.0 and found[profile_bands.POINTS] == 1.0
    assert found[: profile_bands.POINTS] == pytest.approx(5 - above / 10) and (found[0], found[-1]) == (5.0, 0.0)
    wanted, found = profile_bands.resampled(depth[[0, 1, 4]], x[[0, 1, 4]], None)
    assert found == pytest.approx(np.interp(wanted, [0, 10, 30], [5, 4, 0]))


def test_seeds_that_a_study_needed_stay_when_its_file_is_read_again(monkeypatch, tmp_path):
    monkeypatch.setattr(command, "check", lambda study: None)
    words = command.arguments().read([str(ROOT / "parameters/studies/incline.toml"), "--directory", str(tmp_path)])
    assert command.read_study(words).seeds is None
    (tmp_path / "plan.json").write_text('{"seeds": 3}')
    assert command.read_study(words).seeds == 3
    words.seeds = 0
    assert command.read_study(words).seeds == 0
