# SPDX-License-Identifier: GPL-3.0-or-later
"""The plan of a study: a scene, what is varied, and the settings that follow from it."""

import hashlib
import itertools
import os
import re
from dataclasses import dataclass, field

from hybrid_run import UserError
from hybrid_tools.study.axes import Axis, label_text, name_shortly

NOT_RESULTS = ("Output/", "Checkpoint/")  # parameters that change no result
SEED_CHANGE = 1e-6  # of Young's moduli, per seed
PICTURES_OFF = "Output/Picture interval=0"


@dataclass
class Setting:
    """One run. levels: index of each axis; effect: name of what is changed besides; seed: 0, or which copy that differs by millionths."""

    levels: tuple
    effect: str = ""
    seed: int = 0
    overrides: list = field(default_factory=list, compare=False)
    name: str = field(default="", compare=False)


@dataclass
class Study:
    """scene: path. common: -s of every run. effects: {name: overrides}. closed_forms: {quantity: number or path of a CSV}.

    base: parameters of the scene with the common overrides. seeds: copies of the finest run; None: as needed. tolerance: error, or None.
    quantities: patterns of what counts for the error; empty: everything. text: the scene with all parameters, of a new plan.
    """

    scene: str
    directory: str
    common: list
    axes: list
    effects: dict = field(default_factory=dict)
    closed_forms: dict = field(default_factory=dict)
    base: dict = field(default_factory=dict)
    seeds: int = None
    tolerance: float = None
    quantities: list = field(default_factory=list)
    text: str = ""

    def __post_init__(self):
        name_shortly(self.axes)

    @property
    def finest(self):
        """Levels of the run that the others are compared with."""
        return tuple(axis.reference for axis in self.axes)

    def axes_of(self, *kinds):
        """Indices of the axes of these kinds."""
        return [index for index, axis in enumerate(self.axes) if axis.kind in kinds]

    def settings(self, seeds=0):
        """All runs, coarse ones first: the grid, the effects one at a time and `seeds` copies of the finest run."""
        grid = [Setting(levels) for levels in itertools.product(*(range(len(axis.labels)) for axis in self.axes))]
        found = grid + [Setting(self.finest, effect=name) for name in self.effects]
        found += [Setting(self.finest, seed=seed) for seed in range(1, seeds + 1)]
        for setting in found:
            self._complete(setting)
        return found

    def _complete(self, setting):
        setting.overrides = [axis.override(level, self.base) for axis, level in zip(self.axes, setting.levels)]
        setting.overrides += self.effects.get(setting.effect, [])
        if setting.seed:
            setting.overrides += self._seeded_moduli(setting)
        setting.name = "%s-%s" % (re.sub(r"[^A-Za-z0-9.=+,-]+", "_", self.describe(setting, ",", "="))[:80], self._fingerprint(setting))

    def _seeded_moduli(self, setting):
        """Young's modulus of every material, larger by as many millionths as the seed says: the same problem to any engineer."""
        given = dict(override.split("=", 1) for override in self.common + setting.overrides)
        keys = ["Materials/%s/Young modulus" % name.strip() for name in given.get("Materials/Names", self.base["Materials/Names"]).split(",")]
        return ["%s=%r" % (key, float(given.get(key, self.base.get(key, "1e9"))) * (1 + SEED_CHANGE * setting.seed)) for key in keys]

    def _fingerprint(self, setting):
        """Of everything that the results depend on: a changed scene has other runs."""
        parameters = {key: value for key, value in self.base.items() if not key.startswith(NOT_RESULTS)}
        digest = hashlib.sha256(repr((sorted(parameters.items()), setting.overrides)).encode())
        values = list(parameters.values()) + [override.split("=", 1)[1] for override in setting.overrides]
        for value in values:
            if os.path.isfile(value):
                with open(value, "rb") as file:
                    digest.update(hashlib.sha256(file.read()).digest())
        return digest.hexdigest()[:8]

    def describe(self, setting, comma=", ", equals=" "):
        """Time step 0.001, h 4."""
        words = ["%s%s%s" % (axis.short, equals, label_text(axis.labels[level]))
                 for axis, level in zip(self.axes, setting.levels)]
        words += [setting.effect] * bool(setting.effect) + ["seed%s%d" % (equals, setting.seed)] * bool(setting.seed)
        return comma.join(words) or "scene"

    def to_json(self):
        """What study.json holds."""
        members = ("key", "entry", "labels", "kind", "sizes", "reference")
        axes = [{name: getattr(axis, name) for name in members} for axis in self.axes]
        names = ("scene", "directory", "common", "effects", "closed_forms", "seeds", "tolerance", "quantities", "base")
        return dict({name: getattr(self, name) for name in names}, axes=axes)


def from_json(content):
    """A study that was planned before."""
    return Study(**dict(content, axes=[Axis(**axis) for axis in content["axes"]]))


def parse_tolerance(text):
    """0.02 of "2%" or "0.02"."""
    match = re.fullmatch(r"\s*([0-9.eE+-]+)\s*(%?)\s*", str(text))
    try:
        value = float(match.group(1)) / (100 if match.group(2) else 1)
    except (AttributeError, ValueError):
        value = -1.0
    if not 0 < value < 1:
        raise UserError("--tolerance is a part between 0 and 1, such as 2%% or 0.02, not '%s'" % text)
    return value
