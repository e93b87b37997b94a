# SPDX-License-Identifier: GPL-3.0-or-later
"""Every term of the energy audit against time, and the residual."""

import matplotlib.pyplot as plt
import numpy as np

from hybrid_run import MissingData
from hybrid_tools import style

STEPS = [(1e3, 1.0, "J/m"), (1e6, 1e-3, "kJ/m"), (1e9, 1e-6, "MJ/m"), (np.inf, 1e-9, "GJ/m")]


SMALL = 0.01  # of the largest term: smaller ones are drawn as their sum
MOST = 9  # curves
COLOURS = ("#0072b2", "#d55e00", "#009e73", "#8c5fa8", "#e69f00", "#56b4e9", "#000000", "#7a3b10", "#cc79a7")  # after Okabe and Ito (2008)


def read_terms(run):
    time = run.get("energy/time")
    terms = {n: run.get("energy/" + n) for n in run.names("energy") if n not in ("time", "residual")}
    if not terms:
        raise MissingData("no energy terms in run.h5")
    n = min([len(time)] + [len(v) for v in terms.values()])
    terms = {name: values[:n] for name, values in terms.items()}
    if n < 2 or not any(values.any() for values in terms.values()):
        raise MissingData("nothing in the energy terms of run.h5")
    return time[:n], terms


def grouped(terms):
    """({words: history}, names of the rest): terms that can be seen, the largest first; the small ones are one curve."""
    peaks = {name: float(np.abs(values).max()) for name, values in terms.items()}
    seen = sorted((name for name in terms if peaks[name] > SMALL * max(peaks.values())), key=lambda name: -peaks[name])[:MOST]
    rest = [name for name in terms if name not in seen and peaks[name] > 0]
    if len(rest) == 1:
        seen, rest = seen + rest, []
    found = {name.replace("_", " "): terms[name] for name in seen}
    if rest:
        found["%d smaller terms" % len(rest)] = sum(terms[name] for name in rest)
    return found, rest


def draw_terms(axes, time, terms):
    largest = max(np.abs(v).max() for v in terms.values())
    found, rest = grouped(terms)
    for i, (name, values) in enumerate(found.items()):
        is_rest = bool(rest) and i == len(found) - 1
        axes.plot(time, style.scaled(values, largest, STEPS)[0], color="#8a8a8a" if is_rest else COLOURS[i % len(COLOURS)],
                  ls="-" if i < len(COLOURS) and not is_rest else "--", lw=1.1, label=name)
    axes.set_ylabel("energy [%s]" % style.scaled(0.0, largest, STEPS)[1])
    axes.set_xlim(time[0], time[-1])
    axes.legend(loc="center left", bbox_to_anchor=(1.0, 0.5))


def draw(run, directory):
    time, terms = read_terms(run)
    with_residual = run.has("energy/residual")
    figure, axes = plt.subplots(1 + with_residual, 1, figsize=(10, 6.2 if with_residual else 4.5), sharex=True, squeeze=False,
                                gridspec_kw={"height_ratios": [3, 1][: 1 + with_residual]}, constrained_layout=True)
    draw_terms(axes[0, 0], time, terms)
    axes[0, 0].set_title("all terms add up to zero; work put in is negative", fontweight="normal", fontsize=9)
    axes[-1, 0].set_xlabel("time [s]")
    if with_residual:
        residual = np.abs(run.get("energy/residual")[: len(time)])
        axes[1, 0].semilogy(time[: len(residual)], np.maximum(100 * residual, 1e-12), color=style.TENSILE, lw=0.9)
        axes[1, 0].axhline(1, color="#8a8a8a", lw=0.8, ls="--")
        axes[1, 0].set_ylabel("residual [%]")
    style.title(figure, "Energy audit: " + run.title())
    style.save(figure, directory, "energy")
