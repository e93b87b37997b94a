# SPDX-License-Identifier: GPL-3.0-or-later
"""Coulomb joint between two half spaces in a shear wave (Miller 1978), with the joint's stiffness.

Left of the joint v = 2 v_up - tau/Z, right of it v = tau/Z; the jump's rate, 2 (v_up - tau/Z), is (d tau/dt)/k_s plus the
slip rate. Within the strength the joint is a spring, at the strength tau is the strength until the slip rate turns.
"""

import numpy as np
from scene_numbers import Numbers

shown = {}


class Joint:
    def __init__(self, run):
        n = Numbers(run)
        rock, plane = n.material("rock"), "Bedding planes/"
        self.speed = rock.speed("S")
        self.impedance = rock.density * self.speed
        self.stiffness = n.number(plane + "Shear stiffness")
        self.strength = n.number(plane + "Cohesion") + n.number(plane + "Initial normal stress") * np.tan(
            np.radians(n.number(plane + "Friction angle")))
        self.width, self.place = n.mesh("Width"), n.mesh("First plane")
        self.before, self.behind = (n.point(name)[0] for name in ("before", "behind"))

    def response(self, time, velocity, refine=20):
        """Stress and slip for the upgoing velocity; exact exponential steps of the spring."""
        t = np.linspace(time[0], time[-1], refine * (len(time) - 1) + 1)
        v = np.interp(t, time, velocity)
        dt, z = t[1] - t[0], self.impedance
        rate = 2 * self.stiffness / z
        decay = np.exp(-rate * dt)
        lag = (1 - decay) / (rate * dt)
        stress, slip = np.zeros_like(t), np.zeros_like(t)
        for i in range(1, len(t)):
            # tau' = rate (Z v - tau) with v linear over the step, then the plastic corrector
            trial = stress[i - 1] * decay + z * (v[i - 1] * (lag - decay) + v[i] * (1 - lag))
            stress[i] = np.clip(trial, -self.strength, self.strength)
            slip[i] = slip[i - 1]
            if trial != stress[i]:
                # slip takes the jump that the spring does not
                jump = dt * (v[i - 1] + v[i] - (stress[i - 1] + stress[i]) / z)
                slip[i] += jump - (stress[i] - stress[i - 1]) / self.stiffness
        return t, stress, slip

    def energy(self, time, rate):
        squares = rate**2
        return self.impedance * np.sum(0.5 * (squares[1:] + squares[:-1]) * np.diff(time))


def half_cycles(slip):
    """Slip between the turning points of the history; the way back after a turn is at least 1 % of the range."""
    turns, extreme, sign = [slip[0]], slip[0], 0
    for value in slip:
        if sign == 0 or (value - extreme) * sign > 0:
            sign = sign or (np.sign(value - extreme) if abs(value - extreme) > 0.01 * np.ptp(slip) else 0)
            extreme = value if sign else extreme
        elif abs(value - extreme) > 0.01 * np.ptp(slip):
            turns.append(extreme)
            extreme, sign = value, -sign
    return np.diff(turns + [extreme])


def compare(case, name, *overrides):
    run = case.run(name, *overrides)
    joint = Joint(run)
    upgoing = 0.5 * run.file["input/velocity"][:][: len(run.time), 1]  # half the outcrop motion
    t, stress, slip = joint.response(run.time, upgoing)
    v = np.interp(t, run.time, upgoing)
    behind = run.history("monitors/behind/velocity")[:, 1]
    incident = np.interp(run.time - joint.before / joint.speed, run.time, upgoing, left=0.0)
    reflected = run.history("monitors/before/velocity")[:, 1] - incident
    case.near(name + ": transmitted energy", joint.energy(run.time, behind), joint.energy(t, stress / joint.impedance),
              0.02, "J/m2")
    case.near(name + ": reflected energy", joint.energy(run.time, reflected),
              joint.energy(t, v - stress / joint.impedance), 0.02, "J/m2")
    loss = np.sum(0.5 * (stress[1:] + stress[:-1]) * np.diff(slip))
    case.near(name + ": dissipated energy", run.file["energy/bedding_loss"][-1] / joint.width, loss, 0.02, "J/m2")
    # the left side moves against the right one (Bedding planes: tangent upwards, left against right)
    found = run.file["bedding/bedding_1/slip"][:].mean(axis=1)
    measured, expected = half_cycles(found), half_cycles(slip)
    case.true(name + ": %d half cycles slip, closed form %d" % (len(measured), len(expected)),
              len(measured) == len(expected))
    for k in np.flatnonzero(np.abs(expected) > 0.1 * np.abs(expected).max()):
        if len(measured) == len(expected):
            case.near(name + ": slip of half cycle %d" % (k + 1), measured[k], expected[k], 0.02, "m")
    case.below(name + ": energy residual", run.summary["energy_residual"], 1e-6)
    return run, joint, t, v, stress, slip, behind, found


def check(case):
    run, joint, t, v, stress, slip, behind, found = compare(case, "default")
    shown.update(joint=joint, time=run.time, behind=behind, t=t, v=v, stress=stress, slip=slip, found=found,
                 slip_time=run.file["bedding/time"][:])
    stiffness = "%.10g" % (10 * joint.stiffness)
    run, joint, t, v, _, _, behind, _ = compare(case, "stiff", "Bedding planes/Shear stiffness=" + stiffness,
                                                "Bedding planes/Normal stiffness=" + stiffness)
    clipped = np.clip(joint.impedance * v, -joint.strength, joint.strength)
    case.near("stiff: energy of the clipped incident stress", joint.energy(run.time, behind),
              joint.energy(t, clipped / joint.impedance), 0.02, "J/m2")


def draw(case, figure):
    joint, arrival = shown["joint"], shown["joint"].place / shown["joint"].speed
    upper, lower = figure.subplots(2, 1, sharex=True)
    delay = (joint.behind - joint.place) / joint.speed
    upper.plot(shown["t"] + arrival, 1e-3 * joint.impedance * shown["v"], color="0.7", label="incident")
    upper.plot(shown["time"] - delay, 1e-3 * joint.impedance * shown["behind"], label="transmitted, program")
    upper.plot(shown["t"] + arrival, 1e-3 * shown["stress"], "k--", lw=0.8, label="transmitted, closed form")
    upper.set_ylabel("shear stress [kPa]")
    upper.legend(loc="upper right")
    lower.plot(shown["slip_time"], 1e6 * shown["found"], label="program")
    lower.plot(shown["t"] + arrival, 1e6 * shown["slip"], "k--", lw=0.8, label="closed form")
    lower.set_xlim(arrival - 0.1, shown["time"][-1])
    lower.set_xlabel("time [s]")
    lower.set_ylabel("slip [$\\mu$m]")
    lower.legend(loc="upper right")
    figure.suptitle("Coulomb joint in a harmonic shear wave")
