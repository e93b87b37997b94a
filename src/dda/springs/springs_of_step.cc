// SPDX-License-Identifier: GPL-3.0-or-later
// Which springs a step has, and where they are in the matrix.
#include <hybrid/dda/contact/contact_frame.h>
#include <hybrid/dda/geometry/outline_frames.h>
#include <hybrid/dda/linear/shared_loop.h>
#include <hybrid/dda/springs/contact_length.h>
#include <hybrid/dda/springs/springs.h>

#include <algorithm>

namespace hybrid::dda
{
  namespace
  {
    /// Part of a contact's springs on which its residual cohesion acts [-]: blocks that were bonded
    /// to each other, or what a belt bonds still.
    double cohesive_fraction(const Model &model, const Contact &c, const ContactLength &length)
    {
      if (length.spring <= 0.)
        return 0.;
      if (is_surface(model.initial, c.vertex_body) || is_surface(model.initial, c.edge_body))
        return length.bonded / length.spring;
      return model.contacts.were_bonded(c.vertex_body, c.edge_body) ? length.overlap / length.spring
                                                                    : 0.;
    }
  } // namespace



  void Springs::collect(const Model &model, const DdaState &state)
  {
    collected.clear();
    for (std::size_t j = 0; j < model.joints.size(); ++j)
      if (!state.joints[j].released && !(model.hold_bedrock && model.joints[j].within_bedrock()))
        collected.push_back(static_cast<int>(j));
    const std::size_t n = 2 * collected.size() + state.contacts.size();
    if (springs.capacity() == 0)
      springs.reserve(2 * model.joints.size() + state.contacts.size());
    springs.resize(n);
    responses.resize(n);
    forces.resize(n);
    bearing.resize(n);
    bodies_changed = bodies.size() != n;
    bodies.resize(n);
    collect_joints(model, state);
    collect_contacts(model, state);
    if (bodies_changed || by_block.n_blocks() != model.n_blocks())
      {
        by_block.sort(bodies, model.n_blocks());
        connected_pattern = -1;
      }
  }



  bool Springs::take(const std::size_t s, const Spring &spring)
  {
    const Bodies now{spring.block, spring.other, {spring.node[0], spring.node[1]}};
    const bool   same = bodies[s] == now;
    bodies[s]         = now;
    springs[s]        = spring;
    return !same;
  }



  Springs::Spring
  Springs::joint_spring(const Model &model, const DdaState &state, const int j, const int end)
  {
    const Joint &joint = model.joints[j];
    Spring       s;
    s.block            = joint.block;
    s.other            = joint.other;
    s.joint            = j;
    s.end              = end;
    s.law              = &joint.law;
    s.length           = 0.5 * joint.length;
    s.old              = state.joints[j].points[end];
    s.contact_fraction = joint.law.contact_fraction(s.old.history);
    s.coulomb =
      s.contact_fraction == 1. && joint.law.is_coulomb(s.old.history, s.cohesion_length_ratio);
    if (joint.other == foundation_body)
      s.node[0] = s.node[1] = joint.points[end].other_vertex;
    return s;
  }



  void Springs::collect_joints(const Model &model, const DdaState &state)
  {
    const std::size_t n       = 2 * collected.size();
    bool              changed = false, parts = false, torn = false;
#pragma omp parallel for schedule(static) \
  reduction(||                            \
            : changed, parts, torn) if (is_worth_sharing(n))
    for (std::size_t s = 0; s < n; ++s)
      {
        changed = take(s, joint_spring(model, state, collected[s / 2], s % 2)) || changed;
        parts   = parts || springs[s].acts_as_both();
        torn    = torn || springs[s].contact_fraction > 0.;
      }
    any_torn       = torn;
    bodies_changed = bodies_changed || changed;
    contact_parts.clear();
    for (std::size_t s = 0; s < n && parts; ++s)
      if (springs[s].acts_as_both())
        {
          springs[s].part = static_cast<int>(contact_parts.size());
          contact_parts.emplace_back();
        }
  }



  Springs::Spring
  Springs::contact_spring(const Model &model, const DdaState &state, const int c) const
  {
    const Geometry   &geometry      = state.geometry;
    const Contact    &contact       = state.contacts[c];
    const bool        node_on_block = contact.vertex_body == foundation_body;
    const bool        on_foundation = node_on_block || contact.edge_body == foundation_body;
    const ContactLaw &law           = model.contacts.law(model.initial, contact, model.n_mass());
    Spring            s;
    s.block            = node_on_block ? contact.edge_body : contact.vertex_body;
    s.other            = on_foundation ? foundation_body : contact.edge_body;
    s.contact          = c;
    s.contact_fraction = 1.;
    s.law              = &law.law;
    const ContactLength length =
      contact_length(geometry, state.contacts, contact, law.length, &bonded_area);
    s.length = length.spring;
    if (law.law.has_residual_cohesion())
      s.cohesion_length_ratio = cohesive_fraction(model, contact, length);
    if (on_foundation)
      {
        s.node[0] = node_on_block ? contact.vertex : contact.edge;
        s.node[1] = node_on_block ? contact.vertex : contact.edge + 1;
      }

    const ContactFrame frame(contact, places(contact, geometry));
    s.along                    = frame.along;
    s.old.history.plastic_slip = contact.plastic_slip;
    s.old.gap                  = frame.gap - contact.stress_free_gap;
    s.old.slip                 = frame.slip;
    const JointResponse r =
      law.law.respond({s.old.gap, frame.slip, s.cohesion_length_ratio}, s.old.history);
    s.old.history = r.history;
    s.old.normal = s.old.elastic_normal = r.normal;
    s.old.shear = s.old.elastic_shear = r.shear;
    // At its limit it slides on, though the law calls that sticking until more is asked of it.
    const bool slid = contact.state == ContactState::sliding;
    s.old.state     = slid && r.state == ContactState::locked ? contact.state : r.state;
    s.coulomb       = law.law.is_coulomb(s.old.history, s.cohesion_length_ratio);
    return s;
  }



  void Springs::collect_contacts(const Model &model, const DdaState &state)
  {
    bonded_area.update(model, state);
    const std::size_t n = state.contacts.size(), first = first_contact();
    bool              changed = false;
#pragma omp parallel for schedule(static) reduction(|| : changed) if (is_worth_sharing(n))
    for (std::size_t c = 0; c < n; ++c)
      changed = take(first + c, contact_spring(model, state, static_cast<int>(c))) || changed;
    bodies_changed = bodies_changed || changed;
  }



  bool Springs::find_slots(const BlockMatrix &matrix)
  {
    const std::size_t n   = bodies.size();
    bool              all = true;
    slots.resize(n);
#pragma omp parallel for schedule(static) reduction(&& : all) if (is_worth_sharing(n))
    for (std::size_t s = 0; s < n; ++s)
      {
        const auto &[block, other, node] = bodies[s];
        if (other == foundation_body)
          slots[s] = {matrix.node_slot(block, node[0]), matrix.node_slot(block, node[1])};
        else
          slots[s][0] = slots[s][1] =
            matrix.block_slot(std::min(block, other), std::max(block, other));
        all = all && slots[s][0] >= 0 && slots[s][1] >= 0;
      }
    connected_pattern = matrix.pattern_version();
    return all;
  }



  void Springs::connect(const Model &model, BlockMatrix &matrix)
  {
    const bool same_size =
      matrix.n_blocks() == model.n_blocks() && matrix.n_nodes() == model.n_foundation_nodes();
    const std::size_t n_of_blocks = bodies.size() - on_foundation().size();
    if (same_size && matrix.pairs.size() <= 2 * n_of_blocks + 64 &&
        (connected_pattern == matrix.pattern_version() || find_slots(matrix)))
      return;
    std::vector<BlockMatrix::Pair> block_pairs, node_pairs;
    block_pairs.reserve(n_of_blocks);
    for (const auto &[block, other, node] : bodies)
      if (other != foundation_body)
        block_pairs.push_back({block, other});
      else
        for (const int k : node)
          node_pairs.push_back({block, k});
    matrix.set_pattern(model.n_blocks(),
                       model.n_foundation_nodes(),
                       std::move(block_pairs),
                       std::move(node_pairs));
    find_slots(matrix);
  }
} // namespace hybrid::dda
