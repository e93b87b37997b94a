// SPDX-License-Identifier: GPL-3.0-or-later
// How a step begins: prediction and guesses.
#include <hybrid/dda/linear/shared_loop.h>
#include <hybrid/dda/model/block_damping.h>
#include <hybrid/dda/step/open_close_iteration.h>
#include <hybrid/scene/stopwatch.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace hybrid::dda
{
  void OpenCloseIteration::predict(const Model              &model,
                                   const DdaState           &state,
                                   const FoundationResponse &foundation,
                                   const double              dt)
  {
    const int n = model.n_blocks(), m = model.n_foundation_nodes();
    trial.dt = dt;
    trial.increment.resize(n);
    trial.rate.resize(n);
    trial.motion.resize(n);
    trial.displacement.resize(state.geometry.vertices.size());
    mass.resize(n);
    acceleration.resize(n);
    contact_acceleration.resize(n);
    scale.setOnes(6 * n + 2 * m);
    block_damping_times(model, state, damping_time);
    kinematics.begin(model, state, springs, dt);
#pragma omp parallel for schedule(static) if (is_worth_sharing(n))
    for (int b = 0; b < n; ++b)
      {
        mass[b] = BlockMass(model.blocks[b], state.blocks[b].rotation);
        scale.segment<4>(6 * b + 2).setConstant(model.blocks[b].size);
      }
    assert(foundation.displacement.size() == 2 * m);
    start_trial(model, state, foundation);
    if (foundation.prescribed)
      return;
    foundation_start = foundation.load;
    const Stopwatch timer(times.surface_products);
    solver.foundation_stiffness().subtract_whole_product(foundation.displacement.data(),
                                                         foundation_start.data());
  }



  void OpenCloseIteration::start_trial(const Model              &model,
                                       const DdaState           &state,
                                       const FoundationResponse &foundation)
  {
    const int    n  = model.n_blocks();
    const double dt = trial.dt;
#pragma omp parallel for schedule(static) if (is_worth_sharing(n))
    for (int b = 0; b < n; ++b)
      {
        trial.increment[b] = dt * (model.dynamic_coefficient * state.blocks[b].velocity);
        if (guesses_acceleration)
          trial.increment[b] += 0.5 * dt * dt * state.blocks[b].acceleration;
      }
    trial.foundation = foundation.displacement;
  }



  double OpenCloseIteration::unbalanced_without_motion(const Model    &model,
                                                       const DdaState &state) const
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
      shared_sum<Squares>(model.blocks.size(), [&](const std::size_t n, Squares &sum) {
        const int              b     = static_cast<int>(n);
        const BlockProperties &p     = model.blocks[b];
        const BlockState      &block = state.blocks[b];
        // Springs and stresses stay as they were, so they still balance the accelerations.
        const Vec6 left =
          mass[b] * (block.acceleration - block.contact_acceleration +
                     StepKinematics::contact_weight(model.newmark) * block.contact_acceleration +
                     kinematics.inertia(b) * kinematics.predicted(b));
        sum += {left.head<2>().squaredNorm() + left.tail<4>().squaredNorm() / (p.size * p.size),
                std::pow(p.weight * model.gravity, 2)};
      });
    return std::sqrt(all.unbalanced / std::max(all.weight, 1e-300));
  }



  double OpenCloseIteration::choose_guess(const Model              &model,
                                          const DdaState           &state,
                                          const FoundationResponse &foundation)
  {
    constexpr double near_balance = 0.03;
    if (unbalanced_without_motion(model, state) <= nearly_at_rest)
      {
        std::fill(trial.increment.begin(), trial.increment.end(), Vec6::Zero());
        return evaluate(model, state, foundation);
      }
    const double with_acceleration = evaluate(model, state, foundation);
    if (with_acceleration <= near_balance)
      return with_acceleration;
    guesses_acceleration = false;
    start_trial(model, state, foundation);
    const double without = evaluate(model, state, foundation);
    if (without < with_acceleration)
      return without;
    guesses_acceleration = true;
    start_trial(model, state, foundation);
    return evaluate(model, state, foundation);
  }



  bool OpenCloseIteration::moves_nothing(const Step &step) const
  {
    const auto &[model, state, foundation, result] = step;
    return model.iteration.stops_at_rest && foundation.prescribed && model.n_bedrock == 0 &&
           trial.foundation == state.foundation_displacement &&
           std::all_of(trial.increment.begin(), trial.increment.end(), [](const Vec6 &d) {
             return d.isZero(0.);
           });
  }



  bool OpenCloseIteration::lies_in_balance(const Model &model) const
  {
    if (!(residual.cwiseQuotient(scale).norm() <= model.iteration.tolerance * reference))
      return false;
    for (int b = 0; b < model.n_blocks(); ++b)
      {
        const Vec6 left = residual.segment<6>(6 * b).cwiseQuotient(scale.segment<6>(6 * b));
        if (!(left.norm() <= nearly_at_rest * absolute[b]))
          return false;
      }
    return true;
  }



  void OpenCloseIteration::begin(const Model              &model,
                                 const DdaState           &state,
                                 const FoundationResponse &foundation,
                                 const double              dt,
                                 const std::vector<Vec6>  *guess)
  {
    {
      const Stopwatch timer(times.springs);
      springs.collect(model, state);
    }
    stresses.begin(model, state, dt);
    islands.begin(model.n_blocks());
    interior.clear();
    incoming = foundation.boundary_force;
    solver.set_slices(model.slice);
    solver.set_foundation_stiffness(foundation.prescribed ? nullptr : foundation.stiffness);
    if (is_restored)
      solver.matrix_restored(matrix);
    is_restored          = false;
    guesses_acceleration = true;
    may_rest = at_rest = false;
    predict(model, state, foundation, dt);
    if (guess != nullptr)
      trial.increment = *guess;
    sliding_regularisation = {};
  }

} // namespace hybrid::dda
