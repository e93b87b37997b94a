// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/geometry/outline_frames.h>
#include <hybrid/dda/geometry/surface_valley.h>
#include <hybrid/dda/model/joint_valleys.h>

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace hybrid::dda
{
  namespace
  {
    /// A body, its edge, and the body that a joint bonds to it.
    using BondedSide = std::tuple<int, int, int>;


    /// An edge that rises where a joint slides to with this sign of slip (0: positive).
    struct Rise
    {
      std::size_t joint;
      int         sign;
      double      sine;
      BondedSide  side; ///< the edge, and the body that slides into it
    };



    std::vector<Rise> find_rises(const Model &model)
    {
      std::vector<Rise> rises;
      for (std::size_t j = 0; j < model.joints.size(); ++j)
        {
          const Joint &joint = model.joints[j];
          if (joint.within_bedrock())
            continue;
          // Slip is that of the other body along the block's edge.
          const auto look = [&](const int body,
                                const int edge,
                                const int other,
                                const int before,
                                const int after) {
            const auto next = rising_edges(model.initial, body, edge);
            for (const auto &[k, sign] : {std::pair{0, before}, std::pair{1, after}})
              if (next[k].sine > 0.)
                rises.push_back(
                  {j,
                   sign,
                   next[k].sine,
                   {body_of(model.initial, body, next[k].edge), next[k].edge, other}});
          };
          look(joint.block, joint.edge, joint.other, 1, 0);
          if (joint.other == foundation_body) // whose edges run along those of what lies on it
            look(joint.other, joint.other_edge(), joint.block, 0, 1);
          else
            look(joint.other, joint.other_edge(), joint.block, 1, 0);
        }
      return rises;
    }
  } // namespace



  void set_joint_valleys(Model &model)
  {
    const std::vector<Rise> rises = find_rises(model);
    std::set<BondedSide>    rising, bonded;
    for (const Rise &rise : rises)
      rising.insert(rise.side);
    for (const Joint &joint : model.joints)
      for (const BondedSide &side : {BondedSide{joint.block, joint.edge, joint.other},
                                     BondedSide{joint.other, joint.other_edge(), joint.block}})
        if (rising.count(side) > 0)
          bonded.insert(side);
    for (const Rise &rise : rises)
      if (bonded.count(rise.side) == 0)
        {
          double &valley = model.joints[rise.joint].valley[rise.sign];
          valley         = std::max(valley, rise.sine);
        }
  }
} // namespace hybrid::dda
