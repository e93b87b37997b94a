// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/continuum/surface_stiffness.h>

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace hybrid::continuum
{
  /**
   * Matrices A of one pattern, symmetric positive definite, condensed onto the unknowns of the
   * surface, which are the last ones:
   * @f[ S = A_{GG} - A_{GI} A_{II}^{-1} A_{IG} @f]
   * (Guyan 1965), with solutions of A_II and of A. One object holds the analysis of the pattern,
   * each Factor made from it the numbers of one matrix.
   */
  class Condensation
  {
  public:
    /// One matrix, factored.
    class Factor
    {
    public:
      virtual ~Factor() = default;
    };

    virtual ~Condensation() = default;

    virtual int size() const = 0;

    /// What a factor and making it take [B].
    virtual double factor_memory() const = 0;

    /// Factor the matrix with these entries. @throws std::runtime_error if it is not positive
    /// definite.
    virtual std::shared_ptr<Factor> factor(const std::vector<double> &values) = 0;

    /// S of it.
    virtual SurfaceStiffness surface_stiffness(const Factor &factor) const = 0;

    /// Begin a solution. @param g receives b_G - A_GI A_II^-1 b_I; no allocation.
    virtual void forward(Factor &factor, const std::vector<double> &b, Eigen::VectorXd &g) = 0;

    /// x with the surface unknowns given: x_I = A_II^-1 (b_I - A_IG x_G). Follows forward(); no
    /// allocation.
    virtual void
    backward(Factor &factor, const Eigen::VectorXd &surface, std::vector<double> &x) = 0;

    /// x = A^-1 b. Follows forward().
    virtual void backward(Factor &factor, std::vector<double> &x) = 0;

    /// x = A^-1 b, b zero but for @p load on the surface; forward() has to follow before
    /// backward().
    virtual void
    solve_load_on_surface(Factor &factor, const Eigen::VectorXd &load, std::vector<double> &x) = 0;

    /// b := A^-1 b for many right-hand sides; forward() and backward() are not disturbed.
    virtual void solve(const Factor &factor, Eigen::MatrixXd &b) = 0;
  };
} // namespace hybrid::continuum
