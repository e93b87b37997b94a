// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <hybrid/continuum/slip_solver.h>

#include <cmath>
#include <random>

namespace
{
  using namespace hybrid;
  using namespace hybrid::continuum;

  constexpr PlaneStrength strength{0.5, 100., 40.};

  /// One point, sigma and tau without plastic jump given, in rock that lets go G = diag(1, 2)
  /// MPa/m.
  struct OnePoint
  {
    OnePoint(const double sigma, const double tau)
      : solver(1, strength)
    {
      traction << sigma, tau;
      settled = solver.solve({relaxation, traction, old}, failed);
      left    = traction -
             relaxation * Eigen::Vector2d(solver.jump()[0] - old[0], solver.jump()[1] - old[1]);
    }

    Eigen::MatrixXd     relaxation = Eigen::Vector2d(1e6, 2e6).asDiagonal();
    Eigen::VectorXd     traction{2};
    std::vector<double> old    = {0., 1e-4};
    std::vector<char>   failed = {0};
    SlipSolver          solver;
    bool                settled;
    Eigen::Vector2d     left; ///< sigma and tau after slip [Pa]
  };
} // namespace


TEST(SlipSolver, elastic_below_the_strength)
{
  const OnePoint p(-100., 149.); // strength 100 + 0.5 * 100
  EXPECT_TRUE(p.settled);
  EXPECT_EQ(p.solver.conditions()[0], PlaneCondition::elastic);
  EXPECT_EQ(p.solver.jump(), p.old);
  EXPECT_EQ(p.failed[0], 0);
}


TEST(SlipSolver, slips_at_the_strength_along_the_traction)
{
  for (const double sign : {1., -1.})
    {
      const OnePoint p(-100., sign * 350.);
      EXPECT_TRUE(p.settled);
      EXPECT_EQ(p.solver.conditions()[0], PlaneCondition::slipping);
      EXPECT_NEAR(p.left[1], sign * 150., 1e-9);
      EXPECT_NEAR(p.solver.jump()[1] - p.old[1], sign * 200. / 2e6, 1e-15);
      EXPECT_EQ(p.solver.jump()[0], 0.);
    }
}


TEST(SlipSolver, opens_beyond_the_tensile_strength_and_loses_it)
{
  const OnePoint intact(39., 10.), failed(41., 10.);
  EXPECT_EQ(intact.failed[0], 0);
  EXPECT_EQ(intact.solver.jump()[0], 0.);
  EXPECT_EQ(failed.failed[0], 1);
  EXPECT_EQ(failed.solver.conditions()[0], PlaneCondition::open);
  EXPECT_NEAR(failed.left.norm(), 0., 1e-9);
  EXPECT_NEAR(failed.solver.jump()[0], 41. / 1e6, 1e-15);
}


TEST(SlipSolver, a_broken_point_closes_where_it_was_and_has_friction_only)
{
  OnePoint p(41., 0.);
  p.old      = {41e-6, 1e-4};
  p.traction = Eigen::Vector2d(-100. - 41., 80.); // the opening gives 41 Pa back
  ASSERT_TRUE(p.solver.solve({p.relaxation, p.traction, p.old}, p.failed));
  EXPECT_EQ(p.solver.jump()[0], 0.);
  EXPECT_EQ(p.solver.conditions()[0], PlaneCondition::slipping);
  const double tau = p.traction[1] - 2e6 * (p.solver.jump()[1] - p.old[1]);
  EXPECT_NEAR(tau, 0.5 * 100., 1e-9);
}


// Coupled points, random loads: every condition holds at the end.
TEST(SlipSolver, meets_all_conditions_of_coupled_points)
{
  constexpr int                          n = 40;
  std::mt19937                           generator(5);
  std::uniform_real_distribution<double> random(-1., 1.);
  for (int load = 0; load < 200; ++load)
    {
      Eigen::MatrixXd a(2 * n, 2 * n);
      for (double &x : a.reshaped())
        x = random(generator);
      const Eigen::MatrixXd g =
        1e6 * (0.02 * a * a.transpose() + 0.2 * Eigen::MatrixXd::Identity(2 * n, 2 * n));
      Eigen::VectorXd t0(2 * n);
      for (int i = 0; i < n; ++i)
        t0.segment<2>(2 * i) << -100. + 150. * random(generator), 250. * random(generator);
      const std::vector<double> old(2 * n, 0.);
      std::vector<char>         failed(n, 0);
      SlipSolver                solver(n, strength);
      ASSERT_TRUE(solver.solve({g, t0, old}, failed)) << load;
      const Eigen::Map<const Eigen::VectorXd> p(solver.jump().data(), 2 * n);
      const Eigen::VectorXd                   t = t0 - g * p;
      for (int i = 0; i < n; ++i)
        {
          const double sigma = t[2 * i], tau = t[2 * i + 1], slip = p[2 * i + 1];
          const double limit = (failed[i] ? 0. : 100.) - 0.5 * sigma;
          EXPECT_GE(p[2 * i], -1e-12);
          EXPECT_LE(sigma, failed[i] ? 1e-6 : 40.);
          EXPECT_NEAR(p[2 * i] * sigma, 0., 1e-9);
          EXPECT_LE(std::abs(tau), limit + 1e-6);
          if (std::abs(slip) > 1e-12 && p[2 * i] == 0.)
            {
              EXPECT_NEAR(std::abs(tau), limit, 1e-6);
              EXPECT_GE(tau * slip, -1e-12);
            }
        }
    }
}
