# SPDX-License-Identifier: GPL-3.0-or-later
"""hybrid fos where blocks yield: a homogeneous slope without a drawn surface."""
import json
import os

import numpy as np
import pytest
from conftest import ROOT

from hybrid_run import Run

SCENES = ROOT / "parameters/verification"
GRIFFITHS_LANE = 1.40  # Griffiths and Lane (1999), example 1; Bishop and Morgenstern (1960): 1.38
ACADS = 1.00  # Giam and Donald (1989), 1(a): the referees' factor


def factor(hybrid, scene, directory, *words):
    result = hybrid("fos", SCENES / scene, "--output", directory, *words)
    assert result.returncode == 0, result.stderr
    found = json.loads((directory / "fos.json").read_text())
    assert found["stands"] < found["fails"] and found["blocks_yield"]
    return found, result.stdout


def test_homogeneous_slope_fails_through_its_blocks(hybrid, tmp_path):
    found, said = factor(hybrid, "griffiths_lane.prm", tmp_path / "out", "--range", "1.3", "1.5", "--tolerance", "0.05")
    assert found["fos"] == pytest.approx(GRIFFITHS_LANE, rel=0.05)  # half of the bracket and a coarse mesh
    assert "warning" not in said and found["jump_of_displacement"] > 10
    assert (tmp_path / "out/fos.png").read_bytes().startswith(b"\x89PNG")
    run = Run(tmp_path / "out/factor_1.5")
    strain = run.get("section/blocks_plastic_strain")
    x = np.array([polygon.mean(axis=0)[0] for polygon in run.blocks.polygons])
    assert strain.max() > 0.02 and strain[x > 30].max() < 0.1 * strain.max()  # the slope shears, what is far behind it does not


@pytest.mark.skipif("HYBRID_LONG" not in os.environ, reason="minutes; ctest -L long")
@pytest.mark.parametrize("scene, numbers, low, high, expected",
                         [("griffiths_lane.prm", "Height = 10; Slope = 2; Behind = 20; Resolution/h = 0.5", "1.36", "1.46", GRIFFITHS_LANE),
                          ("acads.prm", "Height = 10; Slope = 2; Depth = 5; Front = 10; Behind = 20; Resolution/h = 0.5", "0.96", "1.06", ACADS)])
def test_slopes_of_the_literature(hybrid, tmp_path, scene, numbers, low, high, expected):
    found, _ = factor(hybrid, scene, tmp_path / "out", "-s", f"Mesh/Numbers={numbers}", "--range", low, high, "--tolerance", "0.026")
    assert found["fos"] == pytest.approx(expected, rel=0.03)
