// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/block_matrix.h>
#include <hybrid/dda/sparse_factor.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <vector>

namespace hybrid::dda
{
  /**
   * Krylov solver for blocks and base nodes: conjugate gradients while the
   * matrix is symmetric, BiCGStab while joints slide with friction or soften.
   *
   * Preconditioner of the blocks: their 6x6 diagonal blocks where inertia
   * dominates (small steps, soft joints), or a sparse factor of an
   * earlier matrix, kept until it serves badly (static stage, stiff joints).
   * The choice follows iteration counts only, so results are deterministic.
   * Preconditioner of the base: the Cholesky factor of S.
   */
  class LinearSolver
  {
  public:
    struct Result
    {
      bool converged  = false;
      int  iterations = 0;
      bool factored   = false; ///< a new sparse factor was made
    };

    /// The base's own stiffness S (n x n, symmetric positive definite) for the next solves;
    /// nullptr: none. Entries below round-off are dropped: it is kept as a band.
    void set_base_stiffness(const Eigen::MatrixXd *stiffness);

    /// The matrix has changed: its diagonal blocks are inverted anew; a sparse factor may be kept.
    void matrix_changed(const BlockMatrix &matrix);

    /// y = (K + S) x.
    void multiply(const BlockMatrix &matrix, const Eigen::VectorXd &x, Eigen::VectorXd &y) const;

    /// Solve (K + S) x = b from x = 0 to |residual| <= tolerance (absolute, weighted by @p scale).
    Result solve(const BlockMatrix     &matrix,
                 const Eigen::VectorXd &b,
                 const Eigen::VectorXd &scale,
                 double                 tolerance,
                 Eigen::VectorXd       &x);

  private:
    const Eigen::MatrixXd *base_source = nullptr;
    std::vector<double>
                    base_key;  ///< a few entries of S, to notice another matrix at the same address
    int             band = 0;  ///< half band width of S
    Eigen::MatrixXd base_band; ///< rows 0..band: S(j + r, j), LAPACK lower band storage
    Eigen::MatrixXd base_factor; ///< its Cholesky factor, same storage
    std::vector<Mat6> inverse_diagonal;
    SparseFactor      factor;
    bool              use_factor        = false;
    bool              factor_is_current = false;
    Eigen::VectorXd   r, z, p, q, t, shadow;

    void precondition(const Eigen::VectorXd &residual, Eigen::VectorXd &result);

    /// From x = 0 and r = b.
    Result conjugate_gradients(const BlockMatrix     &matrix,
                               const Eigen::VectorXd &scale,
                               double                 tolerance,
                               int                    limit,
                               Eigen::VectorXd       &x);

    /// The same for unsymmetric matrices.
    Result stabilised_gradients(const BlockMatrix     &matrix,
                                const Eigen::VectorXd &scale,
                                double                 tolerance,
                                int                    limit,
                                Eigen::VectorXd       &x);

    Result iterate(const BlockMatrix     &matrix,
                   const Eigen::VectorXd &b,
                   const Eigen::VectorXd &scale,
                   double                 tolerance,
                   int                    limit,
                   Eigen::VectorXd       &x);
  };
} // namespace hybrid::dda
