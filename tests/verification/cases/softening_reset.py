# SPDX-License-Identifier: GPL-3.0-or-later
"""A slab whose seam is weak and softens below its lower half: what its slip in the static stage takes of its strength.

tau(kappa) = c - k kappa, k = (c - c_r)/d: with the reset kappa counts from the state at rest, without it from the start of the static stage. The slab
is a bar of the stiffness E H, fixed at the strong half, with E H u'' + q + k u = 0 under what drives it beyond the strength, q per area:

    u(x) = q/k (cos(b (L - x))/cos(b L) - 1),  b = sqrt(k/(E H));     without softening u(x) = q x (2 L - x)/(2 E H)

x is measured from the strong half here. That half gives a little: L is taken from the slip without softening.
"""

import numpy as np
from scene_numbers import Numbers
from vtu_file import pictures


class Seam:
    """The weak part of the seam at each picture: stress, slip (lines: times, columns: joints from the toe on)."""

    def __init__(self, run):
        numbers = self.numbers = Numbers(run)
        angle = np.radians(numbers.mesh("Angle"))
        along, normal = np.array([np.cos(angle), np.sin(angle)]), np.array([-np.sin(angle), np.cos(angle)])
        self.length, self.height, self.edge = 0.5 * numbers.mesh("Width"), numbers.mesh("Height"), numbers.mesh("Resolution/h")
        mass, weak = numbers.material("mass"), numbers.material("weak")
        self.stiffness = mass.young * self.height  # of the bar [N/m]
        self.cohesion, residual = weak.cohesion, numbers.text("Materials/weak/Residual cohesion")
        self.residual = weak.cohesion if residual == "automatic" else float(residual)
        self.fall = (self.cohesion - self.residual) / numbers.number("Blocks/Softening slip")  # k [Pa/m]
        self.spring = numbers.number("Blocks/Penalty ratio") * mass.young / self.edge  # of the joints [Pa/m]
        self.weight = mass.density * numbers.gravity() * self.height * np.sin(angle)  # along the seam, per area [Pa]
        self.inertia = mass.density * self.height * np.cos(angle)  # along the seam of a horizontal acceleration [kg/m2]
        self.time, stress, slip = [], [], []
        ground = run.history("monitors/ground/displacement")
        for time, picture in pictures(run.directory, "joints"):
            where = picture.centroids() - (ground[np.argmin(np.abs(run.time - time))] if time > 0 else 0)
            on = np.flatnonzero((np.abs(where @ normal) < 0.1 * self.edge) & (where @ along < self.length - 0.1 * self.edge))
            assert len(on) == round(self.length / self.edge)
            on = on[np.argsort((where @ along)[on])]
            self.time.append(time)
            stress.append(-picture.cell_fields["shear stress [Pa]"][on].astype(float))
            slip.append(picture.cell_fields["slip [m]"][on].astype(float))
        self.time, self.stress, self.slip = np.array(self.time), np.array(stress), np.array(slip)
        begin = self.stress[0] if numbers.text("Gravity/Reset softening") == "true" else 0.0  # slip counts from there
        self.plastic = self.slip - (self.stress - begin) / self.spring

    def strength(self):
        """By the slip that is recorded [Pa]."""
        return np.maximum(self.cohesion - self.fall * np.maximum.accumulate(self.plastic, axis=0), self.residual)

    def bar(self, load, length):
        """Slip [m] of the joint at the toe under a load beyond the strength [Pa]."""
        if self.fall == 0:
            return load * (length**2 - (0.5 * self.edge) ** 2) / (2 * self.stiffness)
        b = np.sqrt(self.fall / self.stiffness)
        return load / self.fall * (np.cos(0.5 * b * self.edge) / np.cos(b * length) - 1)

    def bar_length(self, load):
        """L that gives the recorded slip at rest without softening [m]."""
        return np.sqrt(2 * self.stiffness * self.plastic[0, 0] / load + (0.5 * self.edge) ** 2)


def obeys(case, name, seam):
    """Stress and slip of each joint at each picture."""
    excess = seam.stress / seam.strength() - 1
    case.below(name + ": largest excess of a stress over its strength c - k kappa", max(excess.max(), 0.0), 1e-5)
    nearest = excess[seam.time > 0].max(axis=0)  # of each joint while the ground moves
    case.below(name + ": largest lack of a joint's stress when it is nearest to its strength", min(nearest.min(), 0.0), 1e-5)


def check(case):
    at_rest = ["Time/End time=0.02", "Motion/Type=none"]
    plain = Seam(case.run("residual_is_peak", "Materials/weak/Residual cohesion=automatic", "Gravity/Reset softening=false", *at_rest))
    load = plain.weight - plain.cohesion
    length = plain.bar_length(load)
    case.near("length of the bar by its slip without softening", length, plain.length, 0.06, "m")

    on = case.on = Seam(case.run())
    off = case.off = Seam(case.run("off", "Gravity/Reset softening=false"))
    case.below("reset: largest stress at rest over c, less 1", np.abs(on.stress[0] / on.cohesion - 1).max(), 1e-6)
    case.below("reset: largest slip at rest", np.abs(on.slip[0]).max(), 1e-12, "m")
    case.near("no reset: slip of the toe at rest", off.plastic[0, 0], off.bar(load, length), 0.03, "m")
    case.near("no reset: stress at the toe at rest", off.stress[0, 0], off.cohesion - off.fall * off.bar(load, length), 0.003, "Pa")
    obeys(case, "reset", on)
    obeys(case, "no reset", off)
    push = on.inertia * float(on.numbers.text("Motion/Peak").split()[0])
    case.near("reset: slip of the toe since rest, at most", on.plastic[:, 0].max(), on.bar(push, length), 0.05, "m")
    case.near("no reset: all slip of the toe", off.plastic[:, 0].max(), off.bar(load + push, length), 0.05, "m")

    brittle = ["Blocks/Softening slip=1e-6", *at_rest]
    sudden = Seam(case.run("brittle", *brittle))
    gone = Seam(case.run("brittle_off", "Gravity/Reset softening=false", *brittle))
    case.below("brittle, reset: largest stress at rest over c, less 1", np.abs(sudden.stress[0] / sudden.cohesion - 1).max(), 1e-6)
    case.below("brittle, no reset: largest stress at rest over the residual, less 1", np.abs(gone.stress[0] / gone.residual - 1).max(), 1e-6)


def draw(case, figure):
    rest, history = figure.subplots(1, 2)
    for seam, name, color in ((case.on, "reset", "C0"), (case.off, "no reset", "C1")):
        x = (np.arange(seam.stress.shape[1]) + 0.5) * seam.edge
        rest.plot(x, seam.stress[0] / 1e3, color=color, label=name)
        history.plot(1e3 * seam.slip[:, 0], seam.stress[:, 0] / 1e3, color=color, label=name)
    line = np.linspace(0, 1e3 * case.off.slip.max(), 2)
    history.plot(line, (case.on.cohesion - 1e-3 * case.on.fall * line) / 1e3, "k--", label="c - k slip")
    rest.set(xlabel="distance from the toe [m]", ylabel="shear stress at rest [kPa]")
    history.set(xlabel="slip of the toe [mm]", ylabel="its shear stress [kPa]")
    rest.legend()
    history.legend()
