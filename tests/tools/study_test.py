# SPDX-License-Identifier: GPL-3.0-or-later
"""hybrid study with the program: orders against known ones, chaos, kills, failing levels, grids, mistakes. See study_forms_test.py too."""
import csv
import functools
import json
import math
import os
import pathlib
import signal
import subprocess
import time

import pytest
from conftest import ROOT

from hybrid_run import UserError
from hybrid_run.parameters import parse_parameters
from hybrid_tools.study import command, program, runner

SCENES = ROOT / "parameters/verification"


def table(directory, name="runs"):
    with open(directory / "tables" / (name + ".csv"), encoding="utf-8") as file:
        return list(csv.DictReader(file))


def orders(directory):
    """{(ladder, quantity): (order, reference, verdict)}"""
    found = json.loads((directory / "tables/verdict.json").read_text())["orders"]
    return {(entry["along"], entry["quantity"]): (entry["order"], entry["reference"], entry["verdict"]) for entry in found}


def manifests(directory):
    return [json.loads(path.read_text()) for path in sorted(directory.glob("runs/*/manifest.json"))]


@pytest.fixture(scope="module", autouse=True)
def version():
    """Asked once: tools that run in copies of this process know it."""
    return program.version()


@pytest.fixture(scope="module")
def incline(hybrid, tmp_path_factory):
    """A study of two runs that is done: its directory and what it was called with after the scene."""
    directory = tmp_path_factory.mktemp("incline") / "study"
    words = ["--vary", "Time/Time step=4e-3,2e-3", "-s", "Time/End time=0.1", "--directory", directory]
    result = hybrid("study", SCENES / "incline.prm", *words)
    assert result.returncode == 0, result.stderr
    return directory, words


def test_trapezoidal_is_of_second_order_and_dissipative_of_first(hybrid, tmp_path):
    directory = tmp_path / "study"
    result = hybrid("study", SCENES / "rayleigh_decrement.prm", "--vary", "Time/Scheme=trapezoidal,dissipative",
                    "--vary", "Time/Time step=8e-3,4e-3,2e-3", "-s", "Motion/Frequency=1.5", "-s", "Time/End time=4",
                    "--directory", directory, "--tolerance", "0.5%")
    assert result.returncode == 0, result.stderr
    found = orders(directory)
    for quantity in ("displacement", "velocity", "peak displacement", "peak acceleration"):
        assert found["Time step (Scheme trapezoidal)", "top/" + quantity][0] == pytest.approx(2, abs=0.1)
        assert found["Time step (Scheme dissipative)", "top/" + quantity][0] == pytest.approx(1, abs=0.2)
    runs = table(directory)
    assert len(runs) == 6 and all(run["state"] == "done" and float(run["processor time [s]"]) > 0 for run in runs)
    errors = {(run["Scheme"], run["Time step"]): float(run["error"]) for run in runs}
    assert errors["trapezoidal", "8e-3"] / errors["trapezoidal", "4e-3"] == pytest.approx(4, rel=0.15)
    within = [run for run in runs if float(run["error"]) < 0.005]
    cheapest = min(within, key=lambda run: float(run["processor time [s]"]))
    setting = "Scheme %s, Time step %s" % (cheapest["Scheme"], cheapest["Time step"])
    assert "cheapest setting with an error below 0.5 % is " + setting in result.stdout
    assert {path.name for path in (directory / "figures").iterdir()} == {"error_over_time.png", "orders.png", "costs.png"}
    times = [float(run["processor time [s]"]) for run in runs if run["Pareto front"] == "yes"]
    assert times and min(times) == min(float(run["processor time [s]"]) for run in runs)
    again = hybrid("study", directory, "--tolerance", "0.00001%")
    assert "6 of 6 runs are there already" in again.stdout and "No setting of this study has an error below 1e-05 %" in again.stdout
    assert table(directory) == runs


TRIANGLES = [(-0.9, 2.2, 0.0), (0.7, 2.6, 0.6), (-0.2, 3.6, 1.2), (0.8, 4.4, 0.3), (-0.8, 5.2, 0.9), (0.1, 6.0, 0.2)]


def falling_triangles(directory):
    """A few loose triangles that fall into a bin with steep sides."""
    lines = ["block,x,y"]
    for block, (x, y, turned) in enumerate(TRIANGLES):
        lines += ["%d,%.4f,%.4f" % (block, x + 0.4 * math.cos(turned + k), y + 0.4 * math.sin(turned + k)) for k in (0, 2.2, 4.1)]
    (directory / "blocks.csv").write_text("\n".join(lines) + "\n")
    (directory / "bin.csv").write_text("x,y\n-4,9\n-1.2,0\n1.2,0\n4,9\n")
    scene = directory / "chaos.prm"
    scene.write_text("""set Title = triangles
subsection Time
  set End time = 1.4
  set Time step = 0.001
end
subsection Mesh
  set Polygons file = blocks.csv
  set Surface file = bin.csv
end
subsection Model
  set Bedrock = rigid
  set Blocks = loose
end
subsection Materials
  set Names = rock
  subsection rock
    set Density = 2220
    set Young modulus = 5e9
  end
end
subsection Blocks
  set Material = rock
end
subsection Gravity
  set Static stage = none
end
subsection Monitors
  set Points = high: 0.1, 6
end
""")
    return scene


def test_chaos_has_no_order_but_scatter(hybrid, tmp_path):
    directory = tmp_path / "study"
    result = hybrid("study", falling_triangles(tmp_path), "--vary", "Time/Time step=2e-3,1e-3,5e-4", "--directory", directory,
                    "--tolerance", "1%")
    assert result.returncode == 0, result.stderr
    assert "3 seeds of the finest run" in result.stdout and "do not converge along Time step" in result.stdout
    order, _, verdict = orders(directory)["Time step", "high/velocity"]
    assert order is None and verdict == "does not converge"
    row = next(row for row in table(directory, "scatter") if row["quantity"] == "velocity")
    assert int(row["seeds"]) == 4 and float(row["seeds differ by"]) > 1000 * 3e-6  # of moduli that differ by 3e-6 at most
    assert len(table(directory)) == 6 and (directory / "figures/scatter.png").exists()
    assert "high/velocity" not in {row["quantity"] for row in table(directory, "values") if row["error"]}


def test_a_study_that_is_killed_goes_on_in_the_middle_of_a_run(hybrid, tmp_path):
    directory = tmp_path / "study"
    words = ["study", SCENES / "bonded_bar.prm", "--vary", "Time/Time step=4e-3,4e-4", "--directory", directory]
    with subprocess.Popen([os.environ["HYBRID_PROGRAM"], *map(str, words)], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as study:
        until = time.monotonic() + 120
        while not any(" steps/s" in path.read_text() for path in directory.glob("runs/*4e-4*/console.txt")):
            assert time.monotonic() < until and study.poll() is None
            time.sleep(0.02)
        study.send_signal(signal.SIGKILL)
    coarse = next(directory.glob("runs/*4e-3*/summary.json"))
    before = coarse.stat().st_mtime_ns
    result = hybrid(*words)
    assert result.returncode == 0, result.stderr
    assert "1 of 2 runs are there already" in result.stdout and coarse.stat().st_mtime_ns == before
    fine = next(manifest for manifest in manifests(directory) if "4e-4" in manifest["name"])
    assert fine["state"] == "done" and fine["resumed"] == 1
    log = next(directory.glob("runs/*4e-4*/log.txt")).read_text()
    assert "Resumed from the checkpoint" in log
    assert {run["Time step"]: "resumed" in run["times"] for run in table(directory)} == {"4e-3": False, "4e-4": True}
    result = hybrid("--resume", coarse.parent, "-s", "Time/End time=1.61")  # a run that goes on adds to what it took before
    took = next(manifest["processor_time_s"] for manifest in manifests(directory) if "4e-3" in manifest["name"])
    assert result.returncode == 0 and json.loads(coarse.read_text())["processor_time_s"] > took + 0.02


def test_a_grid_side_by_side_with_an_effect_and_a_level_that_fails(hybrid, tmp_path):
    scene = tmp_path / "grid.toml"
    scene.write_text('scene = "%s"\nset = ["Time/End time=0.1"]\nseeds = 0\n[vary]\n"Mesh/Numbers" = ["Resolution/h = 5", 2.5]\n'
                     '"Time/Time step" = [4e-3, 2e-3]\n[effects]\n"viscous" = ["Continuum/Sides=viscous"]\n'
                     '"no cohesion" = ["Materials/rock/Cohesion=0", "Materials/rock/Tensile strength=0",'
                     ' "Materials/rock/Friction angle=0", "Model/Blocks=loose", "Model/Bedrock=rigid"]\n'
                     % (SCENES / "coupled_column.prm"))
    directory = tmp_path / "study"
    result = hybrid("study", scene, "--jobs", "2", "--directory", directory)
    runs = table(directory)
    assert len(runs) == 6 and {run["times"] for run in runs} == {"side by side"}
    failed = [run for run in runs if run["state"] == "failed"]
    assert [run["effect"] for run in failed] == ["no cohesion"] and failed[0]["reason"] and result.returncode == 1
    assert {along for along, _ in orders(directory)} == {"h (Time step 0.002)", "Time step (h 2.5)"}
    costs = {row["option or effect"]: row for row in table(directory, "options")}
    assert float(costs["viscous"]["times as much"]) > 0 and costs["no cohesion"]["in"] == "not done"
    assert all(manifest["memory_mb"] > 50 for manifest in manifests(directory))


def test_the_least_of_several_times_counts(hybrid, incline):
    directory, words = incline
    words = ["study", SCENES / "incline.prm", *words]
    stamps = {path: path.stat().st_mtime_ns for path in directory.glob("runs/*/run.h5")}
    result = hybrid(*words, "--repeat", "3")
    assert result.returncode == 0 and "least of 3" in result.stdout, result.stderr
    for manifest in manifests(directory):
        times = [entry["processor_time_s"] for entry in manifest["times"]]
        assert len(times) == 3 and manifest["processor_time_s"] == min(times) and manifest["state"] == "done"
    assert {path: path.stat().st_mtime_ns for path in stamps} == stamps and not list(directory.glob("runs/*/timing"))
    assert "2 of 2 runs are there already" in hybrid(*words, "--repeat", "3").stdout


def test_a_workflow_computes_one_run_at_a_time_and_a_closed_form_is_the_reference(hybrid, tmp_path):
    a, phi = math.radians(30), math.radians(15)
    slide = 0.5 * 9.81 * (math.sin(a) - math.cos(a) * math.tan(phi)) * 0.5**2
    directory = tmp_path / "study"
    result = hybrid("study", SCENES / "incline.prm", "--vary", "Time/Time step=4e-3,2e-3", "--closed-form", "block/final displacement=%r" % slide,
                    "-s", "Time/End time=0.5", "--quantities", "block/final*", "--tolerance", "0.3%", "--directory", directory, "--snakemake")
    assert result.returncode == 0, result.stderr
    text = (directory / "Snakefile").read_text()
    runs = json.loads(text[text.index("RUNS = ") + 7 : text.index("\n\n\nrule all")])
    assert len(runs) == 2 and all(run["mem_mb"] > 50 and run["threads"] == 1 for run in runs.values())
    assert hybrid("study", directory, "--only", list(runs)[0]).returncode == 0
    collected = hybrid("study", directory, "--collect")
    assert collected.returncode == 0 and "against the closed form" in collected.stdout
    assert sorted(run["state"] for run in table(directory)) == ["done", "planned"]
    assert next(manifest for manifest in manifests(directory) if manifest["state"] == "done")["taken"] == "by a scheduler"
    errors = [row for row in table(directory, "values") if row["error"]]
    assert [row["reference"] for row in errors] == ["closed form"] and float(errors[0]["error"]) < 3e-3


def test_a_scene_states_its_closed_form_and_its_order_is_that_of_the_elements(hybrid, tmp_path):
    """Waves in elements of degree 2: the error of their phase is of fourth order in h. No option names the closed form."""
    directory = tmp_path / "study"
    result = hybrid("study", SCENES / "wave_packet.prm", "--vary", "Mesh/Numbers=Resolution/h = 25|12.5|6.25", "--directory", directory)
    assert result.returncode == 0, result.stderr
    order, reference, verdict = orders(directory)["h", "here/displacement"]
    assert reference == "closed form" and order == pytest.approx(4, abs=0.3) and verdict == "converges"
    errors = [float(row["error"]) for row in table(directory, "values") if row["quantity"] == "here/displacement"]
    assert errors[0] / errors[1] == pytest.approx(12.8, rel=0.1) and errors[2] < 0.002
    steps = tmp_path / "steps"
    result = hybrid("study", SCENES / "wave_packet.prm", "--vary", "Time/Time step=4e-3,2e-3,1e-3", "-s", "Continuum/Degree=4",
                    "-s", "Time/Scheme=trapezoidal", "--directory", steps)
    order, reference, _ = orders(steps)["Time step", "here/displacement"]
    assert reference == "closed form" and order == pytest.approx(2, abs=0.1)


@pytest.mark.parametrize("words, message", [
    (["scene.prm", "--vary", "Time/Time stepp=1,2"], "Time stepp"),
    (["scene.prm", "--vary", "Time/Time step=1e-3,-1"], "Time step"),
    (["scene.prm", "--vary", "Time/Time step=1e-3,2e-3", "--finest", "Blocks/Tolerance=1"], "not varied"),
    (["column.prm", "--vary", "Mesh/Numbers=Resolution/hh = 5|2.5"], "there is no number 'Resolution/hh'"),
    (["scene.prm", "--variy", "a=1"], "did you mean '--vary'"),
    (["scene.prm"], "nothing is varied"),
    (["."], "plan.json"),
    (["nothing.toml"], "nothing.toml"),
    (["nothing"], "there is no 'nothing'"),
])
def test_mistakes_are_one_line(hybrid, tmp_path, words, message):
    (tmp_path / "scene.prm").write_text("include %s\n" % (SCENES / "incline.prm"))
    (tmp_path / "column.prm").write_text("include %s\n" % (SCENES / "coupled_column.prm"))
    result = hybrid("study", *words, cwd=tmp_path)
    assert result.returncode == 2 and message in result.stderr
    assert result.stderr.startswith("error: ") and len(result.stderr.splitlines()) == 1
    assert not pathlib.Path(tmp_path / "output").exists()


def test_a_directory_holds_the_study_of_one_scene_and_one_process_works_there(hybrid, incline, monkeypatch):
    directory, words = incline
    other = hybrid("study", SCENES / "friction.prm", *words)
    assert other.returncode == 2 and "holds the study of" in other.stderr
    assert hybrid("study", directory, "--quantities", "blok/*").returncode == 2
    before = (directory / "scene.prm").read_text(), (directory / "plan.json").read_text()
    locked = runner.lock(str(directory))
    monkeypatch.setattr(runner, "PATIENCE", 0.0)
    with pytest.raises(UserError, match="another process is at work"):
        command.main([str(SCENES / "incline.prm"), *map(str, words), "-s", "Blocks/Damping ratio=0.1"])
    os.close(locked)
    assert ((directory / "scene.prm").read_text(), (directory / "plan.json").read_text()) == before


@functools.lru_cache
def parameters_of(scene, common):
    return parse_parameters(program.parameters_text(scene, common).splitlines())


@pytest.mark.parametrize("path", sorted((ROOT / "parameters/studies").glob("*.toml")), ids=lambda path: path.stem)
def test_study_files_of_the_repository_vary_what_there_is(path, monkeypatch, tmp_path):
    def check(study):  # asks once, not for every level
        study.base = parameters_of(study.scene, tuple(study.common))

    monkeypatch.setattr(command, "check", check)
    study = command.make_study(command.arguments().read([str(path), "--directory", str(tmp_path / "study")]))
    assert path.read_text().startswith("# ") and len(study.settings()) > 1
    for setting in study.settings():
        assert all(override.split("=")[0] in study.base for override in setting.overrides), setting.overrides
