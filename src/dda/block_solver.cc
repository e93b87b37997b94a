// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/block_solver.h>
#include <hybrid/dda/bonded_area.h>
#include <hybrid/dda/joint_release.h>
#include <hybrid/restart/archive.h>

#include <algorithm>
#include <chrono>
#include <map>

namespace hybrid::dda
{
  namespace
  {
    ContactDetection::Parameters detection_parameters(const Model &model)
    {
      double largest = 0., smallest = std::numeric_limits<double>::infinity();
      // Blocks of the bedrock never meet each other: the sizes of the mass count, if there is one.
      const int n_mass = model.n_mass();
      for (int b = 0; b < (n_mass > 0 ? n_mass : model.n_blocks()); ++b)
        {
          largest  = std::max(largest, model.blocks[b].size);
          smallest = std::min(smallest, model.blocks[b].size);
        }
      // Two bodies that move towards each other by the largest allowed displacement each.
      const double moved = 2. * model.iteration.maximum_displacement_ratio * largest;
      return {std::min(moved, 0.25 * smallest),
              0.25 * largest,
              ContactTolerances::smooth_angle,
              0.25 * smallest};
    }
  } // namespace



  BlockSolver::BlockSolver(const Model &block_model)
    : model(block_model)
    , detection(detection_parameters(block_model))
  {
    std::vector<int> offset{0}, list;
    for (const auto &neighbours : model.neighbours)
      {
        list.insert(list.end(), neighbours.begin(), neighbours.end());
        offset.push_back(static_cast<int>(list.size()));
      }
    detection.set_neighbours(offset, list);

    is_on_belt.assign(model.blocks.size(), 0);
    for (const Joint &joint : model.joints)
      if (joint.kind == JointKind::belt)
        for (const int body : {joint.block, joint.other})
          if (body != base_body)
            is_on_belt[body] = 1;

    std::map<std::pair<double, double>, int> node_at;
    for (int k = 0; k < model.n_base_nodes(); ++k)
      node_at[{model.initial.base_nodes[k].x(), model.initial.base_nodes[k].y()}] = k;
    for (std::size_t v = 0; v < model.initial.vertices.size(); ++v)
      {
        const Vec2 &x    = model.initial.vertices[v];
        const auto  node = node_at.find({x.x(), x.y()});
        if (node == node_at.end())
          continue;
        for (const int segment : {node->second - 1, node->second})
          if (segment >= 0 && segment + 1 < model.n_base_nodes())
            touching_base.push_back({model.initial.block_of[v], segment});
      }
  }



  void BlockSolver::serialize(restart::Archive &archive)
  {
    iteration.serialize(archive);
    archive(search_summary.steps,
            search_summary.searches,
            search_summary.lists,
            search_summary.time);
  }



  std::vector<Awake> BlockSolver::awake_blocks(const DdaState &state) const
  {
    std::vector<Awake> now(model.blocks.size(), Awake::no);
    for (std::size_t b = 0; b < now.size(); ++b)
      if (!model.bonded[b])
        now[b] = Awake::to_all;
    for (std::size_t j = 0; j < model.joints.size(); ++j)
      {
        const JointState &joint = state.joints[j];
        if (!joint.loosened)
          continue;
        for (const int body : {model.joints[j].block, model.joints[j].other})
          if (body != base_body && !model.is_bedrock(body))
            {
              const bool to_all = joint.failure != FailureKind::none || !is_on_belt[body];
              now[body]         = std::max(now[body], to_all ? Awake::to_all : Awake::to_blocks);
            }
      }
    return now;
  }



  bool BlockSolver::update_skipped_pairs(const DdaState &state)
  {
    int now = 0;
    for (const JointState &joint : state.joints)
      now += (joint.loosened ? 1 : 0) + (joint.failure != FailureKind::none ? 1 : 0) +
             (joint.released ? 1 : 0);
    if (now == changes)
      return false;
    changes = now;

    SkippedPairs skipped;
    skipped.awake = awake = awake_blocks(state);
    if (model.n_bedrock > 0)
      for (int b = 0; b < model.n_blocks(); ++b)
        skipped.bedrock.push_back(model.is_bedrock(b));
    for (std::size_t j = 0; j < model.joints.size(); ++j)
      {
        const Joint &joint = model.joints[j];
        if (state.joints[j].released)
          continue;
        if (joint.other == base_body)
          skipped.bonded_base.push_back({joint.block, joint.points[0].other_vertex});
        else
          skipped.bonded.push_back({joint.block, joint.other});
      }
    // A block that only touches the base with a corner is held by its neighbours while it is not
    // awake.
    for (const auto &pair : touching_base)
      if (skipped.awake[pair.first] != Awake::to_all)
        skipped.bonded_base.push_back(pair);
    std::sort(skipped.bonded_base.begin(), skipped.bonded_base.end());
    skipped.bonded_base.erase(std::unique(skipped.bonded_base.begin(), skipped.bonded_base.end()),
                              skipped.bonded_base.end());
    detection.set_skipped_pairs(skipped);
    return true;
  }



  StepResult BlockSolver::solve(DdaState                &state,
                                const BaseResponse      &base,
                                const double             dt,
                                const std::vector<Vec6> *guess)
  {
    if (model.n_mass() > 0) // joints carry all loads of the bedrock
      search_contacts(state);
    return iteration.solve(model, state, base, dt, guess);
  }



  void BlockSolver::search_contacts(DdaState &state)
  {
    const auto                     start          = std::chrono::steady_clock::now();
    const ContactDetection::Report before         = detection.report();
    const bool                     joints_changed = update_skipped_pairs(state);
    detection.set_was_awake(state.awake);
    detection.update(state.geometry, state.contacts, state.rest);
    if (joints_changed)
      hand_over_released_joints(model, state);
    part_opened_belts(model, state);
    state.awake.assign(awake.begin(), awake.end());
    ++search_summary.steps;
    search_summary.searches += detection.report().searches - before.searches;
    search_summary.lists += detection.report().builds - before.builds;
    search_summary.time +=
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
} // namespace hybrid::dda
