// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/dda/linear/preconditioner_choice.h>
#include <hybrid/restart/archive.h>

#include <algorithm>
#include <cmath>

namespace hybrid::dda
{
  namespace
  {
    constexpr int few_sweeps   = 40; ///< always granted
    constexpr int many_sweeps  = 2000;
    constexpr int few_failures = 2;   ///< of old factors in a row, after which they are passed over
    constexpr int retry_every  = 8;   ///< matrices, to see if an old factor serves again
    constexpr int judged_every = 8;   ///< solutions with factors, at least
    constexpr double early     = 0.1; ///< part of the price at which one that lasts is bought
    constexpr double most_patience = 64.; ///< prices of a factor
    constexpr double forgotten     = 0.9; ///< of what sweeps have cost, at each judgement



    int iterations_for(const double price, const double each)
    {
      return static_cast<int>(std::min(1e6, std::ceil(price / each)));
    }
  } // namespace



  int PreconditionerChoice::sweep_limit(const Costs &costs) const
  {
    const int affordable = iterations_for(costs.factor + costs.with_factor, costs.sweep);
    return std::max(few_sweeps, std::min(many_sweeps, affordable));
  }



  int PreconditionerChoice::old_factor_limit(const Costs &costs)
  {
    if (excess >= costs.factor || costs.factor <= costs.with_factor)
      {
        excess = 0.;
        return 0;
      }
    if (failures >= few_failures)
      {
        passed_over = (passed_over + 1) % retry_every;
        if (passed_over != 0)
          return 0;
      }
    return std::max(2, iterations_for(costs.factor, costs.with_factor));
  }



  void PreconditionerChoice::swept(const int iterations, const bool converged, const Costs &costs)
  {
    const double cost = iterations * costs.sweep;
    if (converged)
      {
        sweep_cost = sweep_cost == 0. ? cost : 0.75 * sweep_cost + 0.25 * cost;
        excess     = std::max(0., excess + cost - costs.with_factor);
        if (excess > (costs.lasts ? early : 1.) * patience * costs.factor)
          begin_factors();
        return;
      }
    sweep_cost = std::max(sweep_cost, 8. * cost); // unknown, but more than this
    begin_factors();
  }



  void PreconditionerChoice::used_old_factor(const int    iterations,
                                             const bool   converged,
                                             const Costs &costs)
  {
    failures = converged ? 0 : failures + 1;
    excess   = converged ? excess + (iterations - 1) * costs.with_factor : 0.;
  }



  void PreconditionerChoice::solved(const int iterations, const int n_made, const Costs &costs)
  {
    factor_cost += iterations * costs.with_factor + n_made * costs.factor;
    if (n_made > 0)
      excess = 0.;
    if (++solutions < judged_every || n_made == 0)
      return;
    if (factor_cost > solutions * sweep_cost)
      {
        patience = std::min(most_patience, 2. * patience);
        begin_sweeps();
        return;
      }
    patience = std::max(1., 0.5 * patience);
    sweep_cost *= forgotten;
    factor_cost = 0.;
    solutions   = 0;
  }



  void PreconditionerChoice::give_up_factor()
  {
    begin_sweeps();
  }



  void PreconditionerChoice::begin_factors()
  {
    factored    = true;
    excess      = 0.;
    factor_cost = 0.;
    solutions = failures = passed_over = 0;
  }



  void PreconditionerChoice::begin_sweeps()
  {
    factored   = false;
    excess     = 0.;
    sweep_cost = 0.;
  }



  void PreconditionerChoice::serialize(restart::Archive &archive)
  {
    archive(factored, excess, patience, sweep_cost, factor_cost, solutions, failures, passed_over);
  }
} // namespace hybrid::dda
