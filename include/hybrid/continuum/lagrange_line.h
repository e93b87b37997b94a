// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <vector>

namespace hybrid::continuum
{
  /**
   * Lagrange polynomials on the Gauss-Lobatto nodes of [0, 1]: the one-dimensional
   * basis of the rock's elements, of their edges and of the free-field columns.
   */
  class LagrangeLine
  {
  public:
    explicit LagrangeLine(int degree);

    int degree() const
    {
      return static_cast<int>(points.size()) - 1;
    }

    const std::vector<double> &nodes() const
    {
      return points;
    }

    double value(int i, double x) const;

    double derivative(int i, double x) const;

    /// Gauss points of [0, 1], one more than the degree: what the integrals below are made with.
    struct Quadrature
    {
      std::vector<double> points, weights;
    };

    const Quadrature &quadrature() const
    {
      return gauss;
    }

    /// int_0^1 N_i N_j dx
    const Eigen::MatrixXd &mass() const
    {
      return m;
    }

    /// int_0^1 N_i' N_j' dx
    const Eigen::MatrixXd &stiffness() const
    {
      return k;
    }

    /// int_0^1 N_i N_j' dx
    const Eigen::MatrixXd &gradient() const
    {
      return b;
    }

    /**
     * Of a uniform load between nodes i and i + 1, the part that node i bears [-], so
     * that all nodes together bear their int N_i dx. Half for degree 1, a third at the ends of
     * degree 2.
     */
    std::vector<double> load_shares() const;

  private:
    std::vector<double> points;
    Eigen::MatrixXd     m, k, b;
    Quadrature          gauss;
  };
} // namespace hybrid::continuum
