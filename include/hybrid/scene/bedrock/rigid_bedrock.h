// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/parameters/bedrock_model.h>

namespace hybrid::scene
{
  /// A rigid base with the prescribed motion (pure DDA), or nothing where there is no surface.
  inline BedrockModel rigid_bedrock()
  {
    return {"rigid", "none"};
  }
} // namespace hybrid::scene
