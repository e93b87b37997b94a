// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/joint/bond_law.h>
#include <hybrid/dda/model/model.h>
#include <hybrid/scene/mesh/section_mesh.h>
#include <hybrid/scene/parameters/scene_parameters.h>

namespace hybrid::dda
{
  /**
   * Blocks, joints and contact laws of a scene.
   *
   * Edges shared by two blocks become artificial joints (unless the scene's
   * blocks are loose), edges on the line "sliding_surface" are bonded by the
   * belt to the foundation, one joint per foundation segment.
   *
   * @param foundation_nodes contact surface of the bedrock, left to right [m]; empty: nothing
   * below.
   * @throws InputError for materials that cannot be used.
   */
  Model build_model(const scene::SectionMesh     &mesh,
                    const scene::SceneParameters &scene,
                    const std::vector<Vec2>      &foundation_nodes,
                    const BondLaws               &laws = choose_bonds());
} // namespace hybrid::dda
