// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <functional>

namespace hybrid::continuum
{
  /// S times the columns of a matrix.
  using SurfaceProduct = std::function<Eigen::MatrixXd(const Eigen::MatrixXd &)>;

  /**
   * The band of a symmetric matrix S of which only products are known and whose entries fall away
   * from the diagonal, as those of a dynamic stiffness do: a force goes no farther in a step than a
   * wave.
   *
   * Columns so far apart that they do not reach the same rows are found with one product (Curtis,
   * Powell & Reid 1974). How far they reach is seen in a few columns, and the band is tried on a
   * vector of signs: where S and the band differ by more than 1e-11 of the diagonal it is made
   * anew, twice as wide, in the end with all entries.
   *
   * @param scale positive, no less than the diagonal of S; entries of less than its round-off are
   * left out
   * @param noise of entries of the products, over the diagonal, if that is more than a double's
   * @return rows r: S(j + r, j) in column j
   */
  Eigen::MatrixXd
  surface_band(const SurfaceProduct &product, const Eigen::VectorXd &scale, double noise = 0.);

  /// Columns that surface_band() asks for in one product, at most.
  constexpr int columns_of_product = 16;

  /// Cholesky factor of a band, in its place. @throws std::runtime_error if S is not positive
  /// definite.
  void factorise_band(Eigen::MatrixXd &band);

  /// b := S^-1 b. @param factor by factorise_band()
  void solve_band(const Eigen::MatrixXd &factor, double *b);
} // namespace hybrid::continuum
