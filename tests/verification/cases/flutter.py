# SPDX-License-Identifier: GPL-3.0-or-later
"""Flutter of a sliding elastic block: growth rate and frequency are an eigenvalue of its six equations.

    M q'' + C q' + K q + k_n sum (n_i + mu t_i) n_i^T q = const,     q = (u, v, r, e_x, e_y, g_xy) along and across the plane,

with t_i^T, n_i^T the rows of the displacement at both lower vertices: their normal springs push with k_n n_i^T q, friction
along the plane is mu times that (mode coupling: Hoffmann, Fischer, Allgaier & Gaul 2002, Mech. Res. Commun. 29, 197-205).
C = beta_K K, K the block's own stiffness, with damping.
"""

import numpy as np
from scene_numbers import Numbers
from slope import uphill

MONITORS = ("heel", "toe", "top")
BEGIN = 5e-4  # the other vibrations of the release are there from the start [s]


def displacement_rows(x, y):
    """Displacement at a point of the block (from its centroid) per unknown."""
    return np.array([[1, 0, -y, x, 0, y / 2], [0, 1, x, 0, y, x / 2]])


class SlidingBlock:
    def __init__(self, run):
        n = Numbers(run)
        self.rock, self.mu = n.material("rock"), np.tan(n.material("rock").friction)
        self.width, self.height = n.mesh("Block width"), n.mesh("Block height")
        self.damping = n.number("Blocks/Damping ratio") / (np.pi * n.number("Blocks/Damping frequency"))  # beta_K [s]
        # normal stiffness alpha E / size, size the root of the block's area, half of the edge to each vertex
        area = self.width * self.height
        self.spring = n.number("Blocks/Penalty ratio") * self.rock.young / np.sqrt(area) * self.width / 2
        along = uphill(run)
        self.axes = np.array([along, [-along[1], along[0]]])
        self.places = [self.axes @ n.point(name) - [self.width / 2, self.height / 2] for name in MONITORS]

    def mass(self):
        points, weights = np.polynomial.legendre.leggauss(3)
        result = np.zeros((6, 6))
        for x, a in zip(points * self.width / 2, weights * self.width / 2):
            for y, b in zip(points * self.height / 2, weights * self.height / 2):
                rows = displacement_rows(x, y)
                result += self.rock.density * a * b * rows.T @ rows
        return result

    def stiffness(self):
        """Of the block's strains alone (plane strain)."""
        modulus, shear = self.rock.oedometer, self.rock.shear_modulus
        result = np.zeros((6, 6))
        result[3:5, 3:5] = [[modulus, modulus - 2 * shear], [modulus - 2 * shear, modulus]]
        result[5, 5] = shear
        return self.width * self.height * result

    def system(self):
        """Matrix of the rates of (q, q')."""
        stiffness, matrix = self.stiffness(), np.zeros((12, 12))
        matrix[6:, 6:] = -np.linalg.solve(self.mass(), self.damping * stiffness)
        for x in (-self.width / 2, self.width / 2):
            along, across = displacement_rows(x, -self.height / 2)
            stiffness = stiffness + self.spring * np.outer(across + self.mu * along, across)
        matrix[:6, 6:] = np.eye(6)
        matrix[6:, :6] = -np.linalg.solve(self.mass(), stiffness)
        return matrix

    def fluttering(self):
        """Eigenvalue [1/s] of the mode that grows most or decays least, of those that vibrate, and its left eigenvector."""
        values, vectors = np.linalg.eig(self.system())
        vibrate = np.flatnonzero(values.imag > 1)
        k = vibrate[np.argmax(values[vibrate].real)]
        return values[k], np.linalg.inv(vectors)[k]

    def amplitude(self, run):
        """History of the complex amplitude of that mode (and a constant)."""
        rows, moved = [], []
        for name, place in zip(MONITORS, self.places):
            rows.append(displacement_rows(*place))
            moved.append(self.axes @ run.history("monitors/%s/displacement" % name).T)
        unknowns = np.linalg.solve(np.vstack(rows), np.vstack(moved)).T
        rates = np.gradient(unknowns, run.time, axis=0, edge_order=2)
        return np.hstack([unknowns, rates]) @ self.fluttering()[1]


def measured(run, block):
    """Eigenvalue [1/s] from the history: differences from step to step are a geometric series."""
    d = np.diff(block.amplitude(run)[run.time > BEGIN])
    return np.log((d[:-1].conj() @ d[1:]) / (d[:-1].conj() @ d[:-1])) / (run.time[1] - run.time[0])


def check(case):
    case.curves = {}
    for name, overrides in (("scene", []), ("20 deg", ["Materials/rock/Friction angle=20"]),
                            ("29 deg", ["Materials/rock/Friction angle=29", "Time/End time=0.006"]),
                            ("10 deg", ["Materials/rock/Friction angle=10"]),
                            ("29 deg, damped", ["Materials/rock/Friction angle=29", "Blocks/Damping ratio=0.05",
                                                "Blocks/Damping frequency=50"])):
        run = case.run() if name == "scene" else case.run(name.replace(" ", "_").replace(",", ""), *overrides)
        block = SlidingBlock(run)
        expected, found = block.fluttering()[0], measured(run, block)
        case.near(name + ": circular frequency", found.imag, expected.imag, 0.003, "1/s")
        case.below(name + ": growth %.5g 1/s, closed form %.5g; error of the eigenvalue over its modulus"
                   % (found.real, expected.real), abs(found - expected) / abs(expected), 0.003)
        if expected.real > 100:
            case.near(name + ": growth rate", found.real, expected.real, 0.01, "1/s")
        case.curves[name] = run, block, expected
    case.true("with damping it decays", case.curves["29 deg, damped"][2].real < 0)


def draw(case, figure):
    axes = figure.subplots()
    for name, (run, block, expected) in case.curves.items():
        late = run.time[1:] > BEGIN
        found = np.abs(np.diff(block.amplitude(run)))[late]
        time = run.time[1:][late]
        axes.semilogy(1e3 * time, found[0] * np.exp(expected.real * (time - time[0])), color="0.6", linewidth=4)
        axes.semilogy(1e3 * time, found, label="hybrid, " + ("24 deg" if name == "scene" else name))
    axes.plot([], [], color="0.6", linewidth=4, label="eigenvalue")
    axes.set(xlabel="time [ms]", ylabel="amplitude of the mode (change in a step)")
    axes.legend()
