// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/inertia_correction.h>

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

namespace
{
  using namespace hybrid::continuum;
  using Eigen::Matrix3d;
  using Eigen::Vector3d;

  /// A bar of unit length, density and modulus as one element of degree 2 (nodes at 0, 1/2, 1).
  const Matrix3d mass = (Matrix3d() << 4., 2., -1., 2., 16., 2., -1., 2., 4.).finished() / 30.;
  const Matrix3d stiffness =
    (Matrix3d() << 7., -8., 1., -8., 16., -8., 1., -8., 7.).finished() / 3.;

  Eigen::VectorXd frequencies_squared(const Matrix3d &inertia)
  {
    return Eigen::GeneralizedSelfAdjointEigenSolver<Matrix3d>(stiffness, inertia).eigenvalues();
  }
} // namespace


TEST(InertiaCorrection, is_a_sixth_of_the_squared_step_times_stiffness)
{
  const double          dt   = 1e-3;
  const Eigen::MatrixXd lead = -dt * dt / 6. * stiffness;
  // the next term is tau^3 M X^3; X has the eigenvalues 0, 12, 60
  EXPECT_LT((inertia_correction(mass, stiffness, dt) - lead).norm(), 1e-10 * lead.norm());
}


TEST(InertiaCorrection, takes_back_what_the_trapezoidal_rule_adds_to_the_period)
{
  const Eigen::VectorXd exact = frequencies_squared(mass);
  double                late[2];
  for (const int level : {0, 1})
    {
      const double dt = level == 0 ? 0.1 : 0.05;
      const double w =
        std::sqrt(frequencies_squared(mass + inertia_correction(mass, stiffness, dt))[1]);
      late[level] = 2. / dt * std::atan(0.5 * w * dt) / std::sqrt(exact[1]) - 1.;
    }
  EXPECT_NEAR(exact[1], 12., 1e-12);
  EXPECT_NEAR(late[1] / late[0], 1. / 16., 0.01);
  EXPECT_LT(std::abs(late[0]), 0.1 * 0.01); // a tenth of (w dt)^2/12
}


TEST(InertiaCorrection, leaves_rigid_motion_alone_and_inertia_positive)
{
  for (const double dt : {1e-3, 0.1, 1., 100.})
    {
      const Eigen::MatrixXd added = inertia_correction(mass, stiffness, dt);
      EXPECT_LT((added * Vector3d::Ones()).norm(), 1e-11) << dt;
      EXPECT_LT((added - added.transpose()).norm(), 1e-15) << dt;
      const Eigen::VectorXd inertia =
        Eigen::GeneralizedSelfAdjointEigenSolver<Matrix3d>(mass + added, mass).eigenvalues();
      EXPECT_GT(inertia[0], 0.) << dt;
      EXPECT_NEAR(inertia[2], 1., 1e-11) << dt;
    }
}
