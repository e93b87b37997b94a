// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace hybrid::continuum
{
  /**
   * Supernodal Cholesky factor A = P^T L L^T P with the surface unknowns last, so that the trailing
   * block of L gives the condensed matrix: S = A_GG - A_GI A_II^-1 A_IG = L_GG L_GG^T. A step
   * solves with L_II only, so it reads neither L_GG nor S here.
   *
   * Every rank factors the whole matrix on its own: at the sizes of a section (1e4 to 1e5 unknowns)
   * two triangular solves take a few milliseconds, less than a distributed factor would spend on
   * messages.
   *
   * One object holds the ordering and the symbolic analysis of one sparsity pattern;
   * each Factor made from it holds the numbers of one matrix.
   */
  class CondensedFactorisation
  {
  public:
    /// One matrix, factored.
    class Factor;

    /**
     * @param column_start, row lower triangle by columns (diagonal included, rows ascending).
     * @param n_surface the last unknowns of the numbering are the surface's.
     */
    CondensedFactorisation(std::vector<int> column_start, std::vector<int> row, int n_surface);
    ~CondensedFactorisation();

    int size() const;

    /// What a factor and making it take [B].
    double factor_memory() const;

    /// Factor the matrix with these entries. @throws std::runtime_error if it is not positive
    /// definite.
    std::shared_ptr<Factor> factor(const std::vector<double> &values);

    /// S = L_GG L_GG^T.
    Eigen::MatrixXd surface_matrix(const Factor &factor) const;

    /// y = L_II^-1 b_I. @param g receives b_G - L_GI y = b_G - A_GI A_II^-1 b_I; no allocation.
    void forward(Factor &factor, const std::vector<double> &b, Eigen::VectorXd &g);

    /// x with the surface unknowns given: x_I = L_II^-T (y - L_GI^T x_G). Follows forward(); no
    /// allocation.
    void backward(Factor &factor, const Eigen::VectorXd &surface, std::vector<double> &x);

    /// b := A^-1 b for many right-hand sides; forward() and backward() are not disturbed.
    void solve(const Factor &factor, Eigen::MatrixXd &b);

    /// x = A^-1 b. Follows forward().
    void backward(Factor &factor, std::vector<double> &x);

    /// x = A^-1 b, b zero but for @p load on the surface; forward() has to follow before
    /// backward().
    void solve_load_on_surface(Factor &factor, const Eigen::VectorXd &load, std::vector<double> &x);

  private:
    struct Cholmod;

    /// Take the interior's part and L_GG from the numbers of a whole factor.
    void take_parts(const double *values, Factor &factor) const;

    /// b := S^-1 b, unknowns of the surface.
    template <typename Values>
    static void solve_surface(const Factor &factor, Values &b);

    std::unique_ptr<Cholmod> cholmod;
  };
} // namespace hybrid::continuum
