# SPDX-License-Identifier: GPL-3.0-or-later
"""Order of the time scheme where rock, blocks and free-field columns vibrate together, by steps against a very short one."""

import numpy as np

STEPS = (8e-3, 4e-3, 2e-3)  # [s]
REFERENCE = 2.5e-4  # [s], of the scheme that damps nothing: its own error is a thousandth of that of the largest step
POINTS = ("top", "interface", "rock")
BEDROCK = ("continuum", "triangles")

shown = {}


def motion(run, at):
    """Displacements of all monitors at the given times, one after the other."""
    return np.concatenate([[np.interp(at, run.time, axis) for axis in run.history("monitors/%s/displacement" % name).T]
                           for name in POINTS])


def errors(case, bedrock, scheme, at, reference):
    """L2 error of the displacement of all monitors, relative, per step; the largest energy residual."""
    found, residual = [], 0.0
    for step in STEPS:
        run = case.run("%s_%s_%g" % (bedrock, scheme, step), "Model/Bedrock=" + bedrock, "Time/Scheme=" + scheme,
                       "Time/Time step=%g" % step)
        found.append(np.linalg.norm(motion(run, at) - reference) / np.linalg.norm(reference))
        residual = max(residual, run.summary["energy_residual"])
    return found, residual


def check(case):
    for bedrock in BEDROCK:
        exact = case.run(bedrock + "_reference", "Model/Bedrock=" + bedrock, "Time/Scheme=trapezoidal",
                         "Time/Time step=%g" % REFERENCE)
        at = np.arange(STEPS[0], exact.time[-1], STEPS[0])  # in all histories
        reference = motion(exact, at)
        for scheme in ("filtered", "trapezoidal", "dissipative"):
            found, residual = errors(case, bedrock, scheme, at, reference)
            order = np.log2(np.array(found[:-1]) / found[1:])
            name = "bedrock %s, %s: " % (bedrock, scheme)
            print("      %serrors %s, orders %s" % (name, " ".join("%.3g" % x for x in found), " ".join("%.2f" % x for x in order)))
            if scheme == "dissipative":
                case.true(name + "order %.2f is below 1.3: the test tells the orders apart" % order[-1], order[-1] < 1.3)
            else:
                case.within(name + "order", order[-1], 2, 0.15)
            case.below(name + "energy residual", residual, 1e-6)
            shown[bedrock, scheme] = found
        case.true("bedrock %s: at %g ms filtered has less than a fifth of the error of dissipative" % (bedrock, 1e3 * STEPS[-1]),
                  shown[bedrock, "filtered"][-1] < 0.2 * shown[bedrock, "dissipative"][-1])


def draw(case, figure):
    for axes, bedrock in zip(figure.subplots(1, 2, sharey=True), BEDROCK):
        for scheme, colour in (("dissipative", "#b5482a"), ("filtered", "#1f5a94"), ("trapezoidal", "#3a7d44")):
            axes.loglog(1e3 * np.array(STEPS), 100 * np.array(shown[bedrock, scheme]), "o-", color=colour, label=scheme)
        axes.set(xlabel="time step [ms]", title="bedrock of " + {"continuum": "finite elements", "triangles": "blocks"}[bedrock])
        axes.legend()
    figure.axes[0].set_ylabel("error of the displacement [%]")
