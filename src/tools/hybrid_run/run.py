# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads the output directory of a run: run.h5 (see run_file.md) and summary.json."""

import json
import os

import h5py
import numpy as np

from .blocks import Blocks
from .errors import MissingData, NotInScene, UserError
from .line import Line
from .monitor import Monitor
from .parameters import parameters_of_run, units
from .pictures import Pictures


class Run:
    """One run, finished or going on.

    time: end of each step [s], n. monitors: by name. blocks: of the sliding mass. summary: summary.json, empty until the run has ended.
    parameters: every parameter of the run by "Section/Name", as text.
    """

    def __init__(self, directory):
        """@raises UserError if there is no run in the directory, or run.h5 cannot be read."""
        self.directory = str(directory)
        if not os.path.isdir(self.directory):
            raise UserError("'%s' is not a directory; give the output directory of a run" % self.directory)
        if not os.path.exists(os.path.join(self.directory, "run.h5")):
            raise UserError("'%s' holds no run.h5; give the output directory of a run" % self.directory)
        try:
            self.reopen()
        except (OSError, ValueError) as error:
            raise UserError("cannot read the run in '%s': %s" % (self.directory, error)) from error

    @property
    def monitors(self):
        return {name: Monitor(self, name) for name in self.names("monitors")}

    @property
    def lines(self):
        return {name: Line(self, name) for name in self.names("lines") if name != "time"}

    @property
    def blocks(self):
        return Blocks(self)

    def pictures(self, name):
        """The series "blocks", "joints" or "continuum": .times, and [k] with .points, .cells and .fields. @raises MissingData without it."""
        return Pictures(self.directory, name)

    @property
    def parameters(self):
        try:
            return parameters_of_run(self.directory)
        except OSError as error:
            raise MissingData("no params.used.prm in '%s'" % self.directory) from error

    def unit(self, parameter):
        """Of "Section/Name", "" if it has none."""
        try:
            return units(os.path.join(self.directory, "params.used.prm")).get(parameter, "")
        except OSError:
            return ""

    def reopen(self):
        """What the file says now: a run that goes on writes while it is read."""
        if getattr(self, "file", None):
            self.file.close()
        directory = self.directory
        self.file = h5py.File(os.path.join(directory, "run.h5"), "r")
        self.time = self.file["time"][:] if "time" in self.file else np.zeros(0)
        self.summary = self._read_summary()
        self.corner = float(np.ravel(self.attribute("filtered", "corner", 0.0))[0])
        # The run may be going on: its series can differ by the rows of the last flush.
        histories = [d for g in ("monitors", "input") if g in self.file for d in self._data_sets(self.file[g])]
        self.n = min([len(self.time)] + [len(d) for d in histories])
        self.time = self.time[: self.n]
        sign = float(np.ravel(self.file.attrs.get("downhill_sign", -1.0))[0])
        self.is_level = sign == 0.0
        self.downhill = sign or 1.0  # a level surface: along x
        self.base = self.text(self.file.attrs.get("base_monitor", ""))

    def _read_summary(self):
        """summary.json, unless it is that of an earlier run in the same directory."""
        summary = os.path.join(self.directory, "summary.json")
        if not os.path.exists(summary):
            return {}
        with open(summary, encoding="utf-8") as text:
            found = json.load(text)
        simulated = found.get("simulated_time_s", 0.0)
        ended = len(self.time) == 0 or abs(self.time[-1] - simulated) <= 1e-6 * max(simulated, 1e-9)
        return found if ended else {}

    @staticmethod
    def text(value):
        return value.decode() if isinstance(value, bytes) else str(value)

    @staticmethod
    def _data_sets(group):
        found = []
        group.visititems(lambda name, item: found.append(item) if isinstance(item, h5py.Dataset) else None)
        return found

    def title(self):
        title = self.text(self.file.attrs.get("title", "")) or self.summary.get("title", "")
        return title or os.path.basename(os.path.abspath(self.directory))

    def along(self, level="+x"):
        """What a horizontal component times self.downhill is called."""
        return level if self.is_level else "downhill"

    def has(self, path):
        return path in self.file

    def get(self, path):
        """A data set as an array; MissingData if it is absent or empty, NotInScene if it is of blocks and there are none."""
        if path not in self.file or self.file[path].size == 0:
            if path.startswith("section/blocks") and self.summary.get("blocks") == 0:
                raise NotInScene("the scene has no blocks")
            raise MissingData("no " + path + " in run.h5")
        return self.file[path][:]

    def attribute(self, path, name, default=None):
        return self.file[path].attrs.get(name, default) if path in self.file else default

    def names(self, group):
        return sorted(self.file[group], key=natural_key) if group in self.file else []

    @property
    def downhill_of_soles(self):
        """Sign of x downhill of each sole, 0 where it is level. @raises MissingData without soles."""
        if self.has("slip/downhill"):
            return np.ravel(self.get("slip/downhill"))
        return np.full(len(self.get("slip/position").reshape(-1, 2)), 0.0 if self.is_level else self.downhill)

    @property
    def slips_downhill(self):
        """Whether slip is positive downhill, at least of some soles; else along +x."""
        return bool(np.any(self.downhill_of_soles)) if self.has("slip/downhill") else not self.is_level

    @property
    def is_on_both_flanks(self):
        """Whether some soles fall towards +x and others towards -x."""
        return self.has("slip/downhill") and {1.0, -1.0} <= set(self.downhill_of_soles)

    @property
    def surface(self):
        """The sliding surface: a list of polylines, each n x 2 [m]. @raises MissingData without one."""
        points = self.get("section/surface")
        if not self.has("section/surface_offsets"):
            return [points]
        return np.split(points, self.get("section/surface_offsets").astype(int)[1:-1])

    def history(self, path):
        values = self.get(path)
        if self.n < 2:
            raise MissingData("fewer than two steps in run.h5")
        return values[: self.n]

    def equal_steps(self, values):
        """Time and values at equal spacing (cut steps are interpolated)."""
        if self.n < 3:
            return self.time, values
        steps = np.diff(self.time)
        if np.ptp(steps) <= 1e-6 * steps.max():
            return self.time, values
        spacing = max(steps.min(), steps.mean() / 4)
        time = self.time[0] + spacing * np.arange(int((self.time[-1] - self.time[0]) / spacing) + 1)
        columns = [np.interp(time, self.time, values[:, c]) for c in range(values.shape[1])]
        return time, np.column_stack(columns)

    def resolved_frequency(self):
        """Half of the rate of the recorded steps [Hz]."""
        steps = np.diff(self.time)
        return 0.5 / steps.max() if len(steps) else np.inf

    def frequencies(self, points=200):
        """Frequencies for spectra [Hz]: equal on a logarithmic axis, from three periods in the run to the low-pass, or half the sampling rate."""
        highest = min(self.corner or np.inf, self.resolved_frequency())
        return np.geomspace(min(3 / (self.time[-1] - self.time[0]), 0.5 * highest), highest, points)

    def filtered(self, path):
        """Time and values below self.corner [Hz], as the program writes them at the end of a run; 0: raw."""
        if not self.has("filtered/" + path):
            return self.time, self.history(path)
        return self.get("filtered/time"), self.get("filtered/" + path)

    def relative_displacement(self, name):
        displacement = self.history("monitors/" + name + "/displacement")
        if self.base and self.has("monitors/" + self.base):
            displacement = displacement - self.history("monitors/" + self.base + "/displacement")
        return displacement

    def mobilised(self):
        """Base shear over the shear strength of the sliding surface at every step [-], downhill positive; 0 where nothing presses."""
        shear, strength = self.history("base_shear/shear"), self.history("base_shear/strength")
        return np.divide(shear, strength, out=np.zeros_like(shear), where=strength > 0)

    def monitor_groups(self):
        """{"S": [...], "D": [...], "other": [...], "base": [...]}; the base monitor moves far more than others relative to it."""
        groups = {"S": [], "D": [], "other": [], "base": []}
        for name in self.names("monitors"):
            groups["base" if name == self.base else name[0] if name[0] in "SD" else "other"].append(name)
        return {key: names for key, names in groups.items() if names}


def natural_key(name):
    """S2 before S10."""
    head = name.rstrip("0123456789")
    return head, int(name[len(head) :] or 0), name
