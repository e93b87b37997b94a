// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/motion/motion.h>

#include <string>

namespace hybrid::scene
{
  /// A number with four digits.
  std::string in_words(double value);


  /// Largest |v| at the samples [m/s].
  double largest_velocity(const Motion &motion);
} // namespace hybrid::scene
