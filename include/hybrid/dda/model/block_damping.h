// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/model/model.h>
#include <hybrid/dda/model/state.h>

#include <vector>

namespace hybrid::dda
{
  /**
   * beta_K [s] that damps the shear vibration of a free block critically, or more where it is
   * longer than wide: 2/w, with w^2 = G A over the inertia of a shear strain, (sxx + syy)/4 [kg
   * m2/m].
   */
  double critical_damping_time(const BlockProperties &block);

  /**
   * beta_K of each block in a step that begins at @p state [s]: BlockProperties::damping_time, and
   * at least loose_damping_time while no joint holds the block (it never had one, or all have
   * failed).
   */
  void block_damping_times(const Model &model, const DdaState &state, std::vector<double> &times);
} // namespace hybrid::dda
