// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/linear/block_matrix.h>
#include <hybrid/dda/linear/linear_solver.h>

#include <Eigen/Core>

#include <vector>

namespace hybrid::dda
{
  /**
   * The rows and columns of the few blocks and foundation nodes that hold nearly all of a residual,
   * and of those around them.
   *
   * In a step inertia lets a force go no farther than a wave goes, a few blocks. So where single
   * contacts change their conditions, the system of their surroundings takes most of the residual
   * away at a small part of the cost (nonlinear elimination: Lanzkron, Rose and Wilkes 1996; Cai
   * and Keyes 2002).
   */
  class LocalSystem
  {
  public:
    /// What is left of the balance of blocks, then of nodes, and the scale of its norm.
    struct Residual
    {
      const Eigen::VectorXd &of_unknowns;
      const Eigen::VectorXd &scale;
    };

    /// Choose the bodies: those with the largest parts of the residual, so that all others have a
    /// fifth of its norm, and those coupled to them. @return false if they are more than 15 % of
    /// all, or 4,000, or all are fewer than 500
    bool choose(const BlockMatrix &matrix, const Residual &residual);

    /// Choose these blocks, ascending, and no others.
    void choose(const BlockMatrix &matrix, const std::vector<int> &blocks);

    /// Blocks that move, ascending.
    const std::vector<int> &blocks() const
    {
      return moving_blocks;
    }

    /// Foundation nodes that move, ascending.
    const std::vector<int> &nodes() const
    {
      return moving_nodes;
    }

    /// Blocks whose balance changes, ascending: those that move and all that may touch a body that
    /// moves.
    const std::vector<int> &changing_blocks() const
    {
      return changing;
    }

    /// Norm of the residual of the bodies that move.
    double norm(const Residual &residual) const;

    /// Solve for the update of the chosen bodies, all others held, to a norm of the residual of at
    /// most @p tolerance. @param foundation stiffness of all nodes, or none. @param x
    /// receives the update of all unknowns: what there is, if sweeps do not suffice
    void solve(const BlockMatrix         &matrix,
               const FoundationStiffness &foundation,
               const Residual            &residual,
               double                     tolerance,
               Eigen::VectorXd           &x);

  private:
    std::vector<int>    moving_blocks, moving_nodes, changing;
    int                 n_all_blocks = 0;
    std::vector<double> left;   ///< by body, blocks first: square of its residual
    std::vector<int>    bodies; ///< chosen, by the order in which they were
    std::vector<char>   chosen; ///< by body
    BlockMatrix         part;
    Eigen::MatrixXd     part_foundation;
    LinearSolver        solver;
    Eigen::VectorXd     part_residual, part_scale, part_update;
    std::vector<int>    part_blocks; ///< all of the part

    /// Take the bodies with the largest parts of the residual. @return false if they are more than
    /// @p most
    bool take_largest(const BlockMatrix &matrix, const Residual &residual, std::size_t most);

    /// The lists of what moves, the first bodies, and of what changes, all.
    void list_bodies(std::size_t n_moving);

    /// Take what is coupled to the bodies taken so far. @param with_nodes else blocks alone
    void grow(const BlockMatrix &matrix, bool with_nodes);

    void set_part(const BlockMatrix         &matrix,
                  const FoundationStiffness &foundation,
                  const Residual            &residual);
  };
} // namespace hybrid::dda
