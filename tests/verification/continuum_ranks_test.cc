// SPDX-License-Identifier: GPL-3.0-or-later
// Run on several ranks: the answer must be that of a single rank (MPI_COMM_SELF) to 1e-10.
#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "continuum_check.h"
#include "rectangle_mesh.h"

#include <hybrid/scene/boundary/free_field_side.h>

namespace
{
  using namespace hybrid;
  using namespace hybrid::continuum;

  ContinuumState run(const MPI_Comm communicator, const int degree, const Newmark &newmark)
  {
    auto section =
      test::rectangle_mesh(test::equal_spacing(0., 100., 10), test::equal_spacing(0., 50., 5));
    for (int i = 0; i < 8; ++i)
      section.lines["bedding_1"].push_back({33 + i, 34 + i});
    test::add_block(section);
    auto scene                         = test::rock_scene();
    scene.continuum.degree             = degree;
    scene.continuum.sides              = scene::free_field_side();
    scene.continuum.rayleigh_stiffness = 1e-4;
    scene.bedding.names                = {"bedding_1"};
    scene.motion.angle                 = 20.;
    scene.time.newmark                 = newmark;
    Continuum continuum(section, scene, {test::ricker(10., 1e-3), scene.motion}, communicator);
    auto      state        = continuum.initial_state();
    Eigen::VectorXd lambda = Eigen::VectorXd::Zero(2 * continuum.surface_nodes().size());
    for (int k = 0; k < 200; ++k)
      {
        lambda[7]               = 1e6 * std::sin(0.1 * k);
        const Eigen::VectorXd g = continuum.predict(state, 1e-3);
        continuum.correct(state,
                          1e-3,
                          continuum.surface_stiffness(1e-3).dense().ldlt().solve(g + lambda),
                          lambda);
      }
    state.energy = continuum.audit_energy(state);
    return state;
  }

  void expect_equal(const std::vector<double> &a, const std::vector<double> &b)
  {
    ASSERT_EQ(a.size(), b.size());
    const double scale = test::largest(b);
    for (std::size_t i = 0; i < a.size(); ++i)
      ASSERT_NEAR(a[i], b[i], 1e-10 * scale) << "unknown " << i;
  }
} // namespace


TEST(Ranks, several_ranks_agree_with_one)
{
  int size = 0;
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  EXPECT_GE(size, 2) << "to be started by mpirun";
  Newmark fourth_order        = Newmark::preset("fourth order");
  fourth_order.corrected_step = 1e-3;
  for (const Newmark &newmark : {Newmark(), fourth_order})
    for (const int degree : {1, 2, 3})
      {
        const auto alone    = run(MPI_COMM_SELF, degree, newmark);
        const auto together = run(MPI_COMM_WORLD, degree, newmark);
        expect_equal(together.displacement, alone.displacement);
        expect_equal(together.velocity, alone.velocity);
        expect_equal(together.acceleration, alone.acceleration);
        EXPECT_NEAR(together.energy.strain / alone.energy.strain, 1., 1e-10);
        EXPECT_NEAR(together.energy.boundary_loss / alone.energy.boundary_loss, 1., 1e-10);
      }
}
