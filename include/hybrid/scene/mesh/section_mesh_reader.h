// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/mesh/section_mesh.h>
#include <hybrid/scene/parameters/scene_parameters.h>

#include <functional>

namespace hybrid::scene
{
  /**
   * Read the section that a scene names: a gmsh geometry (.geo, meshed here with the
   * scene's numbers) or mesh (.msh), and/or blocks and a base polyline from CSV files,
   * which replace those of the mesh. A scene without any file gives an empty section.
   *
   * Physical groups carry the meaning:
   *   surfaces  bedrock, bedrock_<suffix>            quadrilaterals only
   *             sliding_mass, sliding_mass_<suffix>  every triangle or quadrilateral is a block
   *   curves    sliding_surface, bedding_<n>, joint_<suffix>, base, left, right, ground,
   *             mass_surface
   *
   * Cells and blocks come out counter-clockwise. The edges of every line are chained
   * (but for joints, which may branch): each connected path is consecutive and runs from its end
   * with the smaller x (at equal x, y), so level lines run left to right and vertical ones upwards.
   * Nodes that nothing uses are dropped; the numbering depends on the file and the numbers only.
   *
   * @param before_meshing told, before the surfaces of a geometry are meshed, which number of cells
   * they get at most.
   *
   * @throws InputError for an unreadable file, an unknown number or physical group, a
   * bedrock triangle, an element in two groups, a branching line, a mesh outside z = 0.
   */
  SectionMesh read_section_mesh(const MeshParameters              &parameters,
                                const std::function<void(double)> &before_meshing = {});
} // namespace hybrid::scene
