#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""An effect that is switched off changes no bit of a scene that never had it.

Usage: effects_off_test.py HYBRID_BINARY ROOT WORK_DIR

For every effect: the scene as it is, the scene with all of the effect's parameters but its switch off, the scene with the
switch on and nothing for it to do where there is such a thing, and the scene with the effect (which must differ, else the
comparison would say nothing). Compared are all data sets of run.h5 but wall times. Effects of one scene are switched off in
one run; if that differs, each by itself, to tell which it is.
"""
import pathlib
import shutil
import sys

TESTS = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(TESTS))
from determinism_test import differences, read  # noqa: E402 (needs the path above)
from run_hybrid import run_hybrid  # noqa: E402

SCENES = TESTS.parent / "parameters/verification"

# The scenes: file and overrides that make them short.
COLUMN = ["coupled_column.prm", "Time/End time=0.06"]
WEAK = COLUMN + ["Materials/rock/Cohesion=7e4", "Materials/rock/Friction angle=20", "Gravity/Static stage=equilibrium or move"]
BAR = ["coulomb_joint.prm", "Time/End time=0.1", "Time/Time step=0.002", "Output/Audit interval=0.01", "Motion/Peak=20",
       "Motion/Frequency=10", "Time/Scheme=dissipative",  # whatever the planes do
       "Mesh/Numbers=Lying = 1; Length = 60; Planes = 1; First plane = 20; Resolution/h = 10",
       "Monitors/Points=before: 10, 5; behind: 30, 5"]
ELASTIC = BAR + ["Bedding planes/Strength=elastic", "Bedding planes/Friction angle=0", "Bedding planes/Cohesion=0",
                 "Bedding planes/Tensile strength=0", "Bedding planes/Initial normal stress=0"]
SLOPE = ["unit_squares.prm", "Time/End time=0.03", "Mesh/Numbers=Angle = 20; Columns = 3; Rows = 2; Base above = 20",
         "Monitors/Points=block: 0.299, 0.641"]
BELT = ["rate_belt.prm", "Time/End time=0.05", "Materials/belt/Friction rate coefficient=0"]
LAYERS = ["bedrock_layers.prm", "Time/End time=0.02"]

BEDDING = ["Bedding planes/Friction angle=30", "Bedding planes/Cohesion=2000", "Bedding planes/Tensile strength=1000",
           "Bedding planes/Initial normal stress=10000"]
SPRINGS = ["Continuum/Normal spring coefficient=2", "Continuum/Tangential spring coefficient=2", "Continuum/Spring distance=50"]
TOP = "Edge loads/Tractions=top: -1, 11, 19.9, 20.1, 0, %s"
WAVE = ["Initial wave/Direction=90", "Initial wave/Frequency=200", "Initial wave/Centre=5, 4", "Initial wave/Length=0.25"]
MAXWELL = ["Maxwell damping/Lowest frequency=2", "Maxwell damping/Highest frequency=30", "Maxwell damping/Branches=4"]
EDGE = ["Edge loads/Start=0.01", "Edge loads/Rise time=0.02"]
POINT = ["Point loads/Frequency=20", "Point loads/Start=0.001"]
HELD = {"energy/edge_load_work", "energy/water_work", "interface/water_force", "section/water_levels", "section/water_line"}  # recorded because the effect is on

# effect: (scene, switched off, on with nothing to do or None, on)
EFFECTS = {
    "bedding slip": (ELASTIC, BEDDING, None, BEDDING + ["Bedding planes/Strength=Mohr-Coulomb"]),
    "bedding planes": (COLUMN, BEDDING + ["Bedding planes/Names=", "Bedding planes/Shear stiffness=1e7"], None, None),
    "water": (COLUMN, ["Water/Level=none", "Water/Density=1100"],
              ["Water/Level=-1000", "Water/Method=paper", "Blocks/Saturated material=rock"],
              ["Water/Level=15", "Water/Method=submerged"]),
    "water, submerged": (SLOPE, ["Water/Density=1100"], ["Water/Level=-1000", "Water/Method=submerged"],
                         ["Water/Level=3", "Water/Method=submerged"]),
    "water, pressures": (COLUMN, ["Water/Density=1100"], ["Water/Level=-1000", "Water/Method=pressures"],
                         ["Water/Level=15", "Water/Method=pressures"]),
    "phreatic line": (SLOPE, ["Water/Line file="], None, ["Water/Line file=%s" % (SCENES / "seepage_line_20.csv"), "Water/Method=submerged"]),
    "level in time": (SLOPE, ["Water/Level file="], None, ["Water/Level file=%s" % (SCENES / "drawdown_level.csv"), "Water/Method=pressures"]),
    "heterogeneity": (COLUMN, ["Heterogeneity/Modulus shape=none", "Heterogeneity/Strength shape=none", "Heterogeneity/Seed=7"],
                      None, ["Heterogeneity/Modulus shape=4", "Heterogeneity/Seed=7"]),
    "lines": (COLUMN, ["Monitors/Line interval=0.1", "Monitors/Line points=5"], None, None),
    "block damping": (COLUMN, ["Blocks/Damping ratio=0", "Blocks/Damping frequency=7"], None,
                      ["Blocks/Damping ratio=0.05", "Blocks/Damping frequency=7"]),
    "loose damping": (SLOPE + ["Blocks/Loose damping=0"], ["Blocks/Loose damping=0"], None, ["Blocks/Loose damping=0.5"]),
    "loose damping of bonded blocks": (COLUMN, ["Blocks/Loose damping=0"], ["Blocks/Loose damping=3"], None),
    "Rayleigh damping": (COLUMN, ["Continuum/Rayleigh mass=0", "Continuum/Rayleigh stiffness=0"], None,
                         ["Continuum/Rayleigh mass=0.1", "Continuum/Rayleigh stiffness=1e-3"]),
    "Maxwell damping of the bedrock": (COLUMN, ["Maxwell damping/Bedrock ratio=0"] + MAXWELL, None,
                                       ["Maxwell damping/Bedrock ratio=0.05"] + MAXWELL),
    "Maxwell damping of blocks": (COLUMN + ["Time/End time=0.2"], ["Maxwell damping/Block ratio=0"] + MAXWELL, None,
                                  ["Maxwell damping/Block ratio=0.05"] + MAXWELL),
    "belt at a rate": (BELT, ["Materials/belt/Friction rate coefficient=0", "Materials/belt/Friction reference rate=0.01"], None,
                       ["Materials/belt/Friction rate coefficient=0.05"]),
    "dynamic coefficient": (SLOPE, ["Time/Dynamic coefficient=1"], None, ["Time/Dynamic coefficient=0.99"]),
    "boundary springs": (COLUMN, ["Continuum/Boundary springs=false"] + SPRINGS, None,
                         ["Continuum/Boundary springs=true"] + SPRINGS),
    "free field": (COLUMN + ["Continuum/Sides=viscous"], SPRINGS, None, ["Continuum/Sides=free field"]),
    "gravity": (COLUMN + ["Gravity/Acceleration=0"], ["Gravity/Static stage=held"], ["Gravity/Static stage=none"],
                ["Gravity/Acceleration=9.81"]),
    "initial stress": (COLUMN, ["Gravity/Initial stress=elastic"], None, ["Gravity/Initial stress=0.8"]),
    "lifts": (COLUMN, ["Gravity/Lifts=3"], None, ["Gravity/Initial stress=staged", "Gravity/Lifts=3"]),
    "repeated motion": (COLUMN, ["Motion/Repetitions=1", "Motion/Repetition interval=0.02"],
                        ["Motion/Repetitions=2", "Motion/Repetition interval=1"],
                        ["Motion/Repetitions=2", "Motion/Repetition interval=0.02"]),
    "pseudo-static force": (COLUMN, ["Gravity/Horizontal coefficient=0"], None, ["Gravity/Horizontal coefficient=0.05"]),
    "strength reduction": (SLOPE, ["Materials/Strength reduction factor=1"], None, ["Materials/Strength reduction factor=1.1"]),
    "point loads": (COLUMN, ["Point loads/Forces="] + POINT, ["Point loads/Forces=a: 5, 0, 0, 0"] + POINT,
                    ["Point loads/Forces=a: 5, 0, 0, 1e6"] + POINT),
    "edge loads": (COLUMN, ["Edge loads/Tractions="] + EDGE, [TOP % "0"] + EDGE, [TOP % "-1e3"] + EDGE),
    "initial wave": (COLUMN, ["Initial wave/Type=none"] + WAVE, None, ["Initial wave/Type=P"] + WAVE),
    "initial velocities": (SLOPE, ["Blocks/Initial velocities="], ["Blocks/Initial velocities=v: -9, 9, -9, 9, 0, 0, 0"],
                           ["Blocks/Initial velocities=v: -9, 9, -9, 9, 0, 0.1, 0"]),
    "fracture": (COLUMN, ["Blocks/Fracture energy=200", "Blocks/Softening slip=0.5", "Materials/rock/Residual cohesion=100",
                          "Materials/rock/Residual friction angle=5"], None,
                 ["Materials/rock/Tensile strength=0", "Materials/rock/Cohesion=1e3", "Gravity/Static stage=equilibrium or move"]),
    "yielding": (WEAK, ["Blocks/Yielding=false", "Materials/rock/Dilation angle=5"], None,
                 ["Blocks/Yielding=true", "Materials/rock/Dilation angle=5"]),
    "motion": (SLOPE, ["Motion/Type=none", "Motion/Frequency=5", "Motion/Angle=30", "Motion/Start=0.01"],
               ["Motion/Type=ricker", "Motion/Peak=0", "Motion/Angle=30"], ["Motion/Type=ricker", "Motion/Peak=2"]),
    "continuum": (SLOPE, ["Model/Bedrock=rigid", "Continuum/Materials=rock", "Continuum/Degree=3", "Continuum/Sides=fixed"], None,
                  ["Materials/rock/Friction angle=5"]),
    "blocks": (BAR, ["Blocks/Material=rock", "Blocks/Damping ratio=0.1", "Blocks/Penalty ratio=10"], None, None),
    "bedding slip of blocks": (LAYERS, BEDDING, None, ["Bedding planes/Strength=Mohr-Coulomb"]),
    "bedrock of layers": (LAYERS, ["Bedding planes/Strength=elastic", "Continuum/Rayleigh mass=0"], None,
                          ["Continuum/Rayleigh stiffness=1e-3"]),
}


class Comparison:
    def __init__(self, binary, root, work):
        self.binary, self.scenes, self.work = binary, pathlib.Path(root) / "parameters/verification", work
        self.made, self.failures = {}, 0

    def data(self, scene, overrides):
        """Data sets of a run; each run is made once."""
        key = tuple(scene) + tuple(overrides)
        if key not in self.made:
            directory = self.work / str(len(self.made))
            code, _, errors, command = run_hybrid(self.binary, self.scenes / scene[0], directory, scene[1:] + overrides)
            if code != 0:
                sys.exit("error: %s ended with code %d: %s" % (command, code, errors[-300:]))
            self.made[key] = read(directory)
        return self.made[key]

    def equal(self, what, scene, overrides, extra=frozenset()):
        without, now = self.data(scene, []), self.data(scene, overrides)
        now = {name: values for name, values in now.items() if name not in extra or name in without}
        names = differences(without, now)
        print("%s  %-22s %s" % ("FAIL" if names else "ok  ", what, ", ".join(names[:4]) or "%d data sets equal" % len(now)))
        self.failures += bool(names)
        return not names

    def different(self, what, scene, overrides):
        without, now = self.data(scene, []), self.data(scene, overrides)
        if all(without[name].tobytes() == now[name].tobytes() for name in without if name.startswith("monitors/")):
            print("FAIL  %-22s on, and the monitors do not feel it" % what)
            self.failures += 1


def main():
    work = pathlib.Path(sys.argv[3])
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    comparison = Comparison(sys.argv[1], sys.argv[2], work)
    for scene in {tuple(scene): scene for scene, _, _, _ in EFFECTS.values()}.values():
        effects = {name: effect[1] for name, effect in EFFECTS.items() if effect[0] == scene}
        together = list(dict.fromkeys(override for off in effects.values() for override in off))
        print("%s: %s" % (scene[0], ", ".join(effects)))
        if not comparison.equal("off", scene, together):
            for name, off in effects.items():
                comparison.equal(name + ", off", scene, off)
    for name, (scene, _, neutral, on) in EFFECTS.items():
        if neutral is not None:
            comparison.equal(name + ", nothing to do", scene, neutral, HELD)
        if on is not None:
            comparison.different(name, scene, on)
    print("%d runs" % len(comparison.made))
    return 1 if comparison.failures else 0


if __name__ == "__main__":
    sys.exit(main())
