# SPDX-License-Identifier: GPL-3.0-or-later
"""Parts of hybrid fos that need no run: kinks that hold a block, strength that is lost, Newmark's displacement against closed forms."""
import numpy as np
import pytest
from hybrid_run.newmark import rate_on_slope, rigid_block
from hybrid_tools.fos.kinks import holding_kink, kink_of_blocks
from hybrid_tools.fos.sliding import friction_rate, lost_strength


@pytest.mark.parametrize("mirror", [1, -1])
def test_a_kink_that_holds_a_corner_is_found(mirror):
    flip = np.array([mirror, 1])
    surface = np.array([[-30, -3], [0, 0], [20, 15], [40, 40]])[::mirror] * flip  # flattens at (20, 15) by 14, at 0 by 31 degrees
    upper, lower = np.array([[0, 0], [8, 6], [0, 9]]) * flip, np.array([[-10, -1], [0, 0], [0, 9], [-10, 4]]) * flip
    point, bend = holding_kink(surface, [lower, upper], -mirror)
    assert point == pytest.approx([0, 0]) and bend == pytest.approx(np.degrees(np.arctan(0.75) - np.arctan(0.1)))
    assert holding_kink(surface, [lower], -mirror) is None  # no block of the steep side has a corner there
    cut = np.array([[0.4, 0.3], [8, 6], [0, 9], [0, 0.6]]) * flip
    assert holding_kink(surface, [lower, cut], -mirror) is None
    across = np.array([[15, 11.25], [20, 15], [24, 20], [15, 25]]) * flip
    assert holding_kink(surface, [lower, across], -mirror)[0] == pytest.approx([20 * mirror, 15])
    assert holding_kink(surface[:2], [lower], -mirror) is None


@pytest.mark.parametrize("mirror", (1, -1))
def test_a_kink_in_the_outline_of_a_block_is_found(mirror):
    """A plane of 35 degrees that ends at a bench, both edges of one block."""
    def drawn(points):
        corners = np.array(points, dtype=float) * [mirror, 1]
        return corners if mirror > 0 else corners[::-1]  # counter-clockwise
    rock = drawn([(0, 0), (40, 0), (40, 9), (20, 9), (10, 2), (0, 2)])
    wedge, cut = drawn([(10, 2), (20, 9), (13, 9)]), drawn([(10.5, 2.35), (20, 9), (13, 9)])
    point, bend = kink_of_blocks([wedge, rock], -mirror)
    assert point == pytest.approx([10 * mirror, 2]) and bend == pytest.approx(np.degrees(np.arctan2(7, 10)))
    assert kink_of_blocks([rock, cut], -mirror) is None
    assert kink_of_blocks([wedge, wedge + [40, 0]], -mirror) is None  # none of them has an inward corner


@pytest.mark.parametrize("changes, words", [
    ({}, ""), ({"Residual friction angle": "12"}, "friction angle 12 of 25 degrees"), ({"Residual cohesion": "5e3"}, "cohesion 5000 of 20000 Pa"),
    ({"Residual cohesion": "20e3", "Residual friction angle": "25"}, ""), ({"Friction rate coefficient": "0.03"}, ""), ({"Friction rate coefficient": "-0.01"}, ""),
    ({"Friction angle": "automatic", "Residual friction angle": "20"}, "friction angle 20 of 30 degrees")])
def test_newmark_says_what_the_surface_loses_as_it_slips(changes, words):
    class Settings:
        parameters = {"Blocks/Material": "soil", "Blocks/Belt material": "clay", "Materials/soil/Residual friction angle": "1"}

    clay = {"Friction angle": "25", "Cohesion": "20e3", "Residual friction angle": "same", "Residual cohesion": "automatic",
            "Friction rate coefficient": "0"}
    Settings.parameters.update({"Materials/clay/" + name: value for name, value in {**clay, **changes}.items()})
    assert lost_strength(Settings) == words
    assert friction_rate(Settings) == np.sign(float(changes.get("Friction rate coefficient", 0)))


def test_rectangular_pulse_and_sine_are_those_of_newmark():
    a, critical, end = 4.0, np.array([0.5, 1.5, 3.9]), 0.5
    tiny = 1e-10
    slip = rigid_block([0, tiny, end, end + tiny, 9], [0, a, a, 0, 0], critical)[-1]
    assert slip == pytest.approx(a * end**2 / 2 * (a / critical - 1), rel=1e-8)
    rate = rate_on_slope(np.radians(20), np.radians(25))
    assert rigid_block([0, tiny, end, end + tiny, 9], [0, a, a, 0, 0], 1.5, rate=rate)[-1] == pytest.approx(rate * slip[1], rel=1e-8)
    # half a sine, a sin(w t): slides from w t1 = asin(ac / a) until the speed is back at zero, in closed form
    w, ac = 2 * np.pi, 1.0
    t = np.linspace(0, 0.5, 4001)
    wave = a * np.sin(w * t)
    t1 = np.arcsin(ac / a) / w
    v = a / w * (np.cos(w * t1) + 1) - ac * (0.5 - t1)  # at the end of the half sine
    s = a / w * np.cos(w * t1) * (0.5 - t1) - a / w**2 * (0 - np.sin(w * t1)) - ac * (0.5 - t1) ** 2 / 2
    history = np.append(wave, [0, 0])
    assert rigid_block(np.append(t, [0.5 + tiny, 9]), history, ac)[-1] == pytest.approx(s + v**2 / (2 * ac), rel=1e-5)


def test_a_block_that_may_slide_both_ways_drifts_by_the_difference():
    rng = np.random.default_rng(3)
    time, acceleration = np.linspace(0, 10, 201), rng.normal(0, 3, 201)
    both = rigid_block(time, acceleration, 1.0, 1.5)
    assert rigid_block(time, -acceleration, 1.5, 1.0)[-1] == pytest.approx(-both[-1], rel=1e-12)
    fine = np.linspace(0, 10, 2001)  # the same function: more samples change nothing
    assert rigid_block(fine, np.interp(fine, time, acceleration), 1.0, 1.5)[::10] == pytest.approx(both, abs=1e-9)
    assert (np.diff(rigid_block(time, acceleration, 1.0)) >= 0).all()  # one-way
