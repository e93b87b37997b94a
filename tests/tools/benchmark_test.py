# SPDX-License-Identifier: GPL-3.0-or-later
"""hybrid benchmark: rows, counts, files and comparison; nothing of how fast anything is."""
import json
import os
import stat

import pytest
from conftest import ROOT

from hybrid_run import UserError
from hybrid_tools.benchmark import catalogue, results

SHORT = ["-s", "Time/End time=0.003"]


def read(directory):
    return json.loads((directory / "benchmark.json").read_text())


@pytest.fixture(scope="module")
def measured(hybrid, tmp_path_factory):
    """A measurement of two rows and a scene of its own, and what was printed."""
    directory = tmp_path_factory.mktemp("benchmark") / "first"
    scene = ROOT / "parameters/verification/free_flight.prm"
    done = hybrid("benchmark", "slide_100", "rest_100", "rest_400", scene, *SHORT, "--repeat", "2", "--output", directory)
    assert done.returncode == 0, done.stderr
    return directory, done.stdout


def test_every_scene_has_a_row_and_every_row_a_scene():
    scenes = {path.stem for path in (ROOT / "parameters/benchmarks").glob("*.prm")}
    assert {os.path.splitext(os.path.basename(row.path))[0] for row in catalogue.ROWS} == scenes
    assert len({row.name for row in catalogue.ROWS}) == len(catalogue.ROWS)


def test_rows_are_chosen_by_name_family_and_pattern():
    def names(*words, **options):
        return [row.name for row in catalogue.choose(words, **options)]

    assert names("rest") == ["rest_100", "rest_400", "rest_900", "rest_2000"]
    assert names("slide_1*") == ["slide_100"] and names("slide_1*", with_long=True) == ["slide_100", "slide_10000"]
    assert names("badong_2", "rest_100", "badong_2") == ["badong_2", "rest_100"]  # its own name is enough
    assert "bonded_1000000" not in names(with_long=True) and "static_2" in names(with_long=True) and "static_2" not in names()
    for words in (["no_such_row"], ["no_such.prm"]):
        with pytest.raises(UserError, match="no_such"):
            catalogue.choose(words)


def test_row_has_its_counts_and_times(measured):
    directory, said = measured
    found = read(directory)
    assert found["machine"]["cores"] >= 1 and found["machine"]["processor"]
    assert "-O" in found["program"]["flags"] and found["program"]["compiler"]
    rows = {r["row"]: r for r in found["rows"]}
    assert list(rows) == ["slide_100", "rest_100", "rest_400", "free_flight"]
    for r in rows.values():
        summary = json.loads((directory / "runs" / r["row"] / "summary.json").read_text())
        for name in ("blocks", "steps", "iterations", "cuts", "simulated_time_s"):
            assert r[name] == summary[name]
        assert len(r["repetitions"]) == 2 and r["value"] == min(r["repetitions"]) > 0 and not r["stopped_at_limit"]
        parts = summary["processor_times_s"]
        assert sum(parts.values()) == pytest.approx(summary["processor_time_s"], abs=0.02)
        inside = [summary["timings_s"][name] for name in ("springs", "assembly", "factors", "products")]
        assert 0.0 < sum(inside) <= summary["timings_s"]["blocks"]
    slide = rows["slide_100"]
    times = slide["processor_times_s"]
    assert slide["value"] == pytest.approx((times["first_step"] + times["steps"]) / 0.003)
    assert slide["goal"] == 1 and slide["unit"] == "ms/ms" and slide["iterations_per_step"] > 1
    assert rows["rest_100"]["steps"] == 3 and rows["rest_100"]["static_iterations"] > 0
    assert rows["free_flight"]["unit"] == "ms/step" and rows["free_flight"]["goal"] is None
    exponent = found["growth"]["rest"]["exponent"]
    assert rows["rest_400"]["value"] / rows["rest_100"]["value"] == pytest.approx(4 ** exponent)
    page = (directory / "benchmark.md").read_text()
    assert "springs [%]" in page
    assert "rest: time grows as n^" in page and "| slide_100" in page and "rest: time grows as n^" in said


def test_ratio_to_an_earlier_measurement(hybrid, measured, tmp_path):
    directory, _ = measured
    old = read(directory)
    for r in old["rows"]:
        r["value"] *= 1000.0
    (tmp_path / "old.json").write_text(json.dumps(old))
    page = tmp_path / "page.md"
    page.write_text("before\n<!-- tables by hybrid benchmark -->\nold\n<!-- end of the tables -->\nafter\n")
    done = hybrid("benchmark", "slide_100", *SHORT, "--repeat", "1", "--output", tmp_path / "new", "--against", tmp_path / "old.json",
                  "--page", page)
    assert done.returncode == 0, done.stderr
    new = read(tmp_path / "new")
    row, before = new["rows"][0], next(r for r in old["rows"] if r["row"] == "slide_100")
    assert new["against"]["time_ratio"] == {"slide_100": pytest.approx(row["value"] / before["value"])}
    assert row["iterations"] == before["iterations"]  # counts do not depend on time
    assert "time over before" in done.stdout
    text = page.read_text()
    assert text.startswith("before\n<!--") and text.endswith("tables -->\nafter\n") and "| slide_100" in text and "\nold\n" not in text


def test_two_programs_in_turn(hybrid, tmp_path):
    other = tmp_path / "other"
    other.write_text('#!/bin/sh\nexec "%s" "$@"\n' % os.environ["HYBRID_PROGRAM"])
    other.chmod(other.stat().st_mode | stat.S_IXUSR)
    done = hybrid("benchmark", "rest_100", *SHORT, "--repeat", "1", "--output", tmp_path / "out", "--beside", other)
    assert done.returncode == 0, done.stderr
    found = read(tmp_path / "out")
    assert found["against"]["rows"][0]["iterations"] == found["rows"][0]["iterations"]
    assert found["against"]["time_ratio"]["rest_100"] > 0 and (tmp_path / "out/runs/rest_100_beside/summary.json").exists()


def test_run_beyond_the_limit_tells_how_far_it_came(hybrid, tmp_path):
    done = hybrid("benchmark", "slide_400", "-s", "Time/End time=100", "--limit", "1", "--repeat", "1", "--output", tmp_path)
    assert done.returncode == 0, done.stderr
    row = read(tmp_path)["rows"][0]
    assert row["stopped_at_limit"] and 0 < row["simulated_time_s"] < 100 and row["value"] > 0
    assert results.time_ratio(row, row) is None and "(until" in done.stdout


def test_two_threads_have_the_same_results(hybrid, tmp_path):
    done = hybrid("benchmark", "threads_beside_work", "-s", "Time/End time=0.01", "-s", "Mesh/Numbers=Resolution/h = 12", "--repeat", "1",
                  "--output", tmp_path)
    assert done.returncode == 0, done.stderr
    assert read(tmp_path)["rows"][0]["value"] > 0


def test_growth_and_ratios_of_rates():
    def row(name, blocks, value, kind="rate"):
        return {"row": name, "family": "f", "kind": kind, "value": value, "blocks": blocks, "simulated_time_s": 1.0,
                "stopped_at_limit": False, "goal": 100.0}

    small, large = row("a", 100, 50.0), row("b", 1000, 5.0)  # time per step: 2 s and 200 s
    assert results.growth([small, large])["f"]["exponent"] == pytest.approx(2)
    assert results.time_ratio(small, dict(small, value=25.0)) == pytest.approx(0.5)  # twice as fast: half the time
    assert results.over_goal(small) == pytest.approx(2)
    assert results.time_ratio(small, dict(small, simulated_time_s=2.0)) is None


@pytest.mark.parametrize("words, said", [
    (["--against", "no.json"], "no.json"), (["--repeat", "0"], "--repeat is 0"), (["--beside", "no/program"], "is no program"),
    (["--limit", "-1"], "--limit is -1"), (["--page", str(ROOT / "README.md")], "no page with the marks"), (["no_such_row"], "no row is called 'no_such_row'")])
def test_mistakes_are_one_sentence(hybrid, words, said):
    done = hybrid("benchmark", *words)
    assert done.returncode == 2 and done.stderr.startswith("error: ") and said in done.stderr and len(done.stderr.splitlines()) == 1
