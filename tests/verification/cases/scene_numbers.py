# SPDX-License-Identifier: GPL-3.0-or-later
"""The numbers of a scene for its closed form: what the run used (params.used.prm) and the defaults of its .geo file."""

import pathlib
import re

import numpy as np

DECLARED = re.compile(r'=\s*\{\s*([-+.\deE]+)\s*,[^}]*Name\s*"([^"]+)"')  # in DefineConstant of a .geo file


class Material:
    """SI, angles in radians."""

    def __init__(self, section):
        self.density = float(section["Density"])
        self.young, self.poisson = float(section["Young modulus"]), float(section["Poisson ratio"])
        angle = section["Friction angle"]
        self.friction = np.radians(30.0 if angle == "automatic" else float(angle))
        self.cohesion, self.tensile_strength = float(section["Cohesion"]), float(section["Tensile strength"])
        weight = section["Weight density"]
        self.weight_density = self.density if weight == "same" else float(weight)
        self.shear_modulus = self.young / (2 * (1 + self.poisson))
        self.oedometer = 2 * self.shear_modulus * (1 - self.poisson) / (1 - 2 * self.poisson)  # lambda + 2 G

    def speed(self, wave):
        """Of "S" or "P" waves [m/s]."""
        return np.sqrt((self.shear_modulus if wave == "S" else self.oedometer) / self.density)


class Numbers:
    """Parameters of a run by their paths, e.g. number("Time/Time step")."""

    def __init__(self, run):
        self.values = run.parameters
        self.geometry = assignments(self.values["Mesh/Numbers"])

    def text(self, path):
        return self.values[path]

    def number(self, path):
        return float(self.values[path])

    def mesh(self, name):
        """Number of the .geo file."""
        if name in self.geometry:
            return self.geometry[name]
        source = pathlib.Path(self.values["Mesh/File"]).read_text(encoding="utf-8")
        return {key: float(value) for value, key in DECLARED.findall(source)}[name]

    def gravity(self):
        return self.number("Gravity/Acceleration")

    def material(self, name):
        head = "Materials/" + name + "/"
        return Material({path[len(head) :]: value for path, value in self.values.items() if path.startswith(head)})

    def point(self, monitor):
        """Where a monitor is [m]."""
        for entry in self.values["Monitors/Points"].split(";"):
            name, place = entry.split(":")
            if name.strip() == monitor:
                return np.array([float(x) for x in place.split(",")])
        raise KeyError(monitor)


def assignments(text):
    """{"Angle": 30.0} of "Angle = 30; Rows = 2"."""
    pairs = (entry.split("=") for entry in text.split(";") if entry.strip())
    return {name.strip(): float(value) for name, value in pairs}
