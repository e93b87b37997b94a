// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hybrid/continuum/substitution_plan.h>

#include <Eigen/Core>

namespace hybrid::continuum
{
  /**
   * Substitutions with the interior's part [L_II; L_GI] of a Cholesky factor. What they cost is
   * reading its numbers, once each (SubstitutionPlan::pack()). Threads share the subtrees; the
   * bits do not depend on their number.
   */
  class Substitution
  {
  public:
    explicit Substitution(const SubstitutionPlan &substitution_plan);

    /// y = L_II^-1 b_I, which is kept. @param g receives b_G - L_GI y.
    void forward(const double *factor, const double *b, Eigen::VectorXd &g);

    /// x_I = L_II^-T (y - L_GI^T x_G); y of the last forward(). @param x in the order of b
    void backward(const double *factor, const Eigen::VectorXd &surface, double *x);

    /// The same with y = 0; the last forward() is not disturbed.
    void backward_from_surface(const double *factor, const Eigen::VectorXd &surface, double *x);

    /// g of the last forward().
    Eigen::Map<const Eigen::VectorXd> surface_load() const;

  private:
    void forward_part(const SubstitutionPlan::Part &part, const double *factor);

    /// @param from y of all parts
    void backward_part(const SubstitutionPlan::Part &part,
                       const double                 *factor,
                       const double                 *from,
                       double                       *x);

    void backward_from(const double          *from,
                       const double          *factor,
                       const Eigen::VectorXd &surface,
                       double                *x);

    const SubstitutionPlan &plan;
    bool                    is_shared; ///< by threads
    std::vector<double>     left;      ///< y of all parts
    std::vector<double>     none;      ///< y = 0
    std::vector<double>     solution;  ///< x of all parts
  };
} // namespace hybrid::continuum
