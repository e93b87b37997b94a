# SPDX-License-Identifier: GPL-3.0-or-later
"""Notched beam in three-point bending: finite elements of one half with a cohesive crack in the ligament (Hillerborg et al. 1976).

On the ligament, by symmetry, opening w = 2 u_x; it is closed while sigma < F_t, then sigma = F_t (1 - w / g_c), g_c = 2 G_f / F_t. The tip of the
cohesive zone goes up node by node: for each place the load P and all openings follow from one linear system, whatever the branch.
"""

import functools

import numpy as np
import scipy.sparse.linalg
from rectangle_elements import Rectangle
from scene_numbers import Numbers

ENERGIES = (10.0, 160.0)  # fracture energies of variants [N/m]
ROWS = 24  # elements through the depth
AFTER = 1.13  # end of a run over the time of the peak load


class Beam:
    def __init__(self, run):
        numbers = Numbers(run)
        rock = numbers.material("rock")
        self.depth, self.span, self.over, self.notch = (numbers.mesh(n) for n in ("Depth", "Span", "Overhang", "Notch"))
        self.young, self.poisson, self.strength = rock.young, rock.poisson, rock.tensile_strength
        box = [float(v) for v in numbers.text("Edge loads/Tractions").split(":")[1].split(",")]
        h = numbers.mesh("Resolution/h")
        self.loaded = 2 * h * np.floor(box[1] / h)  # whole edges within the box [m]
        self.rate = -box[5] * self.loaded / numbers.number("Edge loads/Rise time")  # [N/m/s]

    @functools.cached_property
    def ligament(self):
        """Of a half: stiffness of the ligament's nodes, forces on them by P = 1, their lengths."""
        half = self.span / 2 + self.over
        grid = Rectangle((half, self.depth), (int(round(half / self.depth * ROWS)), ROWS), self.young, self.poisson)
        n, nodes = grid.nodes, grid.node(0, grid.y > self.notch - 1e-9)
        support = n + grid.node(np.argmin(np.abs(grid.x - self.span / 2)), 0)
        pressed = simpson(grid.x) * (grid.x <= self.loaded / 2 + 1e-9)
        load = np.zeros(2 * n)
        load[n + grid.node(slice(None), -1)] = -0.5 * pressed / pressed.sum()
        free = np.setdiff1d(np.arange(2 * n), np.append(nodes, support))
        inside, across = scipy.sparse.linalg.splu(grid.stiffness[free][:, free].tocsc()), grid.stiffness[free][:, nodes].toarray()
        stiffness = grid.stiffness[nodes][:, nodes].toarray() - across.T @ inside.solve(across)
        return stiffness, -across.T @ inside.solve(load[free]), simpson(grid.y[grid.y > self.notch - 1e-9])

    def curve(self, energy):
        """Loads [N/m] and openings at the notch's tip [m] as the cohesive zone grows."""
        stiffness, push, length = self.ligament
        critical, points = 2 * energy / self.strength, []
        for tip in range(1, len(length)):
            torn = np.zeros(tip, bool)
            for _ in range(50):
                matrix = np.column_stack([stiffness[: tip + 1, :tip], -push[: tip + 1]])
                right = -length[: tip + 1] * self.strength
                matrix[np.arange(tip), np.arange(tip)] -= np.where(torn, 0, 2 * length[:tip] * self.strength / critical)
                right[:tip][torn] = 0
                solution = np.linalg.solve(matrix, right)
                if np.array_equal(2 * solution[:tip] > critical, torn):
                    break
                torn = 2 * solution[:tip] > critical
            else:
                raise ArithmeticError("the cohesive zone of G_f = %g N/m is shorter than an element" % energy)
            points.append((solution[tip], 2 * solution[0]))
        return np.transpose(points)


def simpson(places):
    """Lengths of equally spaced nodes of quadratic elements."""
    weights = np.full(len(places), places[1] - places[0]) * 2 / 3
    weights[1::2] *= 2
    weights[[0, -1]] /= 2
    return weights


def compare(case, run, peak):
    numbers = Numbers(run)
    energy, beam = numbers.number("Blocks/Fracture energy"), Beam(run)
    name = "G_f = %g N/m: " % energy
    reaction = run.get("base_shear/normal")  # of both supports [N/m]
    case.near(name + "peak load", reaction.max(), peak, 0.05, "N/m")
    ligament = beam.depth - beam.notch
    loss = run.file["energy/fracture_loss"][:]
    case.near(name + "work of fracture", loss[-1], energy * ligament, 0.05, "J/m")
    case.below(name + "residual of the energy audit", run.summary["energy_residual"], 1e-3)
    mouth = (run.history("monitors/mouth_right/displacement") - run.history("monitors/mouth_left/displacement"))[:, 0]
    case.curves[energy] = mouth, reaction, run.file["energy/time"][:], loss / (energy * ligament)
    case.peaks[energy] = reaction.max(), peak


def check(case):
    case.curves, case.peaks = {}, {}
    first = case.run()
    beam = case.beam = Beam(first)
    compare(case, first, beam.curve(Numbers(first).number("Blocks/Fracture energy"))[0].max())
    for energy in ENERGIES:
        peak = beam.curve(energy)[0].max()
        compare(case, case.run("energy_%g" % energy, "Blocks/Fracture energy=%g" % energy,
                               "Time/End time=%.4g" % (AFTER * peak / beam.rate)), peak)


def draw(case, figure):
    left, right = figure.subplots(1, 2)
    for k, (energy, (mouth, reaction, _, _)) in enumerate(sorted(case.curves.items())):
        shown = mouth < 5e-4
        left.plot(1e3 * mouth[shown], 1e-3 * reaction[shown], "C%d" % k, label="G_f = %g N/m" % energy)
        left.axhline(1e-3 * case.peaks[energy][1], color="C%d" % k, linestyle=":")
    left.set(xlabel="opening of the notch's mouth [mm]", ylabel="reaction of the supports [kN/m]", title="dotted: peaks of finite elements")
    left.legend(fontsize=8)
    modulus = case.beam.young / (1 - case.beam.poisson**2)
    number = lambda energy: energy * modulus / case.beam.strength**2 / case.beam.depth
    energies = np.geomspace(9, 600, 20)
    right.loglog(number(energies), [1e-3 * case.beam.curve(e)[0].max() for e in energies], "0.6", linewidth=3, label="finite elements")
    right.loglog(number(np.array(sorted(case.peaks))), [1e-3 * case.peaks[e][0] for e in sorted(case.peaks)], "o", label="hybrid")
    right.set(xlabel="E' G_f / (F_t^2 depth)", ylabel="peak load [kN/m]")
    right.legend(fontsize=8)
