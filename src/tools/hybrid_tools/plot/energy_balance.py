# SPDX-License-Identifier: GPL-3.0-or-later
"""Every term of the energy audit against time, joints that have failed by then, and the residual."""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.ticker import MaxNLocator

from hybrid_run import MissingData
from hybrid_tools import style

STEPS = [(1e3, 1.0, "J/m"), (1e6, 1e-3, "kJ/m"), (1e9, 1e-6, "MJ/m"), (np.inf, 1e-9, "GJ/m")]


LESSER = 0.1  # of the largest term: smaller ones have a panel of their own
SMALL_OF_LESSER = 0.03  # in that panel
SMALL = 0.01  # of the largest term: smaller ones are drawn as their sum
MOST = len(style.CURVES)  # curves of a panel
# Every term of the audit: its place says how it is drawn, the usual ones first, so that no two of a figure look the same.
TERMS = ("input_work", "boundary_loss", "blocks_gravity", "friction_loss", "joints_and_contacts", "blocks_kinetic", "water_work",
         "bedrock_static_stress", "blocks_strain", "base_work", "bedding_loss", "bedrock_strain", "blocks_damping_loss", "bedrock_kinetic",
         "bedrock_damping_loss", "blocks_integration_loss", "fracture_loss", "edge_load_work", "yield_loss", "bedrock_integration_loss",
         "spring_replacement_loss", "boundary_springs", "bedding_static_stress")
LINES = ("-", (0, (5, 1.5)), (0, (1, 1.2)))  # of the first nine terms, the next nine, the others
REST = {"color": "#8a8a8a", "ls": "--"}  # the sum of the smaller terms
UNKNOWN = {"color": "#8a8a8a", "ls": "-."}  # terms of runs of another version


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


def grouped(terms, small=SMALL):
    """({words: history}, names of the rest): terms that can be seen, the largest first; those below small of it are one curve."""
    peaks = {name: float(np.abs(values).max()) for name, values in terms.items()}
    seen = sorted((name for name in terms if peaks[name] > small * max(peaks.values())), key=lambda name: -peaks[name])[:MOST]
    rest = [name for name in terms if name not in seen and peaks[name] > 0]
    if len(rest) == 1:
        seen, rest = seen + rest, []
    found = {name.replace("_", " "): terms[name] for name in seen}
    if rest:
        found["%d smaller terms" % len(rest)] = sum(terms[name] for name in rest)
    return found, rest


def look(name):
    """Colour and line of a term: the same in every figure."""
    if name not in TERMS:
        return UNKNOWN
    place = TERMS.index(name)
    return {"color": style.CURVES[place % MOST], "ls": LINES[place // MOST]}


def draw_terms(axes, time, terms, small=SMALL):
    """small: as in grouped()."""
    largest = max(np.abs(v).max() for v in terms.values())
    found, rest = grouped(terms, small)
    for i, (words, values) in enumerate(found.items()):
        is_rest = bool(rest) and i == len(found) - 1
        axes.plot(time, style.scaled(values, largest, STEPS)[0], lw=1.1, label=words, **(REST if is_rest else look(words.replace(" ", "_"))))
    axes.set_ylabel("energy [%s]" % style.scaled(0.0, largest, STEPS)[1])
    axes.set_xlim(time[0], time[-1])
    axes.legend(loc="center left", bbox_to_anchor=(1.0, 0.5))


def lesser(terms):
    """Those that the largest ones leave too small to be read, if they are two or more; else none."""
    largest = max(np.abs(values).max() for values in terms.values())
    found = {name: values for name, values in terms.items() if 0 < np.abs(values).max() < LESSER * largest}
    return found if len(found) > 1 else {}


def failures(run):
    """{kind: times of the failures in the motion [s], in order}, and how many failed before; empty if none did or it is not known yet."""
    if not run.has("joints/failure_time") or not run.has("joints/failure_kind"):
        return {}, 0
    time, kind = run.file["joints/failure_time"][:], run.file["joints/failure_kind"][:]
    found = {word: np.sort(time[(kind == number) & (time >= 0)]) for number, word in ((1, "tensile"), (2, "shear"))}
    return ({}, 0) if not any(len(times) for times in found.values()) else (found, int((time < 0).sum()))


def draw_failures(axes, found, at_rest, end):
    """Joints that have failed by each time."""
    everything = np.sort(np.concatenate(list(found.values())))
    for word, times, colour in (("all", everything, style.TEXT), ("tensile", found["tensile"], style.TENSILE), ("shear", found["shear"], style.SHEAR)):
        count = np.arange(len(times) + 1)
        axes.step(np.r_[0, times, end], np.r_[count, count[-1]], where="post", color=colour, lw=1.2, label="%s: %d" % (word, len(times)))
    axes.set_ylabel("failed joints [-]")
    axes.set_ylim(bottom=0)
    axes.yaxis.set_major_locator(MaxNLocator(nbins=6, steps=[1, 2, 5, 10], integer=True))
    title = "failed in the motion" + ("\n(at rest before: %d)" % at_rest if at_rest else "")
    axes.legend(loc="center left", bbox_to_anchor=(1.0, 0.5), title=title, alignment="left", title_fontsize=8)


def draw_residual(axes, time, residual):
    residual = np.abs(residual[: len(time)])
    axes.semilogy(time[: len(residual)], np.maximum(100 * residual, 1e-12), color=style.TENSILE, lw=0.9)
    axes.axhline(1, color="#8a8a8a", lw=0.8, ls="--")
    axes.set_ylabel("residual [%]")


def draw(run, directory):
    time, terms = read_terms(run)
    few = lesser(terms)
    failed, at_rest = failures(run)
    panels = [(2.7, lambda axes: draw_terms(axes, time, terms))]
    if few:
        n = len(terms) - len(few)  # the largest terms; the panel with more to see is the higher one
        heights = (1.8, 2.7) if n <= 3 else (2.7, 1.8)
        panels = [(heights[0], lambda axes: draw_terms(axes, time, terms, LESSER)),
                  (heights[1], lambda axes: draw_terms(axes, time, few, SMALL_OF_LESSER))]
    if failed:
        panels.append((1.7, lambda axes: draw_failures(axes, failed, at_rest, time[-1])))
    if run.has("energy/residual"):
        panels.append((1.2, lambda axes: draw_residual(axes, time, run.get("energy/residual"))))
    heights = [height for height, _ in panels]
    figure, axes = plt.subplots(len(panels), 1, figsize=(10, sum(heights) + 1.3), sharex=True, squeeze=False,
                                gridspec_kw={"height_ratios": heights}, constrained_layout=True)
    for axis, (_, function) in zip(axes[:, 0], panels):
        function(axis)
    axes[0, 0].set_title("all terms add up to zero; work put in is negative", fontweight="normal", fontsize=9)
    if few:
        axes[1, 0].set_title("the smaller terms (below %.0f %% of the largest)" % (100 * LESSER), fontweight="normal", fontsize=9)
    axes[-1, 0].set_xlabel("time [s]")
    style.title(figure, "Energy audit: " + run.title())
    style.save(figure, directory, "energy")
