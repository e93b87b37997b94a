# SPDX-License-Identifier: GPL-3.0-or-later
"""section.geo: the section for gmsh, with its sizes as numbers that a scene can set."""

import numpy as np

from .section import GROWTH

HEAD = """// %s: section made by hybrid new, x along the profile, y up [m].
// The bedrock is cut into %d surfaces along the bedding planes and unnamed continuations of them to the sides.

DefineConstant[ h = {%.10g, Min %.3g, Max %.3g, Name "Resolution/h"} ]; // %s [m]
%s
Mesh.Algorithm                              = 6; // frontal Delaunay
Mesh.RecombinationAlgorithm                 = 2; // simple full-quad: no triangle is left over; blossom (3) crashes on some sections
Mesh.CharacteristicLengthFromPoints         = 0;
Mesh.CharacteristicLengthExtendFromBoundary = 0;
"""
FAR = 'DefineConstant[ far = {%.10g, Min %.3g, Max %.3g, Name "Resolution/far"} ]; // edge length far from there: ten nodes per wavelength [m]\n'
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
    more = FAR % (far, far / 20, 20 * far) if has_mass else ""
    more += PLANES % (section.plane_size, section.plane_size / 20, 20 * section.plane_size) if has_planes else ""
    text = HEAD % (title, len(section.bedrock), h, h / 20, 20 * h, "edge length in the mass and at the sliding surface" if has_mass else "edge length", more)
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


def curve_sizes(section, curve):
    """An even number of elements on each line: gmsh halves them to recombine, and drops some where lines are short (4.8)."""
    middles = [0.5 * (section.mesh.points[a] + section.mesh.points[b]) for a, b in curve]
    apart = [section.distances(*middle) for middle in middles]
    text = "\n// ---- lengths of the lines, their distances from the sliding surface and from the planes [m]\n"
    text += "length[] = {%s};\n" % numbers("%.6g" % section.mesh.length(edge) for edge in curve)
    sizes = "  size = h;\n"
    if section.slip is not None:
        text += "from_slip[] = {%s};\n" % numbers("%.4g" % d for d, _ in apart)
        sizes = "  size = h + %g * from_slip[i];\n  If (size > far)\n    size = far;\n  EndIf\n" % GROWTH
    if section.planes:
        text += "from_planes[] = {%s};\n" % numbers("%.4g" % d for _, d in apart)
        sizes += "  If (size > near_planes + %g * from_planes[i])\n    size = near_planes + %g * from_planes[i];\n  EndIf\n" % (GROWTH, GROWTH)
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
    """h at the sliding surface, growing to far; not larger than near_planes along the planes."""
    def threshold(first, label, smallest):
        lines = [i for edge, i in curve.items() if section.mesh.edges[edge].startswith(label)]
        return """Field[%d] = Distance;
Field[%d].CurvesList = {%s};
Field[%d].NumPointsPerCurve = 100;
Field[%d] = Threshold;
Field[%d].InField = %d;
Field[%d].SizeMin = %s;
Field[%d].SizeMax = %s;
Field[%d].DistMin = %s;
Field[%d].DistMax = %s + (%s - %s) / %g;
""" % (first, first, numbers(lines), first, first + 1, first + 1, first, first + 1, smallest, first + 1, far, first + 1, smallest, first + 1,
            smallest, far, smallest, GROWTH)

    has_mass = section.slip is not None
    far = "Max(far, h)" if has_mass else "h"
    text, fields = "\n// ---- sizes\n", []
    if has_mass:
        text += threshold(1, "sliding_surface", "h") + body_field(section, curve)
        fields += [2, 6]
    if section.planes:
        text += threshold(3, "bedding_", "Min(near_planes, %s)" % far)
        fields.append(4)
    if not fields:
        return text + "Mesh.CharacteristicLengthMin = h;\nMesh.CharacteristicLengthMax = h;\n"
    return text + "Field[7] = Min;\nField[7].FieldsList = {%s};\nBackground Field = 7;\n" % numbers(fields)


def body_field(section, curve):
    """The mass has h all over."""
    first = len(section.bedrock) + 1
    top = [i for edge, i in curve.items() if section.mesh.edges[edge] in ("mass_surface", "sliding_surface")]
    return """Field[5] = MathEval;
Field[5].F = Sprintf("%%.16g", h);
Field[6] = Restrict;
Field[6].InField = 5;
Field[6].SurfacesList = {%s};
Field[6].CurvesList = {%s};
""" % (numbers(range(first, first + len(section.body_faces))), numbers(top))
