# SPDX-License-Identifier: GPL-3.0-or-later
"""Every term of the energy audit against time, and the residual."""

import matplotlib.pyplot as plt
import numpy as np

from hybrid_run import MissingData
from hybrid_tools import style

STEPS = [(1e3, 1.0, "J/m"), (1e6, 1e-3, "kJ/m"), (1e9, 1e-6, "MJ/m"), (np.inf, 1e-9, "GJ/m")]


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


def draw_terms(axes, time, terms):
    largest = max(np.abs(v).max() for v in terms.values())
    order = sorted(terms, key=lambda name: -np.abs(terms[name]).max())
    colours = plt.get_cmap("tab20")(np.r_[0:20:2, 1:20:2])
    for i, name in enumerate(order):
        if np.abs(terms[name]).max() == 0:
            continue
        values, unit = style.scaled(terms[name], largest, STEPS)
        axes.plot(time, values, color=colours[i % 20], lw=1.1, label=name.replace("_", " "))
    axes.set_ylabel("energy [%s]" % style.scaled(0.0, largest, STEPS)[1])
    axes.set_xlim(time[0], time[-1])
    axes.legend(loc="center left", bbox_to_anchor=(1.0, 0.5))


def draw(run, directory):
    time, terms = read_terms(run)
    with_residual = run.has("energy/residual")
    figure, axes = plt.subplots(1 + with_residual, 1, figsize=(10, 6.2 if with_residual else 4.5), sharex=True, squeeze=False,
                                gridspec_kw={"height_ratios": [3, 1][: 1 + with_residual]}, constrained_layout=True)
    draw_terms(axes[0, 0], time, terms)
    axes[-1, 0].set_xlabel("time [s]")
    if with_residual:
        residual = np.abs(run.get("energy/residual")[: len(time)])
        axes[1, 0].semilogy(time[: len(residual)], np.maximum(100 * residual, 1e-12), color=style.TENSILE, lw=0.9)
        axes[1, 0].axhline(1, color="#8a8a8a", lw=0.8, ls="--")
        axes[1, 0].set_ylabel("residual [%]")
    style.title(figure, "Energy audit: " + run.title())
    style.save(figure, directory, "energy")
