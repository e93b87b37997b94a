// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/motion/motion.h>
#include <hybrid/scene/parameters/scene_parameters.h>

#include <string>

namespace hybrid::output
{
  /// The part "Effects" of the card of a scene: what is simulated, by which numbers, and what is
  /// off.
  std::string describe_effects(const scene::SceneParameters &scene, const scene::Motion &motion);
} // namespace hybrid::output
