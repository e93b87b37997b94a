// SPDX-License-Identifier: GPL-3.0-or-later
// How a step begins: prediction and guesses.
#include <hybrid/dda/linear/shared_loop.h>
#include <hybrid/dda/model/block_damping.h>
#include <hybrid/dda/step/open_close_iteration.h>
#include <hybrid/scene/stopwatch.h>

#include <cassert>

namespace hybrid::dda
{
  void OpenCloseIteration::predict(const Model              &model,
                                   const DdaState           &state,
                                   const FoundationResponse &foundation,
                                   const double              dt)
  {
    const int    n = model.n_blocks(), m = model.n_foundation_nodes();
    const double beta = model.newmark.beta;
    trial.dt          = dt;
    trial.increment.resize(n);
    trial.rate.resize(n);
    trial.motion.resize(n);
    trial.displacement.resize(state.geometry.vertices.size());
    mass.resize(n);
    predicted.resize(n);
    start_rate.resize(n);
    acceleration.resize(n);
    contact_acceleration.resize(n);
    scale.setOnes(6 * n + 2 * m);
    block_damping_times(model, state, damping_time);
    const double filtered = 0.5 * dt * dt * model.newmark.filter_in(dt, state.last_step);
#pragma omp parallel for schedule(static) if (is_worth_sharing(n))
    for (int b = 0; b < n; ++b)
      {
        const BlockState &block = state.blocks[b];
        const Vec6        v     = model.dynamic_coefficient * block.velocity;
        const Vec6        a     = block.acceleration - block.contact_acceleration;
        mass[b]                 = mass_matrix(model.blocks[b], block.rotation);
        predicted[b]            = dt * v + dt * dt * (0.5 - beta) * a;
        if (filtered > 0.)
          predicted[b] -= filtered * block.acceleration_change;
        start_rate[b] = v;
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



  double OpenCloseIteration::choose_guess(const Model              &model,
                                          const DdaState           &state,
                                          const FoundationResponse &foundation)
  {
    constexpr double near_balance      = 0.03;
    const double     with_acceleration = evaluate(model, state, foundation);
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
    stresses.begin(model);
    incoming = foundation.boundary_force;
    solver.set_slices(model.slice);
    solver.set_foundation_stiffness(foundation.prescribed ? nullptr : foundation.stiffness);
    if (is_restored)
      solver.matrix_restored(matrix);
    is_restored          = false;
    guesses_acceleration = true;
    predict(model, state, foundation, dt);
    if (guess != nullptr)
      trial.increment = *guess;
    sliding_regularisation = {};
  }

} // namespace hybrid::dda
