// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/geometry/surface_valley.h>
#include <hybrid/dda/model/joint_valleys.h>

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

namespace hybrid::dda
{
  namespace
  {
    /// A body, its edge, and the body that a joint bonds to it.
    using BondedSide = std::tuple<int, int, int>;
  } // namespace



  void set_joint_valleys(Model &model)
  {
    std::set<BondedSide> bonded;
    for (const Joint &joint : model.joints)
      {
        bonded.insert({joint.block, joint.edge, joint.other});
        bonded.insert({joint.other, joint.other_edge(), joint.block});
      }
    for (Joint &joint : model.joints)
      {
        if (joint.within_bedrock())
          continue;
        // Slip is that of the other body along the block's edge.
        const auto look =
          [&](const int body, const int edge, const int other, const int before, const int after) {
            const auto next = rising_edges(model.initial, body, edge);
            for (const auto &[k, sign] : {std::pair{0, before}, std::pair{1, after}})
              if (bonded.count({body, next[k].edge, other}) == 0)
                joint.valley[sign] = std::max(joint.valley[sign], next[k].sine);
          };
        look(joint.block, joint.edge, joint.other, 1, 0);
        if (joint.other == foundation_body) // whose edges run along those of what lies on it
          look(joint.other, joint.other_edge(), joint.block, 0, 1);
        else
          look(joint.other, joint.other_edge(), joint.block, 1, 0);
      }
  }
} // namespace hybrid::dda
