# SPDX-License-Identifier: GPL-3.0-or-later
"""Tools tell slopes apart whose files are all called scene.prm, and keep results of another scene."""
import json
import os

import pytest

from hybrid_run import UserError
from hybrid_tools.results_place import default_directory, refuse_other_scene


def test_scenes_of_hybrid_new_have_the_name_of_their_directory(tmp_path, monkeypatch):
    (tmp_path / "east slope").mkdir()
    monkeypatch.chdir(tmp_path / "east slope")
    assert default_directory("scene.prm", "_fos") == os.path.join("output", "east slope_fos")
    assert default_directory("../west/scene.prm", "-study") == os.path.join("output", "west-study")
    assert default_directory("west/toe.prm", "_condition") == os.path.join("output", "toe_condition")


def test_results_of_another_scene_are_refused(tmp_path):
    refuse_other_scene(tmp_path, "fos", "a/scene.prm")  # nothing is there
    (tmp_path / "fos.json").write_text(json.dumps({"scene": os.path.abspath("a/scene.prm")}))
    refuse_other_scene(tmp_path, "fos", "a/../a/scene.prm")
    refuse_other_scene(tmp_path, "condition", "b/scene.prm")
    with pytest.raises(UserError, match="holds results of .*a/scene.prm'; name another directory with --output, or --force"):
        refuse_other_scene(tmp_path, "fos", "b/scene.prm")
