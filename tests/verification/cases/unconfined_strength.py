# SPDX-License-Identifier: GPL-3.0-or-later
"""Unconfined strength of bonded triangles: that of the edges that the mesh has, and how to calibrate a mesh with edges in all directions."""

import pathlib

import numpy as np
from scene_numbers import Numbers

MESHES = pathlib.Path(__file__).resolve().parents[3] / "meshes"
SEEDS = (2, 3)  # of further meshes
YIELDING_SEEDS = (1, 2, 3)  # of meshes whose blocks yield
CONFINED_SEEDS = (4, 5, 6)  # of meshes that are calibrated and confined
LATERAL = 0.1  # lateral over axial traction of the confined specimen [-]
SHORTENED = 3.0  # has collapsed: times the shortening of the elastic specimen at its strength
LOAD, LOAD_STRUCTURED, LOAD_CALIBRATED, LOAD_CONFINED, LOAD_YIELDING = 1.15, 1.08, 1.1, 1.25, 1.035  # at the end, over the strength expected
EARLIER = (1.05, 1.12)  # runs end there if it has collapsed: then it flies apart in tens of thousands of steps


def mohr_coulomb(rock):
    """Strength of the material without confinement [Pa]."""
    return 2 * rock.cohesion * np.cos(rock.friction) / (1 - np.sin(rock.friction))


def jaeger(rock, angle):
    """Strength of a specimen with joints at an angle to its soles, none confined [Pa] (Jaeger 1960)."""
    return rock.cohesion / (np.cos(angle) * (np.sin(angle) - np.cos(angle) * np.tan(rock.friction)))


def confined(rock, lateral):
    """The axial stress [Pa] at which the material fails if the lateral one is its part."""
    passive = (1 + np.sin(rock.friction)) / (1 - np.sin(rock.friction))
    return mohr_coulomb(rock) / (1 - lateral * passive)


class Specimen:
    """A run, and the load under which it collapses."""

    def __init__(self, run, expected):
        numbers = Numbers(run)
        self.rock = numbers.material("rock")
        load = [float(x) for x in numbers.text("Edge loads/Tractions").split(";")[0].split(":")[1].split(",")]
        self.stress = -load[5] * run.time / numbers.number("Edge loads/Rise time")
        tops = [run.history("monitors/%s/displacement" % name)[:, 1] for name in "abcd"]
        self.shortening = -np.mean(tops, axis=0) / numbers.mesh("Height")
        modulus = self.rock.young / (1 - self.rock.poisson**2)
        collapsed = self.shortening > SHORTENED * expected / modulus
        self.strength = self.stress[np.argmax(collapsed)] if collapsed.any() else np.inf


class Press:
    """Runs specimens of a case."""

    def __init__(self, case, rise):
        self.case, self.rise = case, rise

    def run(self, name, expected, overrides=(), width=4.0, height=8.0, lateral=0.0, load=LOAD, earlier=(), **mesh):
        """A specimen under a load that grows to load times the strength that is expected [Pa], or to the first earlier part where it has collapsed."""
        top = -load * expected
        loads = ["top: -0.01, %.6g, %.6g, %.6g, 0, %.8g" % (width + 0.01, height - 0.01, height + 0.01, top)]
        if lateral > 0:
            loads += ["left: -0.01, 0.01, -0.01, %.6g, %.8g, 0" % (height + 0.01, -lateral * top),
                      "right: %.6g, %.6g, -0.01, %.6g, %.8g, 0" % (width - 0.01, width + 0.01, height + 0.01, lateral * top)]
        points = "; ".join("%s: %.6g, %.6g" % (name_, width * part, height - 1e-3)
                           for name_, part in zip("abcd", (0.13, 0.37, 0.63, 0.87)))
        for part in (*(part for part in earlier if part < load), load):
            run = self.case.run(name, "Edge loads/Tractions=" + "; ".join(loads), "Monitors/Points=" + points, *overrides,
                                "Time/End time=%.6g" % (self.rise * part / load), mesh=dict(mesh, Width=width, Height=height))
            specimen = Specimen(run, expected)
            if np.isfinite(specimen.strength):
                break
        return specimen


def check(case):
    default = case.run()
    press = Press(case, Numbers(default).number("Edge loads/Rise time"))
    rock = Numbers(default).material("rock")
    expected = mohr_coulomb(rock)
    first = Specimen(default, expected)
    case.expected, case.curves = expected, {"all directions, seed 1": first}

    # Edges in the direction of failure: the diagonals of cells sqrt(3) as high as wide.
    structured = ("Mesh/File=%s" % (MESHES / "bonded_blocks.geo"),)
    for size in (2.0, 1.0):
        aligned = press.run("edges_60_h_%g" % size, expected, structured, width=size * 2 / np.sqrt(3) * 0.99999, height=4 * size,
                            load=LOAD_STRUCTURED, **{"Resolution/h": size})
        case.near("edges at 60 degrees, h = %g m: strength" % size, aligned.strength, expected, 0.03, "Pa")
        case.curves["edges at 60 degrees, h = %g m" % size] = aligned
    best = jaeger(rock, np.pi / 4)
    squares = press.run("edges_45", best, structured, load=LOAD_STRUCTURED)
    case.near("edges at 0, 45 and 90 degrees: strength", squares.strength, best, 0.03, "Pa")
    case.curves["edges at 0, 45, 90 degrees"] = squares

    # Edges in all directions.
    strengths = [first.strength]
    for seed in SEEDS:
        specimen = press.run("seed_%d" % seed, expected, Seed=seed)
        case.curves["all directions, seed %d" % seed] = specimen
        strengths.append(specimen.strength)
    factor = np.mean(strengths) / expected
    case.near("edges in all directions, mean of %d meshes: strength" % len(strengths), factor * expected, expected, 0.1, "Pa")

    # Blocks that yield: no mesh is too strong.
    for seed in YIELDING_SEEDS:
        specimen = press.run("yielding_%d" % seed, expected, ("Blocks/Yielding=true",), load=LOAD_YIELDING, Seed=seed)
        case.curves["blocks yield, seed %d" % seed] = specimen
        case.near("blocks that yield, seed %d: strength" % seed, specimen.strength, expected, 0.025, "Pa")

    # Calibrated: cohesion and tensile strength over that factor.
    weaker = ("Materials/rock/Cohesion=%.8g" % (rock.cohesion / factor), "Materials/rock/Tensile strength=%.8g" % (rock.tensile_strength / factor))
    for name, mesh in (("another mesh", {"Seed": 4}), ("a wider specimen", {"Seed": 5, "width": 6.0})):
        specimen = press.run(name.replace(" ", "_"), expected, weaker, load=LOAD_CALIBRATED, earlier=EARLIER, **mesh)
        case.near("calibrated, %s: strength" % name, specimen.strength, expected, 0.1, "Pa")
        case.curves["calibrated, " + name] = specimen
    axial = confined(rock, LATERAL)
    strengths = [press.run("confined_%d" % seed, axial, weaker, lateral=LATERAL, load=LOAD_CONFINED, earlier=EARLIER, Seed=seed).strength
                 for seed in CONFINED_SEEDS]
    case.near("calibrated, confined by a tenth, mean of %d meshes: axial strength" % len(strengths), np.mean(strengths), axial, 0.1, "Pa")


def draw(case, figure):
    axes = figure.subplots()
    for name, specimen in case.curves.items():
        style = "--" if "degrees" in name else (":" if "calibrated" in name else "-")
        axes.plot(100 * specimen.shortening, specimen.stress / 1e3, style, label=name)
    axes.axhline(case.expected / 1e3, color="k", linewidth=0.8, label="Mohr-Coulomb")
    axes.set(xlabel="shortening [%]", ylabel="axial stress [kPa]", xlim=(0, 0.2))
    axes.legend(fontsize="small", loc="lower right")
