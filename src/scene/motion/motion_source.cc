// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/scene/motion/input_motion.h>
#include <hybrid/scene/motion/motion_source.h>
#include <hybrid/scene/motion/recorded_motion.h>
#include <hybrid/scene/motion/ricker.h>
#include <hybrid/scene/motion/sine_burst.h>
#include <hybrid/scene/motion/spectrum_motion.h>
#include <hybrid/scene/motion/stochastic_motion.h>
#include <hybrid/scene/motion/synthetic_motion.h>

#include <algorithm>

namespace hybrid::scene
{
  const std::vector<MotionSource> &motion_sources()
  {
    static const std::vector<MotionSource> sources{
      {"none", [](const MotionParameters &, double, InputMotion &) {}},
      ricker_source(),
      sine_source(),
      synthetic_source(),
      spectrum_source(),
      stochastic_source(),
      text_source(),
      at2_source()};
    return sources;
  }



  const MotionSource *find_motion_source(const std::string               &name,
                                         const std::vector<MotionSource> &sources)
  {
    const auto found =
      std::find_if(sources.begin(), sources.end(), [&](const MotionSource &source) {
        return source.name == name;
      });
    return found == sources.end() ? nullptr : &*found;
  }
} // namespace hybrid::scene
