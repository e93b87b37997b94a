# SPDX-License-Identifier: GPL-3.0-or-later
"""A plane that opens in triangles of bedrock below the ground: waves below and above it (opening_solution.py)."""

import numpy as np
from opening_solution import Plane, flights, solve
from scene_numbers import Numbers

shown = {}


def check(case):
    run = case.run()
    n = Numbers(run)
    rock, height = n.material("rock"), n.mesh("Middle height") + n.mesh("Top height")
    plane = Plane(n, height)
    upgoing = 0.5 * run.history("input/velocity")[:, 1]  # half the outcrop motion
    form = solve(plane, np.concatenate([[0.0], run.time]), np.concatenate([[0.0], upgoing]))
    arrival, step = n.mesh("Base height") / plane.speed, run.time[1] - run.time[0]
    normal = run.file["bedding/bedding_2/normal_stress"][:]
    case.near("normal stress at rest", normal[0].mean(), plane.rest, 1e-3, "Pa")
    case.below("its scatter over the weight of one row of cells (blocks of constant stress)",
               np.ptp(normal[0]) / (rock.density * n.gravity() * n.mesh("Resolution/h")), 0.2)
    points = np.abs(run.file["bedding/bedding_2/position"][:, 0] - 0.5 * n.mesh("Width")) < 3.0
    audits = run.file["bedding/time"][:]
    found = np.median(run.file["bedding/bedding_2/opening"][:, points], axis=1)
    expected = np.interp(audits - arrival, form.t, form.opening, left=0.0)
    peak = expected.max()
    stretch = (plane.rest + plane.cut_off) / plane.stiffness
    case.true("peak opening is %.0f times the elastic stretch" % (peak / stretch), peak > 5 * stretch)
    mine, its = flights(audits, found, 0.02 * peak), flights(form.t + arrival, form.opening, 0.02 * peak)
    case.true("opens %d times, closed form %d" % (len(mine[0]), len(its[0])), len(mine[0]) == len(its[0]) > 0)
    for k in range(len(its[0])):
        for what, a, b in (("opens", mine[0][k], its[0][k]), ("closes", mine[1][k], its[1][k])):
            if np.isfinite(b):
                case.below("%s the %d. time at %.4f s, closed form %.4f s: difference" % (what, k + 1, a, b), a - b, step, "s")
        there = (audits > its[0][k]) & (audits < its[1][k])
        case.near("peak of opening %d" % (k + 1), found[there].max(), expected[there].max(), 0.02, "m")
    case.below("largest error of the opening over its peak", np.abs(found - expected).max() / peak, 0.02)
    path = run.history("monitors/ground/displacement")[:, 1]
    up = np.cumsum(form.away) * (form.t[1] - form.t[0])
    way = 2 * np.interp(run.time - arrival - height / plane.speed, form.t, up, left=0.0)
    case.near("peak displacement of the ground", np.abs(path).max(), np.abs(way).max(), 0.02, "m")
    case.below("largest error of the ground's displacement over its peak", np.abs(path - way).max() / np.abs(way).max(), 0.02)
    case.below("energy residual", run.summary["energy_residual"], 1e-3)
    shown.update(time=run.time, audits=audits, found=found, expected=expected, path=path, way=way)


def draw(case, figure):
    upper, lower = figure.subplots(2, 1, sharex=True)
    upper.plot(shown["audits"], 1000 * shown["expected"], linewidth=4, alpha=0.4, label="closed form")
    upper.plot(shown["audits"], 1000 * shown["found"], color="C0", label="program")
    upper.set_ylabel("opening [mm]")
    upper.legend(loc="upper left")
    lower.plot(shown["time"], 1000 * shown["way"], linewidth=4, alpha=0.4)
    lower.plot(shown["time"], 1000 * shown["path"], color="C0")
    lower.set_xlabel("time [s]")
    lower.set_ylabel("displacement of the ground [mm]")
