// SPDX-License-Identifier: GPL-3.0-or-later
#include <hybrid/continuum/slip_solver.h>
#include <hybrid/scene/parameters/scene_parameters.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace hybrid::continuum
{
  namespace
  {
    /// Conditions that still change after so many linear solves are going round in circles.
    constexpr int max_iterations = 30;

    /// How often sweeps point by point, and how many of them, help then.
    constexpr int max_attempts = 8, sweeps_per_attempt = 20;

    /// Round-off of a traction over the largest one: bounds are not told apart within it.
    constexpr double round_off = 1e-11;

    /// Round-off of G p over the largest entry of G and of p.
    constexpr double product_round_off = 1e-14;

    /// Slip direction of a point that has lost its shear strength: no sign, no traction.
    constexpr signed char no_strength = 2;
  } // namespace


  std::optional<PlaneStrength> strength_of(const scene::BeddingParameters &bedding)
  {
    if (!bedding.slips)
      return std::nullopt;
    return PlaneStrength{std::tan(bedding.friction_angle * M_PI / 180.),
                         bedding.cohesion,
                         bedding.tensile_strength};
  }


  SlipSolver::SlipSolver(const std::size_t n, const PlaneStrength &plane_strength)
    : strength(plane_strength)
    , condition(n, PlaneCondition::elastic)
    , direction(n, 0)
    , old_direction(n, 0)
    , old_condition(n, PlaneCondition::elastic)
    , plastic(2 * n, 0.)
    , t(2 * n)
    , change(2 * n)
  {
    if (strength.friction > 0.)
      strength.tension = std::min(strength.tension, strength.cohesion / strength.friction);
    active.reserve(2 * n);
  }


  void SlipSolver::guess(const Problem &problem, const std::vector<char> &failed)
  {
    double moved = 0.;
    for (std::size_t i = 0; i < plastic.size(); ++i)
      moved = std::max(moved, std::abs(plastic[i] - problem.old[i]));
    const double margin = min_margin + product_round_off * stiffest * moved;
    for (std::size_t i = 0; i < condition.size(); ++i)
      {
        const double sigma = t[2 * i], tau = t[2 * i + 1];
        const bool   was  = old_condition[i] == PlaneCondition::open;
        const double gap  = sigma + problem.relaxation(2 * i, 2 * i) * plastic[2 * i];
        const bool   open = failed[i] && gap > (was ? -margin : margin);
        const double limit =
          open ? 0. : (failed[i] ? 0. : strength.cohesion) - strength.friction * sigma;
        const double trial = tau + problem.relaxation(2 * i + 1, 2 * i + 1) *
                                     (plastic[2 * i + 1] - problem.old[2 * i + 1]);
        // Of a point that bears nothing the limit is round-off, of either sign.
        if (open || limit <= (old_direction[i] == no_strength ? margin : 0.))
          direction[i] = no_strength;
        else if (trial > limit + (old_direction[i] == 1 ? -margin : margin))
          direction[i] = 1;
        else if (trial < -limit + (old_direction[i] == -1 ? margin : -margin))
          direction[i] = -1;
        else
          direction[i] = 0;
        condition[i] = open                ? PlaneCondition::open
                       : direction[i] == 0 ? PlaneCondition::elastic
                                           : PlaneCondition::slipping;
      }
  }


  bool SlipSolver::solve_limits(const Problem &problem, const std::vector<char> &failed)
  {
    // What is not at a limit is known: closed, and no slip in this step.
    active.clear();
    for (std::size_t i = 0; i < condition.size(); ++i)
      {
        if (condition[i] == PlaneCondition::open)
          active.push_back(static_cast<int>(2 * i));
        else
          plastic[2 * i] = 0.;
        if (direction[i] != 0)
          active.push_back(static_cast<int>(2 * i + 1));
        else
          plastic[2 * i + 1] = problem.old[2 * i + 1];
      }
    for (std::size_t i = 0; i < plastic.size(); ++i)
      change[i] = plastic[i] - problem.old[i];
    t.noalias() = problem.traction - problem.relaxation * change;
    const int n = static_cast<int>(active.size());
    if (n == 0)
      return true;

    // Open: sigma = 0; slipping in direction e: tau + e tan(phi) sigma = e c; no strength: tau = 0.
    system.resize(n, n);
    rhs.resize(n);
    const Eigen::MatrixXd &g = problem.relaxation;
    for (int r = 0; r < n; ++r)
      {
        const int    row = active[r], i = row / 2;
        const double e        = direction[i] == no_strength ? 0. : direction[i];
        const double cohesion = failed[i] ? 0. : strength.cohesion;
        const double mixed    = row % 2 == 1 ? e * strength.friction : 0.;
        for (int s = 0; s < n; ++s)
          system(r, s) = g(row, active[s]) + mixed * g(2 * i, active[s]);
        rhs[r] = t[row] + mixed * t[2 * i] - (row % 2 == 1 ? e * cohesion : 0.);
      }
    rhs = system.partialPivLu().solve(rhs);
    if (!rhs.allFinite())
      return false;
    for (int r = 0; r < n; ++r)
      {
        plastic[active[r]] += rhs[r];
        t.noalias() -= rhs[r] * g.col(active[r]);
      }
    return true;
  }


  void SlipSolver::sweep(const Problem &problem, const std::vector<char> &failed)
  {
    const Eigen::MatrixXd &g    = problem.relaxation;
    const auto             move = [&](const std::size_t component, const double by) {
      plastic[component] += by;
      t.noalias() -= by * g.col(component);
    };
    for (std::size_t i = 0; i < condition.size(); ++i)
      for (int repeat = 0; repeat < 3;
           ++repeat) // opening and slip of the point, one after the other
        {
          const std::size_t n = 2 * i, s = n + 1;
          const double      opening = failed[i] ? std::max(0., plastic[n] + t[n] / g(n, n)) : 0.;
          if (opening != plastic[n])
            move(n, opening - plastic[n]);
          const double limit =
            opening > 0.
              ? 0.
              : std::max(0., (failed[i] ? 0. : strength.cohesion) - strength.friction * t[n]);
          const double trial = t[s] + g(s, s) * (plastic[s] - problem.old[s]);
          const double slip  = (trial - std::clamp(trial, -limit, limit)) / g(s, s);
          if (slip != plastic[s] - problem.old[s])
            move(s, problem.old[s] + slip - plastic[s]);
        }
  }


  bool SlipSolver::settle(const Problem &problem, const std::vector<char> &failed)
  {
    for (int attempt = 0; attempt < max_attempts; ++attempt)
      {
        for (int iteration = 0; iteration < max_iterations; ++iteration)
          {
            guess(problem, failed);
            if (iteration > 0 && condition == old_condition && direction == old_direction)
              return true;
            old_condition = condition;
            old_direction = direction;
            ++count;
            if (!solve_limits(problem, failed))
              return false;
          }
        // Newton goes round in circles: Gauss-Seidel sweeps bring it near the solution.
        for (int k = 0; k < (attempt + 1) * sweeps_per_attempt; ++k)
          sweep(problem, failed);
      }
    return false;
  }


  bool SlipSolver::solve(const Problem &problem, std::vector<char> &failed)
  {
    count      = 0;
    plastic    = problem.old;
    t          = problem.traction;
    min_margin = round_off * t.lpNorm<Eigen::Infinity>();
    stiffest   = problem.relaxation.diagonal().maxCoeff();
    std::fill(old_condition.begin(), old_condition.end(), PlaneCondition::elastic);
    std::fill(old_direction.begin(), old_direction.end(), 0);
    for (bool new_break = true; new_break;)
      {
        if (!settle(problem, failed))
          return false;
        new_break = false;
        for (std::size_t i = 0; i < failed.size(); ++i)
          if (!failed[i] && t[2 * i] > strength.tension)
            failed[i] = new_break = true;
      }
    return true;
  }
} // namespace hybrid::continuum
