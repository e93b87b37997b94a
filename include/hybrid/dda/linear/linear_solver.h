// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/dda/linear/block_matrix.h>
#include <hybrid/dda/linear/interface_stiffness.h>
#include <hybrid/dda/linear/preconditioner_choice.h>
#include <hybrid/dda/linear/sparse_factor.h>
#include <hybrid/dda/linear/ssor_system.h>

#include <Eigen/Core>

#include <vector>

namespace hybrid::dda
{
  /**
   * Krylov solver for blocks and foundation nodes: conjugate gradients while the
   * matrix is symmetric, BiCGStab (van der Vorst 1992) while joints slide with
   * friction or soften.
   *
   * Preconditioner: a symmetric Gauss-Seidel sweep, or a sparse factor, of the matrix or of an
   * earlier one, whichever costs less (PreconditionerChoice, by counts: results are
   * deterministic). Preconditioner of the foundation (InterfaceStiffness): S with joints and
   * contacts before the blocks with sweeps, S alone after them with a factor. The blocks' motion is
   * in the factor's solution, so what is left for the nodes is S and the mass that it carries: soft
   * beside the joints between them. The factor of a symmetric matrix has the foundation in it.
   */
  class LinearSolver
  {
  public:
    /// From which the memory of sweeps is given back while factors serve (20 MB or more).
    static constexpr int many_blocks = SparseFactor::many_blocks;

    struct Result
    {
      bool   converged   = false;
      int    iterations  = 0;
      bool   factored    = false; ///< a new sparse factor was made
      double factor_time = 0.;    ///< that it took [s]
    };

    /// Share factors out among @p processes; before anything else.
    void set_processes(const ProcessGroup *processes)
    {
      factor.set_processes(processes);
    }

    /// The foundation's own stiffness S for the next solves, or none.
    void set_foundation_stiffness(const FoundationStiffness &stiffness)
    {
      foundation.set(stiffness);
    }

    /// The foundation's own stiffness.
    const InterfaceStiffness &foundation_stiffness() const
    {
      return foundation;
    }

    /// Slices of the blocks that threads share out, see SsorSystem.
    void set_slices(const std::vector<int> &slice_of_block)
    {
      ssor.set_slices(slice_of_block);
    }

    /// The matrix has changed in the rows of these blocks and in any of nodes: a sparse factor may
    /// be kept.
    void matrix_changed(const BlockMatrix &matrix, const std::vector<int> &blocks);

    /// What is kept from one step to the next, for the checkpoint; after the matrix.
    void serialize(restart::Archive &archive);

    /// The matrix is that of a checkpoint, and set_foundation_stiffness() has been called: make
    /// again what depends on both.
    void matrix_restored(const BlockMatrix &matrix);

    /// y = (K + S) x.
    void multiply(const BlockMatrix &matrix, const Eigen::VectorXd &x, Eigen::VectorXd &y) const;

    /// Solve (K + S) x = b from x = 0 to |residual| <= tolerance (absolute, weighted by @p scale).
    Result solve(const BlockMatrix     &matrix,
                 const Eigen::VectorXd &b,
                 const Eigen::VectorXd &scale,
                 double                 tolerance,
                 Eigen::VectorXd       &x);

    /// The same by sweeps alone; whatever was solved before has no influence. @param x what there
    /// is after @p limit iterations, if that is not enough
    Result solve_by_sweeps(const BlockMatrix     &matrix,
                           const Eigen::VectorXd &b,
                           const Eigen::VectorXd &scale,
                           double                 tolerance,
                           int                    limit,
                           Eigen::VectorXd       &x);

  private:
    /// When to stop.
    struct Target
    {
      const Eigen::VectorXd &scale;
      double                 tolerance;
      int                    limit; ///< of iterations

      bool met_by(const Eigen::VectorXd &residual) const
      {
        return residual.cwiseQuotient(scale).norm() <= tolerance;
      }
    };

    InterfaceStiffness   foundation;
    SsorSystem           ssor;
    SparseFactor         factor;
    PreconditionerChoice choice;
    bool                 factor_is_current = false;
    std::vector<int>     unswept;    ///< blocks whose rows the sweeps do not know yet
    std::vector<char>    is_unswept; ///< by block
    int                  unswept_pattern    = -1;
    bool                 sweeps_are_current = false;
    double n_entries    = 0.; ///< 6x6 blocks of the matrix that are not zero; below 0: not counted
    bool   is_symmetric = true;                        ///< the matrix to be solved
    Eigen::VectorXd unknown, r, p, q, z;               ///< work
    Eigen::VectorXd dual_r, dual_p, t, dual_t, shadow; ///< likewise, of those that need them

    void precondition(const BlockMatrix &matrix, const Eigen::VectorXd &residual);

    PreconditionerChoice::Costs costs(const BlockMatrix &matrix) const;

    /// Let the sweeps know what has changed.
    void prepare_sweeps(const BlockMatrix &matrix);

    /// Sweeps keep their memory though a factor serves: small masses ask for none in a step.
    bool keeps_sweeps(const BlockMatrix &matrix) const
    {
      return matrix.n_blocks() < many_blocks || !choice.uses_factor();
    }

    /// Give back the memory of the sweeps: a factor serves.
    void release_sweeps();

    struct Preconditioned; ///< swept system, as conjugate_gradients() and bicgstab() see it
    struct Factored;       ///< system with the factor, likewise

    // Both start from unknown = 0 and r. A system has a product (multiply), a scalar product (dual)
    // and knows when the residual of the original system is small enough (solved).
    Result conjugate_gradients(Preconditioned &system, int limit); ///< symmetric matrices only
    template <typename System>
    Result bicgstab(System &system, int limit);

    /// With the factor of a symmetric matrix and a foundation that is prescribed.
    Result conjugate_gradients(Factored &system, const Target &target);

    Result solve_by_sweeps(const BlockMatrix     &matrix,
                           const Eigen::VectorXd &b,
                           const Target          &target,
                           Eigen::VectorXd       &x);

    Result solve_with_factor(const BlockMatrix     &matrix,
                             const Eigen::VectorXd &b,
                             const Target          &target,
                             Eigen::VectorXd       &x);

    /// With the factor there is, or a new one.
    Result solve_with_factors(const BlockMatrix     &matrix,
                              const Eigen::VectorXd &b,
                              const Target          &target,
                              Eigen::VectorXd       &x);
  };
} // namespace hybrid::dda
