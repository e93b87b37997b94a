// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/inertia_correction.h>

#include <Eigen/Eigenvalues>

namespace hybrid::continuum
{
  Eigen::MatrixXd
  inertia_correction(const Eigen::MatrixXd &mass, const Eigen::MatrixXd &stiffness, const double dt)
  {
    // In the modes V of the element, K V = M V L and V^T M V = 1, so that no step is too large.
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(stiffness, mass);
    const Eigen::ArrayXd  x     = dt * dt / 6. * modes.eigenvalues().array().max(0.);
    const Eigen::VectorXd added = 1. / (1. + x + x * x) - 1.;
    const Eigen::MatrixXd mv    = mass * modes.eigenvectors();
    return mv * added.asDiagonal() * mv.transpose();
  }
} // namespace hybrid::continuum
