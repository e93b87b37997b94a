# SPDX-License-Identifier: GPL-3.0-or-later
"""A lasting load on a visco-elastic base, and a P wave through it.

Settlement p / k_n and drift p / Z from the balance of the base. Wave: the column of height H moves with
u(y) = B cos(k (H - y)); its traction on the base, 2 Z v_up - Z v + k_n (u_up - u), gives
B = (2 i w Z + k_n) u_up / ((i w Z + k_n) cos kH - Z w sin kH) at every frequency w.
"""

import numpy as np
from scene_numbers import Numbers

shown = {}


class Ground:
    def __init__(self, run):
        n = Numbers(run)
        self.rock, self.height = n.material("rock"), n.mesh("Height")
        self.impedance = self.rock.density * self.rock.speed("P")
        self.spring = n.number("Continuum/Normal spring coefficient") * self.rock.shear_modulus / n.number("Continuum/Spring distance")
        self.pressure = self.rock.density * n.gravity() * n.mesh("Block height")  # the blocks' weight is the load


def base(run):
    return run.history("monitors/base/displacement")[:, 1]


def slope(time, u, begin):
    late = time > begin
    return np.polyfit(time[late], u[late], 1)[0]


def surface(time, upgoing, ground, spring):
    """Displacement of the free top for the upgoing wave's displacement at the base."""
    n = 8 * len(time)
    omega = 2 * np.pi * np.fft.rfftfreq(n, time[1] - time[0])
    phase = omega * ground.height / ground.rock.speed("P")
    denominator = (1j * omega * ground.impedance + spring) * np.cos(phase) - ground.impedance * omega * np.sin(phase)
    gain = np.ones_like(denominator)
    gain[1:] = (2j * omega * ground.impedance + spring)[1:] / denominator[1:]
    if spring == 0:
        gain[0] = 2.0
    return np.fft.irfft(gain * np.fft.rfft(upgoing, n), n)[: len(time)]


def check(case):
    springs = case.run()
    dashpots = case.run("dashpots", "Continuum/Boundary springs=false")
    ground = Ground(springs)
    settlement, drift = ground.pressure / ground.spring, ground.pressure / ground.impedance
    case.near("springs: settlement of the base", -base(springs)[-1], settlement, 0.005, "m")
    case.below("springs: drift at the end", slope(springs.time, base(springs), 2.8) / drift, 0.005)
    case.near("dashpots: drift", -slope(dashpots.time, base(dashpots), 1.0), drift, 0.005, "m/s")
    for run in (springs, dashpots):
        case.below("energy residual", run.summary["energy_residual"], 1e-6)
    shown.update(time=springs.time, springs=base(springs), dashpots=base(dashpots), settlement=settlement, drift=drift)
    wave = ("Gravity/Acceleration=0", "Motion/Type=ricker", "Motion/Peak=1", "Motion/Frequency=4", "Motion/Angle=90",
            "Motion/Meaning=incident", "Time/End time=1.5",
            "Mesh/Numbers=Width = 10; Height = 20; Block height = 2.5; Resolution/h = 2.5")
    for name, spring, setting in (("wave", ground.spring, "true"), ("wave_dashpots", 0.0, "false")):
        run = case.run(name, "Continuum/Boundary springs=" + setting, *wave)
        found = run.history("monitors/top/displacement")[:, 1]
        upgoing = 0.5 * run.file["input/displacement"][:][: len(found), 1]  # half the outcrop motion
        expected = surface(run.time, upgoing, Ground(run), spring)
        peak = np.abs(expected).max()
        case.below(name + ": top against closed form, of the peak", np.abs(found - expected).max() / peak, 0.02)
        if spring:
            shown.update(wave_time=run.time, wave=found, closed=expected)


def draw(case, figure):
    left, right = figure.subplots(1, 2)
    t = shown["time"]
    left.plot(t, 1e3 * shown["dashpots"], label="dashpots")
    left.plot(t, 1e3 * shown["springs"], label="visco-elastic")
    left.axhline(-1e3 * shown["settlement"], color="k", ls="--", lw=0.8, label="$-p/k_n$")
    left.plot(t, -1e3 * shown["drift"] * t, "k:", lw=0.8, label="$-p\\,t/(\\rho c_p)$")
    left.set_xlabel("time [s]")
    left.set_ylabel("base, vertical [mm]")
    left.legend()
    right.plot(shown["wave_time"], 1e3 * shown["wave"], label="program")
    right.plot(shown["wave_time"], 1e3 * shown["closed"], "k--", lw=0.8, label="closed form")
    right.set_xlabel("time [s]")
    right.set_ylabel("top, vertical [mm]")
    right.legend()
    figure.suptitle("Lasting load and P wave on a visco-elastic base")
