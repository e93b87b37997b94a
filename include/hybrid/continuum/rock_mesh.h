// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/mesh/section_mesh.h>

#include <array>
#include <string>
#include <vector>

namespace hybrid::continuum
{
  /// A face of one rock cell; seen along a -> b the rock lies to the left, the outward normal to
  /// the right.
  struct RockFace
  {
    int cell; ///< index into RockMesh::cells
    int a;    ///< first node, RockMesh numbering
    int b;    ///< second node
  };


  /// Two coincident faces on the two sides of a bedding plane; both run in the same direction.
  struct FacePair
  {
    RockFace first;     ///< rock to the left of a -> b
    RockFace second;    ///< rock to the right of a -> b
    int      plane = 0; ///< which of the planes' names
  };


  /**
   * The bedrock alone, cut open along bedding planes.
   *
   * Around each node of a plane the cells that can be reached from each other
   * without crossing a plane form one side; every side gets a node of its own.
   * So a plane's end inside the rock keeps one node, and planes may cross or
   * end on each other.
   */
  struct RockMesh
  {
    std::vector<Vec2>               nodes;  ///< [m]
    std::vector<int>                origin; ///< per node: its index in the section mesh
    std::vector<std::array<int, 4>> cells; ///< counter-clockwise, same order as in the section mesh
    std::vector<FacePair>           joints; ///< faces along the split planes
  };


  /// @param planes names of the lines to cut open; other lines stay welded.
  /// @throws InputError for an unknown line, one without an edge inside the rock, or an inverted
  /// cell.
  RockMesh split_bedding_planes(const scene::SectionMesh       &mesh,
                                const std::vector<std::string> &planes);

  /// Faces of the rock's outer boundary along the named line; edges that do not bound the rock are
  /// left out.
  std::vector<RockFace> boundary_faces(const RockMesh                              &rock,
                                       const std::vector<scene::SectionMesh::Edge> &line);

  /// Sort faces of the top boundary into one chain from left to right (so b -> a of each face);
  /// where a bedding plane crops out the chain steps from one of its nodes to the other.
  /// @throws InputError if they are not one connected chain.
  std::vector<RockFace> surface_chain(const RockMesh &rock, const std::vector<RockFace> &faces);
} // namespace hybrid::continuum
