# SPDX-License-Identifier: GPL-3.0-or-later
"""Settings whose times do not tell them from the cheapest one are named beside it."""

from types import SimpleNamespace

from hybrid_tools.study import report


def entry(name, cost, error=0.01):
    return SimpleNamespace(name=lambda study: name, cost=cost, error=error)


def test_times_that_scatter_do_not_decide():
    cheapest, near, far = entry("Time step 2e-3", 0.357, 1e-6), entry("Time step 8e-3", 0.384, 2.6e-5), entry("Time step 1e-3", 0.5)
    text = report.as_cheap(None, cheapest, [near, cheapest, far])
    assert text == " Times within 10 % of it, which runs scatter by: Time step 8e-3 (0.384 s, 0.0026 %)."


def test_a_clear_verdict_stands_alone():
    cheapest = entry("Time step 4e-3", 1.0)
    assert report.as_cheap(None, cheapest, [cheapest, entry("Time step 2e-3", 1.2)]) == ""
