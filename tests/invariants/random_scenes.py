# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes with random options and numbers inside ranges; hypothesis makes one that fails as plain as it can."""

from hypothesis import HealthCheck, Phase, assume, given, settings
from hypothesis import strategies as st
from run_scene import judge_scene
from scenes import FACTORS, Scene, is_allowed

RANGES = {"angle": (0.0, 32.0), "ratio": (0.3, 10.0), "rock": (1e7, 2e10)}  # [deg], [-], modulus [Pa]


@st.composite
def scenes(draw):
    row = {}
    for name, values in FACTORS.items():
        allowed = [v for v in values if is_allowed(dict(row, **{name: v}))]
        assume(allowed)
        row[name] = draw(st.sampled_from(allowed))
    for name, (low, high) in RANGES.items():
        number = draw(st.floats(low, high).map(lambda x: float("%.3g" % x)) | st.just(FACTORS[name][0]))
        if is_allowed(dict(row, **{name: number})):
            row[name] = number
    numbers = {"Motion/Peak": draw(st.floats(0.1, 6.0)), "Motion/Frequency": draw(st.floats(3.0, 12.0)),
               "Blocks/Penalty ratio": draw(st.floats(10.0, 200.0)), "Blocks/Loose damping": draw(st.sampled_from([1.0, 0.3]))}
    return row, {n: float("%.3g" % v) for n, v in numbers.items() if row["motion"] != "none" or not n.startswith("Motion")}


def search(binary, directory, count):
    """Sentences about the plainest scene that is wrong, if there is one; its files stay in the directory."""
    told = []

    @settings(max_examples=count, deadline=None, derandomize=True, database=None, suppress_health_check=list(HealthCheck),
              phases=(Phase.generate, Phase.shrink))
    @given(scenes())
    def holds(chosen):
        row, numbers = chosen
        scene = Scene(row)
        scene.further = numbers
        wrong = judge_scene(binary, scene, directory)
        if wrong:
            told[:] = wrong + [scene.name(), str(numbers)]
        assert not wrong

    try:
        holds()
    except AssertionError:
        return told
    return []
