// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/model/model.h>
#include <hybrid/dda/model/state.h>
#include <hybrid/output/summary.h>

namespace hybrid::output
{
  /// Count the joints that have failed, by kind and stage, into @p summary, with the times of the
  /// first one in the dynamic stage, and of the first one that lost strength by failing.
  void count_failed_joints(const dda::Model &model, const dda::DdaState &state, Summary &summary);
} // namespace hybrid::output
