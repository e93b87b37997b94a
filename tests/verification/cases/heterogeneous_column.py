# SPDX-License-Identifier: GPL-3.0-or-later
"""The sample of a heterogeneous scene has Weibull's distribution of mean 1."""

from math import gamma, sqrt

import numpy as np

SHAPES = {"modulus": 5.0, "strength": 3.0}

shown = {}


def check(case):
    run, again = case.run(), case.run("two_threads", "Parallel/Threads=2")
    for name, m in SHAPES.items():
        x = np.sort(run.get("heterogeneity/%s_factor" % name))
        n, scale = len(x), 1 / gamma(1 + 1 / m)
        variance = gamma(1 + 2 / m) * scale**2 - 1
        case.below("%s: mean of %d values less 1" % (name, n), x.mean() - 1, 4 * sqrt(variance / n))
        case.near(name + ": variance", x.var(), variance, 0.15)
        p = 1 - np.exp(-((x / scale) ** m))
        distance = max((p - np.arange(n) / n).max(), (np.arange(1, n + 1) / n - p).max())
        case.below(name + ": Kolmogorov's distance", distance, 1.63 / sqrt(n))
        case.true(name + ": the same with two threads",
                  np.array_equal(run.get("heterogeneity/%s_factor" % name), again.get("heterogeneity/%s_factor" % name)))
        shown[name] = x, m
    case.true("another seed is another sample",
              not np.array_equal(case.run("seed", "Heterogeneity/Seed=2").get("heterogeneity/modulus_factor"),
                                 run.get("heterogeneity/modulus_factor")))
    plain = case.run("off", "Heterogeneity/Modulus shape=none", "Heterogeneity/Strength shape=none")
    case.true("off: nothing is recorded", not plain.has("heterogeneity"))


def draw(case, figure):
    from heterogeneity import draw_histogram

    for axes, (name, (x, m)) in zip(figure.subplots(1, 2), shown.items()):
        draw_histogram(axes, x, m, name + " / mean")
