# SPDX-License-Identifier: GPL-3.0-or-later
"""Brazilian test: the stresses of the elastic disc, then 2P / (pi D) = F_t when it splits along the loaded diameter.

The load is the product of traction and arc, rises in proportion to time, and does not fall when the disc gives way. A
disc has split when it has widened half as much again as the elastic one would have.
"""

import numpy as np
from disc_solution import stress
from vtu_file import picture_at

DIAMETER, HALF_ANGLE, STRENGTH = 1.0, np.radians(7.5), 1e6  # m, rad, Pa
RATE = 16e6 / 0.12  # of the traction [Pa/s]
ELASTIC_TIME = 0.05  # s
MESH = "Mesh/Numbers=Diameter = 1; Half angle = 7.5; Resolution/h = %g"
# Edge lengths [m] and, only to save time, when the runs end [s]: a disc that has split costs most.
SPLIT = {0.1: 0.0955, 0.07: 0.095, 0.05: None}
ELASTIC = (0.1, 0.05, 0.025)


def load(time):
    """2P / (pi D) [Pa]."""
    return 2 * RATE * time * HALF_ANGLE / np.pi * 2 * (DIAMETER / 2) / DIAMETER


def widening(run):
    return run.history("monitors/right/displacement")[:, 0] - run.history("monitors/left/displacement")[:, 0]


def elastic_line(run):
    """Widening over time while elastic [m/s]."""
    chosen = (run.time > 0.03) & (run.time < 0.06)
    return np.mean(widening(run)[chosen] / run.time[chosen])


def check(case):
    check_stress(case)
    case.runs = {}
    for h, end in SPLIT.items():
        case.runs[h] = case.run() if end is None else case.run(
            "h_%g" % h, MESH % h, "Time/End time=%g" % end)
    case.strength = {h: strength(case, h, run) for h, run in case.runs.items()}
    # The disc's own centre has a little less than 2P / (pi D), as the load is not in a point.
    centre = stress(0.0, 0.0, DIAMETER / 2, HALF_ANGLE, RATE)[0] / load(1.0)
    errors = [abs(value * centre - 1) for value in case.strength.values()]
    case.true("stress at the centre when the disc splits nears F_t: " + ", ".join("%.2f %%" % (100 * e) for e in errors) + " off",
              errors[0] > errors[1] > errors[2])
    case.below("the last of them, over F_t", errors[-1], 0.02)


def strength(case, h, run):
    """Load 2P / (pi D) over F_t when the disc has split; not a number if it has not."""
    name = "h = %g m, " % h
    failed = run.summary["joints"]["tensile"] + run.summary["joints"]["shear"]
    case.true(name + "joints fail", failed)
    if not failed:
        return np.nan
    time, place = run.get("joints/failure_time").ravel(), run.get("joints/position")
    kinds = run.get("joints/failure_kind").ravel()
    case.near(name + "2P / (pi D) when the first joint fails", load(time.min()), STRENGTH, 0.1, "Pa")
    first = place[time <= time.min()]
    case.below(name + "mean height of the joints that fail first, over the radius", first[:, 1].mean() / (DIAMETER / 2), 0.1)
    wide = (widening(run) > 1.5 * elastic_line(run) * run.time) & (run.time > ELASTIC_TIME)
    case.true(name + "the disc has split", wide.any())
    split = load(run.time[np.argmax(wide)]) if wide.any() else np.nan
    until = load(time) <= split
    case.true(name + "joints fail in tension, on the loaded diameter",
              (kinds[until] == 1).all() and (np.abs(place[until, 0]) < 1e-9).all())
    case.near(name + "2P / (pi D) when the disc splits", split, STRENGTH, 0.1, "Pa")
    return split / STRENGTH


def check_stress(case):
    """Stresses before anything fails: at the centre, and root mean square error of all blocks within 0.7 radii."""
    case.fields, errors = {}, []
    for h in ELASTIC:
        run = case.run("elastic_%g" % h, MESH % h, "Time/End time=%g" % ELASTIC_TIME)
        picture, time = picture_at(run.directory, "blocks", ELASTIC_TIME)
        place, found = picture.centroids(), picture.cell_fields["stress xx, yy, xy [Pa]"]
        expected = np.array(stress(place[:, 0], place[:, 1], DIAMETER / 2, HALF_ANGLE, RATE * time)).T
        unit, radius = load(time), np.hypot(*place.T) / (DIAMETER / 2)
        inner = radius < 0.7
        errors.append(np.sqrt(((found - expected)[inner] ** 2).mean(axis=0)).max() / (3 * unit))
        case.fields[h] = place, found, unit
        if h == ELASTIC[-1]:
            near = radius < 0.2
            for k, name in enumerate(("tension across", "compression along")):
                case.near("h = %g m, mean stress within 0.2 radii, %s" % (h, name), found[near, k].mean(),
                          expected[near, k].mean(), 0.01, "Pa")
            centre = np.array(stress(0.0, 0.0, DIAMETER / 2, HALF_ANGLE, RATE * time))
            case.near("closed form at the centre over 2P / (pi D)", centre[0] / unit, 1, 0.05)
            case.near("closed form at the centre over -6P / (pi D)", centre[1] / (-3 * unit), 1, 0.05)
    case.below("h = %g m, error of the stresses over 6P / (pi D)" % ELASTIC[-1], errors[-1], 0.05)
    case.true("errors of the stresses fall: " + ", ".join("%.3g" % e for e in errors), errors[0] > errors[1] > errors[2])


def draw(case, figure):
    field, split = figure.subplots(1, 2)
    place, found, unit = case.fields[ELASTIC[-1]]
    near = np.abs(place[:, 0]) < 0.6 * ELASTIC[-1]
    y = np.linspace(-0.49, 0.49, 200) * DIAMETER
    exact = np.array(stress(0 * y, y, DIAMETER / 2, HALF_ANGLE, RATE * ELASTIC_TIME)) / unit
    for k, (name, colour) in enumerate((("across", "C0"), ("along", "C1"))):
        field.plot(exact[k], y, color="0.6", linewidth=4, zorder=0)
        field.plot(found[near, k] / unit, place[near, 1], ".", color=colour, label="hybrid, stress " + name)
    field.set(xlabel="stress / (2P / (pi D))", ylabel="height above the centre [m]")
    field.legend()
    for h, run in case.runs.items():
        split.plot(widening(run) * 1e3, load(run.time) / STRENGTH, label="hybrid, h = %g m" % h)
    split.axhline(1, color="0.6", linestyle=":", label="2P / (pi D) = F_t")
    split.set(xlabel="widening of the disc [mm]", ylabel="2P / (pi D F_t)", xlim=(0, 0.25), ylim=(0, 1.2))
    split.legend()
