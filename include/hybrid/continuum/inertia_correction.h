// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace hybrid::continuum
{
  /**
   * What the inertia of an element differs from its mass by so that the trapezoidal rule with steps
   * of dt keeps the period of the waves to fourth order.
   *
   * The rule turns a wave of frequency w with (2/dt) atan(w dt/2): it is late by (w dt)^2/12.
   * Inertia M - tau K with tau = dt^2/6 takes that back (Fox and Goodwin 1949; Newmark's scheme
   * with beta = 1/12), but only w dt < sqrt(6) stays stable. Here, per element and with X = M^-1 K,
   *   M (I + tau X + tau^2 X^2)^-1 = M - tau K + tau^3 M X^3 - ...,
   * which is positive for every dt: the trapezoidal rule stays stable, and high frequencies keep
   * more of its error. What moves as a rigid body has the inertia M.
   *
   * @param mass, stiffness of the element, symmetric [kg/m, Pa]; mass is positive definite.
   * @return the difference [kg/m], symmetric, never positive.
   */
  Eigen::MatrixXd
  inertia_correction(const Eigen::MatrixXd &mass, const Eigen::MatrixXd &stiffness, double dt);
} // namespace hybrid::continuum
