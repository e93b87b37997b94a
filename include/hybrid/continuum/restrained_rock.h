// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deal.II/lac/diagonal_matrix.h>
#include <deal.II/lac/precondition.h>

#include <hybrid/continuum/coarse_rock.h>
#include <hybrid/continuum/restrained_stiffness.h>

#include <vector>

namespace hybrid::continuum
{
  /**
   * Static displacement of the bedrock without a matrix, shared out among the ranks: K u = f with
   * RestrainedStiffness, so that it is the displacement of the factored system.
   *
   * Conjugate gradients, preconditioned by two levels: polynomials of Chebyshev in the diagonal
   * (Adams et al. 2003) before and after a correction by CoarseRock.
   */
  class RestrainedRock
  {
  public:
    using Vector = RestrainedStiffness::Vector;

    /// @param model its cells have to outlive this object.
    explicit RestrainedRock(const RestrainedModel &model);

    struct Solution
    {
      std::vector<double> displacement; ///< of this rank's unknowns [m]
      int                 iterations = 0;
      bool                converged  = false;
    };

    /// @param load on all unknowns [N/m]; what acts on supported ones counts for nothing.
    Solution solve(const std::vector<double> &load) const;

  private:
    using Diagonal = dealii::DiagonalMatrix<Vector>;
    using Smoother = dealii::PreconditionChebyshev<RestrainedStiffness, Vector, Diagonal>;

    /// Both levels, symmetric.
    struct Preconditioner
    {
      const RestrainedRock &rock;
      Vector               &work;

      void vmult(Vector &u, const Vector &residual) const;
    };

    const std::vector<int> &unknowns;
    RestrainedStiffness     stiffness;
    CoarseRock              coarse;
    Smoother                smoother;
  };
} // namespace hybrid::continuum
