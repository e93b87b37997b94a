// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/model/model.h>

namespace hybrid::dda
{
  /// What solving the steps of a model takes beside the model itself [B]: springs, matrix, and a
  /// sparse LU factor whose fill comes from a symbolic analysis of the joints' graph.
  double estimated_memory(const Model &model);
} // namespace hybrid::dda
