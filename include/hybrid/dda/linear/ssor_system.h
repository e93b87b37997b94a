// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/linear/block_matrix.h>
#include <hybrid/dda/linear/interface_stiffness.h>
#include <hybrid/dda/linear/sweep_order.h>

#include <Eigen/Core>

#include <vector>

namespace hybrid::dda
{
  /**
   * The system A x = b of blocks and foundation nodes, preconditioned by one
   * symmetric Gauss-Seidel sweep over blocks, then nodes.
   *
   * With A = L + D_A + U, D the 6x6 diagonal blocks and the foundation's S + P
   * (InterfaceStiffness; the unit matrix without a foundation), it reads
   * @f[ \hat A \hat x = \hat b, \quad \hat A = (D+L)^{-1} A (D+U)^{-1} D, \quad
   *     \hat b = (D+L)^{-1} b, \quad x = (D+U)^{-1} D \hat x. @f]
   * In Eisenstat's (1981) form a product with @f$ \hat A @f$ is one backward and one
   * forward sweep, so it costs no more than a product with A, and takes about
   * half as many iterations as diagonal blocks alone. @f$ \hat A @f$ is symmetric in the
   * scalar product of D if A is symmetric. "Below" means visited earlier by a
   * sweep (SweepOrder): the same bits for any number of threads.
   */
  class SsorSystem
  {
  public:
    /// Slice of each block, which threads share out (SweepOrder); without, or of another number of
    /// blocks: one.
    void set_slices(const std::vector<int> &slice_of_block);

    /// The matrix has changed in the rows of these blocks: copy them in the order of the sweeps and
    /// invert their diagonal blocks; all rows where another matrix or pattern was set before.
    /// Matrix and foundation must outlive the use.
    void set(const BlockMatrix        &block_matrix,
             const InterfaceStiffness &foundation_band,
             const std::vector<int>   &blocks);

    /// A matrix has been set.
    bool is_set() const
    {
      return version >= 0;
    }

    /// Give the memory back: the next set() copies all rows.
    void release();

    /// @f$ y = \hat A x @f$.
    void multiply(const Eigen::VectorXd &x, Eigen::VectorXd &y);

    /// @f$ \hat b @f$ of b.
    void sweep_forward(const Eigen::VectorXd &b, Eigen::VectorXd &result);

    /// x of @f$ \hat x @f$.
    void sweep_backward(const Eigen::VectorXd &hat, Eigen::VectorXd &x);

    /// 6x6 blocks that a product reads.
    double n_entries() const;

    /// y = D x.
    void multiply_diagonal(const Eigen::VectorXd &x, Eigen::VectorXd &y) const;

    /// Diagonal of D.
    const Eigen::VectorXd &weights() const
    {
      return weight;
    }

    /// y = (D + L) x: the residual of A from that of the swept system.
    void undo_forward(const Eigen::VectorXd &x, Eigen::VectorXd &y) const;

  private:
    const BlockMatrix        *matrix     = nullptr;
    const InterfaceStiffness *foundation = nullptr;
    std::vector<int>          slice;
    int                       version = -1; ///< of the pattern that the rows were ordered for
    SweepOrder                order;
    std::vector<int>          row_begin;  ///< CSR over places of the sweep
    std::vector<int>          row_middle; ///< first entry of each row that a sweep visits later
    std::vector<int>          neighbour;  ///< block of each entry
    std::vector<int>          slot; ///< of each entry in the matrix; complement: in its lower part
    // L and U as a sweep reads them: the entries that are not zero (pairs that touch), from the
    // begin and from the middle of each row on.
    std::vector<int>  below_end;
    std::vector<int>  above_end;
    std::vector<int>  column; ///< block of each
    std::vector<Mat6> entry;
    std::vector<Mat6> inverse_diagonal; ///< in the order of the sweep
    Eigen::VectorXd   above;            ///< product with U [6 blocks], of the last backward sweep
    Eigen::VectorXd   weight;           ///< diagonal of D
    Eigen::VectorXd   place;            ///< (D + U)^-1 D x

    void order_rows();

    /// Copy one row.
    void set_row(int block);

    /// Entries @p first to @p last of a row times x.
    Vec6 product(int first, int last, const Eigen::VectorXd &x) const;
  };
} // namespace hybrid::dda
