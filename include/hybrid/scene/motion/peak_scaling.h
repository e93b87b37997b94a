// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/scene/motion/motion.h>

#include <string>

namespace hybrid::scene
{
  /// The motion with exactly this largest |a| [m/s2]. @throws InputError that names @p source if it
  /// is zero.
  Motion scaled_to_peak(const Motion &motion, double peak, const std::string &source);
} // namespace hybrid::scene
