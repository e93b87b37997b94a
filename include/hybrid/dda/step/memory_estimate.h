// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/model/model.h>

namespace hybrid::dda
{
  /// What solving the steps of a model takes beside the model and its state [B].
  struct SolverMemory
  {
    double bonded  = 0.; ///< springs, matrix, a sparse factor of it while that is symmetric
    double sliding = 0.; ///< more once joints or contacts slide with friction or soften: then it is
                         ///< not, and parts of it that stay the same are kept
  };

  /// Counted from the sizes of what is stored. The factor's fill comes from a symbolic analysis of
  /// the graph of joints and of loose blocks that touch; contacts that form later are not in it.
  /// @param moving_foundation the base is a bedrock of finite elements
  SolverMemory estimated_memory(const Model &model, bool moving_foundation = false);
} // namespace hybrid::dda
