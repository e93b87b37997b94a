// SPDX-License-Identifier: GPL-3.0-or-later
// How a step begins: prediction and where the trial starts.
#include <hybrid/dda/linear/shared_loop.h>
#include <hybrid/dda/model/block_damping.h>
#include <hybrid/dda/step/step_problem.h>
#include <hybrid/scene/stopwatch.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace hybrid::dda
{
  void StepProblem::begin(const Model              &block_model,
                          const DdaState           &state,
                          const FoundationResponse &response,
                          const double              dt)
  {
    model          = &block_model;
    before         = &state;
    foundation     = &response;
    incoming       = response.boundary_force;
    few            = nullptr;
    at_rest        = false;
    is_complete    = true;
    lacks_contacts = false;
    {
      const Stopwatch timer(times.springs);
      springs.widen();
      springs.collect(*model, state);
      shared.begin(*model, state, springs);
    }
    stresses.begin(*model, state, dt);
    blocks_at_work.begin(model->n_blocks());
    predict(dt);
  }



  namespace
  {
    /// Of the norm of all masses: the forces on lighter blocks count in the balance as much as if
    /// they had this share [-].
    constexpr double lightest_share = 1e-4;



    double norm_of_masses(const Model &model)
    {
      double    sum = 0.;
      const int n   = model.n_mass() > 0 ? model.n_mass() : model.n_blocks();
      for (int b = 0; b < n; ++b)
        sum += model.blocks[b].mass * model.blocks[b].mass;
      return std::sqrt(sum);
    }
  } // namespace



  void StepProblem::predict(const double dt)
  {
    const int n = model->n_blocks(), m = model->n_foundation_nodes();
    trial.dt = dt;
    trial.increment.resize(n);
    trial.rate.resize(n);
    trial.motion.resize(n);
    trial.displacement.resize(before->geometry.vertices.size());
    mass.resize(n);
    acceleration.resize(n);
    contact_acceleration.resize(n);
    scale.setOnes(6 * n + 2 * m);
    block_damping_times(*model, *before, damping_time);
    kinematics.begin(*model, *before, springs, dt);
    const double light = lightest_share * norm_of_masses(*model);
#pragma omp parallel for schedule(static) if (is_worth_sharing(n))
    for (int b = 0; b < n; ++b)
      {
        mass[b] = BlockMass(model->blocks[b], before->blocks[b].rotation);
        scale.segment<4>(6 * b + 2).setConstant(model->blocks[b].size);
        scale.segment<6>(6 * b) *= std::min(1., model->blocks[b].mass / light);
      }
    assert(foundation->displacement.size() == 2 * m);
    start_trial(true);
    if (foundation->prescribed)
      return;
    foundation_start = foundation->load;
    const Stopwatch timer(times.surface_products);
    surface->subtract_whole_product(foundation->displacement.data(), foundation_start.data());
  }



  void StepProblem::start_trial(const bool with_acceleration)
  {
    const int    n  = model->n_blocks();
    const double dt = trial.dt, kept = model->velocity_kept_in(dt);
#pragma omp parallel for schedule(static) if (is_worth_sharing(n))
    for (int b = 0; b < n; ++b)
      {
        trial.increment[b] = dt * (kept * before->blocks[b].velocity);
        if (with_acceleration)
          trial.increment[b] += 0.5 * dt * dt * before->blocks[b].acceleration;
      }
    trial.foundation = foundation->displacement;
  }



  double StepProblem::unbalanced_without_motion() const
  {
    struct Squares
    {
      double unbalanced = 0., weight = 0.;

      void operator+=(const Squares &other)
      {
        unbalanced += other.unbalanced;
        weight += other.weight;
      }
    };
    const Squares all =
      shared_sum<Squares>(model->blocks.size(), [&](const std::size_t n, Squares &sum) {
        const int              b     = static_cast<int>(n);
        const BlockProperties &p     = model->blocks[b];
        const BlockState      &block = before->blocks[b];
        // Springs and stresses stay as they were, so they still balance the accelerations.
        const Vec6 left =
          mass[b] * (block.acceleration - block.contact_acceleration +
                     StepKinematics::contact_weight(model->newmark) * block.contact_acceleration +
                     kinematics.inertia(b) * kinematics.predicted(b));
        sum += {left.head<2>().squaredNorm() + left.tail<4>().squaredNorm() / (p.size * p.size),
                std::pow(p.weight * model->gravity, 2)};
      });
    return std::sqrt(all.unbalanced / std::max(all.weight, 1e-300));
  }



  double StepProblem::choose_start()
  {
    constexpr double near_balance = 0.03;
    if (unbalanced_without_motion() <= nearly_at_rest)
      {
        std::fill(trial.increment.begin(), trial.increment.end(), Vec6::Zero());
        return evaluate();
      }
    const double with_acceleration = evaluate();
    if (with_acceleration <= near_balance)
      return with_acceleration;
    start_trial(false);
    const double without = evaluate();
    if (without < with_acceleration)
      return without;
    start_trial(true);
    return evaluate();
  }



  bool StepProblem::moves_nothing() const
  {
    return model->iteration.stops_at_rest && foundation->prescribed && model->n_bedrock == 0 &&
           trial.foundation == before->foundation_displacement &&
           std::all_of(trial.increment.begin(), trial.increment.end(), [](const Vec6 &d) {
             return d.isZero(0.);
           });
  }



  bool StepProblem::lies_in_balance() const
  {
    if (!(residual.cwiseQuotient(scale).norm() <= model->iteration.tolerance * reference))
      return false;
    for (int b = 0; b < model->n_blocks(); ++b)
      {
        if (!(left_of(b) <= nearly_at_rest * absolute[b]))
          return false;
      }
    return true;
  }
} // namespace hybrid::dda
