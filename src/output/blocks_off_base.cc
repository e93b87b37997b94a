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
    const auto [left, right] =
      std::minmax_element(drawn.foundation_nodes.begin(),
                          drawn.foundation_nodes.end(),
                          [](const Vec2 &a, const Vec2 &b) { return a.x() < b.x(); });
    const auto is_over_base = [from = left->x(), to = right->x()](const Vec2 &point) {
      return from <= point.x() && point.x() <= to;
    };
    int count = 0;
    for (int b = 0; b < model.n_mass(); ++b)
      {
        const int first = drawn.offset[b], n = drawn.offset[b + 1] - first;
        if (is_over_base(dda::polygon_moments(&drawn.vertices[first], n).centroid) &&
            !is_over_base(state.blocks[b].centroid))
          ++count;
      }
    return count;
  }
} // namespace hybrid::output
