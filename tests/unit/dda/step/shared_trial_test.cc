// SPDX-License-Identifier: GPL-3.0-or-later
#include "block_scenes.h"
#include "thread_group.h"

#include <hybrid/dda/step/shared_trial.h>

#include <gtest/gtest.h>

#include <omp.h>

#include <functional>
#include <set>

namespace
{
  using namespace hybrid;
  using namespace hybrid::dda;
  using namespace hybrid::test;

  using MakeRun = std::function<std::unique_ptr<FixedBaseRun>()>;

  /// A heap of loose squares that falls on a slope and slides.
  std::unique_ptr<FixedBaseRun> sliding_heap()
  {
    auto run = std::make_unique<FixedBaseRun>(square_blocks(4, 3, 1., 0.4),
                                              block_parameters(25.),
                                              straight_foundation(0.4, 2., 20., 5));
    for (std::size_t b = 0; b < run->state.blocks.size(); ++b)
      run->state.blocks[b].velocity = 0.1 * Vec6::LinSpaced(-1., 1. + 0.1 * static_cast<double>(b));
    return run;
  }

  /// A wall of bonded squares, pressed together below and torn apart above; its blocks yield.
  std::unique_ptr<FixedBaseRun> breaking_wall()
  {
    scene::SceneParameters p             = block_parameters(30.);
    p.blocks.bonded                      = true;
    p.blocks.fracture_energy             = 10.;
    p.materials["rock"].tensile_strength = 2e4;
    p.materials["rock"].cohesion         = 5e4;
    p.blocks.yielding                    = true;
    p.time.newmark.filter                = 0.1;
    auto run =
      std::make_unique<FixedBaseRun>(square_blocks(6, 3), p, straight_foundation(0., 2., 10., 12));
    for (std::size_t b = 0; b < run->state.blocks.size(); ++b)
      run->state.blocks[b].velocity[0] = (b % 6 < 3) == (b < 12) ? 1. : -1.;
    return run;
  }

  std::vector<double> numbers_of(const DdaState &state)
  {
    std::vector<double> all;
    const auto          add = [&](const auto &vector) {
      all.insert(all.end(), vector.data(), vector.data() + vector.size());
    };
    for (const BlockState &b : state.blocks)
      {
        add(b.centroid);
        add(b.velocity);
        add(b.acceleration);
        add(b.contact_acceleration);
        add(b.acceleration_change);
        add(b.stress);
      }
    for (const JointState &j : state.joints)
      {
        for (const SpringState &p : j.points)
          all.insert(all.end(), {p.gap, p.slip, p.normal, p.shear, p.history.damage});
        add(j.force_change);
        all.push_back(j.failure_time);
      }
    for (const Contact &c : state.contacts)
      all.insert(all.end(), {c.edge_position, c.slip, c.pressed_gap});
    add(state.foundation_force);
    const BlockEnergy &e = state.energy;
    all.insert(all.end(), {state.time, e.balance(), e.friction_loss, e.fracture_loss, e.kinetic});
    return all;
  }

  /// What @p n_steps steps of 2 ms come to, after each.
  std::vector<std::vector<double>> history(FixedBaseRun &run, const int n_steps)
  {
    std::vector<std::vector<double>> result;
    for (int k = 0; k < n_steps; ++k)
      {
        EXPECT_TRUE(run.advance(2e-3, 6));
        result.push_back(numbers_of(run.state));
      }
    return result;
  }

  void expect_the_bits_of_one(const MakeRun &scene, const int n_steps)
  {
    const auto alone    = scene();
    const auto expected = history(*alone, n_steps);
    EXPECT_GT(alone->iterations, n_steps);
    for (const int n : {2, 3, 20})
      {
        ThreadGroup      group(n);
        std::vector<int> equal(n, 0);
        group.run([&](const ProcessGroup &processes) {
          omp_set_num_threads(1);
          const auto run          = scene();
          run->model.processes    = {std::shared_ptr<void>(), &processes};
          equal[processes.rank()] = history(*run, n_steps) == expected ? 1 : 0;
        });
        EXPECT_EQ(equal, std::vector<int>(n, 1));
        EXPECT_GT(group.received(), 0U);
      }
  }
} // namespace



TEST(SharedTrial, loose_blocks_have_the_bits_of_one_process)
{
  expect_the_bits_of_one(sliding_heap, 40);
}



TEST(SharedTrial, bonded_blocks_that_break_and_yield_have_the_bits_of_one_process)
{
  const auto run = breaking_wall();
  ASSERT_TRUE(run->run(0.04, 2e-3));
  int failed = 0;
  for (const JointState &joint : run->state.joints)
    failed += joint.failure != FailureKind::none ? 1 : 0;
  ASSERT_GT(failed, 0);
  ASSERT_GT(run->state.energy.yield_loss, 0.);
  expect_the_bits_of_one(breaking_wall, 20);
}



TEST(SharedTrial, every_spring_is_evaluated_by_the_owners_of_its_blocks)
{
  const auto run = breaking_wall();
  Springs    springs;
  springs.collect(run->model, run->state);
  ThreadGroup                   group(3);
  std::vector<std::set<int>>    blocks(3), own(3);
  std::vector<std::vector<int>> others(3);
  group.run([&](const ProcessGroup &processes) {
    Model model     = run->model;
    model.processes = {std::shared_ptr<void>(), &processes};
    SharedTrial shared;
    EXPECT_FALSE(shared.is_on());
    shared.begin(model, run->state, springs);
    EXPECT_TRUE(shared.is_on());
    blocks[processes.rank()] = {shared.blocks().begin(), shared.blocks().end()};
    own[processes.rank()]    = {shared.springs().begin(), shared.springs().end()};
    others[processes.rank()] = shared.other_springs();
  });
  std::size_t n = 0;
  for (int p = 0; p < 3; ++p)
    {
      n += blocks[p].size();
      EXPECT_EQ(own[p].size() + others[p].size(), springs.bodies.size());
      for (std::size_t s = 0; s < springs.bodies.size(); ++s)
        {
          const auto [block, other, node] = springs.bodies[s];
          const bool expected =
            other == foundation_body || blocks[p].count(block) + blocks[p].count(other) > 0;
          EXPECT_EQ(own[p].count(static_cast<int>(s)) > 0, expected) << p << ' ' << s;
        }
    }
  EXPECT_EQ(n, run->model.blocks.size());
}



TEST(SharedTrial, the_mass_is_cut_anew_where_springs_connect_others)
{
  const auto run = sliding_heap();
  Springs    springs;
  springs.collect(run->model, run->state);
  ThreadGroup       group(2);
  std::vector<bool> same(2, false), moved(2, false);
  std::vector<int>  far{0, 0};
  group.run([&](const ProcessGroup &processes) {
    Model model       = run->model;
    model.processes   = {std::shared_ptr<void>(), &processes};
    DdaState    state = run->state;
    Springs     own   = springs;
    SharedTrial shared;
    shared.begin(model, state, own);
    const int me = processes.rank(), b = shared.blocks().front();
    far[me]                       = b;
    const std::vector<int> before = shared.blocks();
    state.blocks[b].centroid += (me == 0 ? 30. : -30.) * Vec2(1., 0.);
    shared.begin(model, state, own);
    same[me] = shared.blocks() == before;
    state.contacts.push_back({});
    state.contacts.back().vertex_body = 0;
    state.contacts.back().edge_body   = 1;
    state.contacts.back().edge        = 4;
    own.collect(model, state);
    shared.begin(model, state, own);
    moved[me] = !shared.owns(b);
  });
  EXPECT_EQ(same, std::vector<bool>(2, true));
  EXPECT_EQ(moved, std::vector<bool>(2, true));
}



TEST(SharedTrial, one_process_shares_nothing)
{
  const auto  run = sliding_heap();
  Springs     springs;
  SharedTrial shared;
  springs.collect(run->model, run->state);
  shared.begin(run->model, run->state, springs);
  EXPECT_FALSE(shared.is_on());
}
