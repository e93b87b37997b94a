// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/statics/lost_hold.h>

#include <numeric>

namespace hybrid::dda
{
  namespace
  {
    bool holds(const JointState &joint)
    {
      return !joint.released &&
             (joint.failure == FailureKind::none || joint.points[0].state != ContactState::open ||
              joint.points[1].state != ContactState::open);
    }
  } // namespace



  bool LostHold::falls(const Model &model, const DdaState &state)
  {
    constexpr double fraction = 0.5;
    const int        n        = model.n_mass();
    place.resize(n, Vec2::Zero());
    was_held.resize(n, 0);
    join_bodies(model, state);
    bool any_flies = false, any_falls = false;
    for (int b = 0; b < n; ++b)
      if (root(b) == root(n))
        {
          place[b]    = state.blocks[b].centroid;
          was_held[b] = 1;
        }
      else if (was_held[b])
        {
          const double fallen = (state.blocks[b].centroid - place[b]).norm();
          any_flies           = true;
          any_falls           = any_falls || fallen > fraction * model.blocks[b].size;
        }
    if (any_flies && !flew)
      first_loss = state;
    flew = any_flies;
    return any_falls;
  }



  void LostHold::join_bodies(const Model &model, const DdaState &state)
  {
    const int  n         = model.n_mass();
    const auto number_of = [&](const int body) {
      return body == foundation_body || model.is_bedrock(body) ? n : body;
    };
    leader.resize(n + 1);
    std::iota(leader.begin(), leader.end(), 0);
    for (std::size_t j = 0; j < model.joints.size(); ++j)
      if (holds(state.joints[j]))
        join(number_of(model.joints[j].block), number_of(model.joints[j].other));
    for (const Contact &contact : state.contacts)
      if (contact.state != ContactState::open)
        join(number_of(contact.vertex_body), number_of(contact.edge_body));
  }



  int LostHold::root(int block)
  {
    while (leader[block] != block)
      block = leader[block] = leader[leader[block]];
    return block;
  }



  void LostHold::join(const int a, const int b)
  {
    leader[root(a)] = root(b);
  }
} // namespace hybrid::dda
