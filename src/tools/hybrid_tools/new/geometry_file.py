# SPDX-License-Identifier: GPL-3.0-or-later
"""section.geo: the section for gmsh, with its sizes as numbers that a scene can set."""

import numpy as np

from .section import GROWTH

RANGE = 25  # sizes may be as many times smaller and larger; gmsh makes up 5 or 20 where a file has no range
HEAD = """// %s: section made by hybrid new, x along the profile, y up [m].
// The bedrock is cut into %d surfaces along the bedding planes and unnamed continuations of them to the sides.

DefineConstant[ h = {%.10g, Min %.3g, Max %.3g, Name "Resolution/h"} ]; // %s [m]
%s
Mesh.Algorithm                              = 6; // frontal Delaunay
Mesh.RecombinationAlgorithm                 = 2; // simple full-quad: no triangle is left over; blossom (3) crashes on some sections
Mesh.CharacteristicLengthFromPoints         = 0;
Mesh.CharacteristicLengthExtendFromBoundary = 0;
"""
FAR = 'DefineConstant[ far = {%s, Min %.3g, Max %.3g, Name "Resolution/far"} ]; // edge length far from there: ten nodes per wavelength [m]\n'
GROUND = 'DefineConstant[ near_ground = {%.10g, Min %.3g, Max %.3g, Name "Resolution/ground"} ]; // of the bedrock at the slope [m]\n'
PLANES = 'DefineConstant[ near_planes = {%.10g, Min %.3g, Max %.3g, Name "Resolution/planes"} ]; // along the bedding planes [m]\n'
GROUPS = ("base", "left", "right", "ground", "sliding_surface", "mass_surface")


def numbers(values):
    """Comma-separated, in lines of some 130 characters."""
    text, line = [], ""
    for value in values:
        if len(line) > 120:
            text.append(line)
            line = ""
        line += ("" if not line else " ") + str(value) + ","
    return "\n  ".join(text + [line]).rstrip(",")


def geometry_text(section, title):
    mesh, h, far = section.mesh, section.h, section.far
    used = sorted({k for edge in mesh.edges for k in edge})
    point = {k: i for i, k in enumerate(used, 1)}
    curve = {edge: i for i, edge in enumerate(sorted(mesh.edges, key=lambda e: (mesh.edges[e], mesh.points[e[0]][0], mesh.points[e[0]][1])), 1)}
    has_mass, has_planes = section.slip is not None, bool(section.planes)
    def constant(text, value, words=None):
        return text % (words or value, value / RANGE, RANGE * value)

    more = constant(FAR, far, "%.10g" % far if has_mass else "%.6g * h" % (far / h)) if is_graded(section) else ""
    more += constant(PLANES, section.plane_size) if has_planes else ""
    more += constant(GROUND, section.ground_size) if has_mass and section.slope_line is not None else ""
    where = " in the mass and at the sliding surface" if has_mass else " at the slope; far grows with it" if is_graded(section) else ""
    text = HEAD % (title, len(section.bedrock), h, h / RANGE, RANGE * h, "edge length" + where, more)
    text += "\n".join(["\n// ---- points"] + ["Point(%d) = {%.10g, %.10g, 0};" % (point[k], *mesh.points[k]) for k in used])
    text += "\n\n// ---- lines\n" + "\n".join("Line(%d) = {%d, %d};" % (i, point[a], point[b]) for (a, b), i in curve.items())
    text += "\n\n// ---- surfaces\n"
    number = 0
    for face in section.bedrock + section.body_faces:
        number += 1
        loop = [curve[(a, b)] if a < b else -curve[(b, a)] for a, b in zip(face, face[1:] + face[:1])]
        text += "Curve Loop(%d) = {%s};\nPlane Surface(%d) = {%d};\n" % (number, numbers(loop), number, number)
    bedrock = range(1, len(section.bedrock) + 1)
    text += curve_sizes(section, curve)
    text += size_fields(section, curve)
    text += "\nRecombine Surface {%s};\n\n" % numbers(bedrock)
    text += 'Physical Surface("bedrock") = {%s};\n' % numbers(bedrock)
    if has_mass:
        text += 'Physical Surface("sliding_mass") = {%s};\n' % numbers(range(len(section.bedrock) + 1, number + 1))
    planes = sorted({"bedding_%d" % n for _, n, _ in section.planes}, key=lambda name: int(name[8:]))
    for group in list(GROUPS) + planes:
        lines = [i for edge, i in curve.items() if mesh.edges[edge] == group]
        if lines:
            text += 'Physical Curve("%s") = {%s};\n' % (group, numbers(lines))
    return text


def is_graded(section):
    """Whether elements grow away from anything but the planes."""
    return section.slip is not None or section.slope_line is not None


def refined(section):
    """[(name of the size, lines of the mesh, their number in distances(), what they are)]: where elements are smaller than far away."""
    def labelled(begin):
        return [edge for edge, label in section.mesh.edges.items() if label.startswith(begin)]

    found = []
    if section.slip is not None:
        found.append(("h", labelled("sliding_surface"), 0, "slip"))
    if section.planes:
        found.append(("near_planes", labelled("bedding_"), 1, "planes"))
    if section.slope_line is not None:
        slope = [edge for edge, label in section.mesh.edges.items() if label in ("ground", "mass_surface")
                 and section.distances(*middle_of(section, edge))[2] < 0.5 * section.mesh.length(edge)]
        found.append(("h" if section.slip is None else "near_ground", slope, 2, "slope"))
    return found


def middle_of(section, edge):
    return 0.5 * (section.mesh.points[edge[0]] + section.mesh.points[edge[1]])


def curve_sizes(section, curve):
    """An even number of elements on each line: gmsh halves them to recombine, and drops some where lines are short (4.8)."""
    apart = [section.distances(*middle_of(section, edge)) for edge in curve]
    text = "\n// ---- lengths of the lines, their distances from lines with small elements [m]\n"
    text += "length[] = {%s};\n" % numbers("%.6g" % section.mesh.length(edge) for edge in curve)
    sizes = "  size = %s;\n" % ("far" if is_graded(section) else "h")
    for name, _, k, what in refined(section):
        text += "from_%s[] = {%s};\n" % (what, numbers("%.4g" % distances[k] for distances in apart))
        smaller = "%s + %g * from_%s[i]" % (name, GROWTH, what)
        sizes += "  If (size > %s)\n    size = %s;\n  EndIf\n" % (smaller, smaller)
    return text + """// an even number of elements on each: gmsh halves them before it recombines
For i In {0:#length[] - 1}
%s  n = 2 * Ceil(length[i] / (2 * size) - 0.3);
  If (n < 2)
    n = 2;
  EndIf
  Transfinite Curve {i + 1} = n + 1;
EndFor
""" % sizes


def size_fields(section, curve):
    """h at the sliding surface, sizes of their own along planes and slope, growing to far."""
    far = "Max(far, h)" if is_graded(section) else "h"

    def threshold(first, lines, smallest):
        return """Field[%d] = Distance;
Field[%d].CurvesList = {%s};
Field[%d].NumPointsPerCurve = 100;
Field[%d] = Threshold;
Field[%d].InField = %d;
Field[%d].SizeMin = %s;
Field[%d].SizeMax = %s;
Field[%d].DistMin = %s;
Field[%d].DistMax = %s + (%s - %s) / %g;
""" % (first, first, numbers(curve[edge] for edge in lines), first, first + 1, first + 1, first, first + 1, smallest, first + 1, far,
            first + 1, smallest, first + 1, smallest, far, smallest, GROWTH)

    text, fields = "\n// ---- sizes\n", []
    if section.slip is not None:
        text += body_field(section, curve)
        fields.append(2)
    for k, (name, lines, _, _) in enumerate(refined(section)):
        text += threshold(3 + 2 * k, lines, name if name == "h" else "Min(%s, %s)" % (name, far))
        fields.append(4 + 2 * k)
    if not fields:
        return text + "Mesh.CharacteristicLengthMin = h;\nMesh.CharacteristicLengthMax = h;\n"
    return text + "Field[20] = Min;\nField[20].FieldsList = {%s};\nBackground Field = 20;\n" % numbers(fields)


def body_field(section, curve):
    """The mass has h all over."""
    first = len(section.bedrock) + 1
    top = [i for edge, i in curve.items() if section.mesh.edges[edge] in ("mass_surface", "sliding_surface")]
    return """Field[1] = MathEval;
Field[1].F = Sprintf("%%.16g", h);
Field[2] = Restrict;
Field[2].InField = 1;
Field[2].SurfacesList = {%s};
Field[2].CurvesList = {%s};
""" % (numbers(range(first, first + len(section.body_faces))), numbers(top))
