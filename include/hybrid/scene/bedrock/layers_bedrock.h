// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/parameters/bedrock_model.h>

namespace hybrid::scene
{
  /**
   * One block per layer between bedding planes: every surface of the geometry is one, whose outline
   * is the boundary loop of its cells. The lowest one, along the line "base", is the foundation,
   * which moves as prescribed; only its upper boundary is needed.
   *
   * The cut throws InputError for a layer that is not one simple polygon, or a plane of the scene
   * that does not divide the bedrock into layers.
   */
  BedrockModel layers_bedrock();
} // namespace hybrid::scene
