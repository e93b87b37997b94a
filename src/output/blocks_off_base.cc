// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/geometry/polygon.h>
#include <hybrid/output/blocks_off_base.h>

#include <algorithm>
#include <vector>

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



  int blocks_off_surface(const dda::Model &model, const dda::DdaState &state)
  {
    std::vector<char> lay(model.n_mass(), 0), touches(model.n_mass(), 0);
    for (const dda::Sole &sole : model.soles)
      lay[model.initial.block_of[sole.first]] = 1;
    const auto add = [&](const int block, const int other) {
      const auto is_mass = [&](const int body) { return body >= 0 && !model.is_bedrock(body); };
      if (is_mass(block) && !is_mass(other))
        touches[block] = 1;
      else if (is_mass(other) && !is_mass(block))
        touches[other] = 1;
    };
    for (const dda::Contact &contact : state.contacts)
      if (contact.state != dda::ContactState::open)
        add(contact.vertex_body, contact.edge_body);
    for (std::size_t j = 0; j < model.joints.size(); ++j)
      if (!state.joints[j].released)
        add(model.joints[j].block, model.joints[j].other);
    int count = 0;
    for (int b = 0; b < model.n_mass(); ++b)
      count += lay[b] && !touches[b] ? 1 : 0;
    return count;
  }
} // namespace hybrid::output
