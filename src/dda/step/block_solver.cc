// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/contact/contact_tolerances.h>
#include <hybrid/dda/failure/joint_release.h>
#include <hybrid/dda/geometry/outline_frames.h>
#include <hybrid/dda/linear/shared_loop.h>
#include <hybrid/dda/step/block_solver.h>
#include <hybrid/restart/archive.h>
#include <hybrid/scene/stopwatch.h>

#include <algorithm>
#include <limits>
#include <map>

namespace hybrid::dda
{
  namespace
  {
    // Where blocks yield, rock flows over small slips on many edges: corners that catch make it
    // stronger than it is.
    constexpr double slack_of_yielding = 1e-2, rigid_slack = 1e-3; ///< of the reach [-]

    ContactDetection::Parameters detection_parameters(const Model &model)
    {
      // Blocks of the bedrock never meet each other: the sizes of the mass count, if there is one.
      const int           n_mass = model.n_mass();
      std::vector<double> sizes;
      for (int b = 0; b < (n_mass > 0 ? n_mass : model.n_blocks()); ++b)
        sizes.push_back(model.blocks[b].size);
      const auto middle = sizes.begin() + sizes.size() / 2;
      std::nth_element(sizes.begin(), middle, sizes.end());
      const double largest = *std::max_element(sizes.begin(), sizes.end());
      // Two bodies that move towards each other by the largest allowed displacement each.
      const double moved = 2. * model.iteration.maximum_displacement_ratio * largest;
      // The list of near pairs has a skin that suits most blocks.
      return {std::min(moved, 0.25 * largest),
              0.25 * *middle,
              ContactTolerances::smooth_angle,
              0.25 * largest,
              0.25 * largest,
              model.blocks_yield ? slack_of_yielding : rigid_slack};
    }



    /// Of the blocks, for the tolerances of their contacts: those of the bedrock are surfaces.
    std::vector<double> sizes_of(const Model &model)
    {
      std::vector<double> sizes(model.blocks.size(), std::numeric_limits<double>::infinity());
      for (int b = 0; b < model.n_mass(); ++b)
        sizes[b] = model.blocks[b].size;
      return sizes;
    }



    using Place = std::pair<double, double>; ///< x, y

    /// Directions of the edges of all surfaces that begin or end at each place, with the rock on
    /// the left.
    std::multimap<Place, Vec2> surface_edges(const Geometry &geometry)
    {
      std::multimap<Place, Vec2> edges;
      const auto                 add = [&](const Vec2 &a, const Vec2 &b) {
        edges.insert({{a.x(), a.y()}, b - a});
        edges.insert({{b.x(), b.y()}, b - a});
      };
      for (std::size_t k = 0; k + 1 < geometry.foundation_nodes.size(); ++k)
        add(geometry.foundation_nodes[k + 1], geometry.foundation_nodes[k]);
      for (int b = geometry.bedrock.first_block; b < geometry.n_blocks(); ++b)
        for (int v = geometry.offset[b]; v < geometry.offset[b + 1]; ++v)
          if (geometry.bedrock.next[v] != BedrockSurface::inside)
            add(geometry.vertices[v], geometry.vertices[geometry.next(v)]);
      return edges;
    }



    /// True if an edge of a block lies on the surface: they face each other within 3 degrees.
    bool lies_on(const Vec2 &edge, const Vec2 &surface)
    {
      const double sine = cross(edge, surface) / (edge.norm() * surface.norm());
      return edge.dot(surface) < 0. && std::abs(sine) <= ContactTolerances{}.entry_sine;
    }



    /// No corner of the block turns inward.
    bool is_convex(const Geometry &g, const int block)
    {
      for (int v = g.offset[block]; v < g.offset[block + 1]; ++v)
        {
          const Vec2 before = g.vertices[v] - g.vertices[g.previous(v)],
                     after  = g.vertices[g.next(v)] - g.vertices[v];
          if (cross(before, after) <
              -ContactTolerances::smooth_angle * before.norm() * after.norm())
            return false;
        }
      return true;
    }



    /// Blocks that do not look at a surface unless they are awake to all: those on a belt, and
    /// bonded ones that only touch it with corners, as their neighbours hold them.
    std::vector<char> blocks_held_off(const Model &model, const std::vector<char> &is_on_belt)
    {
      const Geometry   &g     = model.initial;
      const auto        edges = surface_edges(g);
      std::vector<char> held_off(model.blocks.size(), 0);
      for (int b = 0; b < model.n_mass(); ++b)
        {
          bool touches = false, lies = false;
          for (int v = g.offset[b]; v < g.offset[b + 1]; ++v)
            {
              const Vec2 &x    = g.vertices[v];
              const auto  here = edges.equal_range({x.x(), x.y()});
              for (auto e = here.first; e != here.second; ++e)
                {
                  touches = true;
                  lies    = lies || lies_on(g.vertices[g.next(v)] - x, e->second) ||
                         lies_on(x - g.vertices[g.previous(v)], e->second);
                }
            }
          held_off[b] = is_on_belt[b] || (model.bonded[b] && touches && !lies) ? 1 : 0;
        }
      return held_off;
    }
  } // namespace



  BlockSolver::BlockSolver(const Model &block_model)
    : model(block_model)
    , detection(detection_parameters(block_model))
    , mesh_nodes(block_model.initial)
  {
    std::vector<int> offset{0}, list;
    for (const auto &neighbours : model.neighbours)
      {
        list.insert(list.end(), neighbours.begin(), neighbours.end());
        offset.push_back(static_cast<int>(list.size()));
      }
    detection.set_neighbours(offset, list);
    for (const Joint &joint : model.joints)
      if (joint.kind == JointKind::body)
        mesh_nodes.bond(model.initial, joint.edge, joint.other_edge());
    detection.set_sizes(sizes_of(model));
    for (int b = 0; b < model.initial.n_blocks(); ++b)
      is_convex_block.push_back(is_convex(model.initial, b) ? 1 : 0);
    iteration.set_processes(model.processes.get());
  }



  void BlockSolver::serialize(restart::Archive &archive)
  {
    iteration.serialize(archive);
    archive(search_summary.steps,
            search_summary.searches,
            search_summary.lists,
            search_summary.time);
  }



  std::vector<ContactScope> BlockSolver::contact_scopes(const DdaState &state) const
  {
    std::vector<ContactScope> now(model.blocks.size(), ContactScope::no);
    for (std::size_t b = 0; b < now.size(); ++b)
      if (!model.bonded[b])
        now[b] = ContactScope::to_all;
    wake_around_nodes(state, now);
    for (std::size_t j = 0; j < model.joints.size(); ++j)
      {
        const JointState &joint = state.joints[j];
        if (!joint.has_yielded)
          continue;
        for (const int body : {model.joints[j].block, model.joints[j].other})
          if (body != foundation_body && !model.is_bedrock(body))
            {
              const bool to_all = joint.failure != FailureKind::none || !is_on_belt[body] ||
                                  model.joints[j].kind == JointKind::belt;
              now[body] =
                std::max(now[body], to_all ? ContactScope::to_all : ContactScope::to_blocks);
            }
      }
    return now;
  }



  void BlockSolver::wake_around_nodes(const DdaState            &state,
                                      std::vector<ContactScope> &scopes) const
  {
    const Geometry   &g = model.initial;
    std::vector<char> is_open(g.vertices.size(), 0); // per node
    for (std::size_t j = 0; j < model.joints.size(); ++j)
      {
        const Joint &joint = model.joints[j];
        if (joint.kind == JointKind::body && state.joints[j].has_yielded)
          is_open[mesh_nodes.node_of(joint.edge)] =
            is_open[mesh_nodes.node_of(g.next(joint.edge))] = 1;
      }
    for (int v = 0; v < g.offset[model.n_mass()]; ++v)
      if (is_open[mesh_nodes.node_of(v)] != 0)
        scopes[g.block_of[v]] = std::max(scopes[g.block_of[v]], ContactScope::to_blocks);
  }



  void BlockSolver::find_blocks_on_surface()
  {
    is_on_belt.assign(model.blocks.size(), 0);
    for (const Joint &joint : model.joints)
      if (!joint.within_bedrock() && is_surface(model.initial, joint.other))
        is_on_belt[joint.block] = 1;
    held_off = blocks_held_off(model, is_on_belt);
  }



  BondedOutline BlockSolver::bonded_outline(const DdaState &state) const
  {
    BondedOutline outline(model.initial);
    for (std::size_t j = 0; j < model.joints.size(); ++j)
      {
        const Joint      &joint = model.joints[j];
        const JointState &now   = state.joints[j];
        if (joint.kind == JointKind::body && !now.has_yielded && now.failure == FailureKind::none)
          outline.bond(model.initial, joint.edge, joint.other_edge());
      }
    return outline;
  }



  bool BlockSolver::touches_beside(const Joint &joint) const
  {
    return !is_convex_block[joint.block] || !is_convex_block[joint.other];
  }



  bool BlockSolver::update_skipped_pairs(const DdaState &state)
  {
    if (held_off.empty())
      find_blocks_on_surface();
    const int now = shared_sum<int>(state.joints.size(), [&](const std::size_t j, int &sum) {
      const JointState &joint = state.joints[j];
      sum += (joint.has_yielded ? 1 : 0) + (joint.failure != FailureKind::none ? 1 : 0) +
             (joint.released ? 1 : 0);
    });
    if (now == changes)
      return false;
    changes = now;

    SkippedPairs skipped;
    skipped.scope = scope = contact_scopes(state);
    skipped.held_off      = held_off;
    skipped.outline       = bonded_outline(state);
    for (std::size_t j = 0; j < model.joints.size(); ++j)
      {
        const Joint &joint = model.joints[j];
        if (state.joints[j].released)
          continue;
        if (joint.other != foundation_body && !model.is_bedrock(joint.other))
          {
            if (state.joints[j].has_yielded && touches_beside(joint))
              skipped.joint_edges.insert(skipped.joint_edges.end(),
                                         {{joint.block, joint.other, joint.other_edge()},
                                          {joint.other, joint.block, joint.edge}});
            else
              skipped.bonded.push_back({joint.block, joint.other});
          }
        else if (!model.is_bedrock(joint.block))
          skipped.surface.push_back({joint.block,
                                     joint.other,
                                     joint.other == foundation_body
                                       ? joint.points[0].other_vertex
                                       : joint.points[1].other_vertex});
      }
    detection.set_skipped_pairs(skipped);
    return true;
  }



  StepResult BlockSolver::solve(DdaState                 &state,
                                const FoundationResponse &foundation,
                                const double              dt,
                                const std::vector<Vec6>  *guess)
  {
    solved_dt = dt;
    is_asleep = guess == nullptr && sleep.lasts(model, state, foundation, dt);
    if (is_asleep)
      {
        ++search_summary.steps;
        return solved = sleep.result();
      }
    const long searches = search_summary.searches + search_summary.lists;
    if (model.n_mass() > 0) // joints carry all loads of the bedrock
      search_contacts(state);
    searched = search_summary.searches + search_summary.lists > searches;
    solved   = iteration.solve(model, state, foundation, dt, guess);
    if (solved.converged && is_passed(state))
      {
        solved.is_passed = true;
        solved.converged = false;
      }
    if (!iteration.is_at_rest())
      sleep.wake();
    return solved;
  }



  bool BlockSolver::is_passed(const DdaState &state)
  {
    if (model.n_mass() == 0)
      return false;
    const Trial &trial = iteration.trial();
    node_displacements.resize(model.n_foundation_nodes());
    for (std::size_t k = 0; k < node_displacements.size(); ++k)
      node_displacements[k] =
        trial.foundation.segment<2>(2 * k) - state.foundation_displacement.segment<2>(2 * k);
    return detection.is_passed(state.geometry,
                               state.contacts,
                               {trial.motion, trial.displacement, node_displacements});
  }



  void BlockSolver::accept(DdaState &state)
  {
    if (is_asleep)
      {
        state.time += solved_dt;
        return;
      }
    iteration.accept(state);
    if (model.iteration.sleeps && iteration.is_at_rest() && !searched)
      sleep.rested(model, state, solved_dt, solved);
    else
      sleep.wake();
  }



  void BlockSolver::search_contacts(DdaState &state)
  {
    const Stopwatch                watch(search_summary.time);
    const ContactDetection::Report before         = detection.report();
    const bool                     joints_changed = update_skipped_pairs(state);
    detection.set_was_awake(state.contact_scope);
    contacts_before.assign(state.contacts.begin(), state.contacts.end());
    detection.update(state.geometry, state.contacts, state.rest);
    const auto corner = [&](const Contact &contact) {
      return model.contacts.law(model.initial, contact, model.n_mass()).length;
    };
    loads.carry(contacts_before, state.geometry, corner, state.contacts);
    ContactLoads::turn(state.geometry, corner, state.contacts);
    if (joints_changed)
      hand_over_released_joints(model, state);
    belt_parting.update(model, state);
    state.contact_scope.assign(scope.begin(), scope.end());
    ++search_summary.steps;
    search_summary.searches += detection.report().searches - before.searches;
    search_summary.lists += detection.report().builds - before.builds;
  }
} // namespace hybrid::dda
