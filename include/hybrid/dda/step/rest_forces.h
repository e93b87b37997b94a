// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/springs/springs.h>

namespace hybrid::dda
{
  /// The trial in which nothing moves.
  Trial trial_at_rest(const DdaState &state);

  /// Springs of @p state and what they carry while nothing moves.
  Springs springs_at_rest(const Model &model, const DdaState &state);


  /// What springs do to blocks and foundation nodes while nothing moves, bonds and contacts apart
  /// [N/m].
  struct RestForces
  {
    Eigen::VectorXd bonds, contacts; ///< six values per block, then two per foundation node

    RestForces(const Model &model, const DdaState &state);
  };
} // namespace hybrid::dda
