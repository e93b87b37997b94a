// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/geometry/polygon.h>
#include <hybrid/output/blocks_off_base.h>

#include <algorithm>

namespace hybrid::output
{
  int blocks_off_base(const dda::Model &model, const dda::DdaState &state)
  {
    const dda::Geometry &drawn = model.initial;
    if (drawn.foundation_nodes.empty())
      return 0;
    const std::vector<Vec2> &nodes = drawn.foundation_nodes;
    const auto [first, last] =
      std::minmax_element(nodes.begin(), nodes.end(), [](const Vec2 &a, const Vec2 &b) {
        return a.x() < b.x();
      });
    const auto now_at = [&](const auto node) {
      return node->x() + state.foundation_displacement[2 * (node - nodes.begin())];
    };
    const double left_end = now_at(first), right_end = now_at(last);
    int          count = 0;
    for (int b = 0; b < model.n_mass(); ++b)
      {
        const int    begin = drawn.offset[b], n = drawn.offset[b + 1] - begin;
        const double before = dda::polygon_moments(&drawn.vertices[begin], n).centroid.x(),
                     now    = state.blocks[b].centroid.x();
        if (first->x() <= before && before <= last->x() && (now < left_end || now > right_end))
          ++count;
      }
    return count;
  }
} // namespace hybrid::output
