# SPDX-License-Identifier: GPL-3.0-or-later
"""A run directory as the program writes it, from formulas: make_synthetic_run.py DIR complete|runout|away|bare."""

import json
import sys

import h5py
import numpy as np

GROUND = np.array([(-200, 215), (0, 215), (45, 196), (110, 160), (158, 121), (186, 120), (200, 130), (243, 163), (288, 177),
                   (334, 190), (400, 209), (470, 228), (580, 250), (668, 272), (712, 290), (760, 306), (900, 338), (1100, 338)], float)
SLIP = np.array([(200, 130), (228, 136), (258, 140.5), (288, 147), (334, 164), (400, 184.5), (470, 205.5), (540, 222.5),
                 (600, 239), (655, 259), (690, 275), (712, 290)], float)
MONITORS = {"S1": (206, 134.6), "S2": (243, 163), "S3": (310, 183.2), "S4": (400, 209), "S5": (490, 232), "S6": (580, 250),
            "S7": (650, 267.5), "S8": (705, 287.1), "D1": (228, 131), "D2": (334, 159), "D3": (470, 200.5), "D4": (600, 234),
            "D5": (690, 270), "B1": (450, -60)}
BOREHOLES = {"ZK1": (288, 177, 147, 2.4), "ZK2": (334, 190, 164, 4.6)}


def put(file, path, unit, values):
    file.create_dataset(path, data=np.asarray(values, float)).attrs["unit"] = unit


def motion(time, peak):
    rng = np.random.default_rng(3)
    noise = np.fft.rfft(rng.standard_normal(len(time)))
    f = np.fft.rfftfreq(len(time), time[1] - time[0])
    a = np.fft.irfft(noise * (f / 2.5) ** 2 / (1 + (f / 2.5) ** 4) / (1 + (f / 8) ** 8), len(time))
    a *= np.clip(time / 2, 0, 1) * np.exp(-np.maximum(time - 5, 0) / 1.8)
    a *= peak / np.abs(a).max()
    v = np.cumsum(a) * (time[1] - time[0])
    v -= np.linspace(0, v[-1], len(v))
    u = np.cumsum(v) * (time[1] - time[0])
    u -= np.linspace(0, u[-1], len(u))
    return a, v, u


def triangles(layers=5, columns=90):
    """The sliding mass between slip surface and ground as triangles."""
    x = np.linspace(200, 712, columns + 1)
    low, high = np.interp(x, SLIP[:, 0], SLIP[:, 1]), np.interp(x, GROUND[:, 0], GROUND[:, 1])
    p = [[(x[i], low[i] + (high[i] - low[i]) * j / layers) for j in range(layers + 1)] for i in range(columns + 1)]
    cells = []
    for i in range(columns):
        for j in range(layers):
            a, b, c, d = p[i][j], p[i + 1][j], p[i + 1][j + 1], p[i][j + 1]
            cells += [np.array(t) for t in ((a, b, c), (a, c, d)) if abs(np.cross(np.subtract(t[1], t[0]), np.subtract(t[2], t[0]))) > 1e-6]
    return cells


def write_section(file, final_scale, rng):
    cells = triangles()
    centres = np.array([c.mean(axis=0) for c in cells])
    size = (0.3 + np.exp(-((centres[:, 0] - 300) / 90) ** 2)) * final_scale
    final = np.column_stack([-size, -0.3 * size])
    offsets = np.arange(len(cells) + 1) * 3
    put(file, "section/blocks_offsets", "1", offsets)
    put(file, "section/blocks_points", "m", np.vstack(cells))
    put(file, "section/blocks_points_final", "m", np.vstack([c + d for c, d in zip(cells, final)]))
    put(file, "section/blocks_displacement", "m", final)
    put(file, "section/blocks_peak_displacement", "m", 1.4 * size)
    put(file, "section/surface", "m", SLIP)
    rock = np.vstack([GROUND[:7], SLIP[1:], GROUND[15:], [(1100, -60), (-200, -60), (-200, 215)]])
    put(file, "section/outline", "m", np.hstack([rock[:-1], rock[1:]]))
    file["section"].attrs["water_level"] = 175.0

    edges = np.array([np.r_[c[0], c[2]] for c in cells])
    chosen = rng.permutation(len(edges))[:150]
    chosen = chosen[np.argsort(-size[chosen])]
    ends = edges[chosen]
    put(file, "joints/ends", "m", ends)
    put(file, "joints/position", "m", 0.5 * (ends[:, :2] + ends[:, 2:]))
    put(file, "joints/failure_kind", "1", np.where(rng.random(len(ends)) < 0.4, 1, 2))
    put(file, "joints/failure_time", "s", np.where(rng.random(len(ends)) < 0.2, -1, rng.uniform(3, 9, len(ends))))


def write_monitors(file, time, monitors, a, v, u, slip):
    for i, (name, position) in enumerate(monitors.items()):
        delay, gain = 5 + 15 * (i % 8), 1.0 if name[0] in "BD" else 1.3 + 1.2 * np.exp(-i)
        drift = 0 if name[0] in "BD" else slip * np.exp(-((position[0] - 300) / 150) ** 2)
        late = -drift / (1 + np.exp(-(time - 5.5) / 0.4))
        for quantity, series, unit in (("displacement", u, "m"), ("velocity", v, "m/s"), ("acceleration", a, "m/s2")):
            x = gain * np.roll(series, delay)
            x[:delay] = 0
            y = -0.25 * np.roll(x, 40)
            if quantity == "displacement":
                x, y = x + late, y + 0.3 * late
            put(file, "monitors/%s/%s" % (name, quantity), unit, np.column_stack([x, y]))
            if quantity != "displacement":
                put(file, "filtered/monitors/%s/%s" % (name, quantity), unit, np.column_stack([x, y]))
        file["monitors/" + name].attrs["position"] = position
    put(file, "filtered/time", "s", time)
    file["filtered"].attrs["corner"] = [25.0]


def write_profiles(file, time, scale):
    shape = np.sin(2 * np.pi * 0.9 * time) * np.exp(-((time - 6) / 2.5) ** 2) - 0.4 / (1 + np.exp(-(time - 5.5) / 0.4))
    for name, (x, top, bottom, measured) in BOREHOLES.items():
        depth = np.linspace(0, top - bottom + 5, 21)
        mode = np.where(depth < top - bottom, 1 - 0.75 * depth / (top - bottom), 0.05)
        u = np.zeros((len(time), 42))
        u[:, 0::2] = scale * np.outer(shape, mode)
        put(file, "profiles/%s/depth" % name, "m", depth)
        put(file, "profiles/%s/displacement" % name, "m", u)
        attributes = file["profiles/" + name].attrs
        attributes["position"] = [x, top, x, bottom - 5]
        attributes["measured_mm"], attributes["measured_depth_m"] = [measured], [0.0 if name == "ZK1" else 8.0]
        attributes["slip_depth_m"] = top - bottom


def write_slip(file, time, slip):
    """Soles along the sliding surface that slip by half of what is recorded in the boreholes."""
    x = np.linspace(205, 705, 60)
    shape = np.exp(-((x - 300) / 150) ** 2)
    growth = slip / (1 + np.exp(-(time - 5.5) / 0.4))
    put(file, "slip/position", "m", np.column_stack([x, np.interp(x, SLIP[:, 0], SLIP[:, 1])]))
    put(file, "slip/length", "m", np.full(len(x), 500 / 60))
    put(file, "slip/mean", "m", growth * shape.mean())
    put(file, "slip/largest", "m", growth * shape.max())
    put(file, "slip/time", "s", time[::500])
    put(file, "slip/profile", "m", np.outer(growth[::500], shape))
    put(file, "slip/farthest", "m", slip * shape)
    put(file, "slip/part", "1", (np.outer(growth, shape) > 1e-3).mean(axis=1))
    file["slip"].attrs["threshold"] = [1e-3]
    put(file, "base_shear/shear", "N/m", 6e7 + 2e7 * np.sin(9 * time) * np.exp(-((time - 5.5) / 2) ** 2))
    put(file, "base_shear/strength", "N/m", np.full(len(time), 8e7))


def write_energy_and_steps(file, time, v, rng):
    n = len(time)
    audits = slice(0, n, 10)
    work = np.cumsum(v**2)[audits] * 3e3
    kinetic = 4e6 * v[audits] ** 2
    put(file, "energy/time", "s", time[audits])
    for name, values in (("bedrock_kinetic", kinetic), ("bedrock_strain", 0.6 * np.roll(kinetic, 20)), ("input_work", -work),
                         ("boundary_loss", 0.7 * work), ("friction_loss", 0.22 * work), ("fracture_loss", 0.02 * work),
                         ("blocks_integration_loss", 0.01 * work), ("blocks_gravity", -0.05 * work), ("bedrock_damping_loss", 0.1 * work)):
        put(file, "energy/" + name, "J/m", values)
    put(file, "energy/residual", "1", 1e-4 * (1 + rng.random(len(work))) * np.linspace(0.01, 1, len(work)))
    dt = np.full(n, 1e-3)
    dt[n // 2 : n // 2 + 300] /= 4
    put(file, "steps/dt", "s", dt)
    put(file, "steps/iterations", "1", 2 + rng.poisson(1 + 4 * np.abs(v) / np.abs(v).max()))
    put(file, "steps/solver_iterations", "1", 20 + rng.poisson(8, n))
    put(file, "steps/wall_time", "s", 0.02 * (1 + rng.random(n) ** 4 * 3))


def main(directory, kind):
    rng = np.random.default_rng(1)
    time = 1e-3 * np.arange(1, (12000 if kind != "bare" else 500) + 1)
    peak, slip = {"runout": (9.81, 12.0), "away": (9.81, 1e5)}.get(kind, (0.24, 3e-3))
    a, v, u = motion(time, peak)
    with h5py.File(directory + "/run.h5", "w") as file:
        put(file, "time", "s", time)
        if kind == "bare":
            write_monitors(file, time, {"A": (0.0, 0.0)}, a, v, u, 0)
            return
        file.attrs["title"] = "Majiagou, synthetic data, water at 175 m"
        file.attrs["base_monitor"] = "B1"
        file.attrs["downhill_sign"] = [-1.0]
        for name, series, unit in (("acceleration", a, "m/s2"), ("velocity", v, "m/s"), ("displacement", u, "m")):
            put(file, "input/" + name, unit, np.column_stack([series, np.zeros_like(series)]))
        write_monitors(file, time, MONITORS, a, v, u, slip)
        write_profiles(file, time, slip)
        write_section(file, slip, rng)
        write_slip(file, time, slip)
        write_energy_and_steps(file, time, v, rng)
    summary = {"title": "", "finished": True, "steps": 12000, "simulated_time_s": 12.0, "wall_time_s": 312.4, "cuts": 3,
               "blocks": 900, "continuum_unknowns": 24106, "energy_residual": 2.1e-4, "filter_frequency_hz": 25.0,
               "joints": {"tensile": 48, "shear": 72, "static": {"tensile": 11, "shear": 19}}}
    with open(directory + "/summary.json", "w", encoding="utf-8") as text:
        json.dump(summary, text)


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2])
