// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/joint/bond_law.h>
#include <hybrid/dda/model/model.h>
#include <hybrid/scene/mesh/section_mesh.h>
#include <hybrid/scene/parameters/scene_parameters.h>

namespace hybrid::dda
{
  /**
   * Choose the laws of all contacts (Model::contacts) of a model whose joints are there.
   *
   * - A contact that was never bonded has friction only: the smaller one of both materials
   * (residual where given). A bedrock whose material has no `Friction angle`, and a foundation
   * without material, leave it to the block.
   * - Edges on a line joint_<suffix> that has a material have the residual friction of that.
   * - A surface that a belt bonded has the belt's residual friction for everything that touches it.
   * - Residual cohesion acts between blocks that a joint bonded, and on the area that a belt bonds
   *   (BondedArea).
   *
   * @param materials of each block, mass and bedrock.
   */
  void set_contact_laws(const scene::SectionMesh     &mesh,
                        const scene::SceneParameters &scene,
                        const BondLaws               &laws,
                        const std::vector<Material>  &materials,
                        Model                        &model);
} // namespace hybrid::dda
