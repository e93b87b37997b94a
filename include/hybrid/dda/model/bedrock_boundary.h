// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/block/boundary_edge.h>
#include <hybrid/dda/geometry/geometry.h>
#include <hybrid/dda/model/joint_builder.h>
#include <hybrid/scene/mesh/section_mesh.h>
#include <hybrid/scene/parameters/scene_parameters.h>

#include <vector>

namespace hybrid::dda
{
  /**
   * Edges of the bedrock's blocks on the lines "left" and "right", and on "base"
   * if triangles stand on a compliant one. In the order of the blocks.
   */
  std::vector<BoundaryEdge> boundary_edges(const scene::SectionMesh     &mesh,
                                           const scene::SceneParameters &scene,
                                           const Geometry               &geometry,
                                           const JointedBlocks          &blocks);
} // namespace hybrid::dda
