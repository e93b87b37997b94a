// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/motion/motion_words.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace hybrid::scene
{
  std::string in_words(const double value)
  {
    std::ostringstream text;
    text.precision(4);
    text << value;
    return text.str();
  }



  double largest_velocity(const Motion &motion)
  {
    double largest = 0.;
    for (std::size_t i = 0; i < motion.samples().size(); ++i)
      largest = std::max(largest, std::abs(motion.velocity(i * motion.time_step())));
    return largest;
  }
} // namespace hybrid::scene
