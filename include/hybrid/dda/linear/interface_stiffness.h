// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/linear/block_matrix.h>
#include <hybrid/dda/linear/foundation_stiffness.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <vector>

namespace hybrid::dda
{
  /**
   * The foundation's own stiffness S in the tangent, as a band, and factors that precondition
   * the foundation nodes: of S, and of S + P, where P is the symmetric part of what joints and
   * contacts add (BlockMatrix's K_nn) if that matters beside S, else zero.
   */
  class InterfaceStiffness
  {
  public:
    /// @p stiffness for the next steps, or none. Entries far from the diagonal that would not
    /// change the tangent by 1e-8 are dropped. Nothing is done if it is the same as before.
    void set(const FoundationStiffness &stiffness);

    /// Choose P again and factor it.
    void matrix_changed(const BlockMatrix &matrix);

    bool exists() const
    {
      return source.exists();
    }

    /// Distance from the diagonal beyond which entries of S are too small to matter in a factor.
    int near_width() const
    {
      return near;
    }

    /// S(i, j), or 0 beyond the tangent's band.
    double entry(const int i, const int j) const
    {
      const int below = std::abs(i - j);
      return below <= width ? band(below, std::min(i, j)) : 0.;
    }

    /// y -= S x for n entries, S to round-off: for residuals.
    void subtract_whole_product(const double *x, double *y) const;

    /// y += S x for n entries, as the tangent knows S.
    void add_product(const double *x, double *y) const;

    /// y += sign P x for n entries.
    void add_nodes(const double *x, double *y, double sign) const;

    /// @param d receives the diagonal of S + P; that of the unit matrix without a foundation.
    void diagonal(Eigen::Ref<Eigen::VectorXd> d) const;

    /// x = (S + P)^-1 x for n entries; without a foundation x stays.
    void solve(double *x) const;

    /// x = S^-1 x, likewise.
    void solve_alone(double *x) const;

  private:
    FoundationStiffness source;
    std::array<double, 4>
                    key{}; ///< a few entries of S, to notice another matrix at the same address
    int             size  = 0;
    int             near  = 0; ///< near_width()
    int             width = 0; ///< half band width of the tangent's S, at least that of P
    Eigen::MatrixXd band;      ///< rows r = 0, 1, ...: S(j + r, j), more than width
    Eigen::MatrixXf far;       ///< the rows after those, as far as they reach over round-off
    Eigen::MatrixXd foundation_factor;      ///< Cholesky factor of S, LAPACK lower band storage
    Eigen::MatrixXd joined_factor;          ///< of S + P
    bool            joined = false;         ///< P is not zero
    std::vector<Eigen::Matrix2d> own, next; ///< P between a node and itself or the next

    bool factorize(Eigen::MatrixXd &matrix) const;

    void solve_with(const Eigen::MatrixXd &factor, double *x) const;
  };
} // namespace hybrid::dda
