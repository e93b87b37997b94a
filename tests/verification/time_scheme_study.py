#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Schemes that were considered for the step: what they damp, and whether a bar that hits a wall gains energy.

    time_scheme_study.py [FIGURE.png]    prints two tables of doc/notes/time_integration.md; the figure is that of doc/theory.md

One oscillator u'' + w^2 u = 0: spectral radius, damping ratio and period error by w dt, from the eigenvalues of the step.
A bar of 20 elements (length, wave speed and mass 1) at speed 1 hits a wall of penalty springs: largest energy, rebound, energy left.
dt is that of one solution: a step of TR-BDF2, which takes two, is twice as long.
"""

import sys

import numpy as np

# gamma - 1/2, filter, what the filter takes of the last change of the acceleration
NEWMARK = {"trapezoidal": (0.0, 0.0, 0.5), "dissipative": (0.1, 0.0, 0.5), "filtered": (0.1, 0.1, 0.5),
           "filtered 0.05, last step": (0.05, 0.05, 1.0)}
ALPHA = {"generalised-alpha 0.8": 0.8, "generalised-alpha 0.5": 0.5}  # spectral radius at infinity (Chung and Hulbert 1993)
TWO_STAGES = "TR-BDF2"  # Bank et al. 1985
SCHEMES = [*NEWMARK, *ALPHA, TWO_STAGES]
COLOURS = ("#3a7d44", "#b5482a", "#1f5a94", "#7fb3dd", "#7a4f9a", "#999999", "#d98b2b")


def alpha_parameters(rho):
    """alpha_m, alpha_f, beta, gamma."""
    m, f = (2 * rho - 1) / (rho + 1), rho / (rho + 1)
    return m, f, 0.25 * (1 - m + f) ** 2, 0.5 - m + f


def newmark_matrix(w, excess, part, share):
    """Step of (u, v dt, a dt^2, remembered change of a dt^2)."""
    def step(x):
        u, v, a, change = x
        known, gamma = (0.5 - excess) * a - part * change, 0.5 + excess
        end = -w * w * (u + v + known / 2) / (1 + w * w * gamma / 2)
        rate = known + gamma * end
        return u + v + rate / 2, v + rate, end, (1 - share) * change + share * (end - a)
    return np.array([step(e) for e in np.eye(4)]).T


def alpha_matrix(w, rho):
    m, f, beta, gamma = alpha_parameters(rho)

    def step(x):
        u, v, a = x
        known = u + v + (0.5 - beta) * a
        end = -(m * a + w * w * ((1 - f) * known + f * u)) / (1 - m + w * w * (1 - f) * beta)
        return known + beta * end, v + (1 - gamma) * a + gamma * end, end
    return np.array([step(e) for e in np.eye(3)]).T


def two_stage_matrix(w):
    rates, part, one = np.array([[0, 1], [-w * w, 0]]), 2 - 2**0.5, np.eye(2)
    first = np.linalg.solve(one - part * rates, one + part * rates)  # of a step of 2
    known = (first - (1 - part) ** 2 * one) / (part * (2 - part))
    return np.linalg.solve(one - 2 * (1 - part) / (2 - part) * rates, known)


def amplification(scheme, w):
    """Spectral radius per solution, damping ratio, period error."""
    if scheme in NEWMARK:
        matrix, size = newmark_matrix(w, *NEWMARK[scheme]), 1
    else:
        matrix, size = (alpha_matrix(w, ALPHA[scheme]), 1) if scheme in ALPHA else (two_stage_matrix(w), 2)
    values = np.linalg.eigvals(matrix)
    mode = values[np.argmin(abs(values - np.exp(1j * w * size)))]
    turn = max(abs(np.angle(mode)), 1e-300)
    return abs(values).max() ** (1 / size), -np.log(max(abs(mode), 1e-300)) / turn, w * size / turn - 1


class Bar:
    """Twenty elements between the wall at 0 and a free end."""

    def __init__(self, elements=20):
        n = elements + 1
        self.mass = np.full(n, 1 / elements)
        self.mass[[0, -1]] /= 2
        self.stiffness = elements * (2 * np.eye(n) - np.eye(n, k=1) - np.eye(n, k=-1))
        self.stiffness[0, 0] = self.stiffness[-1, -1] = elements
        self.wall = 1e3 * elements
        self.first = np.eye(n)[0]

    def closed(self, u):
        return self.wall * (u[0] < 0)

    def energy(self, u, v):
        return 0.5 * (self.mass * v * v).sum() + 0.5 * u @ self.stiffness @ u + 0.5 * self.closed(u) * u[0] ** 2

    def solve(self, inertia, known, elastic, at):
        """u with inertia M (u - known) + elastic K x(u) + contact(x(u)) = 0, x = (1 - at) u0 + at u; elastic scales K."""
        part, start = at
        u = known.copy()
        for _ in range(30):
            x = (1 - part) * start + part * u
            k = elastic * self.stiffness + self.closed(x) * np.outer(self.first, self.first)
            change = np.linalg.solve(np.diag(inertia * self.mass) + part * k, inertia * self.mass * (u - known) + k @ x)
            u = u - change
            if abs(change).max() < 1e-14:
                break
        return u

    def newmark(self, dt, state, excess, part, share):
        """Contact fully implicit: its force at the end acts with dt^2/2 in u and dt in v."""
        u, v, a, change = state
        known = u + dt * v + dt * dt / 2 * ((0.5 - excess) * a - part * change)
        end = self.solve(2 / dt**2, known, 0.5 + excess, (1.0, u))
        rate = -(self.stiffness @ end) / self.mass
        return end, 2 * (end - u) / dt - v, rate, (1 - share) * change + share * (rate - a)

    def alpha(self, dt, state, rho):
        """Contact at the same place between the ends as the other forces."""
        u, v, a, _ = state
        m, f, beta, gamma = alpha_parameters(rho)
        inertia = (1 - m) / (beta * dt * dt)
        known = u + dt * v + dt * dt * ((0.5 - beta) - m * beta / (1 - m)) * a
        end = self.solve(inertia, known, 1.0, (1 - f, u))
        rate = (end - u - dt * v) / (beta * dt * dt) - (0.5 / beta - 1) * a
        return end, v + dt * ((1 - gamma) * a + gamma * rate), rate, a

    def two_stages(self, dt, state):
        u, v, _, _ = state
        part, size = 2 - 2**0.5, 2 * dt

        def acceleration(x):
            return -(self.stiffness @ x + self.closed(x) * x[0] * self.first) / self.mass
        half, rate = part * size / 2, acceleration(u)
        mid = self.solve(1 / half**2, u + half * (2 * v + half * rate), 1.0, (1.0, u))
        mid_v = v + half * (rate + acceleration(mid))
        new, old = 1 / (part * (2 - part)), (1 - part) ** 2 / (part * (2 - part))
        last, base = (1 - part) / (2 - part) * size, new * mid_v - old * v
        end = self.solve(1 / last**2, new * mid - old * u + last * base, 1.0, (1.0, u))
        return end, base + last * acceleration(end), None, None

    def hit(self, scheme, dt):
        """Largest energy and what is left, of that at the start; speed of the rebound."""
        n = len(self.mass)
        state = np.full(n, 0.1), np.full(n, -1.0), np.zeros(n), np.zeros(n)
        largest, time = 0.0, 0.0
        while time < 4 - 1e-9:
            if scheme in NEWMARK:
                state = self.newmark(dt, state, *NEWMARK[scheme])
            else:
                state = self.alpha(dt, state, ALPHA[scheme]) if scheme in ALPHA else self.two_stages(dt, state)
            time += dt * (1 if scheme != TWO_STAGES else 2)
            largest = max(largest, 2 * self.energy(*state[:2]))
        return largest, (self.mass * state[1]).sum(), 2 * self.energy(*state[:2])


def draw(path):
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib.figure import Figure

    figure = Figure(figsize=(11, 3.6), layout="constrained")
    radius, damping, period = figure.subplots(1, 3)
    for scheme, colour in zip(SCHEMES, COLOURS):
        for axes, w, number in ((radius, np.logspace(-1, 2.5, 300), 0), (damping, np.linspace(0.02, 1.5, 100), 1),
                                (period, np.linspace(0.02, 1.5, 100), 2)):
            axes.plot(w, [amplification(scheme, x)[number] for x in w], color=colour, label=scheme)
    radius.set(xscale="log", ylabel="spectral radius per solution [-]")
    damping.set(ylabel="damping ratio [-]", yscale="log", ylim=(1e-6, 0.2))
    period.set(ylabel="period error [-]")
    for axes in (radius, damping, period):
        axes.set_xlabel("w dt [-]")
    period.legend(fontsize=8)
    figure.savefig(path, dpi=110)


def main():
    print("%-24s" % "" + "".join("  radius at %-4g" % w for w in (1, 3, 10, 100)) + "  damping at 0.1, 0.4   period at 0.1, 0.4")
    for scheme in SCHEMES:
        at = [amplification(scheme, w) for w in (0.1, 0.4, 1, 3, 10, 100)]
        print("%-24s" % scheme + "".join("  %14.3f" % x[0] for x in at[2:]) +
              "  %9.1e %9.1e   %.1e %.1e" % (at[0][1], at[1][1], at[0][2], at[1][2]))
    for dt in (0.01, 0.03, 0.1, 0.3):
        for scheme in SCHEMES:
            print("c dt / h = %-4g %-24s largest energy %8.4f, rebound %.3f, energy left %.3f" % (20 * dt, scheme, *Bar().hit(scheme, dt)))
    if len(sys.argv) > 1:
        draw(sys.argv[1])


if __name__ == "__main__":
    main()
