# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes from combinations of options: the options, what may not be combined, and the files of a scene."""

import math
import pathlib

import section as sections
from newmark_block import REFERENCE_RATE

GRAVITY = 9.81
FACTORS = {
    "bedrock": ["continuum", "rigid", "triangles", "layers"],
    "blocks": ["loose", "bonded"],
    "strength": ["strong", "weak"],  # of joints between blocks
    "belt": ["none", "never fails", "slides", "cohesive"],  # cohesive: a belt that touches blocks it never bonded
    "bedding": ["off", "elastic", "Mohr-Coulomb"],
    "static": ["equilibrium", "held", "none"],
    "water": ["none", "submerged", "pressures", "paper"],
    "scheme": ["automatic", "filtered", "dissipative", "trapezoidal", "shi"],
    "base": ["compliant", "rigid", "fixed"],
    "sides": ["viscous", "free field", "roller", "fixed"],
    "kind": ["quads", "triangles", "columns", "plate"],
    "mass": ["small", "large"],  # large: enough blocks that few of them settle alone
    "nodes": ["shared", "own", "shifted"],
    "ratio": [1.0, 3.0, 10.0, 1.0 / 3.0],  # edge of a block over edge of a cell
    "angle": [20.0, 0.0, 10.0, 30.0],
    "surface": ["plane", "valley", "ridge"],  # the slope changes in the middle of the mass
    "degree": [2, 1, 4],
    "rock": ["stiff", "soft", "mud"],
    "friction": ["holds", "slides"],
    "motion": ["none", "outcrop", "incident", "vertical"],
    "springs": [False, True],
    "damping": ["none", "blocks", "rock", "Maxwell"],
    "belt rate": [0.0, 0.02, -0.02],  # coefficient of the friction of a belt
    "threads": [1, 2],
    "rock solver": ["factor", "band", "iterations"],  # a factor with all of the surface's stiffness or a band of it; conjugate gradients
}
YOUNG = {"stiff": 5e9, "soft": 2e8, "mud": 1e7}  # of the bedrock [Pa]
MASS = {"density": 2000.0, "young": 2e8}  # of the blocks [kg/m3, Pa]
WATER = 1000.0  # [kg/m3]
PENALTY = 40.0

# What the program refuses (exit code 2) or what has no meaning; each rule needs all the options that it names.
RULES = [
    (("bedrock", "sides"), lambda b, s: b != "layers" or s == "viscous"),
    (("bedrock", "sides"), lambda b, s: b != "triangles" or s in ("viscous", "free field")),
    (("bedrock", "sides"), lambda b, s: b != "rigid" or s == "viscous"),  # no sides: one value is enough
    (("bedrock", "base"), lambda b, s: b not in ("rigid", "layers") or s == "rigid"),
    (("bedrock", "bedding"), lambda b, p: b != "layers" or p != "off"),
    (("bedrock", "bedding"), lambda b, p: b != "rigid" or p == "off"),
    (("bedrock", "degree"), lambda b, d: b == "continuum" or d == 2),
    (("bedrock", "rock"), lambda b, r: b != "rigid" or r == "stiff"),
    (("bedrock", "springs"), lambda b, s: b == "continuum" or not s),
    (("bedrock", "rock solver"), lambda b, s: b == "continuum" or s == "factor"),
    (("bedding", "rock solver"), lambda p, s: p != "Mohr-Coulomb" or s != "iterations"),
    (("springs", "base", "sides"), lambda s, b, e: not s or b == "compliant" or e in ("viscous", "free field")),
    (("bedrock", "damping"), lambda b, d: b != "rigid" or d != "rock"),
    (("belt", "belt rate"), lambda b, r: b != "none" or r == 0),
    (("belt", "nodes"), lambda b, n: b == "none" or (n == "shared") == (b != "cohesive")),
    (("nodes", "ratio"), lambda n, r: n != "shared" or r == 1.0),
    (("nodes", "kind"), lambda n, k: n != "shared" or k != "plate"),
    (("blocks", "strength"), lambda b, s: b == "bonded" or s == "strong"),
    (("angle", "friction"), lambda a, f: a > 0 or f == "holds"),
    (("belt", "friction"), lambda b, f: b != "never fails" or f == "holds"),
    (("friction", "static"), lambda f, s: f == "holds" or s != "equilibrium"),
    (("base", "motion"), lambda b, m: b != "fixed" or m == "none"),
    (("surface", "nodes"), lambda s, n: s == "plane" or n != "shifted"),
    (("surface", "kind"), lambda s, k: s == "plane" or k != "plate"),
    (("surface", "ratio"), lambda s, r: s == "plane" or r in (1.0, 3.0, 10.0)),  # the bend lies on a node of the cells
    (("ratio", "degree"), lambda r, d: r < 10 or d < 4),
    (("mass", "kind"), lambda m, k: m == "small" or k == "triangles"),
    (("mass", "ratio"), lambda m, r: m == "small" or r == 1.0),
    (("mass", "blocks", "angle"), lambda m, b, a: m == "small" or b == "bonded" or a <= 10),  # its columns topple on more
]


def is_allowed(options):
    """options: {factor: value}, of some or all factors."""
    return all(rule(*(options[n] for n in names)) for names, rule in RULES if all(n in options for n in names))


def geometry_of(options):
    ratio = options["ratio"]
    width, height, rows = 2.0, 1.0, 2
    columns = 6 if ratio < 1 else 4 if ratio < 2 else 3 if ratio < 6 else 2
    if options["kind"] == "columns":
        height, rows = 3.0, 1
    elif options["kind"] == "plate":
        width, height, rows, columns = 4.0, 1.0, 1, 1
    if options["mass"] == "large":
        rows, columns = 8, 32
    cell = width / ratio
    return {"angle": options["angle"], "surface": options["surface"], "cell": cell, "margin": max(2.0, cell), "rock": 4.0, "width": width,
            "height": height, "columns": columns, "rows": rows, "kind": options["kind"],
            "shared": options["nodes"] == "shared", "phase": 0.37 * min(cell, 1.0) if options["nodes"] == "shifted" else 0.0}


def rock_young(options):
    """Modulus of the bedrock [Pa]: by name, or the number itself."""
    return YOUNG.get(options["rock"], options["rock"])


def friction_angle(options):
    """Of the contact on the slope [deg]."""
    tangent = math.tan(math.radians(options["angle"]))
    if options["friction"] == "slides":
        return math.degrees(math.atan(0.5 * tangent))
    return body_friction(options) if options["belt"] in ("none", "cohesive") else math.degrees(math.atan(1.5 * tangent + 0.25))


def body_friction(options):
    """Between blocks, such that they stand on each other [deg]: loose triangles on their sloping sides, too."""
    steepest = options["angle"]
    if options["kind"] == "triangles" and options["blocks"] == "loose":
        steepest += math.degrees(math.atan(0.5))  # blocks are twice as wide as high
    return math.degrees(math.atan(1.3 * math.tan(math.radians(steepest)) + 0.25))


class Scene:
    """A scene: options, further parameters {"Section/Name": value} and the files in a directory."""

    def __init__(self, options, end_time=0.4, time_step=0.001, factor=1.0):
        self.options, self.end_time, self.time_step = dict(options), end_time, time_step
        self.geometry = geometry_of(options)
        self.section = sections.make_section(self.geometry)
        self.factor = factor  # on everything that has a unit of mass
        self.mirror, self.shift = 1.0, (0.0, 0.0)
        self.further = {}

    def mirrored(self):
        self.section, self.mirror = sections.mirrored(self.section), -1.0
        return self

    def shifted(self, by):
        self.section, self.shift = sections.shifted(self.section, by), by
        return self

    def renumbered(self, seed):
        self.section = sections.renumbered(self.section, seed)
        return self

    def place(self, along, away):
        """Coordinates of a point in the frame of the slope [m]."""
        slope = math.radians(self.options["angle"])
        x = along * math.cos(slope) - away * math.sin(slope)
        y = along * math.sin(slope) + away * math.cos(slope)
        y += sections.bend_of(self.geometry)(x)
        return self.mirror * x + self.shift[0], y + self.shift[1]

    def write(self, directory):
        """The files of the scene; returns the parameter file."""
        directory = pathlib.Path(directory)
        directory.mkdir(parents=True, exist_ok=True)
        sections.write_mesh(self.section, directory / "section.msh")
        if self.section.free_blocks:
            sections.write_polygons(self.section, directory / "blocks.csv")
        file = directory / "scene.prm"
        values = dict(self.parameters(), **self.further)
        file.write_text("# %s\n" % self.name() + "".join(nested(values)), encoding="utf-8")
        return file

    def name(self):
        return ", ".join("%s = %s" % (n, short(v)) for n, v in self.options.items())

    def parameters(self):
        o = self.options
        values = {"Time/End time": self.end_time, "Time/Time step": self.time_step, "Time/Scheme": o["scheme"],
                  "Mesh/File": "section.msh", "Model/Bedrock": o["bedrock"], "Model/Blocks": o["blocks"],
                  "Gravity/Static stage": o["static"], "Parallel/Threads": o["threads"],
                  "Output/Audit interval": self.time_step, "Checkpoint/Wall interval": 0}
        if self.section.free_blocks:
            values["Mesh/Polygons file"] = "blocks.csv"
        values.update(self._materials())
        if o["bedrock"] != "rigid":
            values.update(self._bedrock())
        if o["water"] != "none":
            values.update({"Water/Level": 50 + self.shift[1], "Water/Method": o["water"], "Water/Density": WATER * self.factor})
        if o["damping"] == "blocks":
            values["Blocks/Damping ratio"] = 0.05
        if o["damping"] == "Maxwell":
            values.update({"Maxwell damping/Block ratio": 0.05, "Maxwell damping/Bedrock ratio": 0.0 if o["bedrock"] == "rigid" else 0.03})
        if o["motion"] != "none":
            values.update(self._motion())
        values["Monitors/Points"] = "ground: %.12g, %.12g" % self.place(*self.ground_point())
        return values

    def ground_point(self):
        """Of the monitor on the bare surface, in the frame of the slope [m]."""
        return -0.5 * self.geometry["margin"], -0.01 * self.geometry["cell"]

    def _materials(self):
        o, k = self.options, self.factor
        bond = {"strong": 1e8, "weak": 4e3}[o["strength"]]
        mass = {"Density": MASS["density"] * k, "Young modulus": MASS["young"] * k, "Poisson ratio": 0.25,
                "Friction angle": friction_angle(o) if o["belt"] in ("none", "cohesive") else body_friction(o)}
        if o["blocks"] == "bonded":
            mass.update({"Cohesion": bond * k, "Tensile strength": 0.5 * bond * k})
        materials = {"mass": mass, "rock": {"Density": 2500.0 * k, "Young modulus": rock_young(o) * k,
                                            "Poisson ratio": 0.25}}
        values = {"Blocks/Material": "mass", "Blocks/Fracture energy": 10.0 * k}
        if o["water"] == "paper":  # the same weights as with the other methods
            materials["wet"] = dict(mass, **{"Weight density": (MASS["density"] - WATER) * k})
            values["Blocks/Saturated material"] = "wet"
        if o["belt"] != "none":
            strength = k * {"never fails": 1e8, "cohesive": 2e4}.get(o["belt"], 0.0)
            materials["belt"] = {"Friction angle": friction_angle(o), "Cohesion": strength, "Tensile strength": strength,
                                 "Friction rate coefficient": o["belt rate"], "Friction reference rate": REFERENCE_RATE}
            values["Blocks/Belt material"] = "belt"
        values["Materials/Names"] = ", ".join(materials)
        for name, numbers in materials.items():
            values.update({"Materials/%s/%s" % (name, n): v for n, v in numbers.items()})
        return values

    def _bedrock(self):
        o = self.options
        values = {"Continuum/Materials": "rock", "Continuum/Degree": o["degree"], "Continuum/Base": o["base"],
                  "Continuum/Sides": o["sides"], "Continuum/Boundary springs": "true" if o["springs"] else "false"}
        if o["rock solver"] == "band":
            values["Continuum/Surface stiffness"] = "banded"
        elif o["rock solver"] == "iterations":
            values["Continuum/Linear solver"] = "conjugate gradients"
        if o["damping"] == "rock":
            values["Continuum/Rayleigh stiffness"] = 1e-4
            if o["bedrock"] == "continuum":
                values["Continuum/Rayleigh mass"] = 0.5
        if o["bedding"] != "off":
            values.update({"Bedding planes/Names": "bedding_1", "Bedding planes/Strength": o["bedding"],
                           "Bedding planes/Normal stiffness": 1e10 * self.factor,
                           "Bedding planes/Shear stiffness": 4e9 * self.factor})
            if o["bedding"] == "Mohr-Coulomb":
                values.update({"Bedding planes/Friction angle": 45, "Bedding planes/Cohesion": 1e6 * self.factor,
                               "Bedding planes/Tensile strength": 5e5 * self.factor})
        return values

    def _motion(self):
        direction = 90.0 if self.options["motion"] == "vertical" else (0.0 if self.mirror > 0 else 180.0)
        return {"Motion/Type": "ricker", "Motion/Peak": 3.0, "Motion/Frequency": 6.0, "Motion/Angle": direction,
                "Motion/Meaning": "incident" if self.options["motion"] == "incident" else "outcrop"}


def nested(values):
    """Lines of a parameter file with one subsection per part of a path."""
    tree = {}
    for path, value in values.items():
        *parts, name = path.split("/")
        branch = tree
        for part in parts:
            branch = branch.setdefault(part, {})
        branch[name] = value

    def lines(branch, depth):
        for name, value in branch.items():
            if isinstance(value, dict):
                yield "%ssubsection %s\n" % ("  " * depth, name)
                yield from lines(value, depth + 1)
                yield "%send\n" % ("  " * depth)
            else:
                yield "%sset %s = %s\n" % ("  " * depth, name, short(value))

    return lines(tree, 0)


def short(value):
    return "%.12g" % value if isinstance(value, float) else str(value)
