// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/model/block_damping.h>

#include <algorithm>
#include <cmath>

namespace hybrid::dda
{
  double critical_damping_time(const BlockProperties &block)
  {
    return std::sqrt((block.sxx + block.syy) / (block.area * block.elasticity(2, 2)));
  }



  void block_damping_times(const Model &model, const DdaState &state, std::vector<double> &times)
  {
    times.resize(model.blocks.size());
    for (std::size_t b = 0; b < times.size(); ++b)
      times[b] = std::max(model.blocks[b].damping_time, model.blocks[b].loose_damping_time);
    if (!model.damps_loose)
      return;
    for (std::size_t j = 0; j < model.joints.size(); ++j)
      if (state.joints[j].failure == FailureKind::none)
        for (const int body : {model.joints[j].block, model.joints[j].other})
          if (body != foundation_body)
            times[body] = model.blocks[body].damping_time;
  }
} // namespace hybrid::dda
