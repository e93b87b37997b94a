// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/step/block_stresses.h>

#include <algorithm>

namespace hybrid::dda
{
  void BlockStresses::begin(const Model &model, const DdaState &state, const double dt)
  {
    maxwell.begin(model, state, dt);
    plastic.resize(model.blocks_yield ? model.blocks.size() : 0);
  }



  Eigen::Vector3d BlockStresses::yielded(const BlockProperties &properties,
                                         const Eigen::Vector3d &trial,
                                         const double           viscous,
                                         const int              block)
  {
    YieldResponse &now = plastic[block];
    if (properties.strength.is_limited())
      now = return_to_yield(properties.strength, stiffness(properties, viscous, block), trial);
    else
      {
        now        = {};
        now.stress = trial;
      }
    return now.stress;
  }



  bool BlockStresses::is_symmetric() const
  {
    return std::all_of(plastic.begin(), plastic.end(), [](const YieldResponse &r) {
      return r.region == YieldRegion::elastic || r.tangent == r.tangent.transpose();
    });
  }
} // namespace hybrid::dda
