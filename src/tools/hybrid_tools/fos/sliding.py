# SPDX-License-Identifier: GPL-3.0-or-later
"""Displacements of a run's motion by Newmark's rigid block and by the decoupled method, beside what the coupled run has slipped.

Rigid block (Newmark 1965): the outcrop motion drives it. Decoupled (Makdisi and Seed 1978; Bray and Rathje 1998): the mean acceleration of
the mass in a run in which sliding is prevented drives it, so that the mass is as soft as it is but does not feel its own slip.
"""

import json
import os

import matplotlib.pyplot as plt
import numpy as np

from hybrid_run import Run, UserError
from hybrid_run.newmark import driving_accelerations, rate_on_slope, rigid_block
from hybrid_tools import style
from hybrid_tools.fos import flanks

STRONG = "Materials/Strength reduction factor=1e-6"  # strengths a million times as large: nothing slides
NEAR = 1e-3  # of the largest slip: a run in which sliding is prevented may creep by the springs


def surface_material(run):
    """{parameter: value} of the sliding surface's material."""
    values = run.parameters
    name = values.get("Blocks/Belt material", "") or values["Blocks/Material"]
    if ":" in name:
        raise UserError("Blocks/Material = %s: the sliding surface has the friction of several materials; one of its own, "
                        "Blocks/Belt material, is needed" % name)
    path = "Materials/%s/" % name
    return {name[len(path):]: value for name, value in values.items() if name.startswith(path)}


def first_number(value, word_means):
    """The number of a parameter such as "20e3 [Pa]", or what its word stands for."""
    try:
        return float(value.split()[0])
    except (ValueError, IndexError):
        return word_means


def surface_friction(run):
    """Friction angle of the sliding surface [rad]."""
    return np.radians(first_number(surface_material(run)["Friction angle"], 30.0))


def lost_strength(run):
    """What the sliding surface has less of once it has slipped, in words: Newmark's block keeps the yield coefficient of its peak."""
    material = surface_material(run)
    words = []
    for name, unit, default in (("Friction angle", "degrees", 30.0), ("Cohesion", "Pa", 0.0)):
        peak = first_number(material[name], default)
        residual = first_number(material["Residual " + name.lower()], peak)
        if residual < peak:
            words.append("%s %g of %g %s" % (name.lower(), residual, peak, unit))
    return ", ".join(words)


def friction_rate(run):
    """Friction of the sliding surface: -1 if it falls with the rate of slip, 1 if it rises, 0 if neither."""
    return float(np.sign(first_number(surface_material(run)["Friction rate coefficient"], 0.0)))


def gravity(run):
    return float(run.parameters["Gravity/Acceleration"].split()[0])


def displacements(run, prevented, coefficient, towards):
    """{"rigid block": history, "decoupled": history} [m], and the rate of a slide on this surface [-]."""
    rate = float(rate_on_slope(flanks.slope(run, towards), surface_friction(run)))
    critical = coefficient * gravity(run)
    outcrop, _ = driving_accelerations(run, towards)
    _, mean = driving_accelerations(prevented, towards)
    return {"rigid block": (run.time, rigid_block(run.time, outcrop, critical, rate=rate)),
            "decoupled": (prevented.time, rigid_block(prevented.time, mean, critical, rate=rate))}, rate


def compare(words, trials, bracket, directory):
    run = Run(words.scene)
    if run.attribute("base_shear", "force_at_rest") is None:
        raise UserError("'%s' has no base shear: it has no sliding surface, or was made by an older program" % words.scene)
    print("the same motion with sliding prevented ...", flush=True)
    prevented = Run(trials.run("sliding_prevented", words.overrides + [STRONG]))
    towards = bracket.towards
    found, rate = displacements(run, prevented, bracket.value, towards)
    _, mean_slip, largest_slip = flanks.slip(run, towards)
    outcrop, _ = driving_accelerations(run, towards)
    _, mean = driving_accelerations(prevented, towards)
    g = gravity(run)
    numbers = {
        "yield_coefficient": bracket.value, "towards": flanks.name_of(towards), "rate_on_surface": rate,
        "largest_coefficient_of_outcrop": float(outcrop.max() / g), "largest_coefficient_of_mass": float(mean.max() / g),
        "rigid_block_m": float(found["rigid block"][1][-1]), "decoupled_m": float(found["decoupled"][1][-1]),
        "coupled_mean_m": float(mean_slip[-1]), "coupled_largest_m": largest_slip,
        "slip_with_sliding_prevented_m": float(np.abs(prevented.history("slip/largest")).max()),
        "surface_keeps_after_slip": lost_strength(run), "sign_of_friction_rate": friction_rate(run),
    }
    with open(os.path.join(directory, "newmark.json"), "w", encoding="utf-8") as file:
        json.dump(numbers, file, indent=2)
        file.write("\n")
    tell(numbers)
    if run.is_on_both_flanks:
        print("warning: slides lie on both flanks: slope and slip are of those that fall towards %s, the mean acceleration is of all; a\n"
              "  scene of one slide alone tells more" % flanks.name_of(towards))
    draw(run, prevented, found, numbers, directory, towards)


def tell(numbers):
    print("largest horizontal coefficient: outcrop motion %.3g, mean of the mass %.3g; slides with %.3g (k - k_y) g" % (
        numbers["largest_coefficient_of_outcrop"], numbers["largest_coefficient_of_mass"], numbers["rate_on_surface"]))
    for label, name in (("displacement, mm", "rigid_block_m"), ("", "decoupled_m"), ("", "coupled_mean_m")):
        print("%-20s %-11s %9.4g" % (label, name[:-2].replace("_", " "), 1e3 * numbers[name]))
    if numbers["slip_with_sliding_prevented_m"] > max(NEAR * abs(numbers["coupled_largest_m"]), 1e-6):
        print("warning: the run with sliding prevented moved by %.3g mm on its surface: its mass rocks or opens" % (
            1e3 * numbers["slip_with_sliding_prevented_m"]))
    if numbers["surface_keeps_after_slip"]:
        print("warning: the sliding surface loses strength as it slips (it keeps %s): the yield coefficient is that of its peak, so that\n"
              "  the simpler methods tell too little; with -s and the residual values as peaks they tell a bound from above" % (
                  numbers["surface_keeps_after_slip"]))
    if numbers["sign_of_friction_rate"]:
        print("warning: friction of the sliding surface %s with the rate of slip, which the simpler methods do not have: they tell too %s" % (
            ("rises", "much") if numbers["sign_of_friction_rate"] > 0 else ("falls", "little")))


def draw(run, prevented, found, numbers, directory, towards):
    figure, axes = plt.subplots(2, 1, figsize=(9, 6.2), constrained_layout=True, sharex=True)
    g, (outcrop, _), (_, mean) = gravity(run), driving_accelerations(run, towards), driving_accelerations(prevented, towards)
    axes[0].plot(run.time, outcrop / g, color=style.VERTICAL, lw=0.8, label="outcrop motion")
    axes[0].plot(prevented.time, mean / g, color=style.HORIZONTAL, lw=0.8, label="mean of the mass, sliding prevented")
    axes[0].axhline(numbers["yield_coefficient"], color=style.TENSILE, lw=0.9, ls="--",
                    label="yield coefficient %.3g" % numbers["yield_coefficient"])
    axes[0].set_ylabel("coefficient driving %s [-]" % ("downhill" if run.slips_downhill else "towards " + flanks.name_of(towards)))
    axes[0].legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncol=3)
    slip_time, slip, _ = flanks.slip(run, towards)
    factor, unit = style.length_unit(max(np.abs(slip).max(), *(np.abs(s).max() for _, s in found.values())))
    for (name, (time, values)), colour in zip(found.items(), (style.VERTICAL, style.HORIZONTAL)):
        axes[1].plot(time, factor * values, color=colour, label="%s: %.3g %s" % (name, factor * values[-1], unit))
    axes[1].plot(slip_time, factor * slip, color=style.TEXT, lw=1.4, label="coupled, mean: %.3g %s" % (factor * slip[-1], unit))
    axes[1].set_xlim(run.time[0], run.time[-1])
    axes[1].set_xlabel("time [s]")
    axes[1].set_ylabel("displacement [%s]" % unit)
    axes[1].legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncol=3)
    style.title(figure, "Newmark's displacements: " + run.title())
    style.save(figure, directory, "newmark")
