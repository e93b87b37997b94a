// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/mesh/section_mesh.h>

#include <string>

namespace hybrid::scene
{
  /**
   * Add blocks from a CSV file with the columns block, x [m], y [m] and optionally region
   * ("sliding_mass", the default, or "sliding_mass_<suffix>") and joint ("joint_<suffix>": the line
   * that the edge from this vertex to the next is on), replacing blocks and joints that
   * @p mesh has. Rows with the same block name follow each other and list one simple polygon,
   * in either direction, without repeating the first vertex; the block comes out
   * counter-clockwise. Vertices that are within 1e-6 of the
   * shortest edge of each other become one node.
   * A first row "block,x,y..." is a header; # starts a comment.
   *
   * @throws InputError with file and line for fewer than three vertices, a repeated vertex,
   * crossing edges, zero area, an unknown region or joint.
   */
  void read_polygons(const std::string &file, SectionMesh &mesh);

  /**
   * Set lines["sliding_surface"] of @p mesh from a CSV file with the columns x [m], y [m]:
   * the polyline of a rigid base, left to right (x never decreases), ground above it.
   *
   * @throws InputError with file and line.
   */
  void read_surface(const std::string &file, SectionMesh &mesh);
} // namespace hybrid::scene
