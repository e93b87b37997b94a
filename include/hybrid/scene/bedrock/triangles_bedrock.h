// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/parameters/bedrock_model.h>

namespace hybrid::scene
{
  /**
   * Bonded triangular blocks that carry the waves: every cell is cut along its shorter diagonal;
   * between equal ones the diagonal is taken whose ends meet more diagonals already, so that
   * structured meshes get the pattern of alternating diagonals, which prefers no direction. The
   * foundation is the line "base" unless it is compliant.
   */
  BedrockModel triangles_bedrock();
} // namespace hybrid::scene
