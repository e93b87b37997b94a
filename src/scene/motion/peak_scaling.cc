// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/input_error.h>
#include <hybrid/scene/motion/motion_words.h>
#include <hybrid/scene/motion/peak_scaling.h>

#include <cmath>

namespace hybrid::scene
{
  Motion scaled_to_peak(const Motion &motion, const double peak, const std::string &source)
  {
    const double found = motion.peak_acceleration();
    if (!(found > 0.))
      throw InputError(source + ": the motion is zero and cannot be scaled to the peak of " +
                       in_words(peak) + " m/s2.");
    const Motion        scaled = motion.scaled(peak / found);
    std::vector<double> a      = scaled.samples();
    // the last bit of peak / found must not show in the peak
    for (std::size_t i = 0; i < a.size(); ++i)
      if (std::abs(a[i]) > peak || std::abs(motion.samples()[i]) == found)
        a[i] = std::copysign(peak, a[i]);
    return Motion(motion.time_step(), a);
  }
} // namespace hybrid::scene
