// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>

#include <Eigen/Core>

#include <vector>

namespace hybrid::continuum
{
  /// How the integrals of masses and dashpots are made.
  enum class MassQuadrature
  {
    gauss,  ///< exactly
    lobatto ///< on the nodes themselves: the matrix is diagonal
  };


  /**
   * Lagrange polynomials on the Gauss-Lobatto nodes of [0, 1]: the one-dimensional
   * basis of the rock's elements, of their edges and of the free-field columns.
   */
  class LagrangeLine
  {
  public:
    explicit LagrangeLine(int degree, MassQuadrature of_mass = MassQuadrature::gauss);

    int degree() const
    {
      return static_cast<int>(points.size()) - 1;
    }

    const std::vector<double> &nodes() const
    {
      return points;
    }

    double value(int i, double x) const
    {
      return basis[i].value(x);
    }

    double derivative(int i, double x) const
    {
      double value_and_derivative[2];
      basis[i].value(x, 1, value_and_derivative);
      return value_and_derivative[1];
    }

    /// Gauss points of [0, 1], one more than the degree: what the integrals below are made with,
    /// but for a mass by Lobatto's.
    const dealii::QGauss<1> &quadrature() const
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
    dealii::QGauss<1>                                    gauss;
    std::vector<dealii::Polynomials::Polynomial<double>> basis;
    std::vector<double>                                  points;
    Eigen::MatrixXd                                      m, k, b;
  };
} // namespace hybrid::continuum
