// SPDX-License-Identifier: GPL-3.0-or-later
// Newton's method with a line search by the laws alone.
#include <hybrid/dda/step/open_close_iteration.h>

#include <algorithm>
#include <cmath>

namespace hybrid::dda
{
  namespace
  {
    /// Fraction of the @p residual that the linear solver may leave: the faster the residual falls,
    /// the less (Eisenstat and Walker 1996, choice 2).
    double forcing_term(const double residual, const double previous)
    {
      constexpr double max_term = 1e-3, factor = 0.1;
      const double     ratio = residual / previous;
      return std::min(max_term, factor * ratio * ratio);
    }
  } // namespace



  LineSearch OpenCloseIteration::search_line()
  {
    // Work of the residual along the update; zero at the best place. Falling work is followed to
    // its end: only a spring that grew stiffer on the way can turn its sign. No search where the
    // unsymmetric tangent points uphill.
    constexpr double       good_fraction = 0.3;
    constexpr int          maximum_cuts  = 10;
    const Eigen::VectorXd &residual      = problem.left().of_unknowns;
    const double           start         = residual.dot(update);
    double                 lower = 0., upper = 1., work_lower = start, work_upper = 0.;
    double                 fraction = 1., done = 0.;
    for (int cut = 0;; ++cut)
      {
        problem.move(update, fraction - done);
        done              = fraction;
        const double norm = problem.evaluate();
        const double work = residual.dot(update);
        if (start <= 0. || cut == maximum_cuts || !std::isfinite(norm) ||
            std::abs(work) <= good_fraction * start || (cut == 0 && work > 0.))
          return {norm, done};
        // Regula falsi; an end that stays is given half its weight (Illinois).
        if (work > 0.)
          {
            lower      = fraction;
            work_lower = work;
            work_upper *= 0.5;
          }
        else
          {
            upper      = fraction;
            work_upper = work;
            work_lower *= cut > 0 ? 0.5 : 1.;
          }
        const double zero = work_lower / (work_lower - work_upper);
        fraction          = lower + std::min(0.95, std::max(0.05, zero)) * (upper - lower);
      }
  }



  Attempt OpenCloseIteration::search(StepResult &result)
  {
    constexpr int    stall_window     = 10;
    constexpr double stalled_fraction = 0.3;
    const Model     &model            = *problem.model;
    const int        first            = result.iterations;
    problem.evaluate_alone();
    tangent_conditions.clear(); // it is one of the laws from now on
    double window_start = std::numeric_limits<double>::infinity();
    // The first linear system is solved to the end where that may be all.
    double previous = expects_many ? result.residual : std::numeric_limits<double>::infinity();
    // A tangent that active sets have left is that of another place.
    bool    served = result.iterations == 0;
    Circles circles;
    while (std::isfinite(result.residual))
      {
        if (result.iterations > 0 && result.residual <= model.iteration.tolerance)
          return Attempt::converged;
        if (!may_go_on(result))
          return result.stopped ? Attempt::stopped : Attempt::failed;
        if ((result.iterations - first) % stall_window == 0)
          {
            if (result.residual > stalled_fraction * window_start)
              return Attempt::failed; // a shorter step is cheaper than more of the same
            window_start = result.residual;
          }
        // A kept tangent that no longer takes most of the residual away is rebuilt.
        tangent.repair(problem, served, result.residual <= previous);
        const double left = std::max(0.2 * model.iteration.tolerance,
                                     forcing_term(result.residual, previous) * result.residual);
        solve_linear(result, left);
        ++result.iterations;
        previous                  = result.residual;
        const LineSearch searched = search_line();
        result.residual           = searched.residual;
        served                    = result.residual <= 1e-3 * previous;
        if (!served && circles.close(previous, result.residual))
          return Attempt::failed;
        if (model.iteration.regularises_sliding)
          tangent.adapt_sliding(searched.fraction);
      }
    return Attempt::failed;
  }
} // namespace hybrid::dda
