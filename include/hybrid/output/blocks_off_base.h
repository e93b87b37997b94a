// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/model/model.h>
#include <hybrid/dda/model/state.h>

namespace hybrid::output
{
  /// Blocks of the mass with nothing below them: their centroids, which were over the base when
  /// they were drawn, are beyond one of its ends now. They fall for ever.
  int blocks_off_base(const dda::Model &model, const dda::DdaState &state);

  /// Blocks of the mass that had a sole and neither press on what the mass stands on now nor are
  /// bonded to it: they fly, or lie on other blocks.
  int blocks_off_surface(const dda::Model &model, const dda::DdaState &state);
} // namespace hybrid::output
