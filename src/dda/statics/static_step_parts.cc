// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/statics/static_step_parts.h>

#include <cmath>

namespace hybrid::dda
{
  void stop_blocks(DdaState &state)
  {
    for (BlockState &block : state.blocks)
      {
        block.velocity.setZero();
        block.acceleration.setZero();
        block.contact_acceleration.setZero();
        block.viscous_stress.setZero();
      }
  }



  OpenCloseIteration::Watch watch_of_step(const StaticWatch &watch, const StaticResult &result)
  {
    return [&watch, &result](const StepResult &step) {
      return watch({result.steps,
                    result.iterations + step.iterations,
                    result.steps > 0 ? result.residual : 1.,
                    static_target});
    };
  }



  bool slides_or_shears(const Model &problem, const DdaState &state)
  {
    constexpr double fraction = 0.1;
    for (const BlockState &block : state.blocks)
      if (block.plastic_strain > fraction)
        return true;
    for (std::size_t j = 0; j < problem.joints.size(); ++j)
      for (const SpringState &point : state.joints[j].points)
        if (!state.joints[j].released && !problem.joints[j].within_bedrock() &&
            std::abs(point.slip) > fraction * problem.joints[j].length)
          return true;
    return false;
  }
} // namespace hybrid::dda
