// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/continuum/cell_materials.h>
#include <hybrid/continuum/joint_stiffness.h>
#include <hybrid/continuum/rock_mesh.h>
#include <hybrid/continuum/shared_rock.h>

#include <vector>

namespace hybrid::continuum
{
  /// What the static stage is solved on without a matrix.
  struct RestrainedModel
  {
    const SharedRock        &shared;
    const RockMesh          &rock;
    const ElementNodes      &nodes;
    const CellMaterials     &material;  ///< per cell
    const JointStiffness    &joints;    ///< of bedding planes
    const std::vector<char> &supported; ///< per unknown (2 node + component): does not move
  };
} // namespace hybrid::continuum
