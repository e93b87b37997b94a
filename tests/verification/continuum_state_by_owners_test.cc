// SPDX-License-Identifier: GPL-3.0-or-later
// Run on several ranks: a state of waves that they share holds the nodes of its rank and those that
// all know, and moves as that of a single rank (MPI_COMM_SELF).
#include <gtest/gtest.h>

#include "continuum_check.h"
#include "rectangle_mesh.h"

#include <hybrid/continuum/ownership.h>
#include <hybrid/scene/boundary/free_field_side.h>

namespace
{
  using namespace hybrid;
  using namespace hybrid::continuum;

  constexpr double dt = 2e-3; ///< [s]

  scene::SectionMesh section_with_plane()
  {
    auto section =
      test::rectangle_mesh(test::equal_spacing(0., 100., 10), test::equal_spacing(0., 60., 6));
    for (int i = 0; i < 8; ++i)
      section.lines["bedding_1"].push_back({33 + i, 34 + i});
    return section;
  }

  scene::SceneParameters scene_of(const bool is_explicit)
  {
    auto scene                         = test::rock_scene();
    scene.blocks.enabled               = false;
    scene.continuum.degree             = 4;
    scene.continuum.sides              = scene::free_field_side();
    scene.continuum.rayleigh_stiffness = 1e-5;
    scene.maxwell.bedrock_ratio        = 0.02;
    scene.bedding.names                = {"bedding_1"};
    scene.motion.angle                 = 20.;
    scene.continuum.is_explicit        = is_explicit;
    scene.continuum.linear_solver      = scene::LinearSolver::conjugate_gradients;
    scene.time.newmark                 = Newmark::preset(is_explicit ? "trapezoidal" : "filtered");
    if (is_explicit)
      scene.time.newmark.beta = 0.;
    scene.initial_wave.type      = scene::WaveType::shear;
    scene.initial_wave.centre    = Vec2(50., 30.);
    scene.initial_wave.direction = 60.;
    scene.initial_wave.frequency = 20.;
    scene.initial_wave.length    = 0.5;
    scene.initial_wave.width     = 0.5;
    return scene;
  }

  /// Waves of which some points are watched.
  struct Waves
  {
    Continuum                     rock;
    std::vector<Continuum::Point> points;
    ContinuumState                state;

    Waves(const bool is_explicit, const MPI_Comm communicator)
      : rock(section_with_plane(),
             scene_of(is_explicit),
             {test::ricker(10., 1e-3), scene_of(is_explicit).motion},
             communicator)
    {
      for (const Vec2 &at : {Vec2(13., 17.), Vec2(77., 55.), Vec2(50., 30.)})
        points.push_back(rock.point(at));
      rock.watch(points);
      state = rock.initial_state();
      rock.start_wave(state);
    }

    void run(const int steps)
    {
      for (int k = 0; k < steps; ++k)
        ASSERT_TRUE(rock.step(state, dt));
      rock.collect(state, true);
    }
  };

  /// Of nodes that are @p at in the state of a rank, what that of one rank alone has there.
  void expect_part(const std::vector<double> &part,
                   const std::vector<double> &all,
                   const HeldNodes           &held,
                   const std::vector<int>    &nodes)
  {
    const double scale = test::largest(all);
    ASSERT_GT(scale, 0.);
    for (const int node : nodes)
      for (int c = 0; c < 2; ++c)
        ASSERT_NEAR(part[2 * held.slot(node) + c], all[2 * node + c], 1e-9 * scale) << node;
  }

  std::vector<int> own_nodes(const Ownership &ownership)
  {
    std::vector<int> nodes;
    for (std::size_t k = 0; k < ownership.unknowns().size(); k += 2)
      nodes.push_back(ownership.unknowns()[k] / 2);
    return nodes;
  }
} // namespace



class StateByOwners : public testing::TestWithParam<bool>
{};

INSTANTIATE_TEST_SUITE_P(Steps, StateByOwners, testing::Bool());



TEST_P(StateByOwners, holds_what_its_rank_has_to_know_and_moves_as_that_of_one_rank)
{
  Waves together(GetParam(), MPI_COMM_WORLD), alone(GetParam(), MPI_COMM_SELF);
  ASSERT_NE(together.rock.ownership(), nullptr) << "to be started by mpirun";
  ASSERT_EQ(alone.rock.ownership(), nullptr);
  const Ownership  &ownership = *together.rock.ownership();
  const HeldNodes  &held      = ownership.held();
  const std::size_t columns   = alone.state.velocity.size() - alone.rock.n_unknowns();
  ASSERT_GT(columns, 0u);
  EXPECT_EQ(together.state.velocity.size(), 2 * held.size() + columns);
  EXPECT_EQ(2 * held.size(), ownership.unknowns().size() + 2 * held.others().size());
  EXPECT_LT(held.size(), 0.7 * alone.rock.n_unknowns() / 2);

  together.run(60);
  alone.run(60);
  std::vector<int> known = held.others(), own = own_nodes(ownership);
  const auto      &a = together.state, &b = alone.state;
  expect_part(a.displacement, b.displacement, held, own);
  expect_part(a.velocity, b.velocity, held, own);
  expect_part(a.acceleration, b.acceleration, held, own);
  expect_part(a.velocity, b.velocity, held, known);
  const double scale = test::largest(b.velocity);
  for (std::size_t k = 1; k <= columns; ++k)
    EXPECT_NEAR(a.velocity[a.velocity.size() - k], b.velocity[b.velocity.size() - k], 1e-9 * scale);
  for (std::size_t k = 0; k < together.points.size(); ++k)
    {
      const Vec2 here  = together.rock.sample(a, together.points[k]).velocity;
      const Vec2 there = alone.rock.sample(b, alone.points[k]).velocity;
      EXPECT_LT((here - there).norm(), 1e-9 * scale);
    }
}



TEST_P(StateByOwners, is_read_from_the_vectors_of_one_rank)
{
  Waves together(GetParam(), MPI_COMM_WORLD), alone(GetParam(), MPI_COMM_SELF);
  alone.run(20);
  std::vector<double> &contacts = alone.state.contact_acceleration; // as where blocks push
  contacts                      = {alone.state.acceleration.begin(),
                                   alone.state.acceleration.begin() +
                                     static_cast<std::ptrdiff_t>(alone.rock.n_unknowns())};
  ContinuumState read           = together.rock.initial_state();
  read.time                     = alone.state.time;
  read.last_step                = alone.state.last_step;
  read.energy                   = alone.state.energy;
  std::vector<const std::vector<double> *> whole;
  for (const auto *vector : {&alone.state.displacement,
                             &alone.state.velocity,
                             &alone.state.acceleration,
                             &alone.state.acceleration_change,
                             &contacts,
                             &alone.state.maxwell.strain})
    if (!vector->empty())
      whole.push_back(vector);
  ASSERT_EQ(whole.size(), GetParam() ? 5u : 6u);
  std::size_t k = 0;
  for (const restart::SharedVector &vector : together.rock.shared_vectors(read))
    {
      ASSERT_LT(k, whole.size());
      ASSERT_EQ(vector.length(), whole[k]->size());
      for (std::size_t block = 0; block < vector.blocks; ++block)
        vector.take(block,
                    reinterpret_cast<const char *>(whole[k]->data() +
                                                   block * (vector.shared + vector.alike)));
      ++k;
    }
  EXPECT_EQ(k, whole.size());
  const Ownership &ownership = *together.rock.ownership();
  expect_part(read.contact_acceleration, contacts, ownership.held(), own_nodes(ownership));
  read.contact_acceleration.clear();
  contacts.clear();
  together.state = read;
  together.run(20);
  alone.run(20);
  expect_part(together.state.velocity,
              alone.state.velocity,
              ownership.held(),
              own_nodes(ownership));
  for (std::size_t p = 0; p < alone.points.size(); ++p)
    EXPECT_LT((together.rock.sample(together.state, together.points[p]).acceleration -
               alone.rock.sample(alone.state, alone.points[p]).acceleration)
                .norm(),
              1e-9 * test::largest(alone.state.acceleration));
}
