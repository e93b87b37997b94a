# SPDX-License-Identifier: GPL-3.0-or-later
"""Coulomb joint between two half spaces in a shear wave (Miller 1978), with the joint's stiffness.

Left of the joint v = 2 v_up - tau/Z, right of it v = tau/Z; the jump's rate, 2 (v_up - tau/Z), is (d tau/dt)/k_s plus the
slip rate. Within the strength the joint is a spring, at the strength tau is the strength until the slip rate turns.
"""

import numpy as np

DENSITY, YOUNG, POISSON, WIDTH, PLANE, BEFORE, BEHIND = 2000.0, 5e9, 0.25, 10.0, 300.0, 10.0, 310.0
SHEAR = YOUNG / (2 * (1 + POISSON))
SPEED = np.sqrt(SHEAR / DENSITY)
IMPEDANCE = DENSITY * SPEED
STRENGTH = 2000.0 + 10000.0 * np.tan(np.radians(30.0))
SEPARATION = 0.5  # the incident wave has passed BEFORE, the reflected one has not arrived

shown = {}


def joint(time, velocity, stiffness, refine=20):
    """Stress and slip of the joint for the upgoing velocity; exact exponential steps of the spring."""
    t = np.linspace(time[0], time[-1], refine * (len(time) - 1) + 1)
    v = np.interp(t, time, velocity)
    dt = t[1] - t[0]
    rate = 2 * stiffness / IMPEDANCE
    decay = np.exp(-rate * dt)
    stress, slip = np.zeros_like(t), np.zeros_like(t)
    for i in range(1, len(t)):
        # tau' = rate (Z v - tau) with v linear over the step, then the plastic corrector
        lag = (1 - decay) / (rate * dt)
        trial = stress[i - 1] * decay + IMPEDANCE * (v[i - 1] * (lag - decay) + v[i] * (1 - lag))
        stress[i] = np.clip(trial, -STRENGTH, STRENGTH)
        slip[i] = slip[i - 1]
        if trial != stress[i]:
            # slip takes the jump that the spring does not
            jump = dt * (v[i - 1] + v[i] - (stress[i - 1] + stress[i]) / IMPEDANCE)
            slip[i] += jump - (stress[i] - stress[i - 1]) / stiffness
    return t, stress, slip


def energy(time, rate):
    return IMPEDANCE * np.trapezoid(rate**2, time) if hasattr(np, "trapezoid") else IMPEDANCE * np.trapz(rate**2, time)


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


def compare(case, name, stiffness, *overrides):
    run = case.run(name, *overrides)
    upgoing = 0.5 * run.file["input/velocity"][:][: len(run.time), 1]  # half the outcrop motion
    t, stress, slip = joint(run.time, upgoing, stiffness)
    v = np.interp(t, run.time, upgoing)
    behind = run.history("monitors/behind/velocity")[:, 1]
    before = run.history("monitors/before/velocity")[:, 1]
    before = np.where(run.time > SEPARATION, before, 0.0)
    case.near(name + ": transmitted energy", energy(run.time, behind), energy(t, stress / IMPEDANCE), 0.02, "J/m2")
    case.near(name + ": reflected energy", energy(run.time, before), energy(t, v - stress / IMPEDANCE), 0.02, "J/m2")
    loss = np.sum(0.5 * (stress[1:] + stress[:-1]) * np.diff(slip))
    case.near(name + ": dissipated energy", run.file["energy/bedding_loss"][-1] / WIDTH, loss, 0.02, "J/m2")
    # the left side moves against the right one (Bedding planes: tangent upwards, left against right)
    found = run.file["bedding/bedding_1/slip"][:].mean(axis=1)
    measured, expected = half_cycles(found), half_cycles(slip)
    case.true(name + ": %d half cycles slip, closed form %d" % (len(measured), len(expected)),
              len(measured) == len(expected))
    for k in np.flatnonzero(np.abs(expected) > 0.1 * np.abs(expected).max()):
        case.near(name + ": slip of half cycle %d" % (k + 1), measured[k], expected[k], 0.02, "m")
    case.below(name + ": energy residual", run.summary["energy_residual"], 1e-6)
    return run, t, v, stress, slip, behind, found


def check(case):
    run, t, v, stress, slip, behind, found = compare(case, "default", 1e9)
    shown.update(time=run.time, behind=behind, t=t, v=v, stress=stress, slip=slip, found=found,
                 slip_time=run.file["bedding/time"][:])
    stiff = compare(case, "stiff", 1e10, "Bedding planes/Shear stiffness=1e10", "Bedding planes/Normal stiffness=1e10")
    clipped = np.clip(IMPEDANCE * stiff[2], -STRENGTH, STRENGTH)
    case.near("stiff: energy of the clipped incident stress", energy(stiff[0].time, stiff[5]),
              energy(stiff[1], clipped / IMPEDANCE), 0.02, "J/m2")


def draw(case, figure):
    upper, lower = figure.subplots(2, 1, sharex=True)
    delay = (BEHIND - PLANE) / SPEED
    arrival = PLANE / SPEED
    upper.plot(shown["t"] + arrival, 1e-3 * IMPEDANCE * shown["v"], color="0.7", label="incident")
    upper.plot(shown["time"] - delay, 1e-3 * IMPEDANCE * shown["behind"], label="transmitted, program")
    upper.plot(shown["t"] + arrival, 1e-3 * shown["stress"], "k--", lw=0.8, label="transmitted, closed form")
    upper.set_ylabel("shear stress [kPa]")
    upper.legend(loc="upper right")
    lower.plot(shown["slip_time"], 1e6 * shown["found"], label="program")
    lower.plot(shown["t"] + arrival, 1e6 * shown["slip"], "k--", lw=0.8, label="closed form")
    lower.set_xlim(0.25, 0.85)
    lower.set_xlabel("time [s]")
    lower.set_ylabel("slip [$\\mu$m]")
    lower.legend(loc="upper right")
    figure.suptitle("Coulomb joint in a harmonic shear wave")
