#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Faults of a section drawn by hand: hybrid --check refuses each in one sentence with coordinates and writes nothing.

    bad_geometry_test.py HYBRID SOURCE LIBGMSH WORK PART

PART faults: FAULTS has one scene per fault. PART millimetres_long: every scene of parameters/ is given in millimetres; it is refused,
or, where it is so small that a slope of that size exists, the program doubts the unit. PART millimetres: the first scene of each mesh.
"""
import ctypes
import pathlib
import re
import shutil
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from run_hybrid import Started, program_for_many  # noqa: E402 (needs the path above)

SANITIZED = b"__asan_init" in pathlib.Path(sys.argv[1]).read_bytes()  # a list grows too slowly there to need 2 GB in 30 s
ENDLESS = "has not come to an end of this file after 30 s" if SANITIZED else "needs more than 2 GB of memory before"
SECONDS = 60 if SANITIZED else 10  # processor time for one scene

MATERIAL = """
subsection Materials
  set Names = rock
  subsection rock
    set Density        = 2500
    set Young modulus  = 5e9
    set Friction angle = 30
  end
end
subsection Time
  set End time  = 1
  set Time step = 1e-3
end
subsection Gravity
  set Acceleration = 9.81
end
subsection Blocks
  set Material = rock
end
subsection Continuum
  set Materials = rock
end
"""
TABLES = """
subsection Model
  set Bedrock = rigid
  set Blocks  = loose
end
subsection Mesh
  set Polygons file = blocks.csv
  set Surface file  = surface.csv
end
""" + MATERIAL
MESH = """
subsection Model
  set Bedrock = continuum
  set Blocks  = bonded
end
subsection Mesh
  set File = section.msh
end
""" + MATERIAL
GEOMETRY = MESH.replace("section.msh", "section.geo")
CONTINUUM = GEOMETRY.replace("bonded", "none").replace("subsection Blocks\n  set Material = rock\nend\n", "")
RIGID_MESH = MESH.replace("Bedrock = continuum", "Bedrock = rigid").replace("bonded", "loose")
BLOCKS_ON_MESH = MESH.replace("bonded", "loose").replace("section.msh", "section.msh\n  set Polygons file = blocks.csv")
SHAKEN = """
subsection Motion
  set Type      = sine
  set Peak      = 1
  set Frequency = 2
end
"""

FLAT = "x,y\n-60,0\n60,0\n"


def table(*polygons, scale=1.):
    return "block,x,y\n" + "".join(f"{name},{x * scale:.10g},{y * scale:.10g}\n"
                                   for name, vertices in zip("abcdefgh", polygons) for x, y in vertices)


def square(x, y, size=10.):
    return [(x, y), (x + size, y), (x + size, y + size), (x, y + size)]


class Section:
    """A bedrock of columns x rows squares of 20 m on y = 0 and two triangles on the left half of its top, as .msh."""

    def __init__(self, columns=4, rows=2, size=20.):
        self.columns, self.rows = columns, rows
        self.nodes = [(size * column, size * row) for row in range(rows + 1) for column in range(columns + 1)]
        self.cells = [[self.at(c, r), self.at(c + 1, r), self.at(c + 1, r + 1), self.at(c, r + 1)]
                      for r in range(rows) for c in range(columns)]
        top = self.add(0., size * (rows + 0.5))
        self.blocks = [[self.at(0, rows), self.at(1, rows), top], [self.at(1, rows), self.at(2, rows), top]]
        self.lines = {"base": [[self.at(c, 0), self.at(c + 1, 0)] for c in range(columns)],
                      "left": [[self.at(0, r), self.at(0, r + 1)] for r in range(rows)],
                      "right": [[self.at(columns, r), self.at(columns, r + 1)] for r in range(rows)],
                      "sliding_surface": [[self.at(c, rows), self.at(c + 1, rows)] for c in range(2)],
                      "ground": [[self.at(c, rows), self.at(c + 1, rows)] for c in range(2, columns)]}

    def at(self, column, row):
        return row * (self.columns + 1) + column

    def add(self, x, y):
        self.nodes.append((x, y))
        return len(self.nodes) - 1

    def changed(self, change):
        change(self)
        return self

    def text(self, scale=1.):
        groups = [(1, name, self.lines[name]) for name in self.lines] + [(2, "bedrock", self.cells)]
        if self.blocks:
            groups.append((2, "sliding_mass", self.blocks))
        kind = {2: 1, 3: 2, 4: 3}  # gmsh's line, triangle, quadrangle
        elements = [f"{kind[len(nodes)]} 2 {tag} {tag} " + " ".join(str(node + 1) for node in nodes)
                    for tag, (_, _, members) in enumerate(groups, 1) for nodes in members]
        return "\n".join(["$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames", str(len(groups)),
                          *(f'{dim} {tag} "{name}"' for tag, (dim, name, _) in enumerate(groups, 1)),
                          "$EndPhysicalNames\n$Nodes", str(len(self.nodes)),
                          *(f"{i} {x * scale:.10g} {y * scale:.10g} 0" for i, (x, y) in enumerate(self.nodes, 1)),
                          "$EndNodes\n$Elements", str(len(elements)),
                          *(f"{i} {element}" for i, element in enumerate(elements, 1)), "$EndElements\n"])


def broken(change, **size):
    return {"section.msh": Section(**size).changed(change).text()}


def overlapping_triangle(section):
    section.blocks.append([section.at(1, 2), section.add(45., 40.), section.add(5., 49.)])


def flat_triangle(section):
    section.blocks.append([section.add(50., 60.), section.add(52., 60.), section.add(54., 60.)])


def flat_cell(section):
    section.nodes[section.at(2, 1)] = (20., 20.)


def block_in_rock(section):
    section.blocks.append([section.add(50., 30.), section.add(60., 50.), section.add(50., 50.)])


def gap_without_block(section):
    section.lines["sliding_surface"].append(section.lines["ground"].pop(0))


def gap_between_nodes(section):
    section.blocks[1] = [section.add(20., 40.), section.blocks[1][1], section.add(0., 50.)]
    section.blocks[0][2] = section.add(0., 50.)


def gap_of_base(section):
    section.lines["ground"].pop(0)


def pieces(section):
    section.cells = [cell for i, cell in enumerate(section.cells) if i % 4 != 2]
    section.lines["base"].pop(2)
    section.lines["ground"] = section.lines["ground"][1:]
    section.lines["left"] += [[section.at(3, r), section.at(3, r + 1)] for r in range(2)]
    section.lines["right"] += [[section.at(2, r), section.at(2, r + 1)] for r in range(2)]


def crossing_planes(section):
    section.lines["bedding_1"] = [[section.at(1, 1), section.at(2, 1)], [section.at(2, 1), section.at(3, 1)]]
    section.lines["bedding_2"] = [[section.at(2, 0), section.at(2, 1)], [section.at(2, 1), section.at(2, 2)]]


def level_plane(section):
    section.lines["bedding_1"] = [[section.at(c, 1), section.at(c + 1, 1)] for c in range(4)]


LAYERS = MESH.replace("Bedrock = continuum", "Bedrock = layers") + """
subsection Bedding planes
  set Names = bedding_1
end
"""

SQUARE_GEO = """
h = 20;
Point(1) = {0, 0, 0, h};
Point(2) = {80, 0, 0, h};
Point(3) = {80, 40, 0, h};
Point(4) = {0, 40, 0, h};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1:4};
Plane Surface(1) = {1};
Recombine Surface {1};
Mesh.RecombinationAlgorithm = 3;
Physical Surface("bedrock") = {1};
Physical Curve("base") = {1};
Physical Curve("right") = {2};
Physical Curve("ground") = {3};
Physical Curve("left") = {4};
"""
# Four quarters; the planes between them meet in the middle and go on.
QUADRANTS = """
Point(1) = {0, 0, 0, 10};
l[] = Extrude {40, 0, 0} { Point{1}; Layers{4}; };
r[] = Extrude {40, 0, 0} { Point{l[0]}; Layers{4}; };
a[] = Extrude {0, 20, 0} { Curve{l[1], r[1]}; Layers{2}; Recombine; };
b[] = Extrude {0, 20, 0} { Curve{a[0], a[4]}; Layers{2}; Recombine; };
Physical Surface("bedrock") = {a[1], a[5], b[1], b[5]};
Physical Curve("base") = {l[1], r[1]};
Physical Curve("ground") = {b[0], b[4]};
Physical Curve("left") = {a[3], b[3]};
Physical Curve("right") = {a[6], b[6]};
Physical Curve("bedding_1") = {a[0], a[4]};
Physical Curve("bedding_2") = {a[2], b[2]};
"""


def geometry(extra):
    return {"section.geo": SQUARE_GEO + extra}


# what is wrong: scene, files, parts of the sentence (an expression each)
FAULTS = {
    "overlapping polygons": (TABLES, {"blocks.csv": table(square(0, 0), square(9, 0)), "surface.csv": FLAT},
                             [r"The block at \(\S+, 5\) m overlaps the block at \(\S+, 5\) m", r"\(5, 5\) m", r"\(14, 5\) m"]),
    "overlapping triangles of a mesh": (MESH, broken(overlapping_triangle), [r"The block at \(\S+, \S+\) m overlaps the block at \("]),
    "clockwise polygon": (TABLES, {"blocks.csv": table(square(0, 0), square(20, 0)[::-1]), "surface.csv": FLAT},
                          [r"blocks.csv:6: block b runs clockwise", r"\(20, 10\) m"]),
    "polygon of zero area": (TABLES, {"blocks.csv": table([(0, 0), (10, 0), (5, 0)]), "surface.csv": FLAT},
                             [r"blocks.csv:3: block a", "zero area", r"\(10, 0\) m"]),
    "block of zero area in a mesh": (MESH, broken(flat_triangle), [r"The block at \(50, 60\) m is inverted or has no area"]),
    "cell of zero area": (MESH, broken(flat_cell), [r"The bedrock cell at \(20, 20\) m is inverted or has no area"]),
    "block inside the rock of a mesh": (MESH, broken(block_in_rock), ["inside the bedrock", r"The block at \(53.3333, 43.3333\) m"]),
    "polygon inside the rock": (BLOCKS_ON_MESH, {"section.msh": Section().text(), "blocks.csv": table(square(5, 35))},
                                [r"The block at \(10, 40\) m lies inside the bedrock, in its cell at \(10, 30\) m"]),
    "polygon below a rigid base": (TABLES, {"blocks.csv": table(square(0, -3)), "surface.csv": FLAT},
                                   [r"The block at \(5, 2\) m", r"\(\S+, -3\) m below the base"]),
    "gap: an edge of the sliding surface without a block": (MESH, broken(gap_without_block),
                                                            [r"gap above the sliding surface at \(50, 40\) m"]),
    "gap: nodes that are not shared": (MESH, broken(gap_between_nodes), [r"separate nodes on the sliding surface at \(20, 40\) m"]),
    "gap in a rigid base": (RIGID_MESH, broken(gap_of_base), [r"The base has a gap between \(40, 40\) m and \(60, 40\) m"]),
    "bedrock in two pieces": (MESH, broken(pieces), [r"not one piece: its cells at \(0, 0\) m and \(60, 0\) m"]),
    "bedding planes that cross": (MESH, broken(crossing_planes), [r"bedding_1 and bedding_2 cross at \(40, 20\) m"]),
    "layers that the plane does not divide": (LAYERS, broken(level_plane),
                                              [r"bedding_1 does not divide the bedrock at \(10.0+, 20.0+\) m", "one Plane Surface per layer"]),
    "planes that cross in a .geo": (CONTINUUM, {"section.geo": QUADRANTS}, [r"bedding_1 and bedding_2 cross at \(40, 20\) m"]),
    "planes within a surface that cross between their points": (CONTINUUM, geometry("""
Point(5) = {20, 20, 0, h};
Point(6) = {60, 20, 0, h};
Point(7) = {40, 5, 0, h};
Point(8) = {40, 35, 0, h};
Line(5) = {5, 6};
Line(6) = {7, 8};
Curve {5, 6} In Surface {1};
Physical Curve("bedding_1") = {5};
Physical Curve("bedding_2") = {6};
"""), [r"section.geo: bedding_1 \(curve 5\) and bedding_2 \(curve 6\) of surface 1 cross or touch at \(40, 20\) m without a common "
       r"point, .* meet at the end of one, in a Point that both have, and the surface must be divided along them"]),
    "plane within a surface that touches another": (CONTINUUM, geometry("""
Point(5) = {20, 20, 0, h};
Point(6) = {60, 20, 0, h};
Point(7) = {35, 5, 0, h};
Point(8) = {35, 20, 0, h};
Line(5) = {5, 6};
Line(6) = {7, 8};
Curve {5, 6} In Surface {1};
Physical Curve("bedding_1") = {5};
"""), [r"bedding_1 \(curve 5\) and curve 6 of surface 1 cross or touch at \(35, 20\) m"]),
    "plane within a surface that leaves it": (CONTINUUM, geometry("""
Point(5) = {-10, 20, 0, h};
Point(6) = {60, 20, 0, h};
Line(5) = {5, 6};
Curve {5} In Surface {1};
Physical Curve("bedding_1") = {5};
"""), [r"bedding_1 \(curve 5\) and left \(curve 4\) of surface 1 cross or touch at \(0, 20\) m"]),
    "planes within a surface that cross in a common point": (CONTINUUM, geometry("""
Point(5) = {20, 20, 0, h};
Point(6) = {60, 20, 0, h};
Point(7) = {40, 5, 0, h};
Point(8) = {40, 35, 0, h};
Point(9) = {40, 20, 0, h};
Line(5) = {5, 9};
Line(6) = {9, 6};
Line(7) = {7, 9};
Line(8) = {9, 8};
Curve {5:8} In Surface {1};
Physical Curve("bedding_1") = {5, 6};
Physical Curve("bedding_2") = {7, 8};
"""), [r"section.geo: gmsh crashes on this file: look at bedding_1 \(curve 5\) within surface 1, bedding_1 \(curve 6\) within .*: divide "
       r"a recombined surface along each curve"]),
    "algorithm with which gmsh crashes": (CONTINUUM, {"section.geo": """
Point(1) = {0, 0, 0, 5};
Point(2) = {120, 0, 0, 5};
Point(3) = {0, 30, 0, 5};
Point(4) = {120, 30, 0, 5};
Point(5) = {0, 40, 0, 5};
Point(6) = {40, 40, 0, 5};
Point(7) = {70, 60, 0, 5};
Point(8) = {120, 60, 0, 5};
Line(1) = {1, 2};
Line(2) = {2, 4};
Line(3) = {3, 4};
Line(4) = {1, 3};
Line(5) = {4, 8};
Line(6) = {5, 6};
Line(7) = {6, 7};
Line(8) = {7, 8};
Line(9) = {3, 5};
Curve Loop(1) = {1, 2, -3, -4};
Plane Surface(1) = {1};
Curve Loop(2) = {3, 5, -8, -7, -6, -9};
Plane Surface(2) = {2};
Transfinite Curve {1, 3} = 25;
Transfinite Curve {2, 4} = 7;
Transfinite Surface {1};
Recombine Surface {1, 2};
Mesh.Algorithm = 8;
Physical Surface("bedrock") = {1, 2};
Physical Curve("base") = {1};
"""}, [r"gmsh crashes on this file: it sets Mesh.Algorithm = 8, .* set 6"]),
    "plane within a recombined surface": (CONTINUUM, geometry("""
Point(5) = {20, 20, 0, h};
Point(6) = {60, 20, 0, h};
Line(5) = {5, 6};
Curve {5} In Surface {1};
Physical Curve("bedding_1") = {5};
"""), [r"The line bedding_1 at \(30, 20\) m must run along cell edges inside of the bedrock; gmsh keeps no line within a recombined "
       r"surface, so divide the surface along it"]),
    "point of a .geo far off the plane": (CONTINUUM, {"section.geo": SQUARE_GEO.replace("{80, 40, 0, h}", "{80, 40, -1e308, h}")},
                                          [r"section.geo: the point at \(80, 40, -1e\+308\) m is outside the plane z = 0"]),
    "list without end in a .geo": (CONTINUUM, geometry("L[] = {1:1e18};\n"),
                                   [r"section.geo: gmsh " + ENDLESS, r"\{1:1e9\}"]),
    "list that falls without end": (CONTINUUM, geometry("L[] = {1:-1e308};\n"), [r"gmsh " + ENDLESS]),
    "curve of a thousand million nodes": (CONTINUUM, geometry("Transfinite Curve {1} = 1e9;\n"),
                                          [r"gmsh needs more than 2 GB of memory"]),
    "mesh in millimetres": (MESH, {"section.msh": Section().text(1e3)},
                            [r"from \(0, 0\) to \(80000, 50000\) m is 80 km large", r"if they are millimetres, .* \(80 m\)"]),
    "mesh in kilometres": (MESH, {"section.msh": Section().text(1e-3)},
                           [r"from \(0, 0\) to \(0.08, 0.05\) m is 0.08 m large", r"if they are kilometres, .* \(80 m\)"]),
    "tables in millimetres": (TABLES, {"blocks.csv": table(square(0, 0), scale=1e3), "surface.csv": "x,y\n-60000,0\n60000,0\n"},
                              [r"to \(60000, 10000\) m is 120 km large", r"if they are millimetres, .* \(120 m\)"]),
    "tables in kilometres": (TABLES + SHAKEN, {"blocks.csv": table(square(0, 0), scale=1e-3), "surface.csv": "x,y\n-.06,0\n.06,0\n"},
                             [r"is 0.12 m large", r"if they are kilometres, .* \(120 m\)"]),
}

complaints = []


def check(program, scene):
    """Exit code, standard output and error of --check."""
    begin = program.processor_time()
    before = {path: path.stat().st_mtime_ns for path in scene.parent.rglob("*")}
    code, output, errors = program.ask(["--check", scene.name], scene.parent)
    if {path: path.stat().st_mtime_ns for path in scene.parent.rglob("*")} != before:
        complaints.append(f"{scene.parent.name}: --check wrote something")
    taken = program.processor_time() - begin
    if taken > SECONDS:
        complaints.append(f"{scene.parent.name}: {taken:.0f} s")
    return code, output, errors


def fill(work, name, files):
    folder = work / re.sub(r"\W+", "_", name)
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    for file, text in files.items():
        (folder / file).write_text(text)
    return folder / "scene.prm"


def try_fault(program, work, name, scene, files, parts):
    code, output, errors = check(program, fill(work, name, {"scene.prm": scene, **files}))
    lines = errors.splitlines()
    print(f"{name}:\n    {errors.strip()}")
    if code != 2 or len(lines) != 1 or not lines[0].startswith("error: "):
        complaints.append(f"{name}: exit code {code}, {errors!r}, {output[-300:]!r}")
    for part in parts:
        if not re.search(part, errors):
            complaints.append(f"{name}: '{part}' is not in {errors!r}")


class Gmsh:
    """gmsh's library, to write meshes in other units."""

    def __init__(self, library):
        self.library = ctypes.CDLL(library)
        self.call("Initialize", 0, None, 0)
        self.call("OptionSetNumber", b"General.Terminal", ctypes.c_double(0))
        self.call("OptionSetNumber", b"Mesh.MshFileVersion", ctypes.c_double(2.2))

    def call(self, name, *arguments):
        error = ctypes.c_int()
        getattr(self.library, "gmsh" + name)(*arguments, ctypes.byref(error))
        if error.value != 0:
            raise RuntimeError(f"gmsh{name}{arguments}: error {error.value}")

    def mesh(self, geometry, numbers, scale, target):
        self.call("Clear")
        self.call("OnelabClear", b"")
        for name, value in numbers:
            self.call("OnelabSetNumber", name.encode(), (ctypes.c_double * 1)(value), ctypes.c_size_t(1))
        self.call("Open", str(geometry).encode())
        self.call("ModelMeshGenerate", 2)
        self.call("OptionSetNumber", b"Mesh.ScalingFactor", ctypes.c_double(scale))
        self.call("Write", str(target).encode())


def scale_table(path, scale, target):
    target.write_text(re.sub(r"(?m)^((?:\w+,)??)(-?[\d.]+),(-?[\d.]+)\s*$",
                             lambda m: f"{m[1]}{float(m[2]) * scale:.12g},{float(m[3]) * scale:.12g}", path.read_text()))


def scale_scene(gmsh, scene, scale, work):
    """The scene with its mesh, tables and monitors multiplied."""
    text = scene.read_text()
    target = fill(work, scene.stem + "_scaled", {})
    mesh = re.search(r"set File *= *(\S+\.geo)", text)
    numbers = re.search(r"set Numbers *= *([^#\n]*)", text)
    if mesh:
        pairs = [pair.split("=") for pair in numbers[1].split(";")] if numbers else []
        gmsh.mesh((scene.parent / mesh[1]).resolve(), [(name.strip(), float(value)) for name, value in pairs], scale,
                  target.parent / "section.msh")
        text = text.replace(mesh[0], "set File = section.msh")
        text = text.replace(numbers[0], "") if numbers else text
    for kind in ("Polygons file", "Surface file"):
        table_ = re.search(rf"set {kind} *= *(\S+)", text)
        if table_:
            scale_table(scene.parent / table_[1], scale, target.parent / table_[1])
    for path in scene.parent.iterdir():  # records and targets
        if path.suffix != ".prm" and not (target.parent / path.name).exists():
            shutil.copy(path, target.parent)

    def scaled_line(line):
        return re.sub(r"(?<=[ ,])-?\d+\.?\d*(?=[ ,;]|$)", lambda m: f"{float(m[0]) * scale:.12g}", line[0])

    text = re.sub(r"(?m)^ *set (?:Points|Lines) *=.*$", scaled_line, text)
    text = re.sub(r"(?m)^ *set (?:Tractions|Initial velocities) *=.*$",  # each a box and more
                  lambda line: re.sub(r": *[^;,]+,[^;,]+,[^;,]+,[^;,]+,",
                                      lambda m: scaled_line([m[0]]), line[0]), text)
    target.write_text(text.replace("../../", str(scene.parent.parent.parent) + "/"))
    return target


def try_scaled(server, gmsh, scene, work):
    code, output, errors = check(server, scale_scene(gmsh, scene, 1e3, work))
    found = [line for line in (errors + output).splitlines() if "if they are millimetres" in line]
    print(f"{scene.parent.name}/{scene.stem} in millimetres:\n    {(found or [errors.strip()])[0]}")
    if not found:
        complaints.append(f"{scene.stem} in millimetres: exit code {code}, {errors!r}")
    elif code not in (0, 2):
        complaints.append(f"{scene.stem} in millimetres: exit code {code}")


def main():
    hybrid, source, library, work = (pathlib.Path(argument).resolve() for argument in sys.argv[1:5])
    server, started = program_for_many(hybrid), Started(hybrid)
    if sys.argv[5] == "faults":
        for name, (scene, files, parts) in FAULTS.items():  # what ends gmsh ends the program, and gmsh's parser keeps what a fault has left
            try_fault(started if "section.geo" in files else server, work, name, scene, files, parts)
    else:
        gmsh = Gmsh(library)
        large = ("lamb", "lamb_80x60", "canyon_fine")  # a hundred thousand unknowns
        plausible = ("tiny_block", "notched_beam")  # slopes of a thousand times their size exist
        seen = set()
        for scene in sorted(source.glob("parameters/*/*.prm")):
            text = scene.read_text()
            includes = re.search(r"(?m)^ *include ", text)  # it has the geometry of another scene
            drawn = scene.parent, *re.findall(r"set (?:File|Polygons file) *= *(\S+\.(?:geo|csv))", text)
            is_new = drawn not in seen or sys.argv[5] == "millimetres_long"
            if scene.parent.name != "benchmarks" and scene.stem not in large + plausible and not includes and is_new:
                try_scaled(server, gmsh, scene, work)
                seen.add(drawn)
    server.end()
    if server.said_elsewhere():
        complaints.append(f"something else is said: {server.said_elsewhere()[:500]!r}")
    for complaint in complaints:
        print("FAILED:", complaint)
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
