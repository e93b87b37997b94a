# SPDX-License-Identifier: GPL-3.0-or-later
"""parameters/examples: the commands of each page run as they stand, and give the numbers that the page states."""
import re
import shlex

import numpy as np
import pytest
from conftest import ONE_RUN, ROOT

from hybrid_run import Run

EXAMPLES = ROOT / "parameters/examples"


def page(name):
    return (EXAMPLES / name / "README.md").read_text()


@pytest.fixture
def follow(hybrid, tmp_path):
    """follow(name): runs the commands of the page, from a directory of its own; what they said.

    as_it_stands: with figures and with the further runs that tell errors; one page is enough for that.
    """
    def call(name, as_it_stands=False):
        said = []
        for line in re.findall(r"^    build/release/hybrid (.*?)(?: +#.*)?$", page(name), re.M):
            if line.startswith("plot") and not as_it_stands:
                continue
            words = [str(ROOT / word) if word.startswith("parameters/") else word for word in shlex.split(line)]
            if words[0].endswith(".prm") and not as_it_stands:
                words += ONE_RUN
            result = hybrid(*words, cwd=tmp_path)
            assert result.returncode == 0, line + "\n" + result.stdout + result.stderr
            said.append(result.stdout)
        return said

    return call


def stated(name, pattern):
    """The number that a page states."""
    return float(re.search(pattern, page(name), re.S)[1])


def at(run, history, frequency):
    return abs(np.trapz(history * np.exp(-2j * np.pi * frequency * run.time), run.time))


def test_every_example_has_its_page_with_a_sketch_a_command_a_picture_and_a_way_on():
    names = sorted(path.name for path in EXAMPLES.iterdir() if path.is_dir())
    assert [name[:2] for name in names] == ["01", "02", "03", "04", "05", "06"]
    for name in names:
        text = page(name)
        assert "    build/release/hybrid " in text and "**Expect**" in text and "**Change next**" in text, name
        for link in re.findall(r"\]\(([^)]+)\)", text):
            target = (EXAMPLES / name / link).resolve()
            assert target.is_file(), (name, link)
            assert target.suffix != ".png" or "examples" not in str(target) or target.stat().st_size < 60000, link
        assert name in (EXAMPLES / "README.md").read_text()


def test_block_on_a_plane(follow, hybrid, tmp_path):
    name = "01_block_on_a_plane"
    follow(name, as_it_stands=True)
    closed = 0.5 * 9.81 * (np.sin(np.radians(30)) - np.cos(np.radians(30)) * np.tan(np.radians(20)))
    assert stated(name, r"slid ([\d.]+) m after") == pytest.approx(closed, abs=5e-4)
    slip = Run(tmp_path / "output/01").summary["slip_m"]["mean_left"]
    assert slip == pytest.approx(closed, rel=0.003)
    assert hybrid(EXAMPLES / name / "scene.prm", "-s", "Materials/rock/Friction angle=31", "-s", "Output/Directory=output/01b", *ONE_RUN, cwd=tmp_path).returncode == 0
    assert abs(Run(tmp_path / "output/01b").summary["slip_m"]["mean_left"]) < 1e-4


def test_layered_column(follow, tmp_path):
    name = "02_layered_column"
    follow(name)
    run = Run(tmp_path / "output/02")
    surface, outcrop = run.monitors["surface"].velocity[:, 0], run.history("input/velocity")[:, 0]
    impedances = 2200 * 1000 / (1800 * 200)
    assert stated(name, r"moves ([\d.]+) times") == pytest.approx(impedances, abs=0.005)
    assert at(run, surface, 2.5) / at(run, outcrop, 2.5) == pytest.approx(impedances, rel=0.01)
    assert run.monitors["surface"].peak()[0] == pytest.approx(stated(name, r"reaches ([\d.]+) m/s2"), rel=0.01)


def test_own_slope(follow, tmp_path):
    name = "03_own_slope"
    said = follow(name)
    assert "warning" not in said[0] and "falls to the left; factor of safety at rest 1.5 " in said[0]
    assert "%g m2, up to %g m thick" % (stated(name, r"mass of (\d+) m2"), stated(name, r"up to (\d+) m thick")) in said[0]
    summary = Run(tmp_path / "output/my-slope").summary
    assert 1e3 * summary["slip_m"]["mean_left"] == pytest.approx(stated(name, r"leaves ([\d.]+) mm of slip"), rel=0.05)
    assert summary["joints"]["tensile"] == summary["joints"]["shear"] == 0


def test_bedding_planes(follow, tmp_path):
    name = "04_bedding_planes"
    follow(name)
    for row, directory in (("welded", "welded"), ("3 GPa/m in shear, 8 GPa/m normal", "bedded"), ("a tenth of that", "soft")):
        peak, ratio = stated(name, re.escape(row) + r" \| ([\d.]+)"), stated(name, re.escape(row) + r" \| [\d.]+ \| ([\d.]+)")
        found = Run(tmp_path / "output" / directory).monitors["S7"].peak()[0]
        assert found == pytest.approx(peak, abs=0.006) and found / 0.980665 == pytest.approx(ratio, abs=0.006), row


def test_falling_blocks(follow, tmp_path):
    name = "05_falling_blocks"
    follow(name)
    run = Run(tmp_path / "output/05")
    middle = np.searchsorted(run.time, 0.5 - 1e-9)
    for monitor in run.monitors.values():
        fallen = monitor.displacement[middle]
        assert fallen[0] == pytest.approx(0, abs=1e-9) and -fallen[1] == pytest.approx(stated(name, r"/ 2 = ([\d.]+) m"), abs=1e-3)
        x, y = monitor.position + monitor.displacement[-1]
        assert y == pytest.approx(stated(name, r"centres ([\d.]+) m"), abs=0.005) and 0 < x < 60
        assert np.abs(monitor.velocity[-1]).max() < 1e-6
