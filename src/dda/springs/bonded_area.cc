// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/springs/bonded_area.h>

namespace hybrid::dda
{
  namespace
  {
    constexpr double at_corner = 1e-9; ///< of the edge [-]
  }                                    // namespace



  void BondedArea::update(const Model &model, const DdaState &state)
  {
    edges.assign(model.initial.vertices.size(), 0);
    segments.assign(model.initial.foundation_nodes.size(), 0);
    for (std::size_t j = 0; j < model.joints.size(); ++j)
      {
        const Joint &joint = model.joints[j];
        if (!joint.bears_residual_cohesion())
          continue;
        (joint.other == foundation_body ? segments : edges)[joint.other_edge()] = both;
        if (!state.joints[j].released) // it bears its cohesion itself
          continue;
        for (const int end : {0, 1})
          if (!state.joints[j].parted[end])
            edges[joint.edge] |= joint.points[end].position < at_corner        ? first
                                 : joint.points[end].position > 1. - at_corner ? second
                                                                               : 0;
      }
  }
} // namespace hybrid::dda
