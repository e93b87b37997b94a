# SPDX-License-Identifier: GPL-3.0-or-later
"""Submerged column at rest: effective, pore and total stress over depth."""

import numpy as np
from scene_numbers import Numbers
from vtu_file import picture_at

shown = {}


class Column:
    """Stresses at rest [Pa], compression positive, at a height [m]."""

    def __init__(self, run):
        numbers = Numbers(run)
        self.cell, self.width, self.ground = (numbers.mesh(name) for name in ("Resolution/h", "Width", "Height"))
        self.interface = self.ground - numbers.mesh("Block height")
        self.level = numbers.number("Water/Level")
        self.soil = numbers.material("ground").density * numbers.gravity()  # weights [N/m3]
        self.water = numbers.number("Water/Density") * numbers.gravity()

    def effective(self, height):
        return (self.soil - self.water) * (self.ground - height)

    def pore(self, height):
        return self.water * (self.level - height)

    def rock(self, height, load):
        """In the bedrock under a load on its surface [Pa]."""
        return load + self.soil * (self.interface - height)


def vertical_stress(case, variant, part, field):
    """Height [m] and vertical stress [Pa] of the cells of the last picture."""
    picture, _ = picture_at(case.work / variant, part, 1e9)
    return picture.centroids()[:, 1], picture.cell_fields[field][:, 1]


def check(case):
    force = {}
    for method in ("pressures", "submerged"):
        run = case.run(method, "Water/Method=" + method)
        column = case.column = Column(run)
        force[method] = run.get("interface/force")[0].reshape(-1, 2)
        case.near(method + ": effective force on the bedrock", -force[method][:, 1].sum(),
                  column.width * column.effective(column.interface), 0.001, "N/m")
        height, stress = vertical_stress(case, method, "blocks", "stress xx, yy, xy [Pa]")
        rows = np.round(height / column.cell - 0.5)  # pairs of triangles: their mean is that of the row
        for row in np.unique(rows):
            middle = column.cell * (row + 0.5)
            case.near("%s: effective stress of blocks at y = %.2f m" % (method, middle), -stress[rows == row].mean(),
                      column.effective(middle), 0.01, "Pa")
        shown[method] = height, stress
        height, stress = vertical_stress(case, method, "continuum", "static stress xx, yy, xy [Pa]")
        carried = column.pore(column.interface) if method == "pressures" else 0.0
        expected = column.rock(height, column.effective(column.interface) + carried)
        # forces go to nodes one by one: the element under the surface sees them as points
        deep = height < column.interface - column.cell
        case.below(method + ": stress of the bedrock, largest error over the largest stress",
                   np.abs(-stress - expected)[deep].max() / expected.max(), 0.01)
        shown["rock_" + method] = height, stress
    water = case.run("water").get("interface/water_force")
    case.near("force of the water on the bedrock", -water[:, 1].sum(), column.width * column.pore(column.interface), 1e-9, "N/m")
    case.below("effective forces, pressures less submerged", np.abs(force["pressures"] - force["submerged"]).max(),
               1e-8 * np.abs(force["pressures"]).max(), "N/m")


    rise(case)


def rise(case):
    """The level rises by 10 m within five periods of the column: the bedrock, and what stands on it, goes down by its compression."""
    for method in ("pressures", "submerged"):
        ground = case.column.ground
        period = 4 * ground / Numbers(case.run("water")).material("ground").speed("P")
        table = case.work.resolve() / "rising_level.csv"
        table.write_text("%g,%g\n%.15g,%g\n" % (0, case.column.level, 5 * period, case.column.level + 10), encoding="utf-8")
        run = case.run("rising_" + method, "Water/Method=" + method, "Water/Level=none", "Water/Level file=%s" % table,
                       "Time/End time=%g" % (8 * period), "Time/Time step=0.001", "Output/Audit interval=0.001")
        down = -run.history("monitors/interface/displacement")[:, 1]
        still = run.time > 5.5 * period
        if method == "pressures":
            expected = 10 * case.column.water * case.column.interface / Numbers(run).material("ground").oedometer
            case.near("level risen by 10 m: the surface of the bedrock goes down", down[still].mean(), expected, 0.01, "m")
        else:
            case.below("the same, submerged: it stays", np.abs(down).max(), 1e-8, "m")
        case.below("level risen by 10 m, %s: energy residual" % method, run.summary["energy_residual"], 1e-3)


def draw(case, figure):
    axes, column = figure.subplots(), case.column
    y = np.array([0.0, column.interface, column.ground])
    axes.plot(1e-3 * column.effective(y[1:]), y[1:], "k--", lw=1, label="closed form")
    total = column.effective(column.interface) + column.pore(column.interface)
    axes.plot(1e-3 * column.rock(y[:2], total), y[:2], "k--", lw=1)
    height, stress = shown["pressures"]
    axes.plot(-1e-3 * stress, height, ".", label="blocks (effective)")
    height, stress = shown["rock_pressures"]
    axes.plot(-1e-3 * stress, height, "x", label="bedrock (total)")
    axes.set_xlabel("vertical pressure [kPa]")
    axes.set_ylabel("y [m]")
    axes.legend()
