// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/parameters/scene_parameters.h>

#include <string>
#include <vector>

namespace hybrid::scene
{
  /**
   * What the user has asked for and will not get because another setting switches it off, one
   * sentence each: a motion below a fixed base, a record that the type of motion does not read,
   * bedding planes in a rigid bedrock.
   */
  std::vector<std::string> settings_without_effect(const SceneParameters &scene);
} // namespace hybrid::scene
