// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/joint/joint_strength.h>

namespace hybrid::scene
{
  struct BeddingParameters;
}

namespace hybrid::dda
{
  /// Bedding plane: one that neither breaks nor slips, or Mohr-Coulomb with tension cut-off. Slip
  /// takes nothing of the strength; an end that opens beyond the cut-off (at most c / tan phi)
  /// keeps its friction only.
  JointStrength bedding_strength(const scene::BeddingParameters &bedding);
} // namespace hybrid::dda
