// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/continuum/cell_materials.h>
#include <hybrid/continuum/element_space.h>
#include <hybrid/continuum/joint_stiffness.h>
#include <hybrid/continuum/node_matrices.h>

#include <vector>

namespace hybrid::continuum
{
  /**
   * Consistent mass and plane-strain stiffness, with the joints' energy
   * int [[u]]^T (k_n n n^T + k_s t t^T) [[u]] ds. Cells are shared out among the ranks
   * (Trilinos sums up what they add to each other's rows), then every rank
   * receives the whole matrices, since each factors them on its own.
   *
   * @param material per cell.
   * @param corrected_step see Newmark; 0: no correction of the inertia.
   */
  NodeMatrices assemble_elastic(const ElementSpace   &space,
                                const RockMesh       &rock,
                                const CellMaterials  &material,
                                const JointStiffness &joints,
                                double                corrected_step = 0.);
} // namespace hybrid::continuum
