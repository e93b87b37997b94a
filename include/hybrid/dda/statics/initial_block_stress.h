// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/model/model.h>
#include <hybrid/dda/model/state.h>
#include <hybrid/scene/mesh/initial_stress.h>

namespace hybrid::dda
{
  /// Which blocks have an initial stress, and how much of it.
  struct StressedPart
  {
    bool   bedrock = false; ///< the bedrock's blocks instead of the mass
    double factor  = 1.;    ///< [-]
  };


  /**
   * The stress that blocks and joints have before the static stage (Gravity/Initial stress).
   *
   * A block has the stress at its centroid. A joint's traction is the mean of both sides', linear
   * along it. Its two springs bear what does the work of that traction on edges that stay straight:
   * the traction a third of the length from each end. So a stress that is linear in each block and
   * in equilibrium leaves no force on any of the six unknowns of a block, and level ground does not
   * move. Joints have the elastic stretch of their tractions, from which their slip counts.
   *
   * A belt bears what the mass puts on it. Contacts without a bond begin without force, as ever.
   *
   * @param mesh_regions regions of the mesh's blocks, which come before the bedrock's in
   *   BlockProperties::region
   */
  void prescribe_block_stress(const scene::InitialStress &initial,
                              int                         mesh_regions,
                              const Model                &model,
                              DdaState                   &state,
                              const StressedPart         &part = {});
} // namespace hybrid::dda
