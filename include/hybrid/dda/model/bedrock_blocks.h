// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/mesh/section_mesh.h>
#include <hybrid/scene/parameters/scene_parameters.h>

#include <vector>

namespace hybrid::dda
{
  /// The bedrock as blocks and what they stand on.
  struct BedrockBlocks
  {
    std::vector<std::vector<int>> outlines; ///< nodes of the mesh, counter-clockwise
    std::vector<int>              region;   ///< per block: index into bedrock_region_names
    std::vector<int>
      foundation; ///< nodes of a foundation that moves as prescribed, left to right; may be empty
  };


  /**
   * Cut the bedrock of a mesh into blocks, as the scene says:
   *   - layers: every surface of the geometry is one block whose outline is the
   *     boundary loop of its cells; the lowest one, along the line "base", is
   *     the foundation, of which only the upper boundary is needed;
   *   - triangles: every cell is cut along its shorter diagonal; between equal
   *     ones the diagonal is taken whose ends meet more diagonals already, so
   *     that structured meshes get the pattern of alternating diagonals, which
   *     prefers no direction. The foundation is the line "base" unless it is compliant.
   * A scene without such bedrock has no bedrock blocks.
   *
   * @throws InputError for a layer that is not one simple polygon, or a plane of the scene
   * that does not divide the bedrock into layers.
   */
  BedrockBlocks cut_bedrock(const scene::SectionMesh &mesh, const scene::SceneParameters &scene);
} // namespace hybrid::dda
