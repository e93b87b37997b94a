# SPDX-License-Identifier: GPL-3.0-or-later
"""Brazilian test: the stresses of the elastic disc, then 2P / (pi D) = F_t when it splits along the loaded diameter.

The load is the product of traction and arc, rises in proportion to time, and does not fall when the disc gives way. A
disc has split when it has widened half as much again as the elastic one would have.
"""

import numpy as np
from disc_solution import stress
from scene_numbers import Numbers
from vtu_file import picture_at

# Edge lengths over the diameter and, only to save time, the load over F_t when the runs end: a disc that has split costs
# most; 0: the scene.
SPLIT = {0.1: 1.0556, 0.07: 1.05, 0.05: 0}
ELASTIC = (0.1, 0.05, 0.025)
ELASTIC_LOAD = 0.5556  # over F_t


class Disc:
    def __init__(self, run):
        n = Numbers(run)
        self.diameter, self.half_angle = n.mesh("Diameter"), np.radians(n.mesh("Half angle"))  # m, rad
        self.radius, self.strength = self.diameter / 2, n.material("rock").tensile_strength
        top = n.text("Edge loads/Tractions").split(";")[0]
        self.rate = -float(top.split(",")[-1]) / n.number("Edge loads/Rise time")  # of the traction [Pa/s]

    def load(self, time):
        """2P / (pi D) [Pa]."""
        return 2 * self.rate * time * self.half_angle / np.pi

    def time(self, part):
        """When the load is this part of F_t [s]."""
        return part * self.strength / self.load(1.0)

    def stress(self, x, y, traction):
        return stress(x, y, self.radius, self.half_angle, traction)


def widening(run):
    return run.history("monitors/right/displacement")[:, 0] - run.history("monitors/left/displacement")[:, 0]


def elastic_line(run, disc):
    """Widening over time while elastic [m/s]."""
    chosen = (run.time > disc.time(0.33)) & (run.time < disc.time(0.67))
    return np.mean(widening(run)[chosen] / run.time[chosen])


def check(case):
    scene = case.run()
    disc = case.disc = Disc(scene)
    check_stress(case, disc)
    case.runs = {}
    for part, end in SPLIT.items():
        h = part * disc.diameter
        case.runs[h] = scene if end == 0 else case.run(
            "h_%g" % part, "Time/End time=%.4g" % disc.time(end), mesh={"Resolution/h": h})
    case.strength = {h: strength(case, disc, h, run) for h, run in case.runs.items()}
    # The disc's own centre has a little less than 2P / (pi D), as the load is not in a point.
    centre = disc.stress(0.0, 0.0, disc.rate)[0] / disc.load(1.0)
    errors = [abs(value * centre - 1) for value in case.strength.values()]
    case.true("stress at the centre when the disc splits nears F_t: " + ", ".join("%.2f %%" % (100 * e) for e in errors) + " off",
              errors[0] > errors[1] > errors[2])
    case.below("the last of them, over F_t", errors[-1], 0.02)


def strength(case, disc, h, run):
    """Load 2P / (pi D) over F_t when the disc has split; not a number if it has not."""
    name = "h = %g m, " % h
    failed = run.summary["joints"]["tensile"] + run.summary["joints"]["shear"]
    case.true(name + "joints fail", failed)
    if not failed:
        return np.nan
    time, place = run.get("joints/failure_time").ravel(), run.get("joints/position")
    kinds = run.get("joints/failure_kind").ravel()
    case.near(name + "2P / (pi D) when the first joint fails", disc.load(time.min()), disc.strength, 0.1, "Pa")
    first = place[time <= time.min()]
    case.below(name + "mean height of the joints that fail first, over the radius", first[:, 1].mean() / disc.radius, 0.1)
    wide = (widening(run) > 1.5 * elastic_line(run, disc) * run.time) & (run.time > disc.time(ELASTIC_LOAD))
    case.true(name + "the disc has split", wide.any())
    split = disc.load(run.time[np.argmax(wide)]) if wide.any() else np.nan
    until = disc.load(time) <= split
    case.true(name + "joints fail in tension, on the loaded diameter",
              (kinds[until] == 1).all() and (np.abs(place[until, 0]) < 1e-9 * disc.diameter).all())
    case.near(name + "2P / (pi D) when the disc splits", split, disc.strength, 0.1, "Pa")
    return split / disc.strength


def check_stress(case, disc):
    """Stresses before anything fails: at the centre, and root mean square error of all blocks within 0.7 radii."""
    case.fields, errors = {}, []
    moment = float("%.4g" % disc.time(ELASTIC_LOAD))
    for part in ELASTIC:
        h = part * disc.diameter
        run = case.run("elastic_%g" % part, "Time/End time=%g" % moment, "Output/Picture interval=%g" % moment,
                       mesh={"Resolution/h": h})
        picture, time = picture_at(run.directory, "blocks", moment)
        place, found = picture.centroids(), picture.cell_fields["stress xx, yy, xy [Pa]"]
        expected = np.array(disc.stress(place[:, 0], place[:, 1], disc.rate * time)).T
        unit, radius = disc.load(time), np.hypot(*place.T) / disc.radius
        inner = radius < 0.7
        errors.append(np.sqrt(((found - expected)[inner] ** 2).mean(axis=0)).max() / (3 * unit))
        case.fields[h] = place, found, unit
        if part == ELASTIC[-1]:
            near = radius < 0.2
            for k, name in enumerate(("tension across", "compression along")):
                case.near("h = %g m, mean stress within 0.2 radii, %s" % (h, name), found[near, k].mean(),
                          expected[near, k].mean(), 0.01, "Pa")
            centre = np.array(disc.stress(0.0, 0.0, disc.rate * time))
            case.near("closed form at the centre over 2P / (pi D)", centre[0] / unit, 1, 0.05)
            case.near("closed form at the centre over -6P / (pi D)", centre[1] / (-3 * unit), 1, 0.05)
    case.below("h = %g m, error of the stresses over 6P / (pi D)" % h, errors[-1], 0.05)
    case.true("errors of the stresses fall: " + ", ".join("%.3g" % e for e in errors), errors[0] > errors[1] > errors[2])


def draw(case, figure):
    field, split = figure.subplots(1, 2)
    disc, h = case.disc, min(case.fields)
    place, found, unit = case.fields[h]
    near = np.abs(place[:, 0]) < 0.6 * h
    y = np.linspace(-0.49, 0.49, 200) * disc.diameter
    exact = np.array(disc.stress(0 * y, y, disc.rate)) / disc.load(1.0)
    for k, (name, colour) in enumerate((("across", "C0"), ("along", "C1"))):
        field.plot(exact[k], y, color="0.6", linewidth=4, zorder=0)
        field.plot(found[near, k] / unit, place[near, 1], ".", color=colour, label="hybrid, stress " + name)
    field.set(xlabel="stress / (2P / (pi D))", ylabel="height above the centre [m]")
    field.legend()
    for h, run in case.runs.items():
        split.plot(widening(run) * 1e3, disc.load(run.time) / disc.strength, label="hybrid, h = %g m" % h)
    split.axhline(1, color="0.6", linestyle=":", label="2P / (pi D) = F_t")
    split.set(xlabel="widening of the disc [mm]", ylabel="2P / (pi D F_t)", xlim=(0, 0.25), ylim=(0, 1.2))
    split.legend()
