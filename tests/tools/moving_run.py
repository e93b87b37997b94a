# SPDX-License-Identifier: GPL-3.0-or-later
"""Small runs whose monitors move as formulas say: for tools that compare runs."""
import json

import h5py
import numpy as np

PARAMETERS = {"Time/Time step": "0.001", "Time/Scheme": "automatic", "Model/Bedrock": "continuum", "Model/Blocks": "bonded",
              "Continuum/Sides": "free field", "Motion/Type": "sine", "Monitors/Filter frequency": "25", "Output/Directory": "x"}
STEP, END = 1e-3, 4.0


def wave(t, frequency=2.0, begin=0.5):
    """A displacement that starts smoothly, dies out and leaves something."""
    grown = np.clip(t - begin, 0, None)
    return 0.01 * (1 - np.exp(-grown**2)) * (0.5 + np.exp(-grown) * np.sin(2 * np.pi * frequency * grown))


def quiver(t):
    """The ground."""
    return wave(t, 3.3) - wave(t, 1.1)


class Maker:
    """Writes run.h5, summary.json and params.used.prm of a run that moves as it is told."""

    def __init__(self, folder):
        self.folder = folder

    def __call__(self, name, step=STEP, end=END, gain=1.0, monitors=None, base="base", summary=None, parameters=None,
                 motion=quiver, sway=wave, vertical=0.25, nan_at=None, slip=None, failures=None, corner=25.0, width=10.0, finished=True):
        directory = self.folder / name
        directory.mkdir(parents=True)
        time = step * np.arange(1, round(end / step) + 1)
        with h5py.File(directory / "run.h5", "w") as file:
            file["time"] = time
            file.attrs.update({"title": "a slope", "base_monitor": base, "downhill_sign": [-1.0]})
            ground = np.column_stack([motion(time), 0 * time])
            file["input/acceleration"] = np.gradient(np.gradient(ground, step, axis=0), step, axis=0)
            for key, (position, factor) in (monitors or {"crest": ((0, 10), 1.0), "toe": ((9, 1), 0.5), "base": ((0, -9), 0.0)}).items():
                u = ground - gain * factor * np.outer(sway(time), [1.0, vertical])
                if nan_at and key == "crest":
                    u[np.searchsorted(time, nan_at), 0] = np.nan
                file["monitors/%s/displacement" % key] = u
                file["monitors/%s/velocity" % key] = np.gradient(u, step, axis=0)
                file["monitors/%s/acceleration" % key] = np.gradient(np.gradient(u, step, axis=0), step, axis=0)
                file["monitors/" + key].attrs["position"] = np.array(position, float)
            if finished:
                file["filtered/time"] = time
                file["filtered"].attrs["corner"] = [corner]
            if slip is not None:
                file["slip/mean"], file["slip/largest"] = slip * sway(time), 1.2 * slip * sway(time)
            if failures is not None:
                file["joints/failure_time"] = np.array(failures, float)
            file["section/blocks_offsets"] = [0.0, 4.0]
            file["section/blocks_points"] = np.array([(0, 0), (width, 0), (width, 10), (0, 10)], float)
        if finished:
            facts = {"finished": True, "simulated_time_s": float(time[-1]), **(summary or {})}
            (directory / "summary.json").write_text(json.dumps(facts))
        lines = []
        for key, value in {**PARAMETERS, "Time/Time step": "%g" % step, **(parameters or {})}.items():
            section, _, parameter = key.rpartition("/")
            lines += ["subsection " + section, "  set %s = %s" % (parameter, value), "end"]
        (directory / "params.used.prm").write_text("\n".join(lines) + "\n")
        return directory
